"""Outputs at the output times as a function of the unknowns, with derivatives."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import casadi as ca
import numpy as np

from viscodesign.compiled.endings import Endings, volumes_count
from viscodesign.compiled.problem_at import stretch_of
from viscodesign.compiled.row_functions import RowFunction
from viscodesign.compiled.scene_numbers import ProblemNumbers
from viscodesign.compiled.symbols import Symbols, parameter_names
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model import formulas as of
from viscodesign.model.network_equations import NetworkForm
from viscodesign.model.rod import RodDiscretisation
from viscodesign.model.rod_equations import RodForm
from viscodesign.postprocess.fluid_balance import holding_columns
from viscodesign.results.channels import CHANNELS, TIP_QUANTITIES, Channel, Per
from viscodesign.solve.problem import Problem

SX = ca.SX
FILLED_AMOUNTS = 2
"""Place of what nodes hold at the baseline among the results of `formulas.quantities`."""
STRAIGHT_TURN = 1e-3
"""Half turn of an arc [rad] below which its chord is taken from a series, exact to round-off."""


@dataclass(frozen=True)
class ReadColumns:
    """Columns, and what they were read from."""

    rows: list[np.ndarray]
    """Arguments of the function that reads the columns."""
    columns: np.ndarray
    """(T, columns)"""


class Reading:
    """Chosen columns of `trajectory.csv` (T, columns) of unknowns at T times.

    Arguments of a row: states, algebraic unknowns, time, inlet coefficients; the parameters are
    shared by all rows.
    """

    @classmethod
    def of(cls, problem: Problem, members: Members, columns: Sequence[str]) -> Reading:
        """That of all problems with these formulas and names."""
        names = members, problem.inlets, problem.bellows_along_tubes, tuple(columns)
        key = names, problem.places.tobytes(), problem.body.sections, volumes_count(problem)
        return problem.equations.shared.derived(cls, key, lambda: cls(problem, members, columns))

    def __init__(self, problem: Problem, members: Members, columns: Sequence[str]) -> None:
        symbols, self._states = Symbols.of(problem), problem.equations.states.count
        own = _in_order(problem, symbols.outputs(problem), symbols.parameters)
        places = places_of(problem, members)
        result = ca.vertcat(SX(0, 1), *(own[places[c][0]][places[c][1]] for c in columns))
        self.endings = Endings(problem, symbols)
        self._function = RowFunction(symbols.row, result, shared=1)
        both = ca.vertcat(result, self.endings.formulas)
        self._with_endings = RowFunction(symbols.row, both, shared=1)

    def __call__(
        self, problem: Problem, times: np.ndarray, numbers: ProblemNumbers, unknowns: np.ndarray
    ) -> ReadColumns:
        """Columns of a solved problem's unknowns (T, nx + nz) at times (T,).

        Raises `SolveError` where the motion has lost its meaning.
        """
        read, looked_at = self.read(times, numbers, unknowns)
        self.endings.check(problem, times, looked_at)
        return read

    def read(
        self, times: np.ndarray, numbers: ProblemNumbers, unknowns: np.ndarray
    ) -> tuple[ReadColumns, np.ndarray]:
        """Columns of unknowns (T, nx + nz) at times (T,), and what `endings` looks at (T, k)."""
        x, z = np.split(unknowns, [self._states], axis=1)
        rows = [x, z, times, numbers.pieces[stretch_of(times, numbers)], numbers.parameters]
        columns, looked_at = np.split(self._with_endings(*rows), [self._function.size], axis=1)
        return ReadColumns(rows, columns), looked_at

    def pull_back(self, rows: Sequence[np.ndarray], weights: np.ndarray) -> list[np.ndarray]:
        """Slopes of weights (T, columns) times columns, one array per argument."""
        return self._function.pull_back(rows, weights)

    def push_forward(self, rows: Sequence[np.ndarray], rates: Sequence[np.ndarray]) -> np.ndarray:
        """Rates (T, columns) for the rates of all arguments."""
        return self._function.push_forward(rows, rates)


@dataclass(frozen=True)
class Members:
    """Names of what quantities have one value of."""

    inlets: tuple[str, ...]
    bellows: tuple[str, ...]
    tubes: tuple[str, ...]
    junctions: tuple[str, ...]
    rods: tuple[str, ...] = ()
    """Names of several actuators that share fluid; empty for a single one."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Members:
        """Those of a scene."""
        graph, inlets = quantities.graph, tuple(quantities.scene.inputs)
        tubes = tuple(tube.name for tube in graph.tubes)
        return cls(inlets, graph.bellows, tubes, graph.junctions, tuple(quantities.scene.members))

    @property
    def rod_prefixes(self) -> tuple[str, ...]:
        """What the columns of each rod begin with."""
        return tuple(f"{name}." for name in self.rods) or ("",)

    def bellows_of(self, prefix: str) -> tuple[str, ...]:
        """A rod's bellows, under its own names."""
        own = (name for name in self.bellows if name.startswith(prefix))
        return tuple(name.removeprefix(prefix) for name in own)

    def column(self, channel: Channel, member: str) -> str:
        """The column of a member; what belongs to a rod has the rod's name before all."""
        found = [prefix for prefix in self.rod_prefixes if prefix and member.startswith(prefix)]
        prefix = found[0] if found else ""
        return prefix + channel.column(member.removeprefix(prefix))

    def columns(self, channel: Channel) -> list[str]:
        """Columns of a quantity, in order."""
        own = {
            Per.INLET: self.inlets,
            Per.BELLOW: self.bellows,
            Per.TUBE: self.tubes,
            Per.JUNCTION: self.junctions,
            Per.CONTACT: (),  # a scene with contact is not compiled
        }
        is_only = channel.per is Per.INLET and len(self.inlets) == 1 and not self.rods
        if channel.per not in own or is_only:
            return [channel.column()]
        return [self.column(channel, name) for name in own[channel.per]]


SECTION_END_AXES = ("x", "z")
DELIVERED = "inflow"
READ = ("inlet_pressure", "pressure", "volume", "junction_pressure", "flow")
"""Quantities that are outputs of the equations under the same name."""


def places_of(problem: Problem, members: Members) -> dict[str, tuple[str, int]]:
    """The columns that can be read: quantity and place in it."""
    found: dict[str, tuple[str, int]] = {}
    flows = problem.equations.network_form is NetworkForm.DISTRIBUTED
    for channel in CHANNELS:
        if channel.quantity in TIP_QUANTITIES:
            for k, prefix in enumerate(members.rod_prefixes):
                place = len(TIP_QUANTITIES) * k + TIP_QUANTITIES.index(channel.quantity)
                found[prefix + channel.column()] = "tip", place
        elif channel.quantity in READ and (flows or channel.quantity != "flow"):
            for k, column in enumerate(members.columns(channel)):
                found[column] = channel.quantity, k
        elif channel.quantity == DELIVERED:
            for k, column in enumerate(members.columns(channel)):
                if problem.inlets[k] in delivering(problem):
                    found[column] = DELIVERED, k
    ends = [
        prefix + column
        for prefix, rod in zip(members.rod_prefixes, _rods(problem), strict=True)
        for column in section_end_columns(rod.body.sections)
    ]
    return found | {column: ("section_end", k) for k, column in enumerate(ends)}


def _rods(problem: Problem) -> list[RodDiscretisation]:
    """Each rod by itself."""
    return [rod for rod, _ in problem.rod.rods({})]


def section_end_columns(sections: int) -> list[str]:
    """Columns of x and z [m] of the ends of the sections, the first at the clamp."""
    return [f"m{k}_{axis}_m" for k in range(1, sections + 1) for axis in SECTION_END_AXES]


def _in_order(problem: Problem, values: Mapping[str, SX], parameters: SX) -> dict[str, SX]:
    """Quantities by name, those of bellows in the order of the columns."""
    order = problem.places.tolist()
    own = {name: values[name] for name in READ}
    own |= {name: own[name][order] for name in ("pressure", "volume")}
    ends, angles = _section_ends(problem, values, parameters)
    tips = [part for end, turn in zip(ends, angles, strict=True) for part in (end[-2:], turn)]
    own |= {"section_end": ca.vertcat(*ends), "tip": ca.vertcat(*tips)}
    return own | {DELIVERED: _delivered(problem, values, parameters)}


def _section_ends(
    problem: Problem, values: Mapping[str, SX], parameters: SX
) -> tuple[list[SX], list[SX]]:
    """By rod: x and z of the end of every section (2 S,) [m], and the angle of the last [rad]."""
    rods = _rods(problem)
    if problem.equations.rod_form is RodForm.ARCS:
        return _arc_ends(problem, rods, values, parameters)
    edges = np.cumsum([0, *(rod.body.sections * rod.edges_per_section for rod in rods)]).tolist()
    places = ca.vertsplit(values["position"], [2 * edge for edge in edges])
    ends = []
    for rod, place in zip(rods, places, strict=True):
        step = 2 * rod.edges_per_section
        last = range(step - 2, place.numel(), step)
        ends.append(ca.vertcat(*(place[k : k + 2] for k in last)))
    return ends, [own[-1] for own in ca.vertsplit(values["angle"], edges)]


def _arc_ends(
    problem: Problem, rods: list[RodDiscretisation], values: Mapping[str, SX], parameters: SX
) -> tuple[list[SX], list[SX]]:
    """The same where no load bends the rods: every section is an arc."""
    joints = np.cumsum([0, *(rod.body.sections for rod in rods)]).tolist()
    names = parameter_names(problem.equations)
    endings = [f".{k + 1}" for k in range(len(rods))] if problem.body.members else [""]
    lengths = [parameters[names.index(f"section_length{end}")] for end in endings]
    parts = (
        ca.vertsplit(values[name], joints) for name in ("intrinsic_curvature", "intrinsic_stretch")
    )
    each = [_arcs(*own) for own in zip(lengths, *parts, strict=True)]
    return [ends for ends, _ in each], [angle for _, angle in each]


def _arcs(length: SX, curvatures: SX, stretches: SX) -> tuple[SX, SX]:
    """Ends of the arcs of a rod, one after the other, and the angle of the last."""
    x, z, angle = SX(0), SX(0), SX(0)
    ends = []
    for curvature, stretch in zip(ca.vertsplit(curvatures), ca.vertsplit(stretches), strict=True):
        half = curvature * length / 2
        chord = (1 + stretch) * length * _sinc(half)
        x += chord * ca.sin(angle + half)
        z += chord * ca.cos(angle + half)
        angle += 2 * half
        ends += [x, z]
    return ca.vertcat(*ends), angle


def delivering(problem: Problem) -> list[str]:
    """Inlets that alone feed what they feed, so that it holds what they have delivered."""
    driven = problem.equations.driven
    shared = [[n for n in part.inlets if n in driven] for part in problem.equations.fed]
    return [name for name in problem.inlets if name not in driven or [name] in shared]


def _delivered(problem: Problem, values: Mapping[str, SX], parameters: SX) -> SX:
    """Fluid that every inlet has delivered [m3 at ambient density]; see `DeliveredVolume`.

    0 of inlets that share what they feed.
    """
    equations = problem.equations
    own = equations.compiled(of.quantities).call([parameters])
    beyond = values["stored"] - own[FILLED_AMOUNTS]
    names = [*problem.bellows_along_tubes, *equations.storing]
    found = {name: -beyond[k] for k, name in enumerate(names) if name in problem.inlets}
    for part in equations.fed:
        for name in part.inlets:
            if name in equations.driven and name in delivering(problem):
                found[name] = ca.sum1(beyond[holding_columns(problem, part)])
    return ca.vertcat(SX(0, 1), *(found.get(name, SX(0)) for name in problem.inlets))


def _sinc(half: SX) -> SX:
    """sin(half)/half, with all derivatives at zero."""
    square, is_straight = half**2, ca.fabs(half) < STRAIGHT_TURN
    safe = ca.if_else(is_straight, 1.0, half)
    return SX(ca.if_else(is_straight, 1 - square / 6 + square**2 / 120, ca.sin(safe) / safe))
