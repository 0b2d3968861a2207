"""What a compiled function gives: columns over time, and metrics of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from viscodesign.compiled.reading import Members, places_of
from viscodesign.errors import Fault, SpecError, not_among
from viscodesign.results.metrics import (
    METRIC_NAMES,
    MetricInputs,
    metric_gradients,
    metric_values,
)
from viscodesign.solve.problem import Problem

TIP_COLUMNS = ("tip_x_m", "tip_z_m")


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
        known = [*places_of(problem, members), *METRIC_NAMES]
        faults = [Fault(not_among(name, known), "outputs") for name in self.names]
        faults = [f for f, name in zip(faults, self.names, strict=True) if name not in known]
        if faults or not self.names:
            raise SpecError(faults or [Fault("name at least one, such as tip_x_m", "outputs")])
        self._bellows = members.bellows
        self._times = problem.schedule.edges[problem.schedule.outputs]
        self.has_metrics = any(name in METRIC_NAMES for name in self.names)
        self._metrics = [name for name in self.names if name in METRIC_NAMES]
        own = [name for name in self.names if name not in METRIC_NAMES]
        pressures = [f"pressure_{name}_pa" for name in self._bellows]
        needed = [*TIP_COLUMNS, *pressures] if self._metrics else []
        self.columns = list(dict.fromkeys([*own, *needed]))
        """Columns that all outputs are read from."""
        self._place = {name: k for k, name in enumerate(self.columns)}
        self._tip = [self._place[name] for name in TIP_COLUMNS] if needed else []
        self._pressures = [self._place[name] for name in pressures] if needed else []

    def read(self, columns: np.ndarray, period: float | None) -> dict[str, Any]:
        """Outputs from columns (T, c)."""
        own = self._metrics
        found = metric_values(self._inputs(columns, period), own) if own else {}
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
        if self._metrics:
            tip, pressures = moved[:, self._tip], moved[:, self._pressures]
            gradients = metric_gradients(self._inputs(columns, period), self._metrics)
            found = {
                # Where the inputs lose their period, only what depends on it has no slope.
                n: own.along(tip, pressures, period_rates if own.period else 0.0)
                for n, own in gradients.items()
            }
        return {
            name: found[name] if name in found else moved[:, self._place[name]].copy()
            for name in self.names
        }

    def pull_back(
        self, columns: np.ndarray, period: float | None, weights: Mapping[str, Any]
    ) -> tuple[np.ndarray, float]:
        """Weights (T, c) of the columns, and that of the period, for those of some outputs."""
        found, period_weight = np.zeros_like(columns), 0.0
        unknown = [name for name in weights if name not in self.names]
        if unknown:
            raise SpecError([Fault(not_among(unknown[0], self.names), "weights")])
        for name, weight in weights.items():
            given = np.asarray(weight, dtype=float)
            shape = () if name in METRIC_NAMES else (len(self._times),)
            if given.shape != shape:
                raise SpecError.plain(
                    f"weights: {name} needs an array of shape {shape}; got {given.shape}"
                )
            if name not in METRIC_NAMES:
                found[:, self._place[name]] += given
                continue
            (gradient,) = metric_gradients(self._inputs(columns, period), [name]).values()
            found[:, self._tip] += given * gradient.tip
            found[:, self._pressures] += given * gradient.pressure
            period_weight += float(given) * gradient.period
        return found, period_weight

    def blank(self) -> dict[str, Any]:
        """Outputs of a run that failed."""
        return {
            name: np.nan if name in METRIC_NAMES else np.full(len(self._times), np.nan)
            for name in self.names
        }

    def _inputs(self, columns: np.ndarray, period: float | None) -> MetricInputs:
        tip, pressures = columns[:, self._tip], columns[:, self._pressures]
        return MetricInputs.of(self._times, tip, pressures, self._bellows, period)
