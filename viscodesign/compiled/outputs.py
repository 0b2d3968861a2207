"""What a compiled function gives: columns over time, and metrics of them."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from viscodesign.compiled.given_values import numbers_in
from viscodesign.compiled.reading import Members, places_of
from viscodesign.errors import Fault, SpecError, not_among
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.metrics import (
    METRIC_NAMES,
    MetricGradient,
    MetricInputs,
    metric_gradients,
    metric_values,
)
from viscodesign.solve.problem import Problem

TIP_COLUMNS = ("tip_x_m", "tip_z_m")


@dataclass(frozen=True)
class _Metric:
    """A metric of one rod."""

    name: str
    tip: list[int]
    """Places of x and z among the columns."""
    pressures: list[int]
    bellows: tuple[str, ...]


class ChosenOutputs:
    """Outputs by name, read from columns (T, c), and their derivatives.

    Metrics also depend on the ``period`` of all inputs [s], None where they have none: the last one
    is their loop. Raises `SpecError` for names that are neither a column nor a metric.
    """

    def __init__(
        self,
        problem: Problem,
        members: Members,
        names: Sequence[str],
    ) -> None:
        self.names = (names,) if isinstance(names, str) else tuple(names)
        known = known_outputs(problem, members)
        faults = [Fault(not_among(name, known), "outputs") for name in self.names]
        faults = [f for f, name in zip(faults, self.names, strict=True) if name not in known]
        if faults or not self.names:
            raise SpecError(faults or [Fault("name at least one, such as tip_x_m", "outputs")])
        self._times = problem.schedule.edges[problem.schedule.outputs]
        metrics = {f"{prefix}{name}": prefix for prefix, name in _metric_names(members)}
        own = [name for name in self.names if name not in metrics]
        used = {name: metrics[name] for name in self.names if name in metrics}
        needed = [c for prefix in dict.fromkeys(used.values()) for c in _read_by(members, prefix)]
        self.columns = list(dict.fromkeys([*own, *needed]))
        """Columns that all outputs are read from."""
        self._place = {name: k for k, name in enumerate(self.columns)}
        self._metrics = {
            name: self._metric(members, prefix, name.removeprefix(prefix))
            for name, prefix in used.items()
        }

    def _metric(self, members: Members, prefix: str, name: str) -> _Metric:
        places = [self._place[column] for column in _read_by(members, prefix)]
        tip, pressures = places[: len(TIP_COLUMNS)], places[len(TIP_COLUMNS) :]
        return _Metric(name, tip, pressures, members.bellows_of(prefix))

    @property
    def has_metrics(self) -> bool:
        """Whether any output is a metric."""
        return bool(self._metrics)

    def read(self, columns: np.ndarray, period: float | None) -> dict[str, Any]:
        """Outputs from columns (T, c)."""
        found: dict[str, Any] = {}
        for inputs, names in self._by_rod(columns, period):
            values = metric_values(inputs, [self._metrics[name].name for name in names])
            found |= {name: values[self._metrics[name].name] for name in names}
        return {
            name: found[name] if name in found else columns[:, self._place[name]].copy()
            for name in self.names
        }

    def push_forward(
        self, columns: np.ndarray, period: float | None, rates: np.ndarray, period_rates: np.ndarray
    ) -> dict[str, Any]:
        """Rates (T, d) or (d,) of the outputs for those of columns (d, T, c) and period (d,)."""
        moved = np.moveaxis(rates, 0, -1)
        found: dict[str, Any] = {}
        for name, gradient in self._gradients(columns, period, list(self._metrics)).items():
            own = self._metrics[name]
            # Where the inputs lose their period, only what depends on it has no slope.
            by_period = period_rates if gradient.period else 0.0
            found[name] = gradient.along(moved[:, own.tip], moved[:, own.pressures], by_period)
        return {
            name: found[name] if name in found else moved[:, self._place[name]].copy()
            for name in self.names
        }

    def pull_back(
        self, columns: np.ndarray, period: float | None, weights: Mapping[str, Any]
    ) -> tuple[np.ndarray, float]:
        """Weights (T, c) of the columns, and that of the period, for those of some outputs."""
        found, period_weight = np.zeros_like(columns), 0.0
        given = self.weights(weights)
        for name, weight in given.items():
            if name not in self._metrics:
                found[:, self._place[name]] += weight
        metrics = [name for name in given if name in self._metrics]
        for name, gradient in self._gradients(columns, period, metrics).items():
            own, weight = self._metrics[name], given[name]
            found[:, own.tip] += weight * gradient.tip
            found[:, own.pressures] += weight * gradient.pressure
            period_weight += float(weight) * gradient.period
        return found, period_weight

    def weights(self, given: Mapping[str, Any]) -> dict[str, np.ndarray]:
        """Weights of outputs as arrays; raises `SpecError` for names and shapes that none has."""
        found = {}
        if not isinstance(given, Mapping):
            message = f"must be a mapping of some of the outputs to their weights; got {given!r}"
            raise SpecError([Fault(message, "weights")])
        for name, weight in given.items():
            if name not in self.names:
                raise SpecError([Fault(not_among(name, self.names), "weights")])
            shape = () if name in self._metrics else (len(self._times),)
            found[name] = numbers_in(weight, f"weights: {name}", "numbers, shaped like the output")
            if found[name].shape != shape:
                raise SpecError.plain(
                    f"weights: {name} needs an array of shape {shape}; got {found[name].shape}"
                )
        return found

    def blank(self) -> dict[str, Any]:
        """Outputs of a run that failed."""
        return {
            name: np.nan if name in self._metrics else np.full(len(self._times), np.nan)
            for name in self.names
        }

    def _gradients(
        self, columns: np.ndarray, period: float | None, wanted: Sequence[str]
    ) -> dict[str, MetricGradient]:
        """Gradients of some metrics."""
        found: dict[str, MetricGradient] = {}
        for inputs, names in self._by_rod(columns, period):
            own = {name: self._metrics[name].name for name in names if name in wanted}
            gradients = metric_gradients(inputs, list(own.values())) if own else {}
            found |= {name: gradients[plain] for name, plain in own.items()}
        return found

    def _by_rod(
        self, columns: np.ndarray, period: float | None
    ) -> Iterator[tuple[MetricInputs, list[str]]]:
        """What the metrics of each rod are computed from, and these metrics."""
        for places in {tuple(own.tip): own for own in self._metrics.values()}.values():
            names = [name for name, own in self._metrics.items() if own.tip == places.tip]
            tip, pressures = columns[:, places.tip], columns[:, places.pressures]
            yield MetricInputs.of(self._times, tip, pressures, places.bellows, period), names


def known_outputs(problem: Problem, members: Members) -> list[str]:
    """Names of all outputs of a problem: columns, and metrics of every rod."""
    metrics = [f"{prefix}{name}" for prefix, name in _metric_names(members)]
    return [*places_of(problem, members), *metrics]


def _metric_names(members: Members) -> Iterator[tuple[str, str]]:
    """What each rod's columns begin with, and each metric."""
    return itertools.product(members.rod_prefixes, METRIC_NAMES)


def _read_by(members: Members, prefix: str) -> list[str]:
    """Columns that the metrics of a rod are read from: its tip, then the pressures."""
    pressures = (f"pressure_{name}_pa" for name in members.bellows_of(prefix))
    return [f"{prefix}{column}" for column in (*TIP_COLUMNS, *pressures)]
