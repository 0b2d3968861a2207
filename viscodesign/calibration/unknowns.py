"""The unknown numbers of a fit, and the ranges in which they are sought."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from viscodesign.calibration.driving import RecordedDrive
from viscodesign.calibration.misfit import Unknown
from viscodesign.calibration.run_model import RunModel
from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.compiled.free_number import FreeNumber
from viscodesign.errors import Fault, SpecError
from viscodesign.scene.scene import Scene
from viscodesign.studies.least_squares import NumberRanges

DEFAULT_KEYS = (
    "bellows.area_per_pressure",
    "bellows.angle_per_pressure",
    "bellows.extension_per_pressure",
    "bellows.area_per_force",
    "bellows.area_per_moment",
    "fluid.viscosity",
    "actuator.damping_time",
)
"""What is fitted unless keys are named."""
FREE_RATIO = 30.0
"""Largest ratio of a free number to that of the spec."""
INPUT_RATIO = 5.0
"""The same of an input's number, which has been fitted to its pressure already."""
INPUT_SPAN = {"Pa": 1e5, "s": 10.0}
"""Least distance that such a number may go which can be negative, by its unit."""
CLOCK_SHARE = 0.5
"""Longest clock offset, as a part of a recording."""


def scene_unknowns(scene: Scene, keys: Sequence[str]) -> list[Unknown]:
    """The free numbers of a scene. Raises `SpecError` for keys that cannot be free, or are 0."""
    numbers = FreeKeys(scene, keys).numbers
    faults = [
        Fault("is 0, and a fit cannot start there; give a first guess with --set", own.name)
        for own in numbers
        if not own.value
    ]
    if faults:
        raise SpecError(faults)
    return [Unknown(own.name, own.value, own.unit, _is_log(own)) for own in numbers]


def run_unknowns(model: RunModel, run: int) -> Iterator[Unknown]:
    """Free numbers of one recording only: those of its inputs, and its clock offset if free."""
    drive: RecordedDrive = model.drive
    numbers = FreeKeys(drive.scene, drive.free).numbers if drive.free else []
    for own in numbers:
        yield Unknown(own.name, own.value, own.unit, _is_log(own), run)
    if model.clock_is_free:
        yield Unknown("clock", 0.0, "s", False, run, is_clock=True)


def _is_log(number: FreeNumber) -> bool:
    return number.value > 0.0 and number.bounds.low >= 0.0


def ranges_of(
    models: Sequence[RunModel], unknowns: Sequence[Unknown], *, keeps_signs: bool = False
) -> NumberRanges:
    """Where every unknown is sought, within what a spec allows.

    ``keeps_signs``: the scene's own numbers with the signs that the spec has.
    """
    bounds: dict[tuple[int | None, str], FreeNumber] = {}
    for run, model in enumerate(models):
        keys = FreeKeys(model.drive.scene, model.function.names)
        for own in keys.numbers:
            bounds[run, own.name] = own
            bounds.setdefault((None, own.name), own)
    ends = [_ends(own, bounds.get((own.run, own.name)), models) for own in unknowns]
    if keeps_signs:
        ends = [_with_sign(own, *pair) for own, pair in zip(unknowns, ends, strict=True)]
    low, high = np.array(ends).T
    return NumberRanges.of(low, high)


def _with_sign(unknown: Unknown, low: float, high: float) -> tuple[float, float]:
    if unknown.run is not None or unknown.is_log:
        return low, high
    least = unknown.start / FREE_RATIO
    return (max(low, least), high) if least > 0.0 else (low, min(high, least))


def _ends(
    unknown: Unknown, number: FreeNumber | None, models: Sequence[RunModel]
) -> tuple[float, float]:
    if unknown.is_clock or number is None:
        time = models[unknown.run or 0].recording.time
        longest = CLOCK_SHARE * float(time[-1] - time[0])
        return -longest, longest
    ratio = FREE_RATIO if unknown.run is None else INPUT_RATIO
    if unknown.is_log:
        low, high = unknown.start / ratio, unknown.start * ratio
    else:
        reach = ratio * abs(unknown.start) + INPUT_SPAN.get(unknown.unit, 1.0)
        low, high = unknown.start - reach, unknown.start + reach
    bounds = number.bounds
    within = [max(low, bounds.low), min(high, bounds.high)]
    if bounds.excludes_low and within[0] == bounds.low:
        within[0] = math.nextafter(within[0], math.inf)
    if bounds.excludes_high and within[1] == bounds.high:
        within[1] = math.nextafter(within[1], -math.inf)
    return within[0], within[1]
