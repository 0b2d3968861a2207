"""From a best fit to what users are told: intervals, known products, recordings."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from viscodesign.calibration.combinations import known_products
from viscodesign.calibration.misfit import Misfit
from viscodesign.calibration.profile_likelihood import NORMAL_95, Profiles
from viscodesign.calibration.recorded_columns import KINDS
from viscodesign.calibration.spread import Spread
from viscodesign.calibration.unknowns import ranges_of
from viscodesign.interrupt import StopRequest
from viscodesign.results.fit_result import (
    Edge,
    FittedNumber,
    FittedProduct,
    FittedRun,
    WhyUnknown,
)
from viscodesign.studies.least_squares import AT_BOUND

OPEN_FROM = 1.0
"""Standard deviation of a step from which the data do not determine a number: its interval would
reach from a seventh to seven times its value."""
IDENTIFIED = 0.5
"""Half width of an interval, relative to the value, up to which a number counts as identified."""


def fitted_numbers(
    misfit: Misfit, spread: Spread, profiles: Profiles, stop: StopRequest
) -> tuple[FittedNumber, ...]:
    """The scene's free numbers with intervals; Gaussian ones once the user asked to stop."""
    ranges = ranges_of(misfit.models, misfit.unknowns)
    shares = ranges.shares(spread.values)
    return tuple(
        _number(misfit, spread, profiles, k, _edge(float(shares[k])), stop) for k in misfit.pulled
    )


def _number(
    misfit: Misfit, spread: Spread, profiles: Profiles, k: int, edge: Edge, stop: StopRequest
) -> FittedNumber:
    own, value = misfit.unknowns[k], float(spread.values[k])
    low, high = _interval(spread, profiles, k, own.is_log, stop)
    why = "edge_of_range" if edge else _why_unknown(value, low, high)
    return FittedNumber(own.name, value, own.unit, own.start, low, high, why, edge)


def _edge(share: float) -> Edge:
    """The edge at which a number is, by its share of the range."""
    if share <= AT_BOUND:
        return "low"
    return "high" if share >= 1 - AT_BOUND else ""


def _why_unknown(value: float, low: float | None, high: float | None) -> WhyUnknown:
    if low is None or high is None:
        return "no_end"
    return "" if (high - low) / 2 <= IDENTIFIED * abs(value) else "too_wide"


def not_identified(numbers: Sequence[FittedNumber]) -> tuple[FittedNumber, ...]:
    """Numbers of a model that does not describe the recordings: none of them is identified."""
    return tuple(
        replace(own, why_unknown="mismatch") if own.is_identified else own for own in numbers
    )


def edge_warnings(numbers: Sequence[FittedNumber]) -> Iterator[str]:
    """What to do about numbers at the edge of the range that was searched."""
    for own in numbers:
        if own.edge:
            yield (
                f"{own.key} = {own.value:.4g} {own.unit} is at the {own.edge} edge of the range "
                f"that was searched about the spec's {own.start:.4g}: the data call for a value "
                "beyond it, or the model is wrong; give a nearer first guess by "
                f"--set {own.key}=..., or leave it out of --free"
            )


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
