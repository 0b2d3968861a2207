"""From a scene and its effects to a problem for a solver."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import partial

import casadi as ca
import numpy as np

from viscodesign.effects.base import Effect, Trait
from viscodesign.effects.catalogue import every_effect
from viscodesign.effects.joining import join
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.chain import Chain
from viscodesign.model.formulation import formulate
from viscodesign.model.network_equations import NetworkForm
from viscodesign.model.rod import Body, RodDiscretisation
from viscodesign.model.scene_number import Numbers
from viscodesign.model.several_rods import SeveralRods, several_bodies
from viscodesign.model.syringes import SyringeParameters
from viscodesign.model.system import InletSource, System
from viscodesign.model.unknowns import Sizes
from viscodesign.postprocess.sample_times import with_samples
from viscodesign.scene.inputs.base import Input, PiecewiseLinear
from viscodesign.scene.inputs.syringe import SyringeInput
from viscodesign.scene.scene import Scene
from viscodesign.solve.obstacles import Obstacle, Remedies
from viscodesign.solve.problem import DrawingLimits, Problem, Schedule, merged
from viscodesign.solve.transient import DEFAULT_SOLVER, solver_catalogue

SHARE_OF_TIME = 0.5
"""Part of the accuracy that a first solution may spend on its steps through time."""


@dataclass(frozen=True)
class Settings:
    """How finely a problem is solved."""

    edges_per_section: int
    tolerance: float
    solver: str = DEFAULT_SOLVER
    is_free: bool = False
    """Whether a solver without error in time replaces it where the equations allow."""
    for_balances: bool = True
    """Whether it is also solved so densely between the outputs that balances can be summed."""


def suggest_settings(quantities: SceneQuantities, effects: Sequence[Effect]) -> Settings:
    """Mesh, tolerance and solver that should meet the scene's accuracy with these effects.

    A run then measures what they do.
    """
    accuracy, body = quantities.accuracy, quantities.body
    mesh = _kind_of(body).suggested(body, accuracy, quantities.largest_turn)
    solver = solver_catalogue()[DEFAULT_SOLVER]
    tolerance = SHARE_OF_TIME * accuracy / solver.tip_error_per_tolerance
    return Settings(mesh.edges_per_section, tolerance, solver.name, is_free=True)


def build(quantities: SceneQuantities, effects: Sequence[Effect], settings: Settings) -> Problem:
    """Assemble the system, let every effect join it, and formulate its equations."""
    scene = quantities.scene
    rod = rod_of(quantities.body, settings.edges_per_section)
    system = assemble(quantities, effects, rod, resolvable_body(quantities))
    system.wide = wide_tubes(quantities)
    equations = formulate(system, sizes_of(quantities))
    return Problem(
        equations=equations,
        rod=system.discretisation,
        inlets=tuple(scene.inputs),
        bellows=quantities.graph.bellows,
        bellows_along_tubes=quantities.graph.bellows_along_tubes(),
        baseline=scene.gauge_pressure,
        schedule=with_samples(
            schedule(scene),
            equations,
            scene.run.start != "equilibrium",
            for_balances=settings.for_balances,
        ),
        has_straight_inputs=all(isinstance(i, PiecewiseLinear) for i in scene.inputs.values()),
        rest_volume=quantities.bellows.rest_volume,
        floor_volume=_floor_volume(quantities, effects),
        drawing=_drawing_limits(quantities, effects),
        remedies=_remedies(quantities),
        max_steps=scene.run.max_steps,
        flow_shares=_flow_shares(quantities, equations.network_form),
        junctions=quantities.graph.junctions,
    )


def rod_of(body: Body, edges_per_section: int) -> RodDiscretisation:
    """The rod of a body, or of several side by side, on a mesh."""
    return _kind_of(body)(body, edges_per_section)


def _kind_of(body: Body) -> type[RodDiscretisation]:
    return SeveralRods if body.members else Chain


def assemble(
    quantities: SceneQuantities,
    effects: Iterable[Effect],
    rod: RodDiscretisation,
    body: Body,
    *,
    held: bool = False,
) -> System:
    """The system of a scene with every effect's terms; ``body``: with the stiffness to use.

    ``held``: with one number at each inlet in place of its input.
    """
    scene = quantities.scene
    system = System(
        quantities.graph,
        body,
        quantities.bellows,
        {name: _source(scene, name, held) for name in scene.inputs},
        scene.gauge_pressure,
        scene.ambient_pressure,
        rod,
    )
    for effect in effects:
        join(effect, system)
    return system


MIN_FILLING = 1e-10
"""Part of its rest volume by which the pressures of a run fill a bellow at least: the volume is
known to round-off, and with it the pressure."""


def sizes_of(quantities: SceneQuantities) -> Sizes:
    """By which the unknowns are scaled."""
    law = quantities.bellow
    least = MIN_FILLING * law.rest_volume / law.compliance
    return Sizes(
        pressure=max(quantities.swing, least),
        time=quantities.scales.t_s,
        swing=quantities.swing_time,
    )


HARDLY_RESISTS = 3e-3
"""Time in which a tube fills one bellow, relative to the input's swing, below which the flow
through it is an unknown of its own. At the tolerances of the default accuracy (1e-5 of the
pressure) an error of pressure would pass for 1/300 of that flow."""
MOST_RESIST = 0.75
"""Part of the tubes that bound the flow through the others."""


def wide_tubes(quantities: SceneQuantities) -> frozenset[str]:
    """Tubes whose flow the input's swing, or the other tubes, bound far more than they do."""
    if not quantities.resistances:
        return frozenset()
    filling = quantities.swing_time / quantities.bellow.compliance
    resistances = quantities.resistances
    others = np.quantile(list(resistances.values()), MOST_RESIST, method="nearest")
    least = HARDLY_RESISTS * max(filling, float(others))
    return frozenset(name for name, value in resistances.items() if value < least)


INEXTENSIBLE = 30.0
"""Stiffness along the axis over what the accuracy can tell from infinite: a rod that is stiffer
only makes its equations harder to solve."""
MAX_STIFFENED = 1e4
"""The same for the bending of a section that is stiffer than the others: steel in silicone."""


def resolvable_body(quantities: SceneQuantities) -> Body:
    """The body, its axis made no stiffer than moves the tip by a thirtieth of the accuracy.

    A force F stretches a rod by F/EA of its length; forces are scaled by EI/L2.
    """
    if quantities.body.members:
        return several_bodies([_resolvable(quantities, own) for own in quantities.body.members])
    return _resolvable(quantities, quantities.body)


def _resolvable(quantities: SceneQuantities, body: Body) -> Body:
    pull, bending = (
        quantities.load_force + quantities.fluid_weight,
        body.bending_stiffness / body.length**2,
    )
    most = INEXTENSIBLE / quantities.accuracy * max(bending, pull)
    varied = body.varied
    if varied is not None:
        stiffest = np.maximum(INEXTENSIBLE / quantities.accuracy, MAX_STIFFENED)
        varied = replace(
            varied,
            bending_stiffness=np.minimum(
                varied.bending_stiffness,
                stiffest * max(body.bending_stiffness, pull * body.length**2),
            ),
            extension_stiffness=np.minimum(varied.extension_stiffness, most),
        )
    return replace(body, extension_stiffness=min(body.extension_stiffness, most), varied=varied)


def _floor_volume(quantities: SceneQuantities, effects: Sequence[Effect]) -> Numbers | None:
    """Minimum volume of bellows whose law leads to negative ones, with a gas that fills them.

    It holds of a gas that is taken as incompressible, too, unless the spec says so: a gas that may
    be neglected meets it where one that is not does.
    """
    traits = _traits(effects)
    if Trait.LIMITED_EMPTYING in traits:
        return None
    allowed = _traits(_allowed(quantities))
    is_forbidden = Trait.LIMITED_EMPTYING not in allowed
    is_gas = Trait.COMPRESSIBLE_FLUID in (allowed if is_forbidden else traits)
    return quantities.bellows.floor_volume if is_gas else None


def _allowed(quantities: SceneQuantities) -> Iterator[Effect]:
    """Effects that the spec does not switch off, if the scene has what they act on."""
    choice = quantities.scene.effects
    for effect in every_effect(quantities).values():
        if effect.mode_in(choice) != "off" and effect.present(quantities):
            yield effect


def _drawing_limits(quantities: SceneQuantities, effects: Sequence[Effect]) -> DrawingLimits | None:
    scene = quantities.scene
    if all(source.gives_pressure for source in scene.inputs.values()):
        return None
    is_limited = Trait.LIMITED_EMPTYING in _traits(effects)
    floor = None if is_limited else quantities.bellow.floor_volume
    return DrawingLimits(-scene.ambient_pressure, floor)


def _traits(effects: Iterable[Effect]) -> set[Trait]:
    return {trait for effect in effects for trait in effect.traits}


def _remedies(quantities: SceneQuantities) -> Remedies:
    """What every effect offers, included or not, if the scene has what it acts on."""
    law, count = quantities.bellow, len(quantities.graph.bellows)
    held, kept = (1e6 * count * volume for volume in (law.rest_volume, law.floor_volume))
    found: dict[Obstacle, tuple[str, ...]] = {
        Obstacle.OVERDRAWN: (
            f"Draw less: all bellows together hold {held:.3g} mL at rest, of which {kept:.3g} mL "
            "cannot be drawn",
        )
    }
    for effect in every_effect(quantities).values():
        for obstacle, remedy in effect.remedies.items() if effect.present(quantities) else ():
            found[obstacle] = (*found.get(obstacle, ()), remedy)
    return found


def _source(scene: Scene, name: str, held: bool) -> InletSource:
    source, syringe = scene.inputs[name], None
    if isinstance(source, SyringeInput):
        fluid = scene.fluid
        modulus, exponent = fluid.bulk_modulus, fluid.polytropic_exponent
        # Beside a gas it is the same gas, and part of the full volume.
        cushion = 0.0 if fluid.is_gas else source.cushion
        syringe = SyringeParameters(source.full_volume, modulus, exponent, cushion)
    if held:
        return InletSource(_held, 1, syringe)
    return InletSource(partial(_value, type(source)), source.coefficients, syringe)


def _held(_: ca.SX, piece: ca.SX) -> ca.SX:
    """Value of an inlet that is held."""
    return piece[0]


def _value(kind: type[Input], time: ca.SX, piece: ca.SX) -> ca.SX:
    """Value of an input of this kind: its own numbers are all in ``piece``."""
    value: ca.SX = kind.expression(time, piece, ca)
    return value


def _flow_shares(quantities: SceneQuantities, form: NetworkForm) -> np.ndarray:
    """Tube flows (Q, B) per rate of every bellow's volume, shared by the tubes' resistances."""
    graph = quantities.graph
    if form is NetworkForm.DISTRIBUTED:
        return np.zeros((len(graph.tubes), len(graph.bellows)))
    tubes = {t.name: k for k, t in enumerate(graph.tubes)}
    bellows = {name: k for k, name in enumerate(graph.bellows)}
    shares = np.zeros((len(tubes), len(bellows)))
    for component in graph.components():
        nodes = (*component.bellows, *component.junctions)
        # Least squares, since a sealed island's pressures are known up to a constant.
        drop = -np.linalg.pinv(quantities.laplacian(component))
        for t in component.tubes:
            conductance = 1 / quantities.resistances[t.name]
            for end, sign in ((t.start, 1.0), (t.end, -1.0)):
                if end in nodes:
                    row = sign * conductance * drop[nodes.index(end)]
                    for k, name in enumerate(component.bellows):
                        shares[tubes[t.name], bellows[name]] += row[k]
    return shares


def schedule(scene: Scene) -> Schedule:
    """Output times, corners of all inputs, and the coefficients between them."""
    stops = stops_of(scene)
    return Schedule.of(scene.run.output_times_array(), stops, *pieces_between(scene, stops))


def cycle_schedule(scene: Scene, period: float) -> Schedule:
    """One period of all inputs, whose end is the only output."""
    stops = stops_of(scene, period)
    return one_period(stops, *pieces_between(scene, stops))


def one_period(stops: np.ndarray, pieces: np.ndarray, initial_piece: np.ndarray) -> Schedule:
    """The same of coefficients (m, c) between ``stops`` (m + 1,), the last of which is the end."""
    times = np.linspace(0.0, stops[-1], EDGES_PER_CYCLE)
    found = Schedule.of(times, stops, pieces, initial_piece)
    return replace(found, outputs=found.outputs[-1:])


EDGES_PER_CYCLE = 33
"""Edges of a period: what is integrated over each interval has few swings in it."""


def stops_of(scene: Scene, duration: float | None = None) -> np.ndarray:
    """Zero, the corners of all inputs, and the end, ascending (m + 1,) [s].

    ``duration``: that of the run unless told otherwise [s].
    """
    duration = scene.run.duration if duration is None else duration
    return merged(corners_of(scene, duration), duration)


def corners_of(scene: Scene, duration: float) -> np.ndarray:
    """Zero, the corners of all inputs, and the end, in any order [s]."""
    corners = [np.array(source.corners(duration)) for source in scene.inputs.values()]
    return np.concatenate([[0.0], *corners, [duration]])


def pieces_between(scene: Scene, stops: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Coefficients of all inputs (m, c) between ``stops`` (m + 1,), and those before t = 0 (c,)."""
    sources = scene.inputs.values()
    pieces = [s.pieces(stops) for s in sources] or [np.zeros((len(stops) - 1, 0))]
    initial = [s.initial_piece() for s in sources] or [np.zeros(0)]
    return np.concatenate(pieces, 1), np.concatenate(initial)
