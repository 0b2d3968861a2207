"""Numbers that such actuators hardly have, parts that cannot fit, and what was probably meant."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace

from viscodesign.checks.changed_ranges import with_changes
from viscodesign.checks.fitting_parts import misfits
from viscodesign.checks.input_ranges import input_ranges
from viscodesign.checks.numbers_at_keys import numbers_at
from viscodesign.checks.plausible_ranges import RANGES, PlausibleRange
from viscodesign.checks.relative_ranges import reciprocal_ranges, relative_ranges
from viscodesign.checks.slight_inputs import slight_inputs
from viscodesign.checks.written_numbers import written
from viscodesign.errors import Fault
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Notice
from viscodesign.scene.pressure_levels import bare_levels
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import SpecPart
from viscodesign.storage.lru_cache import LruCache

_OTHER_UNITS: dict[float | str, str] = {"celsius": "degC", "degrees": "deg"}
BODY = ("actuator.", "bellows.", "sections.")
"""Keys of what others are compared with."""
_SURROUNDINGS = ("temperature", "ambient_pressure")
_OF_ANY = tuple(with_changes(RANGES))


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


LIMITS = PlausibilityLimits()


def plausibility_notices(scene: Scene) -> Iterator[Notice]:
    """One warning for each number or part that is hardly meant.

    A number that is warned about is left out of the comparisons with others.
    """
    if scene.members:
        yield from dict.fromkeys(_of_members(scene))
        return
    told = {found.key: (found, value) for found, value in _outside(scene)}
    for found, value in told.values():
        yield unusual(found, value)
    if not any(key.startswith(BODY) for key in told):
        yield from slight_inputs(scene)
    yield from (notice for notice in misfits(scene) if notice.where not in told)
    if not told.keys() & {"fluid.density", "fluid.gas_constant", *_SURROUNDINGS}:
        yield from _gas_density(scene)
    if not told.keys() & set(_SURROUNDINGS):
        yield from _bare_levels(scene)
    yield from _outputs(scene)


def _of_members(scene: Scene) -> Iterator[Notice]:
    """Warnings of each actuator that shares fluid, and of what drives all of them."""
    for name, own in scene.members.items():
        for notice in plausibility_notices(own):
            is_own = notice.where.startswith((*BODY, "network."))
            yield replace(notice, where=f"actuators.{name}.{notice.where}") if is_own else notice
    for found, value in _outside(scene):
        if found.key.startswith("input"):
            yield unusual(found, value)


def unusual(found: PlausibleRange, value: float) -> Notice:
    """The warning of a number outside of its range."""
    size = " in size" if found.either_sign else ""
    told = found.requirement or (
        f"is far {_side(found, value)} what {found.whose}, {written(found.low, found.unit)} to "
        f"{written(found.high, found.unit)}{size} ({found.source})"
    )
    words = f"{written(value, found.unit)} {told}{_meant(found, value)}"
    return Notice("implausible_value", words, found.key)


def impossible_values(scene: Scene) -> Iterator[Fault]:
    """A fault for each number that nothing has."""
    for found, value in _outside(scene):
        low, high = found.possible
        if not low <= value <= high:
            bound = (
                f"at least {written(low, found.unit)}"
                if value < low
                else (f"at most {written(high, found.unit)}")
            )
            given = written(value, found.unit)
            yield Fault(f"must be {bound}; got {given}{_meant(found, value)}", found.key)


def _outside(scene: Scene) -> tuple[tuple[PlausibleRange, float], ...]:
    """Given numbers outside of their usual ranges; beside others where these are sound."""
    return _latest.get(scene.digest, lambda: tuple(_found_outside(scene)))


_latest: LruCache[tuple[tuple[PlausibleRange, float], ...]] = LruCache(16)
"""Those of the latest scenes: whether they are possible is asked before what is unusual."""


def _found_outside(scene: Scene) -> Iterator[tuple[PlausibleRange, float]]:
    found: dict[str, tuple[PlausibleRange, float]] = {}
    for ranges in (_OF_ANY, relative_ranges, reciprocal_ranges):
        if any(key.startswith(BODY) for key in found):
            break
        own = with_changes(ranges(scene)) if callable(ranges) else ranges
        for one, value in outside(scene, own):
            found.setdefault(one.key, (one, value))
    for one, value in outside(scene, input_ranges(scene)):
        found.setdefault(one.key, (one, value))
    yield from found.values()


def outside(
    scene: SpecPart, ranges: Iterable[PlausibleRange]
) -> Iterator[tuple[PlausibleRange, float]]:
    """Numbers of a spec outside of ranges, each with that of its own key."""
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
            return f"; did you mean {written(meant, found.unit)}?"
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
            f"{written(scene.ambient_pressure, 'Pa')}; check density, gas_constant, temperature",
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
            f"{written(run.output_interval, 's')} in a run of {run.duration:g} s are "
            f"{run.outputs:,} outputs{often}; did you mean "
            f"{written(1e3 * run.output_interval, 's')}?",
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
                f"{written(highest, 'Pa')} is taken as gauge; if absolute was meant, write "
                f"'{written(highest, 'Pa')} abs' ({written(highest - ambient, 'Pa')} gauge)",
                "input" if scene.several_inputs is None else f"inputs.{name}",
            )
