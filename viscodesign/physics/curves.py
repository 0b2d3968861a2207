"""Piecewise cubics through measured points, in a form that numbers and symbols share."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np


@dataclass(frozen=True)
class PiecewiseCubic:
    """value + slope x + sum of b_k (x - x_k)_+^2 + c_k (x - x_k)_+^3, x = argument - origin.

    Once continuously differentiable; straight lines beyond the first and the last knot.
    Truncated powers instead of a search for the interval: an expression of a symbol has
    no search.
    """

    origin: float
    value: float
    slope: float
    knots: np.ndarray
    """(n,) relative to the origin."""
    squares: np.ndarray
    """b_k (n,)"""
    cubes: np.ndarray
    """c_k (n,)"""

    @classmethod
    def monotone(cls, x: np.ndarray, y: np.ndarray) -> PiecewiseCubic:
        """Through points (n,) without overshoot: monotone where they are.

        Slopes by Fritsch and Butland, SIAM Journal on Scientific and Statistical
        Computing 5, 1984, as scipy's PCHIP has them.
        """
        from scipy.interpolate import PchipInterpolator

        ends = PchipInterpolator(x, y).derivative()(x)
        width, chord = np.diff(x), np.diff(y) / np.diff(x)
        square = (3 * chord - 2 * ends[:-1] - ends[1:]) / width
        cube = (ends[:-1] + ends[1:] - 2 * chord) / width**2
        # Second and third derivatives of each piece at its start; nothing beyond the ends.
        second = np.concatenate([[0.0], 2 * square + 6 * cube * width])
        return cls(
            origin=float(x[0]),
            value=float(y[0]),
            slope=float(ends[0]),
            knots=x - x[0],
            squares=(np.append(2 * square, 0.0) - second) / 2,
            cubes=np.diff(np.concatenate([[0.0], cube, [0.0]])),
        )

    def __call__(self, argument: Any, functions: Any = np) -> Any:
        """The curve's value."""
        x = argument - self.origin
        result = self.value + self.slope * x
        for knot, square, cube in self._corners():
            beyond = functions.fmax(x - knot, 0.0)
            result = result + beyond * beyond * (square + cube * beyond)
        return result

    def integral(self, argument: Any, functions: Any = np) -> Any:
        """Its integral from the first knot."""
        x = argument - self.origin
        result = self.value * x + self.slope * x * x / 2
        for knot, square, cube in self._corners():
            beyond = functions.fmax(x - knot, 0.0)
            result = result + beyond**3 * (square / 3 + cube * beyond / 4)
        return result

    def zeroed(self) -> PiecewiseCubic:
        """The same, moved to vanish at zero."""
        return replace(self, value=self.value - float(self(0.0)))

    def scaled(self, factor: float) -> PiecewiseCubic:
        """The same, times a factor."""
        return replace(
            self,
            value=factor * self.value,
            slope=factor * self.slope,
            squares=factor * self.squares,
            cubes=factor * self.cubes,
        )

    def _corners(self) -> list[tuple[float, float, float]]:
        """Knots where the curve really changes; a straight one has none but round-off."""
        range_ = float(self.knots[-1])
        size = max(abs(self.slope), abs(self.value) / range_, 1e-300)
        return [
            (float(k), float(b), float(c))
            for k, b, c in zip(self.knots, self.squares, self.cubes, strict=True)
            if max(abs(b) * range_, abs(c) * range_**2) > 1e-12 * size
        ]
