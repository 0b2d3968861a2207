"""By how much one column of bellows is behind the other.

The lag is the shift of the right column's mean pressure at which its cosine with the left
column's is largest: there the shifted curve, scaled, is the left one's best fit in least
squares. Over a period, curves are cyclic and without their means; over a whole run they are
the changes since its start, before which nothing moved.
"""

from __future__ import annotations

import math

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.shifted_product import ShiftedProduct


@dataclass(frozen=True)
class LagNumbers:
    """When two columns have a lag, and how it is found."""

    still_pa: float = 1e-3
    """Change of a pressure up to which it counts as constant [Pa]."""
    still_rel: float = 1e-6
    """The same, of the largest pressure."""
    least_cosine: float = 0.1
    """Cosine below which two curves are not alike."""
    least_norm: float = 1e-3
    """Norm of what the end leaves of a delayed curve, of the whole norm, that is too little."""
    largest_shift: float = 0.5
    """Largest shift that is looked at, of the time that is compared."""
    tie_rel_tol: float = 1e-9
    """Difference of cosines that counts as none: of equal ones the smallest shift is taken."""
    kink_share: float = 1e-9
    """Slope beside a peak, relative to its change over an interval, from which it is a kink."""
    least_samples: int = 5
    """Samples below which nothing is compared."""
    least_intervals: int = 200
    most_intervals: int = 32768
    """Samples of the curves; more only where a run has them, fewer never."""
    root_tol: float = 1e-15
    """Last step of the root search, in intervals."""
    max_iterations: int = 100
    """Steps of the root search within an interval."""


LAG = LagNumbers()


@dataclass(frozen=True, eq=False)
class ColumnLag:
    """The lag in sampling intervals, and its gradients (n + 1,) with the samples.

    Everything is NaN where there is no lag: where a pressure is constant, where the curves are
    not alike, or where they are most alike at the largest shift.
    """

    intervals: float
    by_right: np.ndarray
    by_left: np.ndarray


def intervals_for(outputs: int) -> int:
    """Number of sampling intervals: a multiple of that of output intervals, if not too many."""
    if outputs >= LAG.most_intervals:
        return LAG.most_intervals
    return outputs * max(1, math.ceil(LAG.least_intervals / outputs))


def column_lag(right: np.ndarray, left: np.ndarray, is_cyclic: bool) -> ColumnLag:
    """The lag of the left pressure (n + 1,) behind the right one (n + 1,), equally spaced [Pa]."""
    undefined = np.full(len(right), math.nan)
    nothing = ColumnLag(math.nan, undefined, undefined)
    if len(right) < LAG.least_samples or _is_still(right) or _is_still(left):
        return nothing
    pair = _Pair(_changes(right, is_cyclic), _changes(left, is_cyclic), is_cyclic)
    peak = pair.peak()
    if peak is None:
        return nothing
    late, early = peak.gradients()
    by_right, by_left = (early, late) if peak.sign > 0 else (late, early)
    return ColumnLag(
        pair.wrapped(peak.shift),
        _changes_pulled_back(by_right, is_cyclic),
        _changes_pulled_back(by_left, is_cyclic),
    )


def _is_still(pressure: np.ndarray) -> bool:
    swing = float(pressure.max() - pressure.min())
    return swing <= max(LAG.still_pa, LAG.still_rel * float(np.abs(pressure).max()))


def _changes(pressure: np.ndarray, is_cyclic: bool) -> np.ndarray:
    """Without its mean, over a period (n,); else since the start (n + 1,)."""
    if is_cyclic:
        return np.asarray(pressure[1:] - pressure[1:].mean())
    return np.asarray(pressure - pressure[0])


def _changes_pulled_back(gradient: np.ndarray, is_cyclic: bool) -> np.ndarray:
    """Gradient (n + 1,) with the pressures from that with their changes."""
    if is_cyclic:
        return np.append(0.0, gradient - gradient.mean())
    found = gradient.copy()
    found[0] = -gradient[1:].sum()
    return found


@dataclass(frozen=True, eq=False)
class _Peak:
    """A peak of the cosine."""

    product: ShiftedProduct
    fraction: float
    sign: int
    """1 where the left curve is the later one, -1 where it is the right one."""
    is_kink: bool = False
    """Whether the cosine has a corner there; small changes of the curves do not shift it."""

    @property
    def shift(self) -> float:
        """By how many intervals the left curve is late."""
        return self.sign * (self.product.shift + self.fraction) + 0.0

    def gradients(self) -> tuple[np.ndarray, np.ndarray]:
        """Gradients of `shift` with the later and the earlier curve, by the implicit function
        theorem: the slope remains zero."""
        late, early = self.product.slope_gradients(self.fraction)
        factor = 0.0 if self.is_kink else -self.sign / self.product.curvature(self.fraction)
        return factor * late, factor * early


@dataclass(frozen=True, eq=False)
class _Pair:
    """Changes of both columns' pressures, (n,) each."""

    right: np.ndarray
    left: np.ndarray
    is_cyclic: bool

    @property
    def _most(self) -> int:
        return int(LAG.largest_shift * len(self.right))

    def wrapped(self, shift: float) -> float:
        """A shift of a cycle, at most half of it to either side."""
        count = len(self.right)
        return shift - count * math.ceil(shift / count - 0.5) if self.is_cyclic else shift

    def peak(self) -> _Peak | None:
        """The largest cosine; None where there is none."""
        cell, came_from = self._best_shift(), None
        while cell is not None and abs(cell) <= self._most + 1:
            product, sign = self._cell(cell)
            ends = (0.0, 1.0) if sign > 0 else (1.0, 0.0)
            if not (product.is_alike(0.0) and product.is_alike(1.0)):
                return None
            at_low, at_high = (sign * product.slope(end) for end in ends)
            step = -1 if at_low < 0 else 1 if at_high > 0 else 0
            if step == 0:
                return _Peak(product, _root(product), sign)
            if cell + step == came_from:
                end = ends[step > 0]
                steepness = abs(at_high if step > 0 else at_low)
                is_kink = steepness > LAG.kink_share * abs(product.curvature(end))
                return _Peak(product, end, sign, is_kink)
            cell, came_from = cell + step, cell
        return None

    def _cell(self, cell: int) -> tuple[ShiftedProduct, int]:
        """Shifts from ``cell`` to ``cell + 1``: the later curve is the left one, or the right."""
        if cell >= 0:
            return ShiftedProduct(self.left, self.right, cell, self.is_cyclic), 1
        return ShiftedProduct(self.right, self.left, -cell - 1, self.is_cyclic), -1

    def _best_shift(self) -> int | None:
        """The whole shift of the largest cosine; None if the curves are not alike there."""
        shifts, cosines = self._cosines()
        best = float(cosines.max())
        if best < LAG.least_cosine:
            return None
        padded = np.concatenate(([-math.inf], cosines, [-math.inf]))
        is_top = (padded[1:-1] >= padded[:-2]) & (padded[1:-1] >= padded[2:])
        equal = shifts[is_top & (cosines >= best - LAG.tie_rel_tol)]
        return int(equal[np.argmin(np.abs(equal))])

    def _cosines(self) -> tuple[np.ndarray, np.ndarray]:
        """Whole shifts (k,) and the cosines there, as sums instead of integrals."""
        count, most = len(self.right), self._most
        size = count if self.is_cyclic else 1 << (2 * count).bit_length()
        left, right = (np.fft.rfft(curve, size) for curve in (self.left, self.right))
        products = np.fft.irfft(left * right.conj(), size)
        shifts = np.arange(-most, most + 1)
        norms = self._norms(self.left, -shifts) * self._norms(self.right, shifts)
        return shifts, np.where(norms > 0, products[shifts % size], 0.0) / np.where(
            norms > 0, norms, 1.0
        )

    def _norms(self, curve: np.ndarray, shifts: np.ndarray) -> np.ndarray:
        """Norms of what is left of a curve that is delayed by these shifts; 0 if almost nothing."""
        whole = math.sqrt(curve @ curve)
        if self.is_cyclic:
            return np.full(len(shifts), whole)
        left = np.sqrt(np.cumsum(curve**2))[len(curve) - 1 - np.maximum(shifts, 0)]
        return np.where(left > LAG.least_norm * whole, left, 0.0)


def _root(product: ShiftedProduct) -> float:
    """Where the slope changes its sign between 0 and 1: Newton's steps, else halves."""
    low, high, at = 0.0, 1.0, 0.5
    for _ in range(LAG.max_iterations):
        slope = product.slope(at)
        if slope > 0:
            low = at
        else:
            high = at
        curvature = product.curvature(at)
        then = at - slope / curvature if curvature < 0 else math.nan
        then = then if low <= then <= high else (low + high) / 2
        if abs(then - at) <= LAG.root_tol:
            return then
        at = then
    return at
