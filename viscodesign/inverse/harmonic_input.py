"""A free input: a sum of harmonics within limits of pressure, and of its rate."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from viscodesign.errors import Fault, SpecError, described, did_you_mean
from viscodesign.inverse.free_range import FreeRange, bounds
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.inputs.harmonics import MAX_HARMONICS, HarmonicsInput
from viscodesign.scene.scene import Scene
from viscodesign.studies.key_values import read_values

KEYS = ("harmonics", "period", "limits", "rate_limit")
EXAMPLE = "{harmonics: 6, period: [5 s, 400 s], limits: [-25 kPa, 30 kPa]}"
AMPLITUDE_SHARE = 0.65
"""Largest amplitude of one harmonic over the range of pressures: a square wave's first has 0.64."""
FIRST_SHARE = 0.35
LIMIT_SAMPLES = 96
"""Points of a period at which limits are kept during a search."""
MARGIN_SHARE = 0.002
"""A search stays away from the limits by this part of the range of pressures."""
STIFFNESS = 500.0
"""Tolerances that an excess of the whole range counts as."""


@dataclass(frozen=True)
class HarmonicChoice:
    """What a task says of a free input."""

    count: int
    period: tuple[float, float]
    """Bounds [s]; equal where it is given."""
    limits: tuple[float, float]
    """Limits of the pressure above the baseline [Pa]."""
    rate_limit: float | None = None
    """Limit of the pressure's slope [Pa/s]."""

    @classmethod
    def of(cls, given: Mapping[str, Any], own: float = 0.0) -> HarmonicChoice:
        """From what is written under `input`; ``own``: the size of the spec's input [Pa], or 0.

        Raises `SpecError`.
        """
        for key in given:
            if key not in KEYS:
                raise SpecError.plain(f"'{key}' is no such key{did_you_mean(key, KEYS)}")
        count = given["harmonics"]
        if type(count) is not int or not 1 <= count <= MAX_HARMONICS:
            raise SpecError.plain(
                f"harmonics: must be a whole number from 1 to {MAX_HARMONICS}; "
                f"got {described(count)}"
            )
        for key in ("period", "limits"):
            if key not in given:
                raise SpecError.plain(f"{key} is missing; write {EXAMPLE}")
        low, high = bounds("limits", "Pa", given["limits"], own)
        rate = given.get("rate_limit")
        found = None if rate is None else _rate_limit(rate, given["limits"])
        return cls(count, _period(given["period"]), (low, high), found)

    @property
    def span(self) -> float:
        """Distance of the limits [Pa]."""
        return self.limits[1] - self.limits[0]

    def ranges(self) -> list[FreeRange]:
        """The free numbers of the input."""
        most = AMPLITUDE_SHARE * self.span
        found = [
            FreeRange("input.mean", *self.limits),
            FreeRange("input.cosine[*]", -most, most),
            FreeRange("input.sine[*]", -most, most),
        ]
        is_free = self.period[0] < self.period[1]
        return [*found, FreeRange("input.period", *self.period)] if is_free else found

    def placed(self, scene: Scene) -> Scene:
        """The scene with such an input, from which a search starts: one harmonic."""
        none = [0.0] * (self.count - 1)
        own = {
            "kind": "harmonics",
            "period": math.sqrt(self.period[0] * self.period[1]),
            "mean": sum(self.limits) / 2,
            "cosine": [FIRST_SHARE * self.span, *none],
            "sine": [0.0, *none],
        }
        longest = max(scene.run.duration, math.sqrt(self.period[0] * self.period[1]))
        return scene.replace({"input": own, "run.duration": longest})


def _period(given: Any) -> tuple[float, float]:
    if isinstance(given, Sequence) and not isinstance(given, str):
        low, high = bounds("period", "s", given)
    else:
        low = high = _single("period", "s", given)
    if low <= 0.0:
        raise SpecError.plain(f"period: must be above 0 s; got {low:g} s")
    return low, high


def _rate_limit(given: Any, limits: Any) -> float:
    """A limit [Pa/s], with a unit where ``limits`` have one."""
    found = _single("rate_limit", "Pa/s", given)
    is_bare = read_values("rate_limit", "Pa/s", given).is_bare
    if is_bare and not read_values("limits", "Pa", limits).is_bare:
        message = (
            f"{described(given)} has no unit beside limits {limits}; give every value its unit, "
            "such as 50 kPa/s"
        )
        raise SpecError([Fault(message, "rate_limit")])
    return found


def _single(key: str, unit: str, given: Any) -> float:
    found = read_values(key, unit, given)
    if found.is_range or len(found.listed) != 1 or not float(found.listed[0]) > 0.0:
        raise SpecError([Fault(f"expected one value above 0; got {described(given)}", key)])
    return float(found.listed[0])


class InputLimits:
    """Residuals of what an input exceeds its limits by, in a search; and a way to keep them.

    ``names``: the free numbers in order.
    """

    def __init__(
        self, choice: HarmonicChoice, names: Sequence[str], period: float, tolerance: float
    ) -> None:
        self._choice, self._fixed_period = choice, period
        place = {name: k for k, name in enumerate(names)}
        orders = range(choice.count)
        self._mean = place["input.mean"]
        self._cosine = [place[f"input.cosine[{k}]"] for k in orders]
        self._sine = [place[f"input.sine[{k}]"] for k in orders]
        self._period = place.get("input.period")
        turns = (
            2
            * math.pi
            * np.outer(np.arange(LIMIT_SAMPLES) / LIMIT_SAMPLES, np.arange(1, choice.count + 1))
        )
        self._levels = np.zeros((LIMIT_SAMPLES, len(names)))
        self._levels[:, self._mean] = 1.0
        self._levels[:, self._cosine], self._levels[:, self._sine] = np.cos(turns), np.sin(turns)
        orders_row = 2 * math.pi * np.arange(1, choice.count + 1)
        self._rates = np.zeros_like(self._levels)
        self._rates[:, self._cosine] = -orders_row * np.sin(turns)
        self._rates[:, self._sine] = orders_row * np.cos(turns)
        self._weight = STIFFNESS * tolerance / choice.span / math.sqrt(LIMIT_SAMPLES)

    def __call__(self, values: np.ndarray) -> np.ndarray:
        """(3 LIMIT_SAMPLES,) [m]"""
        return self._weight * self._excess(values)[0]

    def jacobian(self, values: np.ndarray) -> np.ndarray:
        """(3 LIMIT_SAMPLES, f)"""
        return self._weight * self._excess(values)[1]

    def _excess(self, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        low, high = self._choice.limits
        margin = MARGIN_SHARE * self._choice.span
        level = self._levels @ values
        above, below = level - (high - margin), (low + margin) - level
        rate, by_rate = np.zeros(LIMIT_SAMPLES), np.zeros_like(self._levels)
        if self._choice.rate_limit is not None:
            period = self._period_of(values)
            limit = self._choice.rate_limit * period * (1 - MARGIN_SHARE)
            slope = self._rates @ values
            # In pressures of a period, so that one weight suits all.
            rate, by_rate = np.abs(slope) - limit, np.sign(slope)[:, None] * self._rates
            if self._period is not None:
                by_rate = by_rate.copy()
                by_rate[:, self._period] -= limit / period
            rate, by_rate = rate / (2 * math.pi), by_rate / (2 * math.pi)
        found = np.concatenate([above, below, rate])
        slopes = np.concatenate([self._levels, -self._levels, by_rate])
        return np.maximum(found, 0.0), np.where(found[:, None] > 0.0, slopes, 0.0)

    def _period_of(self, values: np.ndarray) -> float:
        return self._fixed_period if self._period is None else float(values[self._period])

    def within(self, values: np.ndarray) -> np.ndarray:
        """Values whose input keeps its limits exactly, with smaller amplitudes where need be."""
        low, high = self._choice.limits
        found = values.copy()
        found[self._mean] = min(max(found[self._mean], low), high)
        lowest, highest, steepest = self._extremes(found)
        mean = found[self._mean]
        shares = [1.0]
        if highest > high:
            shares.append((high - mean) / (highest - mean))
        if lowest < low:
            shares.append((mean - low) / (mean - lowest))
        if self._choice.rate_limit is not None and steepest > self._choice.rate_limit:
            shares.append(self._choice.rate_limit / steepest)
        share = min(shares)
        found[[*self._cosine, *self._sine]] *= share * (1 - 1e-12) if share < 1.0 else 1.0
        return found

    def is_at_limit(self, values: np.ndarray) -> bool:
        """Whether the input comes as near to a limit as a search lets it."""
        near = 3 * MARGIN_SHARE
        lowest, highest, steepest = self._extremes(values)
        low, high = self._choice.limits
        rate = self._choice.rate_limit
        is_steep = rate is not None and steepest > (1 - near) * rate
        margin = near * self._choice.span
        return lowest < low + margin or highest > high - margin or is_steep

    def _extremes(self, values: np.ndarray) -> tuple[float, float, float]:
        own = HarmonicsInput(
            kind="harmonics",
            period=self._period_of(values),
            mean=float(values[self._mean]),
            cosine=tuple(values[self._cosine].tolist()),
            sine=tuple(values[self._sine].tolist()),
        )
        return *own.extremes(own.period), own.steepest()
