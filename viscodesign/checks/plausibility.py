"""Numbers that such actuators hardly have, parts that cannot fit, and what was probably meant."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace

from viscodesign.checks.input_ranges import input_ranges
from viscodesign.checks.numbers_at_keys import numbers_at
from viscodesign.checks.plausible_ranges import RANGES, PlausibleRange
from viscodesign.checks.relative_ranges import reciprocal_ranges, relative_ranges
from viscodesign.checks.slight_inputs import slight_inputs
from viscodesign.errors import Fault
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Notice
from viscodesign.scene.pressure_levels import bare_levels
from viscodesign.scene.scene import Scene

_PREFIXES = {-9: "n", -6: "u", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
_PREFIXED_UNITS = ("m", "Pa", "s")
_OTHER_UNITS: dict[float | str, str] = {"celsius": "degC", "degrees": "deg"}
BODY = ("actuator.", "bellows.")
"""Keys of what others are compared with."""
_SURROUNDINGS = ("temperature", "ambient_pressure")
_FINEST = {"m": -6, "Pa": -3, "s": -6}
_COARSEST = {"m": 6, "Pa": 9, "s": 0}


@dataclass(frozen=True)
class PlausibilityLimits:
    """From where a relation of numbers is worth a warning."""

    outputs: int = 1_000_000
    """Rows of trajectory.csv, some 100 bytes each."""
    outputs_of_swing: int = 10_000
    """Rows in which the input swings once, where there are more than ten times as many."""
    gas_density_ratio: float = 1.5
    """Largest ratio of a gas's density to ambient pressure over gas constant and temperature, or
    inverse."""
    fit: float = 1.001
    """Share of the space at hand, with a margin for rounding."""


LIMITS = PlausibilityLimits()


def plausibility_notices(scene: Scene) -> Iterator[Notice]:
    """One warning for each number or part that is hardly meant.

    A number that is warned about is left out of the comparisons with others.
    """
    outside = {found.key: (found, value) for found, value in _outside(scene)}
    for found, value in outside.values():
        size = " in size" if found.either_sign else ""
        yield Notice(
            "implausible_value",
            f"{_written(value, found.unit)} is far {_side(found, value)} what such actuators have, "
            f"{_written(found.low, found.unit)} to {_written(found.high, found.unit)}{size} "
            f"({found.source}){_meant(found, value)}",
            found.key,
        )
    if not any(key.startswith(BODY) for key in outside):
        yield from slight_inputs(scene)
    yield from (notice for notice in _misfits(scene) if notice.where not in outside)
    if not outside.keys() & {"fluid.density", "fluid.gas_constant", *_SURROUNDINGS}:
        yield from _gas_density(scene)
    if not outside.keys() & set(_SURROUNDINGS):
        yield from _bare_levels(scene)
    yield from _outputs(scene)


def impossible_values(scene: Scene) -> Iterator[Fault]:
    """A fault for each number that nothing has."""
    for found, value in _outside(scene):
        low, high = found.possible
        if not low <= value <= high:
            bound = (
                f"at least {_written(low, found.unit)}"
                if value < low
                else (f"at most {_written(high, found.unit)}")
            )
            given = _written(value, found.unit)
            yield Fault(f"must be {bound}; got {given}{_meant(found, value)}", found.key)


def _outside(scene: Scene) -> Iterator[tuple[PlausibleRange, float]]:
    """Given numbers outside of their usual ranges; beside others where these are sound."""
    found: dict[str, tuple[PlausibleRange, float]] = {}
    for ranges in (RANGES, relative_ranges, reciprocal_ranges):
        if any(key.startswith(BODY) for key in found):
            break
        for one, value in _beyond(scene, ranges(scene) if callable(ranges) else ranges):
            found.setdefault(one.key, (one, value))
    for one, value in _beyond(scene, input_ranges(scene)):
        found.setdefault(one.key, (one, value))
    yield from found.values()


def _beyond(
    scene: Scene, ranges: Iterable[PlausibleRange]
) -> Iterator[tuple[PlausibleRange, float]]:
    for found in ranges:
        for key, value in numbers_at(scene, found.key):
            if not found.holds(value):
                yield replace(found, key=key), value


def _side(found: PlausibleRange, value: float) -> str:
    is_signed = found.either_sign and value < 0.0
    return "above" if (-value if is_signed else value) > found.high else "below"


def _meant(found: PlausibleRange, value: float) -> str:
    """The likely slip, as a question."""
    for slip in found.slips:
        meant = _slipped(value, slip)
        if found.holds(meant):
            if slip in _OTHER_UNITS:
                return f"; did you mean {value:g} {_OTHER_UNITS[slip]}?"
            return f"; did you mean {_written(meant, found.unit)}?"
    return ""


def _slipped(value: float, slip: float | str) -> float:
    if slip == "celsius":
        return value + 273.15
    if slip == "degrees":
        return math.radians(value)
    if slip == "exponent":  # 1.79e5 for 1.79e-5
        exponent = math.floor(math.log10(value))
        return value * 10.0 ** (-2 * exponent)
    return value * float(slip)


def _written(value: float, unit: str) -> str:
    """A number in the prefix that leaves one to three digits before the point."""
    if unit not in _PREFIXED_UNITS or not value:
        return f"{value:.4g} {unit}".rstrip()
    exponent = 3 * math.floor(math.log10(abs(value) * (1 + 1e-12)) / 3)
    exponent = min(max(exponent, _FINEST[unit]), _COARSEST[unit])
    return f"{value / 10.0**exponent:.4g} {_PREFIXES[exponent]}{unit}"


def _misfits(scene: Scene) -> Iterator[Notice]:
    """Parts that are larger than the space that they lie in."""
    body, bellows = scene.actuator, scene.bellows
    pairs = bellows.count // 2
    rows = (
        ("bellows.height", bellows.height, 2, "a pair", "actuator.height", body.height),
        ("bellows.length", bellows.length, 1, "a bellow", "actuator.width", body.width),
        (
            "bellows.width",
            bellows.width,
            pairs,
            f"a row of {pairs}",
            "actuator.length",
            body.length,
        ),
    )
    for key, size, count, words, outer, space in rows:
        if count * size > LIMITS.fit * space:
            needed, free = _written(count * size, "m"), _written(space, "m")
            message = f"{words} needs {needed} and cannot lie within {outer}, {free}"
            yield Notice("does_not_fit", f"{_written(size, 'm')}: {message}", key)
    opening = min(bellows.height, bellows.width)
    widest = max(scene.graph.tubes, key=lambda tube: tube.radius)
    if 2 * widest.radius > LIMITS.fit * opening:
        yield Notice(
            "does_not_fit",
            f"tube {widest.name} is {_written(2 * widest.radius, 'm')} wide, more than the "
            f"bellows' smaller side of {_written(opening, 'm')}; is it a diameter, or in another "
            "unit?",
            "network.tube_radius",
        )


def _gas_density(scene: Scene) -> Iterator[Notice]:
    """An own gas whose density is not that of its pressure and temperature."""
    fluid = scene.fluid_choice
    if fluid.density is None or fluid.gas_constant is None:
        return
    ideal = scene.ambient_pressure / (fluid.gas_constant * scene.temperature)
    ratio = fluid.density / ideal
    if not 1 / LIMITS.gas_density_ratio < ratio < LIMITS.gas_density_ratio:
        yield Notice(
            "gas_density",
            f"{fluid.density:.4g} kg/m^3 is {ratio:.3g} times the {ideal:.4g} kg/m^3 that a gas of "
            f"{fluid.gas_constant:.4g} J/(kg*K) has at {scene.temperature:.4g} K and "
            f"{_written(scene.ambient_pressure, 'Pa')}; check density, gas_constant, temperature",
            "fluid.density",
        )


def _outputs(scene: Scene) -> Iterator[Notice]:
    run = scene.run
    swings = (source.swing_time_within(run.duration) for source in scene.inputs.values())
    per_swing = min(swings, default=0.0) / run.output_interval
    is_dense = LIMITS.outputs_of_swing < per_swing < math.inf
    if run.output_times is None and run.outputs >= LIMITS.outputs / (10 if is_dense else 1):
        often = f", {per_swing:,.0f} in one swing of the input" if is_dense else ""
        yield Notice(
            "many_outputs",
            f"{_written(run.output_interval, 's')} in a run of {run.duration:g} s are "
            f"{run.outputs:,} outputs{often}; did you mean "
            f"{_written(1e3 * run.output_interval, 's')}?",
            "run.output_interval",
        )


def _bare_levels(scene: Scene) -> Iterator[Notice]:
    """Levels above ambient that look like absolute pressures of the surroundings."""
    ambient = scene.ambient_pressure
    for name, source in scene.inputs.items():
        bare = [level for _, level in bare_levels(source) if level]
        if bare and min(bare) > 0.5 * ambient and max(bare) > ambient:
            highest = max(bare)
            yield Notice(
                "gauge_or_absolute",
                f"{_written(highest, 'Pa')} is taken as gauge; if absolute was meant, write "
                f"'{_written(highest, 'Pa')} abs' ({_written(highest - ambient, 'Pa')} gauge)",
                "input" if scene.several_inputs is None else f"inputs.{name}",
            )
