"""Specs that have no bounded solution, or none that double precision could hold.

They are refused before anything is solved, each with its key and its number.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from viscodesign.checks.extreme_numbers import extreme_numbers
from viscodesign.checks.plausibility import impossible_values, plausibility_notices
from viscodesign.checks.vacuum import vacuum_faults
from viscodesign.effects.catalogue import every_effect
from viscodesign.errors import Fault, SpecError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class NumericLimits:
    """Sizes beyond which no result would have a digit, or no mesh could follow the rod."""

    size: float = 1e250
    """Largest resistance of a tube [Pa s/m3], and largest inverse of one."""
    resistance_ratio: float = 1e13
    """Largest ratio of two tubes' resistances in a network that double precision still carries."""
    rod_turn: float = 400.0
    """Largest turn of the whole rod [rad]: every radian asks for an edge, twice as many to
    verify."""
    section_turn: float = 30.0
    """Largest turn of one section [rad], which would then lie five times around itself."""
    section_stretch: float = 100.0


LIMITS = NumericLimits()


def refuse_beyond_numbers(quantities: SceneQuantities) -> None:
    """Raise `SpecError` where sizes lie so far apart that no result would have a digit."""
    scene = quantities.scene
    in_vacuum = vacuum_faults("gauge_pressure", scene.gauge_pressure, scene.ambient_pressure)
    if extreme := [*extreme_numbers(scene), *in_vacuum]:
        raise SpecError(extreme)  # before anything is computed of them
    if faults := list(_numeric_faults(quantities)):
        raise SpecError(_with_likely_cause(faults, quantities))


def refuse_unsolvable(quantities: SceneQuantities, active: frozenset[str]) -> None:
    """Raise `SpecError` where a scene has no bounded solution with its effects.

    ``active``: names of the effects that are to be simulated.
    """
    for effect in every_effect(quantities).values():
        if faults := list(effect.refusals(quantities, active)):
            raise SpecError(_with_likely_cause(faults, quantities))


def _with_likely_cause(faults: list[Fault], quantities: SceneQuantities) -> list[Fault]:
    """Faults, and before them numbers that are hardly meant, from which they may follow."""
    told = {fault.key for fault in faults}
    causes = [
        Fault(notice.message, notice.where)
        for notice in plausibility_notices(quantities.scene)
        if notice.code == "implausible_value" and notice.where not in told
    ]
    return [*causes, *faults]


def _numeric_faults(quantities: SceneQuantities) -> Iterator[Fault]:
    """A fault for every number that lies too far from its neighbours."""
    if out_of_range := list(_sizes(quantities)):
        yield from out_of_range[:3]
        return
    if impossible := list(impossible_values(quantities.scene)):
        yield from impossible
        return
    if contrasts := list(_contrast(quantities)):
        yield from contrasts
        return
    for effect in every_effect(quantities).values():
        if effect.mode_in(quantities.scene.effects) != "off":
            yield from effect.numeric_faults(quantities)
    yield from _rod(quantities)
    yield from _work(quantities)


def _sizes(quantities: SceneQuantities) -> Iterator[Fault]:
    """Resistances that overflow, though none of their numbers is extreme."""
    for name, value in quantities.resistances.items():
        if not 1 / LIMITS.size < value < LIMITS.size:
            yield Fault(
                f"is {value:.3g} in SI units, outside the range of double precision",
                f"tube {name} (its resistance)",
            )


def _contrast(quantities: SceneQuantities) -> Iterator[Fault]:
    """Tubes of one network whose resistances lie too far apart."""
    for part in quantities.graph.components():
        own = {t.name: quantities.resistances[t.name] for t in part.tubes}
        if not own:
            continue
        least, most = min(own, key=own.__getitem__), max(own, key=own.__getitem__)
        ratio = own[most] / own[least]
        if ratio > LIMITS.resistance_ratio:
            yield Fault(
                f"tube {most} has {ratio:.2g} times the resistance of tube {least} in the same "
                f"network; double precision allows {LIMITS.resistance_ratio:g}. Remove the first, "
                "or merge the ends of the second",
                "network",
            )
            return


def _rod(quantities: SceneQuantities) -> Iterator[Fault]:
    """Strains that no mesh can follow."""
    yield from _turn(quantities)
    pressure = max(abs(quantities.lowest_pressure), quantities.pressure_range)
    stretch = 2 * pressure * float(np.max(np.abs(quantities.bellows.stretch_per_pressure)))
    if not stretch <= LIMITS.section_stretch:
        yield Fault(
            f"at the input's pressures a section stretches by {stretch:.3g} times its length; "
            "check the pressures, youngs_modulus and extension_per_pressure",
            "bellows.extension_per_pressure",
        )


def _turn(quantities: SceneQuantities) -> Iterator[Fault]:
    turn, sections = quantities.largest_turn, quantities.body.sections
    is_sound = turn <= LIMITS.section_turn
    if is_sound and turn * sections <= LIMITS.rod_turn:
        return
    several = f", and there are {sections}" if is_sound else ""
    limit = LIMITS.rod_turn if is_sound else LIMITS.section_turn
    yield Fault(
        f"at the input's pressures a section turns by {turn:.3g} rad{several}: more than the "
        f"{limit:g} rad that can be resolved; check the pressures, youngs_modulus and "
        "angle_per_pressure",
        "bellows.angle_per_pressure",
    )


def _work(quantities: SceneQuantities) -> Iterator[Fault]:
    scene = quantities.scene
    duration, most = scene.run.duration, scene.run.max_steps
    corners = sum(len(source.corners(duration)) for source in scene.inputs.values())
    if corners > most:
        yield Fault(
            f"the inputs have {corners} corners in {duration:g} s, each of which takes at least "
            f"one step: more than the {most} allowed. Raise run.max_steps, or shorten "
            f"run.duration to less than {duration * most / corners:.3g} s",
            "run.max_steps",
        )
