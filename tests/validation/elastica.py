"""A clamped column under dead loads at its tip: boundary value problem and elliptic integrals.

Lengths are in those of the column, forces in EI/L2. Nothing of the package is used.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_bvp
from scipy.special import ellipe, ellipk

EULER = np.pi**2 / 4
"""Critical load of an inextensible column."""
TOLERANCE = 1e-10


@dataclass(frozen=True)
class Tip:
    """The end of a column: across and along its initial direction, and its angle from it."""

    x: float
    z: float
    phi: float


def critical(eta: float) -> float:
    """Critical load of a column with EA L2/EI = ``eta``: P (1 - P/eta) = pi2/4."""
    return float(eta / 2 * (1 - np.sqrt(1 - 4 * EULER / eta)))


def column(load: float, aside: float, eta: float = np.inf) -> Tip:
    """The bent shape under a load along -z and a small force along +x.

    theta'' = -(1 + N/eta) (F_x cos theta - F_z sin theta), N = F_x sin theta + F_z cos theta,
    theta(0) = 0, theta'(1) = 0, and (x, z)' = (1 + N/eta) (sin theta, cos theta): what makes
    the energy of bending, stretching and loads stationary.
    """

    def rates(s: np.ndarray, y: np.ndarray) -> np.ndarray:
        del s
        sin, cos = np.sin(y[0]), np.cos(y[0])
        stretch = 1 + (aside * sin - load * cos) / eta
        return np.array([y[1], -stretch * (aside * cos + load * sin), stretch * sin, stretch * cos])

    def ends(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        return np.array([a[0], b[1], a[2], a[3]])

    s = np.linspace(0.0, 1.0, 401)
    turn = _first_guess(load, eta)
    angle = turn * np.sin(np.pi * s / 2)
    guess = np.array([angle, np.gradient(angle, s), s * np.sin(angle), s * np.cos(angle)])
    found = solve_bvp(rates, ends, s, guess, tol=TOLERANCE, max_nodes=200_000)
    assert found.success, found.message
    phi, _, x, z = found.y[:, -1]
    assert phi > 0.0, "the straight or the mirrored branch was found"
    return Tip(float(x), float(z), float(phi))


def _first_guess(load: float, eta: float) -> float:
    """An end slope near that of the bent branch."""
    slopes = np.linspace(0.01, 3.1, 2000)
    loads = np.array([buckled(slope)[0] for slope in slopes])
    return float(
        np.interp(load * EULER / (critical(eta) if np.isfinite(eta) else EULER), loads, slopes)
    )


def buckled(slope: float) -> tuple[float, Tip]:
    """Load and tip of a perfect inextensible column that is bent to an end slope.

    With k = sin(slope/2): sqrt(P) = K(k), z = 2 E(k)/K(k) - 1, x = 2 k/K(k).
    Source: Timoshenko and Gere, Theory of Elastic Stability, section 2.7.
    """
    modulus = np.sin(slope / 2)
    first, second = ellipk(modulus**2), ellipe(modulus**2)
    return float(first**2), Tip(2 * modulus / first, 2 * second / first - 1, slope)
