"""Where a run leaves the model's assumptions: each once, at its worst place and time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from viscodesign.effects.conditions import Conditions
from viscodesign.physics import beam, gas, tube
from viscodesign.trajectory import Notice

LAMINAR_LIMIT = 2300.0
SLOW_SOUND_FRACTION = 0.3
"""Mach number from which a gas can no longer be taken as incompressible."""
CHOKING_FRACTION = 0.8
"""Mach number near which a gas in a tube goes no faster, whatever drives it."""
SMALL_STRETCH = 0.2
LARGE_VOLUME = 7**0.5
"""Volume of a bellow, of that at rest, from which no linear law can be trusted: there even a thin
sphere of a neo-Hookean elastomer, whose pressure goes as 1/s - 1/s^7 with its stretch s, has
passed its peak, at s^6 = 7."""
SLIGHT = 0.02
"""Part of its floor by which a bellow may pass it: loads take volume too."""


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
    tube_pressure: np.ndarray
    """(T, Q) lower gauge pressure of each tube's ends [Pa]."""
    section_stretch: np.ndarray
    """(T, S) smallest total stretch of each section [1]."""
    section_turn: np.ndarray
    """(T, S) angle that each section turns [rad]."""


def course_notices(conditions: Conditions, course: Course) -> Iterator[Notice]:
    """What a run met beyond the model's assumptions, each once, at its worst place."""
    if not course.time.size:
        return  # it ended before the first output
    yield from _bellow_extremes(conditions, course)
    yield from _swelling_notice(conditions, course)
    yield from _flow_notices(conditions, course)
    yield from _strain_notices(conditions, course)
    yield from _curve_notice(conditions, course)


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
    if least < law.floor_volume * (1 - SLIGHT):
        count = int(np.sum(course.volume.min(axis=0) < law.floor_volume * (1 - SLIGHT)))
        yield Notice(
            "negative_volume" if least <= 0.0 else "collapse",
            f"{count} of {len(course.bellows)} bellows fall below their floor of "
            f"{law.floor_volume / law.rest_volume:.3g} of the rest volume; {course.bellows[which]} "
            f"goes to {least / law.rest_volume:.3g}",
            course.bellows[which],
            float(course.time[when]),
        )


def _swelling_notice(conditions: Conditions, course: Course) -> Iterator[Notice]:
    if "material_curve" in conditions.taken:
        return  # it was measured, or `extrapolated_curve` says where it was not
    when, which = _worst(course.volume)
    share = course.volume[when, which] / conditions.bellow.rest_volume
    if share > LARGE_VOLUME:
        yield Notice(
            "large_volume",
            f"{course.bellows[which]} swells to {share:.3g} times its rest volume: beyond about "
            f"{LARGE_VOLUME:.2g} times an elastomer's wall gives way faster than linearly; give "
            "what was measured (bellows.curve)",
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
    if reynolds[when, which] > LAMINAR_LIMIT and "flow_regime" not in conditions.taken:
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
    speed = tube.mean_speed(course.flow, radius) / _density_ratio(conditions, course)
    mach = speed / fluid.speed_of_sound
    when, which = _worst(mach)
    worst = mach[when, which]
    slow = SLOW_SOUND_FRACTION if "gas_compressibility" not in conditions.taken else 1.0
    if worst > min(slow, CHOKING_FRACTION):
        choked = worst > CHOKING_FRACTION
        yield Notice(
            "choking" if choked else "fast_gas",
            f"the {'gas' if fluid.is_gas else 'fluid'} reaches Mach {worst:.3g} in "
            f"{course.tubes[which]}: "
            + ("it would choke there" if choked else "incompressible flow fails there"),
            course.tubes[which],
            float(course.time[when]),
        )


def _density_ratio(conditions: Conditions, course: Course) -> np.ndarray:
    """Density at the thinner end of each tube over that at ambient pressure (T, Q)."""
    if "gas_compressibility" not in conditions.taken:
        return np.ones_like(course.flow)
    scene = conditions.scene
    exponent = scene.fluid.polytropic_exponent
    pressure = np.maximum(course.tube_pressure, -0.999 * scene.ambient_pressure)
    return np.asarray(gas.density_ratio(pressure, scene.ambient_pressure, exponent))


def _curve_notice(conditions: Conditions, course: Course) -> Iterator[Notice]:
    curve = conditions.scene.bellows.curve
    if curve is None or curve.rows is None or "material_curve" not in conditions.taken:
        return
    low, high = (pick(row[0] for row in curve.rows) for pick in (min, max))
    beyond = np.maximum(course.pressure - high, low - course.pressure)
    when, which = _worst(beyond)
    if beyond[when, which] > 0.0:
        yield Notice(
            "extrapolated_curve",
            f"{course.bellows[which]} comes to {course.pressure[when, which] / 1e3:.4g} kPa gauge, "
            f"beyond the measured {low / 1e3:.4g} to {high / 1e3:.4g} kPa: the curve is taken as "
            "straight there",
            course.bellows[which],
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
