"""Where the model's assumptions end: what the numbers of a scene or a run give away.

Nothing here changes a result. What a scene's numbers show before solving, and what
a run met on its way, is reported with its number; coefficients for which the model
has no bounded solution are refused.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from viscodesign.effects.conditions import Conditions
from viscodesign.errors import SpecError
from viscodesign.physics import beam, bellow, tube
from viscodesign.trajectory import Notice

LAMINAR_LIMIT = 2300.0
SLOW_SOUND_FRACTION = 0.3
"""Mach number from which a gas can no longer be taken as incompressible."""
SMALL_STRETCH = 0.2
STEEP_RECIPROCITY = 1.05


@dataclass(frozen=True)
class Course:
    """What a run met, for the checks: T times, B bellows, Q tubes, S sections."""

    time: np.ndarray
    bellows: tuple[str, ...]
    pressure: np.ndarray
    """(T, B) gauge [Pa]."""
    volume: np.ndarray
    """(T, B) [m3]."""
    tubes: tuple[str, ...]
    flow: np.ndarray
    """(T, Q) [m3/s]."""
    section_stretch: np.ndarray
    """(T, S) smallest total stretch of each section [1]."""
    section_turn: np.ndarray
    """(T, S) angle that each section turns [rad]."""


def scene_notices(conditions: Conditions) -> Iterator[Notice]:
    """What can be said before anything is solved."""
    yield from _pressure_notices(conditions)
    yield from _gas_notice(conditions)
    yield from _reciprocity_notices(conditions)
    yield from _network_notices(conditions)


def refuse_unsolvable(conditions: Conditions) -> None:
    """Raise `SpecError` where feedback leaves a held section no positive compliance."""
    if conditions.scene.effects.mode("feedback") == "off":
        return
    for name, key, value in _blocked(conditions):
        if value <= 0.0:
            raise SpecError.plain(
                f"{key}: with the strain of a section held, its bellows have a negative "
                f"compliance in {name} ({value:.4g} m3/Pa, of {conditions.bellow.compliance:.4g} "
                f"m3/Pa free): pressures would run away and the model is ill posed. "
                f"Lower {key}, or switch effects.feedback off."
            )


def _blocked(conditions: Conditions) -> list[tuple[str, str, float]]:
    law, body, b = conditions.bellow, conditions.body, conditions.scene.bellows
    return [
        (
            "extension",
            "bellows.area_per_force",
            bellow.blocked_compliance(
                law.compliance,
                law.length * b.area_per_force,
                law.stretch_per_pressure,
                body.extension_stiffness,
            ),
        ),
        (
            "bending",
            "bellows.area_per_moment",
            bellow.blocked_compliance(
                law.compliance,
                law.length * b.area_per_moment,
                law.curvature_per_pressure,
                body.bending_stiffness,
            ),
        ),
    ]


def _pressure_notices(conditions: Conditions) -> Iterator[Notice]:
    scene, law = conditions.scene, conditions.bellow
    low = conditions.lowest_pressure
    absolute = scene.ambient_pressure + low
    if absolute <= 0.0:
        yield Notice(
            "below_vacuum",
            f"the lowest inlet pressure, {low / 1e3:.4g} kPa gauge, is {absolute / 1e3:.4g} kPa "
            "absolute: below vacuum, which no pump reaches",
            "input",
        )
    elif scene.fluid.vapour_pressure is not None and absolute < scene.fluid.vapour_pressure:
        yield Notice(
            "cavitation",
            f"the lowest inlet pressure, {low / 1e3:.4g} kPa gauge, is {absolute / 1e3:.4g} kPa "
            f"absolute, below the vapour pressure of {scene.fluid.name} "
            f"({scene.fluid.vapour_pressure / 1e3:.3g} kPa)",
            "input",
        )
    elif absolute < 0.05 * scene.ambient_pressure:
        yield Notice(
            "near_vacuum",
            f"the lowest inlet pressure, {low / 1e3:.4g} kPa gauge, is {absolute / 1e3:.3g} kPa "
            "absolute: near vacuum",
            "input",
        )
    lowest_volume = law.rest_volume + law.compliance * low
    if lowest_volume < law.floor_volume:
        empty = -law.rest_volume / law.compliance
        yield Notice(
            "negative_volume" if lowest_volume <= 0.0 else "collapse",
            f"at {low / 1e3:.4g} kPa gauge the linear law gives a bellow of "
            f"{lowest_volume / law.rest_volume:.3g} of its rest volume (none is left below "
            f"{empty / 1e3:.4g} kPa gauge); a real bellow collapses at about "
            f"{law.floor_volume / law.rest_volume:.3g}",
            "bellows",
        )


def _gas_notice(conditions: Conditions) -> Iterator[Notice]:
    scene, law = conditions.scene, conditions.bellow
    if not scene.fluid.is_gas:
        return
    share = law.rest_volume / (scene.ambient_pressure + scene.gauge_pressure) / law.compliance
    if share > 0.1 * 5 * scene.accuracy:
        yield Notice(
            "gas_compressibility",
            f"{scene.fluid.name} is taken as incompressible, but the gas in a bellow stores "
            f"V_0/p_abs = {100 * share:.3g} % of what the bellow's wall stores",
            "fluid",
        )


def _reciprocity_notices(conditions: Conditions) -> Iterator[Notice]:
    """Volume per resultant against strain per pressure: equal in a reciprocal coupling."""
    if conditions.scene.effects.mode("feedback") == "off":
        return
    law, b = conditions.bellow, conditions.scene.bellows
    section = conditions.body.section_length
    for strain, resultant, found in (
        (law.curvature_per_pressure * section, "moment", law.length * b.area_per_moment),
        (law.stretch_per_pressure * section, "force", law.length * b.area_per_force),
    ):
        if found * strain < 0.0:
            yield Notice(
                "not_passive",
                f"volume per {resultant} and strain per pressure have opposite signs "
                f"({found:.3g} and {strain:.3g}): the coupling creates energy",
                "bellows",
            )
        elif found and not 1 / STEEP_RECIPROCITY < strain / found < STEEP_RECIPROCITY:
            yield Notice(
                "not_reciprocal",
                f"volume per {resultant} is {found:.3g}, strain per pressure {strain:.3g}, a "
                f"factor of {strain / found:.3g}: an elastic body has them equal, so the coupling "
                "does work of its own",
                "bellows",
            )


def _network_notices(conditions: Conditions) -> Iterator[Notice]:
    for component in conditions.graph.components():
        if not component.fed and component.bellows:
            yield Notice(
                "sealed_island",
                f"no inlet reaches {', '.join(component.bellows)}: what they hold stays in them",
                "network",
            )


def course_notices(conditions: Conditions, course: Course) -> Iterator[Notice]:
    """What a run met beyond the model's assumptions, each once, at its worst place."""
    yield from _bellow_extremes(conditions, course)
    yield from _flow_notices(conditions, course)
    yield from _strain_notices(conditions, course)


def _bellow_extremes(conditions: Conditions, course: Course) -> Iterator[Notice]:
    scene, law = conditions.scene, conditions.bellow
    when, which = _worst(-course.pressure)
    absolute = scene.ambient_pressure + course.pressure[when, which]
    vapour = scene.fluid.vapour_pressure or 0.0
    if absolute <= vapour:
        yield Notice(
            "cavitation" if vapour else "below_vacuum",
            f"{course.bellows[which]} falls to {absolute / 1e3:.4g} kPa absolute, below "
            + (f"the vapour pressure {vapour / 1e3:.3g} kPa" if vapour else "vacuum"),
            course.bellows[which],
            float(course.time[when]),
        )
    when, which = _worst(-course.volume)
    least = course.volume[when, which]
    if least < law.floor_volume:
        count = int(np.sum(course.volume.min(axis=0) < law.floor_volume))
        yield Notice(
            "negative_volume" if least <= 0.0 else "collapse",
            f"{count} of {len(course.bellows)} bellows fall below their floor of "
            f"{law.floor_volume / law.rest_volume:.3g} of the rest volume; {course.bellows[which]} "
            f"goes to {least / law.rest_volume:.3g} by the linear law",
            course.bellows[which],
            float(course.time[when]),
        )


def _flow_notices(conditions: Conditions, course: Course) -> Iterator[Notice]:
    if not course.tubes:
        return
    fluid = conditions.scene.fluid
    radius = np.array([t.radius for t in conditions.graph.tubes])
    reynolds = tube.reynolds_number(course.flow, fluid.density, fluid.viscosity, radius)
    when, which = _worst(reynolds)
    if reynolds[when, which] > LAMINAR_LIMIT:
        count = int(np.sum(reynolds.max(axis=0) > LAMINAR_LIMIT))
        yield Notice(
            "turbulent_flow",
            f"the Reynolds number passes {LAMINAR_LIMIT:.0f} in {count} of {len(course.tubes)} "
            f"tubes and reaches {reynolds[when, which]:.4g} in {course.tubes[which]}: "
            "slow viscous flow fails there",
            course.tubes[which],
            float(course.time[when]),
        )
    if fluid.speed_of_sound is None:
        return
    mach = tube.mean_speed(course.flow, radius) / fluid.speed_of_sound
    when, which = _worst(mach)
    if mach[when, which] > SLOW_SOUND_FRACTION:
        yield Notice(
            "fast_gas",
            f"the gas reaches Mach {mach[when, which]:.3g} in {course.tubes[which]}: "
            "incompressible flow fails there",
            course.tubes[which],
            float(course.time[when]),
        )


def _strain_notices(conditions: Conditions, course: Course) -> Iterator[Notice]:
    when, which = _worst(-course.section_stretch)
    if course.section_stretch[when, which] <= SMALL_STRETCH:
        yield Notice(
            "small_stretch",
            f"section {which + 1} is pressed to {course.section_stretch[when, which]:.3g} "
            "of its length",
            f"section {which + 1}",
            float(course.time[when]),
        )
    body, height = conditions.body, conditions.scene.actuator.height
    length = course.section_stretch * body.section_length
    inner = beam.inner_fibre_stretch(length, height, course.section_turn)
    when, which = _worst(-inner)
    if inner[when, which] <= 0.0:
        yield Notice(
            "self_contact",
            f"section {which + 1} bends so sharply that its inner side would be shorter than "
            "nothing: neighbouring sections touch",
            f"section {which + 1}",
            float(course.time[when]),
        )
    total = np.abs(course.section_turn.sum(axis=1))
    if total.max() > 2 * np.pi:
        when = int(np.argmax(total))
        yield Notice(
            "full_turn",
            f"the actuator turns through {total[when]:.3g} rad, more than once around: "
            "it would pass through itself in the plane",
            "rod",
            float(course.time[when]),
        )


def _worst(values: np.ndarray) -> tuple[int, int]:
    """Indices (time, place) of the largest value."""
    when, which = np.unravel_index(int(np.argmax(values)), values.shape)
    return int(when), int(which)
