"""From a best fit to what users are told: intervals, known products, recordings."""

from __future__ import annotations

import math

import numpy as np

from viscodesign.calibration.combinations import known_products
from viscodesign.calibration.misfit import Misfit
from viscodesign.calibration.profile_likelihood import NORMAL_95, Profiles
from viscodesign.calibration.recorded_columns import KINDS
from viscodesign.calibration.spread import Spread
from viscodesign.calibration.unknowns import ranges_of
from viscodesign.interrupt import StopRequest
from viscodesign.results.fit_result import FittedNumber, FittedProduct, FittedRun

OPEN_FROM = 1.0
"""Standard deviation of a step from which the data do not tell a number: its interval would reach
from a seventh to seven times its value."""
IDENTIFIED = 0.5
"""Half width of an interval, in parts of the value, up to which a number counts as identified."""


def fitted_numbers(misfit: Misfit, spread: Spread, stop: StopRequest) -> tuple[FittedNumber, ...]:
    """The scene's free numbers with intervals; Gaussian ones once the user asked to stop."""
    profiles = Profiles(misfit, spread, ranges_of(misfit.models, misfit.unknowns), stop)
    return tuple(_number(misfit, spread, profiles, k, stop) for k in misfit.pulled)


def _number(
    misfit: Misfit, spread: Spread, profiles: Profiles, k: int, stop: StopRequest
) -> FittedNumber:
    own, value = misfit.unknowns[k], float(spread.values[k])
    low, high = _interval(spread, profiles, k, misfit.unknowns[k].is_log, stop)
    is_identified = (
        low is not None and high is not None and (high - low) / 2 <= IDENTIFIED * abs(value)
    )
    return FittedNumber(own.name, value, own.unit, own.start, low, high, is_identified)


def _interval(
    spread: Spread, profiles: Profiles, k: int, is_log: bool, stop: StopRequest
) -> tuple[float | None, float | None]:
    deviation, value = float(spread.deviations[k]), float(spread.values[k])
    if deviation > OPEN_FROM:
        return None, None
    if not stop.asked:
        try:
            low, high = profiles.ends(k)
        except KeyboardInterrupt:
            pass
        else:
            return None if low.is_open else low.value, None if high.is_open else high.value
    step = NORMAL_95 * deviation
    if is_log:
        return value * math.exp(-step), value * math.exp(step)
    size = float(spread.sizes[k])
    return value - step * size, value + step * size


def fitted_products(
    misfit: Misfit, spread: Spread, numbers: tuple[FittedNumber, ...]
) -> tuple[FittedProduct, ...]:
    """Products that are known where their factors are not."""
    places = np.array(misfit.pulled)
    unsure = [k for k, own in enumerate(numbers) if not own.is_identified]
    found = []
    for product in known_products(spread.logarithmic(places), unsure):
        powers = tuple(
            (numbers[k].key, float(power))
            for k, power in zip(product.factors, product.powers, strict=True)
        )
        factors = (
            numbers[k].value ** float(p)
            for k, p in zip(product.factors, product.powers, strict=True)
        )
        value = math.prod(factors)
        width = math.exp(NORMAL_95 * product.deviation)
        found.append(FittedProduct(powers, value, value / width, value * width))
    return tuple(found)


def fitted_runs(misfit: Misfit, spread: Spread, values: np.ndarray) -> tuple[FittedRun, ...]:
    """The recordings beside what the model makes of them."""
    found = []
    apart = misfit.deviations(values)
    for k, (model, own) in enumerate(zip(misfit.models, apart, strict=True)):
        clock = [
            j for j, unknown in enumerate(misfit.unknowns) if unknown.is_clock and unknown.run == k
        ]
        late = float(values[clock[0]]) if clock else 0.0
        deviation = float(spread.deviations[clock[0]] * spread.sizes[clock[0]]) if clock else None
        found.append(
            FittedRun(
                file=model.recording.file,
                overrides=model.recording.overrides,
                time=model.recording.time,
                headers=tuple(channel.header for channel in model.channels),
                units=tuple(KINDS[channel.measured].unit for channel in model.channels),
                measured=model.measured,
                expected=model.measured - own,
                kept=misfit.kept[k],
                noise=misfit.levels[k],
                clock_offset_s=late + model.drive.shift_s,
                clock_deviation_s=deviation,
                driven_by=model.drive.words,
            )
        )
    return tuple(found)
