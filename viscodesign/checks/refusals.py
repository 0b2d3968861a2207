"""Specs that have no bounded solution, or none that double precision could hold.

They are refused before anything is solved, each with its key and its number.
"""

from __future__ import annotations

from collections.abc import Iterator

from viscodesign.errors import Fault, SpecError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.network_equations import SNAPS_WITHOUT_FLOW, two_pressures
from viscodesign.physics import bellow
from viscodesign.scene.bellows import snaps

MOST_CONTRAST = 1e13
"""Ratio of two tubes' resistances in one network that double precision still carries."""
MOST_TIMES = 1e14
"""Ratio of two times that double precision still carries."""
MOST_LOAD = 1e5
"""Force over EI/l2 beyond which a rod would turn within a thousandth of its length."""
MOST_TURN = 400.0
"""Radians, over the whole rod: every one of them asks for an edge, twice as many to verify."""
MOST_SECTION_TURN = 30.0
"""Radians, of one section, which would then lie five times around itself."""
MOST_STRETCH = 100.0


def refuse_beyond_numbers(quantities: SceneQuantities) -> None:
    """Raise `SpecError` where sizes lie so far apart that no result would have a digit."""
    faults = [Fault(message, key) for key, message in _beyond(quantities)]
    if faults:
        raise SpecError(faults)


def refuse_unsolvable(quantities: SceneQuantities, active: frozenset[str]) -> None:
    """Raise `SpecError` for what asks for two pressures at once, and for negative compliances.

    ``active``: names of the effects that are to be simulated.

    The former are a curve that snaps and inlets of one network; the latter come where
    feedback leaves a held section no compliance that is positive.
    """
    at_once = "pressure_distribution" not in active
    if at_once and "material_curve" in active and snaps(quantities.scene.bellows):
        raise SpecError.plain(SNAPS_WITHOUT_FLOW)
    for component in quantities.graph.components() if at_once else []:
        inlets = [name for name in component.inlets if name not in quantities.barrels]
        if len(inlets) > 1:
            raise two_pressures(inlets)
    if "feedback" not in active:
        return
    for name, key, value in _blocked(quantities):
        if value <= 0.0:
            raise SpecError.plain(
                f"{key}: with the strain of a section held, its bellows have a negative "
                f"compliance in {name} ({value:.4g} m3/Pa, of {quantities.bellow.compliance:.4g} "
                f"m3/Pa free): pressures would run away and the model is ill posed. "
                f"Lower {key}, or switch effects.feedback off."
            )


def _blocked(quantities: SceneQuantities) -> list[tuple[str, str, float]]:
    law, body, b = quantities.bellow, quantities.body, quantities.scene.bellows
    ways = (
        ("extension", "force", law.stretch_per_pressure, body.extension_stiffness),
        ("bending", "moment", law.curvature_per_pressure, body.bending_stiffness),
    )
    areas = {"force": b.area_per_force, "moment": b.area_per_moment}
    return [
        (
            name,
            f"bellows.area_per_{resultant}",
            bellow.blocked_compliance(
                law.compliance, law.length * areas[resultant], strain, stiffness
            ),
        )
        for name, resultant, strain, stiffness in ways
    ]


def _beyond(quantities: SceneQuantities) -> Iterator[tuple[str, str]]:
    """Key and message of every number that lies too far from its neighbours."""
    sizes = {
        "actuator (its bending stiffness)": quantities.body.bending_stiffness,
        "actuator (its stiffness along the axis)": quantities.body.extension_stiffness,
        "actuator (its mass per length)": quantities.body.mass_per_length,
        "actuator.length (its fourth power)": quantities.body.length**4,
        "bellows (their compliance)": quantities.bellow.compliance,
        "bellows (their volume)": quantities.bellow.rest_volume,
        **{f"tube {name} (its resistance)": r for name, r in quantities.resistances.items()},
    }
    lost = [(key, value) for key, value in sizes.items() if not 1e-250 < value < 1e250]
    for key, value in lost[:3]:
        yield key, f"comes to {value:.3g} in SI units, beyond the range of numbers"
    if lost:
        return
    of_network = list(_network(quantities))
    yield from of_network
    if not of_network:
        # The times of a network beyond numbers are none to compare a rod's with.
        yield from _rod(quantities)
        yield from _work(quantities)


def _network(quantities: SceneQuantities) -> Iterator[tuple[str, str]]:
    scene, resistances = quantities.scene, quantities.resistances
    for part in quantities.graph.components():
        own = {t.name: resistances[t.name] for t in part.tubes}
        if not own:
            continue
        least, most = min(own, key=own.__getitem__), max(own, key=own.__getitem__)
        if own[most] / own[least] > MOST_CONTRAST:
            yield (
                "network",
                f"tube {most} resists {own[most] / own[least]:.2g} times as much as tube {least} "
                f"in the same network, beyond the {MOST_CONTRAST:g} that double precision "
                "carries; leave the one out, or join the ends of the other",
            )
            return
    if not resistances or scene.effects.mode("pressure_distribution") == "off":
        return
    times = [r * quantities.bellow.compliance for r in resistances.values()]
    for time in (min(times), max(times)):
        share = time / scene.run.duration
        if not 1 / MOST_TIMES < share < MOST_TIMES:
            slow = "lower fluid.viscosity, or lengthen run.duration"
            fast = "use effects.pressure_distribution: off"
            yield (
                "fluid.viscosity",
                f"a bellow fills in {time:.3g} s, {share:.2g} of run.duration: beyond what "
                f"double precision carries; {slow if share > 1 else fast}",
            )
            return


def _rod(quantities: SceneQuantities) -> Iterator[tuple[str, str]]:
    scene, turn, unit = quantities.scene, quantities.largest_turn, quantities.bending_force
    pressure = max(abs(quantities.lowest_pressure), quantities.pressure_range)
    is_sound = turn <= MOST_SECTION_TURN
    if not (is_sound and turn * quantities.body.sections <= MOST_TURN):
        sections = f", and there are {quantities.body.sections}" if is_sound else ""
        limit = MOST_TURN if is_sound else MOST_SECTION_TURN
        yield (
            "bellows.angle_per_pressure",
            f"at the input's pressures a section turns by {turn:.3g} rad{sections}: more than the "
            f"{limit:g} rad that can be followed; check the pressures, youngs_modulus and "
            "angle_per_pressure",
        )
    stretch = 2 * pressure * abs(quantities.bellow.stretch_per_pressure)
    if not stretch <= MOST_STRETCH:
        yield (
            "bellows.extension_per_pressure",
            f"at the input's pressures a section stretches {stretch:.3g} times its length; check "
            "the pressures, youngs_modulus and extension_per_pressure",
        )
    loads = {"loads.tip_force": quantities.tip_force, "loads.gravity": quantities.weight}
    for key, load in loads.items():
        if not load <= MOST_LOAD * unit:
            yield (
                key,
                f"{load:.3g} N is {load / unit:.3g} times EI/l2 = {unit:.3g} N; a rod so loaded "
                f"turns within less than can be followed (at most {MOST_LOAD:g} times)",
            )
    memory = scene.actuator.damping_time / scene.run.duration
    if not memory < MOST_TIMES:
        yield (
            "actuator.damping_time",
            f"{scene.actuator.damping_time:.3g} s is {memory:.2g} of run.duration: beyond what "
            "double precision carries",
        )
    ratio = quantities.scales.t_s / scene.run.duration
    if scene.effects.mode("inertia") != "off" and not 1 / MOST_TIMES < ratio < MOST_TIMES:
        yield (
            "actuator.density",
            f"the rod swings in {quantities.scales.t_s:.3g} s, {ratio:.2g} of run.duration: "
            "beyond what double precision carries; use effects.inertia: off",
        )


def _work(quantities: SceneQuantities) -> Iterator[tuple[str, str]]:
    scene = quantities.scene
    duration, most = scene.run.duration, scene.run.max_steps
    corners = sum(len(source.corners(duration)) for source in scene.inputs.values())
    if corners > most:
        yield (
            "run.max_steps",
            f"the inputs have {corners} corners in {duration:g} s, and every one takes a step or "
            f"more: beyond the {most} that are allowed. Raise run.max_steps, or shorten "
            f"run.duration to less than {duration * most / corners:.3g} s",
        )
