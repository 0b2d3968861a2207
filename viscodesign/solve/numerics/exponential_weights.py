r"""Responses of decaying modes to inputs that are polynomials, exact whatever the rate.

A mode obeys dy/dt = -rate y + f(t). Over a cell of length h, in z = rate h,

    y(h theta) = exp(-z theta) y(0) + h \int_0^theta exp(-z (theta - s)) f(h s) ds.

With f interpolated at Gauss-Legendre points, the integrals are weighted sums of its values
there. The weights follow from moments of Legendre polynomials, which are modified spherical
Bessel functions: by quadrature for small z, by their recurrence upwards for large z, where it
is stable. No step limit follows from a rate; only the input has to be resolved.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.polynomial import legendre

from viscodesign.lazy_dataclass import dataclass

QUADRATURES = ((16.0, 24), (128.0, 64))
"""Largest |z| up to which moments are found by quadrature, and its points."""


@dataclass(frozen=True)
class Weights:
    """Weights of U values of z, each with n modes, at the P points of a cell and at its end.

    Responses are in units of h: multiply by the cell's length.
    """

    decay: np.ndarray
    """(U, n, P + 1): exp(-z theta)."""
    response: np.ndarray
    """(U, n, P + 1, P): by values of the input at the points."""


@dataclass(frozen=True)
class CellPoints:
    """Gauss-Legendre points of [0, 1], with what is derived from them alone."""

    theta: np.ndarray
    """(P + 1,): the points, and 1."""
    share: np.ndarray
    """(P,): weights of an integral over [0, 1]."""
    coefficients: np.ndarray
    """(P, P): values at the points -> Legendre coefficients."""
    partial: np.ndarray
    """(P + 1, P, P): values -> Legendre coefficients of the part up to each theta."""


@cache
def cell_points(count: int) -> CellPoints:
    """So many points of a cell."""
    place, weight = legendre.leggauss(count)
    values = legendre.legvander(place, count - 1)
    coefficients = (np.arange(count) + 0.5)[:, None] * values.T * weight
    theta = np.append((place + 1) / 2, 1.0)
    # A part's own points, placed in the whole cell.
    inner = theta[:, None] * (place + 1) - 1
    partial = coefficients @ legendre.legvander(inner, count - 1) @ coefficients
    partial[-1] = coefficients
    return CellPoints(theta, weight / 2, coefficients, partial)


def weights(z: np.ndarray, points: CellPoints) -> Weights:
    """Weights of all modes at ``z`` (U, n), real or complex, none with a negative real part."""
    count = len(points.share)
    scaled = z[..., None] * points.theta
    parts = (_moments(scaled, count) * points.theta[:, None])[..., None, :]
    response = (parts @ points.partial)[..., 0, :]
    # Interpolation towards the end of a cell costs two digits: not those of a constant.
    response += ((parts[..., 0, 0] - response.sum(axis=-1)) / count)[..., None]
    return Weights(np.exp(-scaled), response)


def _moments(z: np.ndarray, orders: int) -> np.ndarray:
    """Integrals of exp(-z (1 - s)) P_m(2 s - 1) over [0, 1] (..., orders), m = 0, 1, ..."""
    flat = z.ravel()
    found = np.empty((len(flat), orders), dtype=z.dtype)
    size, least = np.abs(flat), -1.0
    for largest, count in QUADRATURES:
        own = (size > least) & (size <= largest)
        if own.any():
            rest, polynomials = _quadrature(count, orders)
            found[own] = np.exp(-flat[own, None] * rest) @ polynomials
            found[own, 0] = _mean(flat[own])
        least = largest
    own = size > least
    if own.any():
        found[own] = _recurred(flat[own], orders)
    return found.reshape(*z.shape, orders)


def _mean(z: np.ndarray) -> np.ndarray:
    """Mean of exp(-z s) over [0, 1]."""
    still = z == 0.0
    return np.asarray(np.where(still, 1.0, -np.expm1(-z) / np.where(still, 1.0, z)))


@cache
def _quadrature(count: int, orders: int) -> tuple[np.ndarray, np.ndarray]:
    """1 - s (count,) at Gauss-Legendre points, and the weighted polynomials (count, orders)."""
    place, weight = legendre.leggauss(count)
    return (1 - place) / 2, legendre.legvander(place, orders - 1) * weight[:, None] / 2


def _recurred(z: np.ndarray, orders: int) -> np.ndarray:
    """Moments for large z, by the recurrence of spherical Bessel functions."""
    found = np.empty((len(z), orders), dtype=z.dtype)
    end = np.exp(-z)
    found[:, 0] = _mean(z)
    found[:, 1] = (1 + end - 2 * found[:, 0]) / z
    for m in range(1, orders - 1):
        found[:, m + 1] = found[:, m - 1] - (4 * m + 2) / z * found[:, m]
    return found
