"""How well one curve, shifted in time, resembles another: an exact function of the shift.

Both curves are linear between equally spaced samples, so the integral of their product is a
cubic polynomial of the shift between two multiples of the spacing. Lengths of time are in
spacings throughout.
"""

from __future__ import annotations

import math

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.storage.cached_property import cached_property

_BEFORE, _AFTER = np.zeros((2, 4)), np.zeros((2, 4))
_BEFORE[0] = (0.0, 0.0, 1 / 2, -1 / 6)
_BEFORE[1] = (0.0, 0.0, 0.0, 1 / 6)
_AFTER[1] = (1 / 3, -1 / 2, 0.0, 1 / 6)
_AFTER[0] = (1 / 6, -1 / 2, 1 / 2, -1 / 6)
_WEIGHTS = np.stack(
    (_BEFORE, np.array([[0.5, 0.0, 0.0, 0.0]] * 2) - _BEFORE - _AFTER, _AFTER), axis=1
)
"""(2, 3, 4): coefficients in the shift's fraction of the integral, over one spacing, of hat k or
k + 1 of one curve times hat k - m - 1, k - m or k - m + 1 of the other, shifted by m and it."""


@dataclass(frozen=True, eq=False)
class ShiftedProduct:
    """The cosine between one curve and another that is shifted by m to m + 1 spacings.

    ``late``, ``early``: samples (n,) of the two. Of cyclic curves they are one period; others
    are zero at the first sample and before, and compared up to the last one, so that the early
    curve's norm is that of its part which is not shifted beyond the end.
    """

    late: np.ndarray
    early: np.ndarray
    shift: int
    """m >= 0: by how much the early curve is delayed at least."""
    is_cyclic: bool

    def is_alike(self, fraction: float) -> bool:
        """Whether the cosine is positive."""
        return self._product(fraction) > 0.0 and self._norm(fraction) > 0.0

    def log_cosine(self, fraction: float) -> float:
        """Natural logarithm of the cosine, where it is positive, up to a constant."""
        return math.log(self._product(fraction)) - math.log(self._norm(fraction)) / 2

    def slope(self, fraction: float) -> float:
        """Derivative of `log_cosine` with the shift."""
        product, norm = self._product(fraction), self._norm(fraction)
        return self._product(fraction, 1) / product - self._norm(fraction, 1) / norm / 2

    def curvature(self, fraction: float) -> float:
        """Second derivative of `log_cosine`."""
        product, norm = self._product(fraction), self._norm(fraction)
        by_product, by_norm = self._product(fraction, 1) / product, self._norm(fraction, 1) / norm
        return (
            self._product(fraction, 2) / product
            - by_product**2
            - self._norm(fraction, 2) / norm / 2
            + by_norm**2 / 2
        )

    def slope_gradients(self, fraction: float) -> tuple[np.ndarray, np.ndarray]:
        """Gradients (n,) of `slope` with the samples of the late and the early curve."""
        product, norm = self._product(fraction), self._norm(fraction)
        by_product, by_norm = self._product(fraction, 1) / product, self._norm(fraction, 1) / norm
        weights = _WEIGHTS @ (_powers(fraction, 1) - by_product * _powers(fraction, 0))
        late, early = self._product_gradients(weights / product)
        parts = self._norm_gradient(fraction, 1) - by_norm * self._norm_gradient(fraction, 0)
        return late, early - parts / norm / 2

    # -- the integral of the product ---------------------------------------------------------

    @cached_property
    def _late_ends(self) -> np.ndarray:
        """(2, cells): the late curve at both ends of every spacing."""
        curve = np.append(self.late, self.late[0]) if self.is_cyclic else self.late
        return np.stack((curve[:-1], curve[1:]))

    @cached_property
    def _early_rows(self) -> np.ndarray:
        """(3, cells): early samples that meet every spacing; -1 where there is none."""
        cells = self._late_ends.shape[1]
        rows = np.arange(cells) - self.shift + np.array([[-1], [0], [1]])
        return np.asarray(rows % len(self.early) if self.is_cyclic else np.maximum(rows, -1))

    @cached_property
    def _early_nodes(self) -> np.ndarray:
        """(3, cells): the early curve there."""
        return np.asarray(np.append(self.early, 0.0)[self._early_rows])

    @cached_property
    def _coefficients(self) -> np.ndarray:
        """(4,) of the integral, as a polynomial of the fraction."""
        products = self._late_ends @ self._early_nodes.T
        return np.asarray(np.einsum("ab,abp->p", products, _WEIGHTS))

    def _product(self, fraction: float, order: int = 0) -> float:
        """The integral, or a derivative with the shift."""
        return float(self._coefficients @ _powers(fraction, order))

    def _product_gradients(self, weights: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Gradients of a sum of products with these weights (2, 3)."""
        ends = weights @ self._early_nodes
        late = np.zeros(self._late_ends.shape[1] + 1)
        late[:-1] += ends[0]
        late[1:] += ends[1]
        if self.is_cyclic:
            late[0] += late[-1]
            late = late[:-1]
        early = np.zeros(len(self.early) + 1)
        np.add.at(early, self._early_rows, weights.T @ self._late_ends)
        return late, early[:-1]

    # -- the norm of what is compared of the early curve --------------------------------------

    @property
    def _cut(self) -> int:
        """The spacing of the early curve that the end of the comparison falls into."""
        return len(self.early) - 2 - self.shift

    @cached_property
    def _norm_before(self) -> float:
        """Integral of its square up to that spacing; over a period if it is cyclic."""
        if self.is_cyclic:
            ends = self.early, np.roll(self.early, -1)
        else:
            ends = self.early[: self._cut], self.early[1 : self._cut + 1]
        return float(np.sum(ends[0] ** 2 + ends[0] * ends[1] + ends[1] ** 2)) / 3

    def _norm(self, fraction: float, order: int = 0) -> float:
        """Integral of the square of what is compared, or its derivative with the shift."""
        if self.is_cyclic:
            return self._norm_before if order == 0 else 0.0
        first, change = self._cut_values()
        left = 1 - fraction
        value = first + change * left
        if order == 0:
            part = first**2 * left + first * change * left**2 + change**2 * left**3 / 3
            return self._norm_before + part
        return -(value**2) if order == 1 else 2 * value * change

    def _norm_gradient(self, fraction: float, order: int) -> np.ndarray:
        """Gradient (n,) of `_norm` with the early samples."""
        found = np.zeros(len(self.early))
        if self.is_cyclic:  # a number that does not depend on the shift has no part in the slope
            return found
        first, change = self._cut_values()
        left = 1 - fraction
        if order == 0:
            ends = self.early[: self._cut], self.early[1 : self._cut + 1]
            found[: self._cut] += (2 * ends[0] + ends[1]) / 3
            found[1 : self._cut + 1] += (ends[0] + 2 * ends[1]) / 3
            by_first = 2 * first * left + change * left**2
            by_change = first * left**2 + 2 * change * left**3 / 3
        else:
            by_first = -2 * (first + change * left)
            by_change = by_first * left
        found[self._cut] += by_first - by_change
        found[self._cut + 1] += by_change
        return found

    def _cut_values(self) -> tuple[float, float]:
        first, second = self.early[self._cut], self.early[self._cut + 1]
        return float(first), float(second - first)


def _powers(fraction: float, order: int) -> np.ndarray:
    """Powers 0 to 3 of a number, or their first or second derivatives."""
    rows = (
        (1.0, fraction, fraction**2, fraction**3),
        (0.0, 1.0, 2 * fraction, 3 * fraction**2),
        (0.0, 0.0, 2.0, 6 * fraction),
    )
    return np.array(rows[order])
