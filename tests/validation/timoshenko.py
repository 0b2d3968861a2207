"""Beams that shear: frequencies of Timoshenko's, large deflections of Reissner's.

Nothing of the package is used. Lengths are in those of the beam, forces in EI/l^2;
``softness`` is EI/(kappa G A l^2), ``slenderness`` the radius of gyration over l.
"""

from __future__ import annotations

import numpy as np
from scipy.integrate import solve_bvp
from scipy.linalg import expm
from scipy.optimize import brentq


def timoshenko_frequencies(slenderness: float, softness: float, count: int) -> np.ndarray:
    """The first of a clamped-free beam, times sqrt(m l^4/EI) [1].

    Along it w' = phi + softness Q, phi' = M, M' = -Q - (slenderness omega)^2 phi and
    Q' = -omega^2 w. At the clamp w = phi = 0; M and Q at the free end vanish where their map
    from those at the clamp is singular.
    """

    def determinant(omega: float) -> float:
        along = np.array(
            [
                [0.0, 1.0, 0.0, softness],
                [0.0, 0.0, 1.0, 0.0],
                [0.0, -((slenderness * omega) ** 2), 0.0, -1.0],
                [-(omega**2), 0.0, 0.0, 0.0],
            ]
        )
        return float(np.linalg.det(expm(along)[2:, 2:]))

    found: list[float] = []
    low, step = 0.5, 0.25
    while len(found) < count:
        if determinant(low) * determinant(low + step) < 0:
            found.append(float(brentq(determinant, low, low + step, xtol=1e-13)))
        low += step
    return np.array(found)


def bent_tip(aside: float, along: float, softness: float, eta: float) -> np.ndarray:
    """x, z and angle of the cross section at the tip under dead loads there (3,).

    Reissner's rod with EA l^2/EI = ``eta``: N = F_x sin phi + F_z cos phi, Q = F_x cos phi -
    F_z sin phi, phi'' = -(1 + N/eta) Q + N softness Q,
    (x, z)' = (1 + N/eta) (sin phi, cos phi) + softness Q (cos phi, -sin phi).
    """

    def rates(s: np.ndarray, y: np.ndarray) -> np.ndarray:
        del s
        sin, cos = np.sin(y[0]), np.cos(y[0])
        normal, across = aside * sin + along * cos, aside * cos - along * sin
        stretch, shear = 1 + normal / eta, softness * across
        bend = -stretch * across + normal * shear
        return np.array([y[1], bend, stretch * sin + shear * cos, stretch * cos - shear * sin])

    def ends(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        return np.array([a[0], b[1], a[2], a[3]])

    s = np.linspace(0.0, 1.0, 201)
    found = solve_bvp(rates, ends, s, np.array([s, 1 - s, s**2, s]), tol=1e-11, max_nodes=200_000)
    assert found.success, found.message
    phi, _, x, z = found.y[:, -1]
    return np.array([x, z, phi])


def critical_load(softness: float, eta: float) -> float:
    """Of a clamped column: P (1 - P/eta + P softness) = pi^2/4, from phi'' of `bent_tip`."""
    rise = softness - 1 / eta
    return float((np.sqrt(1 + rise * np.pi**2) - 1) / (2 * rise))
