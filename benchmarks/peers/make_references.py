"""Make the references of the rod cases: python benchmarks/peers/make_references.py

A spectral method that shares nothing with any contestant: curvature and stretch are
Legendre polynomials over the whole rod, their coefficients are the coordinates, and
positions follow by integration (no node, no constraint, no shear). The equations are
Lagrange's with the exact mass matrix, integrated explicitly (DOP853) at 1e-10.

The error is what a coarser basis moves the tip by. Smooth motion converges
exponentially. A load that comes at once excites every mode, the n-th by n^-5, and there
the order of the basis is what the reference is good to; the file's own entry
`<case>_moved` keeps the distance over the case's scale. Two outside checks:

- `cycle_fast` against twenty instants by two other spectral codes, agreed to 1e-9 m
  (tests/validation/data/rod_dynamic.json);
- `release` at 0.05, 0.1 and 0.2 s: x = 3.6619e-5, 1.429489e-4 and 5.282063e-4 m.

Takes some minutes.
"""

from __future__ import annotations

import os

os.environ["OPENBLAS_NUM_THREADS"] = "1"

import json
from pathlib import Path

import numpy as np
import rod
from numpy.polynomial import legendre
from scipy.integrate import solve_ivp
from scipy.linalg import cho_factor, cho_solve

DEGREES = {"cycle_fast": 9, "cycle_slow": 7, "release": 12, "release_heavy": 12}
"""Of the polynomials; the check takes two less."""
TOLERANCE = 1e-10
THEIR_RODS = Path(__file__).parents[2] / "tests" / "validation" / "data" / "rod_dynamic.json"
"""Twenty instants of the fast cycle by two other codes."""
RELEASED = {0.05: 3.6619e-5, 0.1: 1.429489e-4, 0.2: 5.282063e-4}
"""Lateral tip positions [m] at times [s] under 1 g."""


def main() -> None:
    """Compute, check, store."""
    stored = {}
    for case in rod.CASES:
        degree = DEGREES[case.name]
        coarse, fine = (Spectral(case, d).tip() for d in (degree - 2, degree))
        moved = float(np.max(np.hypot(*(fine - coarse).T))) / case.scale
        largest = float(np.max(np.hypot(*(fine - fine[0]).T)))
        print(f"{case.name}: moved by {moved:.1e}; the tip goes {largest:.6e} m")
        stored |= {case.name: fine, f"{case.name}_moved": np.array(moved)}
    check(stored)
    np.savez_compressed(rod.DATA, **stored)


class Spectral:
    """The rod in Legendre polynomials up to a degree, on Gauss points."""

    def __init__(self, case: rod.RodCase, degree: int) -> None:
        self.case = case
        count = 2 * degree + 6
        points, weights = legendre.leggauss(count)
        half = rod.LENGTH / 2
        self.n = degree + 1
        self.basis = legendre.legvander(points, degree)
        self.angle = half * _integrals(points, degree)
        self.weights = half * weights
        # Integral of an interpolant: coefficients by quadrature, then term by term.
        fit = (np.arange(count) + 0.5)[:, None] * legendre.legvander(points, count - 1).T * weights
        self.sum = half * _integrals(points, count - 1) @ fit

    def tip(self) -> np.ndarray:
        """Position x, z of the tip (T, 2) [m] at the case's times."""
        case, none = self.case, np.zeros(4 * self.n)
        found = solve_ivp(
            self.rate,
            (0.0, case.duration),
            none,
            method="DOP853",
            t_eval=case.times,
            rtol=TOLERANCE,
            atol=TOLERANCE,
        )
        assert found.success, found.message
        return np.array([self._tip(q) for q in found.y[: 2 * self.n].T])

    def _tip(self, q: np.ndarray) -> np.ndarray:
        phi, stretch = self.angle @ q[: self.n], 1 + self.basis @ q[self.n :]
        slopes = stretch * np.array([np.sin(phi), np.cos(phi)])
        return slopes @ self.weights

    def rate(self, t: float, y: np.ndarray) -> np.ndarray:
        """Of coefficients and their rates, Lagrange's equations."""
        n = self.n
        q, v = y[: 2 * n], y[2 * n :]
        phi, stretch = self.angle @ q[:n], 1 + self.basis @ q[n:]
        turning, stretching = self.angle @ v[:n], self.basis @ v[n:]
        along, across = np.array([np.sin(phi), np.cos(phi)]), np.array([np.cos(phi), -np.sin(phi)])
        lever = np.empty((2, len(phi), 2 * n))
        lever[:, :, :n] = (stretch * across)[:, :, None] * self.angle
        lever[:, :, n:] = along[:, :, None] * self.basis
        lever = self.sum @ lever
        centripetal = (
            self.sum @ (2 * stretching * turning * across - stretch * turning**2 * along).T
        )
        mass = rod.MASS_PER_LENGTH * self.weights
        pull = np.array([self.case.gravity, 0.0])
        flat = lever.transpose(1, 0, 2).reshape(-1, 2 * n)
        heavy = np.repeat(mass, 2)[:, None] * flat
        force = heavy.T @ (pull - centripetal).ravel()
        bent = self.basis @ q[:n] - self.case.curvature(t)
        force[:n] -= rod.BENDING_STIFFNESS * self.basis.T @ (self.weights * bent)
        force[n:] -= rod.EXTENSION_STIFFNESS * self.basis.T @ (self.weights * (stretch - 1))
        return np.concatenate([v, cho_solve(cho_factor(flat.T @ heavy), force)])


def _integrals(points: np.ndarray, degree: int) -> np.ndarray:
    """Integrals (P, degree + 1) of the Legendre polynomials from -1 to each point."""
    kinds = [legendre.legint(np.eye(degree + 1)[k], lbnd=-1) for k in range(degree + 1)]
    return np.array([legendre.legval(points, kind) for kind in kinds]).T


def check(stored: dict[str, np.ndarray]) -> None:
    """Hold against others' values."""
    theirs = np.array(json.loads(THEIR_RODS.read_text())["prescribed_curvature_cycle"]["rows"])
    fast = rod.CASES[0]
    places = np.rint(theirs[:, 0] / fast.times[1]).astype(int)
    apart = float(np.max(np.abs(stored[fast.name][places] - theirs[:, 1:3])))
    print(f"cycle_fast: {apart:.1e} m from two other codes")
    assert apart < 1e-8
    release = rod.CASES[2]
    for time, x in RELEASED.items():
        ours = stored[release.name][round(time / release.times[1]), 0]
        print(f"release at {time} s: {ours:.6e} m, theirs {x:.6e} m")
        assert abs(ours - x) < 3e-5 * release.scale


if __name__ == "__main__":
    main()
