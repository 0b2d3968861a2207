"""The numbers that a run comes down to, one row each, with their gradients.

Extremes are those of the output times, and their times are output times, so that all can be
found in `trajectory.csv` again. The loop is the last full period where every input is periodic,
else the whole run; between output times it is a polyline. Smooth motions come with errors of
order two in the output interval, times of extremes with half an interval.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.column_lag import ColumnLag, column_lag, intervals_for
from viscodesign.results.loop_part import LoopPart
from viscodesign.results.tip_path import (
    enclosed_area,
    enclosed_area_gradient,
    extent,
    extent_gradient,
    path_length,
    path_length_gradient,
)
from viscodesign.storage.cached_property import cached_property
from viscodesign.storage.disk_arrays import blocks

RIGHT_COLUMN, LEFT_COLUMN = 0, 1
MIN_LAG_OUTPUTS = 3
"""Output times of a loop below which two columns have no lag."""


def column_weights(bellows: Sequence[str]) -> np.ndarray:
    """(B, 2): pressures (T, B) times this are the means of the right and of the left column.

    A bellow's name says its column: R1, R2, ..., L1, L2, ...
    """
    sides = np.array([[name.startswith(side) for side in "RL"] for name in bellows], dtype=float)
    return np.asarray(sides / np.maximum(sides.sum(axis=0), 1.0))


@dataclass(frozen=True, eq=False)
class MetricInputs:
    """What metrics are computed from."""

    time: np.ndarray
    """(T,) output times [s], increasing."""
    tip: np.ndarray
    """(T, 2): x, z [m]."""
    columns: np.ndarray
    """(T, 2): mean gauge pressures of the right and of the left column [Pa]."""
    bellows: tuple[str, ...]
    period: float | None = None
    """Common period of the inputs [s]; None where they have none."""

    @classmethod
    def of(
        cls,
        time: np.ndarray,
        tip: np.ndarray,
        pressure: np.ndarray,
        bellows: Sequence[str],
        period: float | None = None,
    ) -> MetricInputs:
        """Read a run: times (T,) [s], tip (T, 2 or more) [m], pressures (T, B) [Pa]."""
        weights = column_weights(bellows)
        means = [pressure[rows] @ weights for rows in blocks(len(time), pressure)]
        columns = np.concatenate([np.zeros((0, 2)), *means])
        return cls(time, np.asarray(tip[:, :2]), columns, tuple(bellows), period)

    @cached_property
    def loop(self) -> LoopPart:
        """The part of the run that is its loop."""
        return LoopPart.of(self.time, self.period)

    @cached_property
    def path(self) -> np.ndarray:
        """(m, 2): the tip's way along the loop [m]."""
        return self.loop.path.values(self.tip)

    @cached_property
    def lag(self) -> ColumnLag:
        """Lag of the left column behind the right one, in equal parts of the loop."""
        curves = self.loop.even(self.lag_intervals).values(self.columns)
        return column_lag(curves[:, RIGHT_COLUMN], curves[:, LEFT_COLUMN], self.loop.is_period)

    @cached_property
    def lag_intervals(self) -> int:
        """Number of these parts."""
        return intervals_for(self.loop.intervals)


@dataclass(frozen=True, eq=False)
class MetricGradient:
    """Gradient of one metric."""

    tip: np.ndarray
    """(T, 2) [1/m]."""
    columns: np.ndarray
    """(T, 2), of the columns' mean pressures [1/Pa]."""
    bellows: tuple[str, ...]
    period: float = 0.0
    """Slope by the period [1/s], the motion fixed: where the loop begins depends on it."""

    @property
    def pressure(self) -> np.ndarray:
        """(T, B), of the bellows' pressures [1/Pa]."""
        return np.asarray(self.columns @ column_weights(self.bellows).T)

    def along(
        self, tip: np.ndarray, pressure: np.ndarray, period: np.ndarray | float = 0.0
    ) -> np.ndarray:
        """Change (n,) of the metric with changes (T, 2, n), (T, B, n) and (n,)."""
        columns = np.einsum("tbn,bc->tcn", pressure, column_weights(self.bellows))
        by_tip = np.einsum("tc,tcn->n", self.tip, tip)
        return np.asarray(
            by_tip + np.einsum("tc,tcn->n", self.columns, columns) + self.period * period
        )


Value = Callable[[MetricInputs], float]
Gradient = Callable[[MetricInputs], MetricGradient]


@dataclass(frozen=True)
class Metric:
    """One number of a run, in SI; the unit is the last word of its name."""

    name: str
    meaning: str
    value: Value
    """NaN where it is not defined."""
    gradient: Gradient
    """Gradient of a metric that is defined."""
    least_outputs: int = 1
    """Output times that it needs."""

    def of(self, inputs: MetricInputs) -> float:
        """The metric of a run; NaN where it is not defined."""
        if len(inputs.time) < self.least_outputs:
            return math.nan
        return self.value(inputs)


def _zero(inputs: MetricInputs) -> MetricGradient:
    zeros = np.zeros_like(inputs.tip)
    return MetricGradient(zeros, zeros, inputs.bellows)


def _extremes(component: int, axis: str) -> Iterator[Metric]:
    """Smallest and largest x or z, and when."""
    for word, size, pick in (("min", "smallest", np.argmin), ("max", "largest", np.argmax)):
        yield _extreme(component, f"tip_{axis}_{word}_m", f"{size} {axis} of the tip", pick)
        yield _extreme_time(component, f"tip_{axis}_{word}_time_s", f"{size} {axis}", pick)


def _extreme(component: int, name: str, meaning: str, pick: Callable[..., np.intp]) -> Metric:
    def gradient(inputs: MetricInputs) -> MetricGradient:
        tip = np.zeros_like(inputs.tip)
        tip[pick(inputs.tip[:, component]), component] = 1.0
        return MetricGradient(tip, np.zeros_like(inputs.tip), inputs.bellows)

    def value(inputs: MetricInputs) -> float:
        return float(inputs.tip[pick(inputs.tip[:, component]), component])

    return Metric(name, f"{meaning} at an output time", value, gradient)


def _extreme_time(component: int, name: str, size: str, pick: Callable[..., np.intp]) -> Metric:
    def value(inputs: MetricInputs) -> float:
        return float(inputs.time[pick(inputs.tip[:, component])])

    return Metric(name, f"first output time with the {size}", value, _zero)


def _of_loop(
    name: str,
    meaning: str,
    value: Callable[[np.ndarray], float],
    gradient: Callable[[np.ndarray], np.ndarray],
) -> Metric:
    """A number of the tip's way along the loop."""

    def pulled_back(inputs: MetricInputs) -> MetricGradient:
        by_path, sampled = gradient(inputs.path), inputs.loop.path
        by_period = float(np.sum(by_path * sampled.change_with_period(inputs.tip, later=True)))
        tip = sampled.pulled_back(by_path)
        return MetricGradient(tip, np.zeros_like(tip), inputs.bellows, by_period)

    return Metric(name, meaning, lambda inputs: value(inputs.path), pulled_back, least_outputs=2)


def _lag_s(inputs: MetricInputs) -> float:
    return inputs.lag.intervals * inputs.loop.duration / inputs.lag_intervals


def _lag_gradient(inputs: MetricInputs) -> MetricGradient:
    spacing, lag = inputs.loop.duration / inputs.lag_intervals, inputs.lag
    sampled = inputs.loop.even(inputs.lag_intervals)
    by_curves = spacing * np.column_stack((lag.by_right, lag.by_left))
    by_period = float(np.sum(by_curves * sampled.change_with_period(inputs.columns)))
    if inputs.loop.is_period:
        by_period += lag.intervals / inputs.lag_intervals
    columns = sampled.pulled_back(by_curves)
    return MetricGradient(np.zeros_like(columns), columns, inputs.bellows, by_period)


METRICS: tuple[Metric, ...] = (
    *_extremes(0, "x"),
    *_extremes(1, "z"),
    _of_loop(
        "loop_width_m",
        "largest less smallest x of the loop",
        lambda path: extent(path, 0),
        lambda path: extent_gradient(path, 0),
    ),
    _of_loop(
        "loop_height_m",
        "largest less smallest z of the loop",
        lambda path: extent(path, 1),
        lambda path: extent_gradient(path, 1),
    ),
    _of_loop(
        "path_length_m",
        "length of the tip's way along the loop, not closed",
        path_length,
        path_length_gradient,
    ),
    _of_loop(
        "loop_area_m2",
        "area within the loop, closed by a straight line; counter-clockwise positive, with x to "
        "the right and z upwards",
        enclosed_area,
        enclosed_area_gradient,
    ),
    Metric(
        "column_lag_s",
        "delay of the left column's mean pressure behind the right column's: the shift, up to half "
        "of the loop's time, at which the one, scaled, fits the other best in least squares; none "
        "where a column's pressure is constant or the two are not alike",
        _lag_s,
        _lag_gradient,
        MIN_LAG_OUTPUTS,
    ),
)
"""In the order of `summary.json`."""
METRIC_NAMES = tuple(row.name for row in METRICS)


def metric(name: str) -> Metric:
    """The row of a metric; raises `KeyError` where there is none."""
    return {row.name: row for row in METRICS}[name]


def metric_table() -> Iterator[tuple[str, str]]:
    """Name and meaning of every metric, for the page of quantities."""
    for row in METRICS:
        yield f"`{row.name}`", row.meaning


def metric_values(inputs: MetricInputs, names: Iterable[str] = METRIC_NAMES) -> dict[str, float]:
    """Metrics of a run by their names; NaN where they are not defined."""
    return {name: metric(name).of(inputs) for name in names}


def metric_gradients(
    inputs: MetricInputs, names: Iterable[str] = METRIC_NAMES
) -> dict[str, MetricGradient]:
    """Gradients of metrics by their names; NaN where the metric is not defined."""
    return {name: _defined_gradient(metric(name), inputs) for name in names}


def _defined_gradient(row: Metric, inputs: MetricInputs) -> MetricGradient:
    if math.isnan(row.of(inputs)):
        undefined = np.full(inputs.tip.shape, math.nan)
        return MetricGradient(undefined, undefined, inputs.bellows, math.nan)
    return row.gradient(inputs)
