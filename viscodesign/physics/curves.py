"""Piecewise cubics through measured points, for numbers and symbols alike."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class PiecewiseCubic:
    r"""A piecewise cubic in truncated powers.

    .. math:: y = y_0 + s x + \sum_k b_k (x - x_k)_+^2 + c_k (x - x_k)_+^3

    x is the argument less ``origin``, y_0 ``value``, s ``slope``. Once continuously differentiable;
    linear beyond the first and the last knot. Truncated powers need no search for the interval,
    which a symbolic expression could not do.
    """

    origin: float
    value: float
    slope: float
    knots: np.ndarray
    """x_k (n,), relative to the origin."""
    squares: np.ndarray
    """b_k (n,)"""
    cubes: np.ndarray
    """c_k (n,)"""

    @classmethod
    def monotone(cls, x: np.ndarray, y: np.ndarray) -> PiecewiseCubic:
        """Through the points ``x``, ``y`` (n,), without overshoot: monotone where the points are.

        Slopes by Fritsch and Butland, SIAM Journal on Scientific and Statistical
        Computing 5, 1984, as in SciPy's PCHIP.
        """
        from scipy.interpolate import PchipInterpolator

        ends = PchipInterpolator(x, y).derivative()(x)
        width, chord = np.diff(x), np.diff(y) / np.diff(x)
        square = (3 * chord - 2 * ends[:-1] - ends[1:]) / width
        cube = (ends[:-1] + ends[1:] - 2 * chord) / width**2
        # Second derivatives at the ends of each piece; zero beyond the first and last point.
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
        """Value of the curve; ``functions`` is numpy or casadi."""
        x = argument - self.origin
        result = self.value + self.slope * x
        for knot, square, cube in self._kinks():
            beyond = functions.fmax(x - knot, 0.0)
            result = result + beyond * beyond * (square + cube * beyond)
        return result

    def integral(self, argument: Any, functions: Any = np) -> Any:
        """Integral from the first knot; ``functions`` is numpy or casadi."""
        x = argument - self.origin
        result = self.value * x + self.slope * x * x / 2
        for knot, square, cube in self._kinks():
            beyond = functions.fmax(x - knot, 0.0)
            result = result + beyond**3 * (square / 3 + cube * beyond / 4)
        return result

    def zeroed(self) -> PiecewiseCubic:
        """The curve, shifted to vanish at zero."""
        return replace(self, value=self.value - float(self(0.0)))

    def scaled(self, factor: float) -> PiecewiseCubic:
        """The curve, multiplied by a factor."""
        return replace(
            self,
            value=factor * self.value,
            slope=factor * self.slope,
            squares=factor * self.squares,
            cubes=factor * self.cubes,
        )

    def _kinks(self) -> list[tuple[float, float, float]]:
        """Knots at which the cubic changes by more than rounding error."""
        range_ = float(self.knots[-1])
        size = max(abs(self.slope), abs(self.value) / range_, 1e-300)
        return [
            (float(k), float(b), float(c))
            for k, b, c in zip(self.knots, self.squares, self.cubes, strict=True)
            if max(abs(b) * range_, abs(c) * range_**2) > 1e-12 * size
        ]
