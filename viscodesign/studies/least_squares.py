"""Bounded least squares over free numbers, from several starts, with exact Jacobians."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Callable, Sequence
from dataclasses import field
from typing import Any, Literal, Protocol

import numpy as np

from viscodesign.errors import ViscodesignError
from viscodesign.interrupt import StopRequest
from viscodesign.lazy_dataclass import dataclass

LOG_FROM = 3.0
"""Ratio of two positive bounds from which a number is scaled by its logarithm."""
AT_BOUND = 1e-4
"""Distance from a bound, relative to the range, at which a number counts as at it."""
DESCENT_REL_TOL = 1e-9
"""Relative change of the sum of squares, and step relative to the ranges, that ends a descent."""
SAME_COST = 1.02
"""Ratio of two sums of squares up to which they count as the same optimum."""
MAX_EVALUATIONS = 200
"""Values of the residuals in one descent."""
Loss = Literal["linear", "soft_l1", "huber", "cauchy"]
Scaling = Literal["ranges", "slopes"]
"""By what steps of different numbers are compared: their ranges, or what they do to the residuals,
as in MINPACK, for numbers known far better than their ranges say."""
FitStatus = Literal["converged", "met", "unfinished", "interrupted"]
"""Unfinished: out of evaluations or time."""


class Residuals(Protocol):
    """Residuals (m,) of free numbers (f,) and their derivatives (m, f).

    A `ViscodesignError` at some values means that there is no solution there.
    """

    def __call__(self, values: np.ndarray, /) -> np.ndarray: ...

    def jacobian(self, values: np.ndarray, /) -> np.ndarray: ...


@dataclass(frozen=True)
class NumberRanges:
    """Finite bounds of numbers (f,), and their shares of the range, from 0 to 1."""

    low: np.ndarray
    high: np.ndarray
    is_log: np.ndarray
    """(f,) Whether equal steps of the share are equal ratios."""

    @classmethod
    def of(
        cls, low: Sequence[float] | np.ndarray, high: Sequence[float] | np.ndarray
    ) -> NumberRanges:
        """Logarithmic where both bounds are positive and far apart."""
        lowest, highest = np.array(low, dtype=float), np.array(high, dtype=float)
        if not np.all(np.isfinite(lowest) & np.isfinite(highest) & (lowest < highest)):
            raise ValueError("bounds must be finite, the lower one first")
        return cls(lowest, highest, (lowest > 0.0) & (highest > LOG_FROM * lowest))

    def shares(self, values: np.ndarray) -> np.ndarray:
        """(f,) Of values; those outside are moved to the nearest bound."""
        inside = np.clip(values, self.low, self.high)
        return np.asarray((self._bent(inside) - self._ends[0]) / (self._ends[1] - self._ends[0]))

    def values(self, shares: np.ndarray) -> np.ndarray:
        """(f,) Numbers at shares of their ranges, never outside."""
        bent = self._ends[0] + shares * (self._ends[1] - self._ends[0])
        found = np.where(self.is_log, np.exp(np.where(self.is_log, bent, 0.0)), bent)
        return np.asarray(np.clip(found, self.low, self.high))

    def slopes(self, values: np.ndarray) -> np.ndarray:
        """(f,) Of the values by their shares."""
        return np.asarray((self._ends[1] - self._ends[0]) * np.where(self.is_log, values, 1.0))

    def starts(self, own: np.ndarray, count: int, seed: int = 0) -> list[np.ndarray]:
        """Values to start from: ``own``, and ``count`` of a Latin hypercube by the seed."""
        first = [self.values(self.shares(own))]
        if count < 1:
            return first
        # scipy's needs a second to be imported.
        chance, size = np.random.default_rng(seed), (count, len(self.low))
        places = chance.permuted(np.tile(np.arange(count)[:, None], size[1]), axis=0)
        drawn = (places + chance.random(size)) / count
        return [*first, *(self.values(row) for row in drawn)]

    def _bent(self, values: np.ndarray) -> np.ndarray:
        return np.where(self.is_log, np.log(np.where(self.is_log, values, 1.0)), values)

    @property
    def _ends(self) -> tuple[np.ndarray, np.ndarray]:
        return self._bent(self.low), self._bent(self.high)


@dataclass(frozen=True)
class BestSoFar:
    """The best numbers of a search until now."""

    values: np.ndarray
    cost: float
    """Sum of the squared residuals, or what the loss makes of them."""
    evaluations: int


@dataclass(frozen=True)
class SearchLimits:
    """What ends a search, and how it tells of its progress."""

    met_cost: float = 0.0
    """Sum of squares at which nothing better is sought."""
    enough_cost: float = 0.0
    """Where a descent ends with such a sum, no other start is tried."""
    repeats: int = 3
    """Descents that end as low as the best of them, after which no other start is tried."""
    evaluations: int = MAX_EVALUATIONS
    """Limit of each descent."""
    converged: float = DESCENT_REL_TOL
    """See there."""
    until: float = math.inf
    """Time of `time.perf_counter` [s]."""
    stop: StopRequest = field(default_factory=StopRequest)
    report: Callable[[BestSoFar], None] | None = None
    """Called after every evaluation."""


@dataclass(frozen=True)
class LeastSquaresFit:
    """The numbers with the least sum of squares that a search found."""

    values: np.ndarray
    """(f,)"""
    residuals: np.ndarray
    """(m,)"""
    cost: float
    status: FitStatus
    evaluations: int
    optima: tuple[BestSoFar, ...]
    """Where each descent ended, the best first."""
    at_low: np.ndarray
    at_high: np.ndarray
    """(f,) Which numbers are at a bound."""


class _EndedError(Exception):
    """The search ends here."""


class _Search:
    """Residuals in shares of the ranges, and the best values so far."""

    def __init__(
        self,
        residuals: Residuals,
        ranges: NumberRanges,
        limits: SearchLimits,
        loss: Loss,
        scale: float,
    ):
        self._residuals, self._ranges, self._limits = residuals, ranges, limits
        self._loss, self._scale = loss, scale
        self.evaluations, self.best_residuals = 0, np.zeros(0)
        self.best: BestSoFar | None = None
        self.ended: FitStatus = "converged"
        self.error: ViscodesignError | None = None

    def __call__(self, shares: np.ndarray) -> np.ndarray:
        """(m,) NaN where there is no solution: a descent then takes a shorter step."""
        self._look()
        values = self._ranges.values(shares)
        self.evaluations += 1
        try:
            found = self._residuals(values)
        except ViscodesignError as error:
            self.error = error
            return np.full(max(len(self.best_residuals), 1), np.nan)
        except KeyboardInterrupt:
            self._end("interrupted")
        self._note(values, found)
        return found

    def jacobian(self, shares: np.ndarray) -> np.ndarray:
        """(m, f)"""
        values = self._ranges.values(shares)
        try:
            slopes = self._residuals.jacobian(values)
        except KeyboardInterrupt:
            self._end("interrupted")
        return np.asarray(slopes * self._ranges.slopes(values))

    def cost(self, found: np.ndarray) -> float:
        """The sum of squares; infinite where there is no solution."""
        if not np.all(np.isfinite(found)):
            return math.inf
        z = (found / self._scale) ** 2
        if self._loss == "soft_l1":
            z = 2 * (np.sqrt(1 + z) - 1)
        elif self._loss == "huber":
            z = np.where(z <= 1, z, 2 * np.sqrt(z) - 1)
        elif self._loss == "cauchy":
            z = np.log1p(z)
        return float(np.sum(z) * self._scale**2)

    def _note(self, values: np.ndarray, found: np.ndarray) -> None:
        cost = self.cost(found)
        if self.best is None or cost < self.best.cost:
            self.best, self.best_residuals = BestSoFar(values, cost, self.evaluations), found
        if self._limits.report is not None and self.best is not None:
            self._limits.report(BestSoFar(self.best.values, self.best.cost, self.evaluations))
        if cost <= self._limits.met_cost:
            self._end("met")

    def _look(self) -> None:
        if self._limits.stop.asked:
            self._end("interrupted")
        # Late as it may be, a first solution is worth more than none.
        if self.best is not None and clock.perf_counter() > self._limits.until:
            self._end("unfinished")

    def _end(self, status: FitStatus) -> Any:
        self.ended = status
        raise _EndedError


def least_squares(
    residuals: Residuals,
    ranges: NumberRanges,
    starts: Sequence[np.ndarray],
    *,
    descents: int = 1,
    limits: SearchLimits | None = None,
    loss: Loss = "linear",
    loss_scale: float = 1.0,
    scaling: Scaling = "ranges",
) -> LeastSquaresFit:
    """The least sum of squared residuals within bounds.

    All ``starts`` (f,) are tried, and from as many of the best as ``descents`` says a trust-region
    method goes down (Branch, Coleman, Li 1999, as in scipy's `least_squares`), in shares of the
    ranges. ``loss`` with its scale weighs gross residuals less, as scipy names them.

    The same arguments give the same numbers, unless time ends the search. Ctrl-C, as noted by
    ``limits.stop``, ends it with the best so far. Raises the `ViscodesignError` of the last start
    where none has a solution, `KeyboardInterrupt` where it ended before the first.
    """
    limits = limits or SearchLimits()
    search = _Search(residuals, ranges, limits, loss, loss_scale)
    optima: list[BestSoFar] = []
    try:
        ranked = _ranked(search, [ranges.shares(start) for start in starts])
        for start in ranked[:descents]:
            optima.append(_descend(search, ranges, start, limits, loss, loss_scale, scaling))
            least = min(own.cost for own in optima)
            again = sum(own.cost <= SAME_COST * least for own in optima)
            if least <= limits.enough_cost or again >= limits.repeats:
                break
    except _EndedError:
        pass
    return _fit_of(search, ranges, optima)


def _ranked(search: _Search, starts: Sequence[np.ndarray]) -> list[np.ndarray]:
    """Starts that have a solution, the best first. With one, there is nothing to rank."""
    if len(starts) == 1:
        return list(starts)
    costs = [search.cost(search(start)) for start in starts]
    order = np.argsort(costs, kind="stable")
    return [starts[k] for k in order if math.isfinite(costs[k])]


def _descend(
    search: _Search,
    ranges: NumberRanges,
    start: np.ndarray,
    limits: SearchLimits,
    loss: Loss,
    scale: float,
    scaling: Scaling,
) -> BestSoFar:
    """Where a descent from shares (f,) ends."""
    from scipy.optimize import least_squares as descend

    if not np.all(np.isfinite(search(start))):
        return BestSoFar(ranges.values(start), math.inf, search.evaluations)
    try:
        found = descend(
            search,
            start,
            jac=search.jacobian,
            bounds=(0.0, 1.0),
            loss=loss,
            f_scale=scale,
            ftol=limits.converged,
            xtol=limits.converged,
            gtol=1e-15,
            x_scale="jac" if scaling == "slopes" else 1.0,
            max_nfev=limits.evaluations,
        )
    except ViscodesignError as error:  # no derivative there
        search.error = error
        return BestSoFar(ranges.values(start), math.inf, search.evaluations)
    if found.status == 0:
        search.ended = "unfinished"
    return BestSoFar(ranges.values(found.x), 2 * float(found.cost), search.evaluations)


def _fit_of(search: _Search, ranges: NumberRanges, optima: list[BestSoFar]) -> LeastSquaresFit:
    best = search.best
    if best is None:
        if search.error is not None and search.ended == "converged":
            raise search.error
        raise KeyboardInterrupt
    shares = ranges.shares(best.values)
    return LeastSquaresFit(
        best.values,
        search.best_residuals,
        best.cost,
        search.ended,
        search.evaluations,
        tuple(sorted(optima, key=lambda own: own.cost)),
        shares < AT_BOUND,
        shares > 1 - AT_BOUND,
    )
