"""Where a run leaves the model's assumptions: each once, at its worst place and time."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.physics import beam, gas, tube
from viscodesign.results.findings import Notice

LAMINAR_LIMIT = 2300.0
SLOW_SOUND_FRACTION = 0.3
"""Mach number from which a gas can no longer be taken as incompressible."""
CHOKING_FRACTION = 0.8
"""Mach number near which a gas in a tube goes no faster, whatever drives it."""
SMALL_STRETCH = 0.2
LARGE_STRETCH = 2.0
"""Length of a section, of that at rest, from which no linear law can be trusted: there a
neo-Hookean elastomer, whose force goes as s - 1/s^2 with its stretch s, pulls 1.7 times less
than its slope at rest says."""
LARGE_VOLUME = 7**0.5
"""Volume of a bellow, of that at rest, from which no linear law can be trusted: there even a thin
sphere of a neo-Hookean elastomer, whose pressure goes as 1/s - 1/s^7 with its stretch s, has
passed its peak, at s^6 = 7."""
SLIGHT = 0.02
"""Part of its floor by which a bellow may pass it: loads take volume too."""


@dataclass(frozen=True)
class Course:
    """What a stretch of a run met, for the checks: T times, B bellows, Q tubes, S sections."""

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


class Largest:
    """The largest of numbers that come stretch by stretch, with its time and its place."""

    def __init__(self) -> None:
        self.value = -np.inf
        self.time = 0.0
        self.which = 0
        self.columns = np.zeros(0)
        """The largest of every column (n,)."""

    def meet(self, time: np.ndarray, values: np.ndarray) -> None:
        """Take in rows (T, n) at times (T,)."""
        when, which = np.unravel_index(int(np.argmax(values)), values.shape)
        if values[when, which] > self.value:
            self.value = float(values[when, which])
            self.time, self.which = float(time[when]), int(which)
        highest = values.max(axis=0)
        self.columns = np.maximum(self.columns, highest) if self.columns.size else highest


class Extremes:
    """The worst of a whole run."""

    def __init__(self, quantities: SceneQuantities, active: frozenset[str]) -> None:
        self.quantities = quantities
        self.active = active
        self.suction = Largest()
        """Gauge pressure below the ambient [Pa]."""
        self.emptiness = Largest()
        """Volume of bellows, negative [m3]."""
        self.fullness = Largest()
        """Volume of bellows [m3]."""
        self.reynolds = Largest()
        self.mach = Largest()
        self.above_curve, self.below_curve = Largest(), Largest()
        """Pressure outside of what a curve was measured at [Pa]."""
        self.drawn = Largest()
        """Stretch of sections."""
        self.thinness = Largest()
        """Stretch of sections, negative."""
        self.inner_fibre = Largest()
        """Stretch of the inner side of a bend, negative [m]."""
        self.turn = Largest()
        """Of the whole rod [rad]."""

    def meet(self, course: Course) -> None:
        """Take in a stretch."""
        if not course.time.size:
            return
        self.suction.meet(course.time, -course.pressure)
        self.emptiness.meet(course.time, -course.volume)
        self.fullness.meet(course.time, course.volume)
        self._meet_flow(course)
        self._meet_strain(course)
        rows = measured_rows(self.quantities, self.active)
        if rows:
            low, high = measured_range(rows)
            self.above_curve.meet(course.time, course.pressure - high)
            self.below_curve.meet(course.time, low - course.pressure)

    def _meet_flow(self, course: Course) -> None:
        if not course.tubes:
            return
        fluid = self.quantities.scene.fluid
        radius = np.array([t.radius for t in self.quantities.graph.tubes])
        reynolds = tube.reynolds_number(course.flow, fluid.density, fluid.viscosity, radius)
        self.reynolds.meet(course.time, reynolds)
        if fluid.speed_of_sound is not None:
            speed = tube.mean_speed(course.flow, radius) / self._density_ratio(course)
            self.mach.meet(course.time, speed / fluid.speed_of_sound)

    def _density_ratio(self, course: Course) -> np.ndarray:
        """Density at the thinner end of each tube over that at ambient pressure (T, Q)."""
        if "gas_compressibility" not in self.active:
            return np.ones_like(course.flow)
        scene = self.quantities.scene
        exponent = scene.fluid.polytropic_exponent
        pressure = np.maximum(course.tube_pressure, -0.999 * scene.ambient_pressure)
        return np.asarray(gas.density_ratio(pressure, scene.ambient_pressure, exponent))

    def _meet_strain(self, course: Course) -> None:
        self.thinness.meet(course.time, -course.section_stretch)
        self.drawn.meet(course.time, course.section_stretch)
        length = course.section_stretch * self.quantities.body.section_length
        height = self.quantities.scene.actuator.height
        inner = beam.inner_fibre_stretch(length, height, course.section_turn)
        self.inner_fibre.meet(course.time, -inner)
        self.turn.meet(course.time, np.abs(course.section_turn.sum(axis=1))[:, None])


def measured_rows(
    quantities: SceneQuantities, active: frozenset[str]
) -> Sequence[Sequence[float]] | None:
    """Rows of the curve that a run uses, pressure first; None without one."""
    curve = quantities.scene.bellows.curve
    return curve.rows if curve is not None and "material_curve" in active else None


def measured_range(rows: Sequence[Sequence[float]]) -> tuple[float, float]:
    """Lowest and highest pressure of a curve, which may fall in between [Pa]."""
    pressures = [row[0] for row in rows]
    return min(pressures), max(pressures)


def course_notices(
    quantities: SceneQuantities, active: frozenset[str], courses: Iterable[Course]
) -> Iterator[Notice]:
    """What a run met beyond the model's assumptions, each once, at its worst place.

    ``courses``: the run, stretch by stretch.
    """
    met = Extremes(quantities, active)
    for course in courses:
        met.meet(course)
    if met.suction.value == -np.inf:
        return  # it ended before the first output
    yield from _bellow_extremes(met)
    yield from _swelling_notice(met)
    yield from _flow_notices(met)
    yield from _strain_notices(met)
    yield from _curve_notice(met)


def _bellow_extremes(met: Extremes) -> Iterator[Notice]:
    scene, law, bellows = met.quantities.scene, met.quantities.bellow, met.quantities.graph.bellows
    name, absolute = bellows[met.suction.which], scene.ambient_pressure - met.suction.value
    vapour = scene.fluid.vapour_pressure or 0.0
    if absolute <= vapour:
        yield Notice(
            "cavitation" if vapour else "below_vacuum",
            f"{name} falls to {absolute / 1e3:.4g} kPa absolute, below "
            + (f"the vapour pressure {vapour / 1e3:.3g} kPa" if vapour else "vacuum"),
            name,
            met.suction.time,
        )
    name, least = bellows[met.emptiness.which], -met.emptiness.value
    if least < law.floor_volume * (1 - SLIGHT):
        count = int(np.sum(-met.emptiness.columns < law.floor_volume * (1 - SLIGHT)))
        yield Notice(
            "negative_volume" if least <= 0.0 else "collapse",
            f"{count} of {len(bellows)} bellows fall below their floor of "
            f"{law.floor_volume / law.rest_volume:.3g} of the rest volume; {name} "
            f"goes to {least / law.rest_volume:.3g}",
            name,
            met.emptiness.time,
        )


def _swelling_notice(met: Extremes) -> Iterator[Notice]:
    if "material_curve" in met.active:
        return  # it was measured, or `extrapolated_curve` says where it was not
    share = met.fullness.value / met.quantities.bellow.rest_volume
    if share > LARGE_VOLUME:
        name = met.quantities.graph.bellows[met.fullness.which]
        yield Notice(
            "large_volume",
            f"{name} swells to {share:.3g} times its rest volume: beyond about "
            f"{LARGE_VOLUME:.2g} times an elastomer's wall gives way faster than linearly; give "
            "what was measured (bellows.curve)",
            name,
            met.fullness.time,
        )


def _flow_notices(met: Extremes) -> Iterator[Notice]:
    taken, fluid = met.active, met.quantities.scene.fluid
    tubes = [t.name for t in met.quantities.graph.tubes]
    if met.reynolds.value > LAMINAR_LIMIT and "flow_regime" not in taken:
        count = int(np.sum(met.reynolds.columns > LAMINAR_LIMIT))
        name = tubes[met.reynolds.which]
        yield Notice(
            "turbulent_flow",
            f"the Reynolds number passes {LAMINAR_LIMIT:.0f} in {count} of {len(tubes)} "
            f"tubes and reaches {met.reynolds.value:.4g} in {name}: "
            "slow viscous flow fails there",
            name,
            met.reynolds.time,
        )
    slow = SLOW_SOUND_FRACTION if "gas_compressibility" not in taken else 1.0
    if met.mach.value > min(slow, CHOKING_FRACTION):
        choked = met.mach.value > CHOKING_FRACTION
        name = tubes[met.mach.which]
        yield Notice(
            "choking" if choked else "fast_gas",
            f"the {'gas' if fluid.is_gas else 'fluid'} reaches Mach {met.mach.value:.3g} in "
            f"{name}: " + ("it would choke there" if choked else "incompressible flow fails there"),
            name,
            met.mach.time,
        )


def _curve_notice(met: Extremes) -> Iterator[Notice]:
    rows = measured_rows(met.quantities, met.active)
    is_above = met.above_curve.value >= met.below_curve.value
    beyond = met.above_curve if is_above else met.below_curve
    if not rows or beyond.value <= 0.0:
        return
    low, high = measured_range(rows)
    name = met.quantities.graph.bellows[beyond.which]
    reached = high + beyond.value if is_above else low - beyond.value
    yield Notice(
        "extrapolated_curve",
        f"{name} comes to {reached / 1e3:.4g} kPa gauge, "
        f"beyond the measured {low / 1e3:.4g} to {high / 1e3:.4g} kPa: the curve is taken as "
        "straight there",
        name,
        beyond.time,
    )


def _strain_notices(met: Extremes) -> Iterator[Notice]:
    if -met.thinness.value <= SMALL_STRETCH:
        where = f"section {met.thinness.which + 1}"
        yield Notice(
            "small_stretch",
            f"{where} is pressed to {-met.thinness.value:.3g} of its length",
            where,
            met.thinness.time,
        )
    if met.drawn.value > LARGE_STRETCH:
        where = f"section {met.drawn.which + 1}"
        yield Notice(
            "large_stretch",
            f"{where} is drawn to {met.drawn.value:.3g} times its length or more: no elastomer's "
            "law is linear so far; lower the loads or the pressure, or check "
            "actuator.youngs_modulus and actuator.extension_factor",
            where,
            met.drawn.time,
        )
    if -met.inner_fibre.value <= 0.0:
        where = f"section {met.inner_fibre.which + 1}"
        yield Notice(
            "self_contact",
            f"{where} bends so sharply that its inner side would be shorter than "
            "nothing: neighbouring sections touch",
            where,
            met.inner_fibre.time,
        )
    if met.turn.value > 2 * np.pi:
        yield Notice(
            "full_turn",
            f"the actuator turns through {met.turn.value:.3g} rad, more than once around: "
            "it would pass through itself in the plane",
            "rod",
            met.turn.time,
        )
