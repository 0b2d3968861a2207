"""Make the references of the rod cases: python benchmarks/peers/make_references.py [CASE ...]

A spectral method that shares nothing with any contestant: curvature and stretch are
Legendre polynomials over the whole rod, their coefficients are the coordinates, and
positions follow by integration (no node, no constraint, no shear). The equations are
Lagrange's with the exact mass matrix, in steps of Gauss's collocation at three points
(order 6, no numerical damping).

The error is what a coarser basis and doubled steps move the tip by. Smooth motion converges
exponentially. A load that comes at once excites every mode, the n-th by n^-5, and there
the order of the basis is what the reference is good to; the file's own entry
`<case>_moved` keeps the distance over the case's scale. Two outside checks:

- `cycle_fast` against twenty instants by two other spectral codes, agreed to 1e-9 m
  (tests/validation/data/rod_dynamic.json);
- `release` at 0.05, 0.1 and 0.2 s: x = 3.6619e-5, 1.429489e-4 and 5.282063e-4 m.

Takes ten minutes; each case is stored when it is done.
"""

from __future__ import annotations

import os

os.environ["OPENBLAS_NUM_THREADS"] = "1"

import json
import sys
from pathlib import Path

import numpy as np
import rod
from numpy.polynomial import legendre
from scipy.linalg import lu_factor, lu_solve

DEGREES = {"cycle_fast": 9, "cycle_slow": 7, "release": 16, "release_heavy": 12}
"""Of the polynomials; the check takes two less."""
STEPS_PER_OUTPUT = {"cycle_fast": 40, "cycle_slow": 40, "release": 120, "release_heavy": 100}
"""The check takes half."""
TOLERANCE = 1e-10
"""Of the stages: change of the positions' coordinates in the last iteration."""
STALE = 6
"""Iterations after which a step's Jacobian is made anew for the next."""
THEIR_RODS = Path(__file__).parents[2] / "tests" / "validation" / "data" / "rod_dynamic.json"
"""Twenty instants of the fast cycle by two other codes."""
RELEASED = {0.05: 3.6619e-5, 0.1: 1.429489e-4, 0.2: 5.282063e-4}
"""Lateral tip positions [m] at times [s] under 1 g."""


def main() -> None:
    """Compute, check, store."""
    stored: dict[str, np.ndarray] = {}
    if rod.DATA.exists():
        with np.load(rod.DATA) as before:
            stored = dict(before)
    for case in rod.CASES:
        if sys.argv[1:] and case.name not in sys.argv[1:]:
            continue
        degree, steps = DEGREES[case.name], STEPS_PER_OUTPUT[case.name]
        coarse = Spectral(case, degree - 2).tip(steps // 2)
        fine = Spectral(case, degree).tip(steps)
        moved = float(np.max(np.hypot(*(fine - coarse).T))) / case.scale
        largest = float(np.max(np.hypot(*(fine - fine[0]).T)))
        print(f"{case.name}: moved by {moved:.1e}; the tip goes {largest:.6e} m")
        stored |= {case.name: fine, f"{case.name}_moved": np.array(moved)}
        np.savez_compressed(rod.DATA, **stored)
    check(stored)


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

    def tip(self, steps: int) -> np.ndarray:
        """Position x, z of the tip (T, 2) [m] at the case's times, with so many steps between."""
        length = float(self.case.times[1]) / steps
        q, v = np.zeros((2, 2 * self.n))
        gauss = Gauss(self, length)
        found = [self._tip(q)]
        for output in self.case.times[:-1]:
            for k in range(steps):
                q, v = gauss.step(output + k * length, q, v)
            found.append(self._tip(q))
        return np.array(found)

    def _tip(self, q: np.ndarray) -> np.ndarray:
        phi, stretch = self.angle @ q[: self.n], 1 + self.basis @ q[self.n :]
        slopes = stretch * np.array([np.sin(phi), np.cos(phi)])
        return slopes @ self.weights

    def acceleration(self, t: np.ndarray, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """Of the coefficients (B, 2 n), Lagrange's equations, at times (B,)."""
        n = self.n
        phi, stretch = q[:, :n] @ self.angle.T, 1 + q[:, n:] @ self.basis.T
        turning, stretching = v[:, :n] @ self.angle.T, v[:, n:] @ self.basis.T
        along = np.stack([np.sin(phi), np.cos(phi)], axis=1)
        across = np.stack([np.cos(phi), -np.sin(phi)], axis=1)
        bend = (stretch[:, None] * across)[..., None] * self.angle
        lever = self.sum @ np.concatenate([bend, along[..., None] * self.basis], axis=3)
        swing = (2 * stretching * turning)[:, None] * across
        centripetal = (swing - (stretch * turning**2)[:, None] * along) @ self.sum.T
        centripetal[:, 0] -= self.case.gravity
        flat = lever.reshape(len(q), -1, 2 * n).transpose(0, 2, 1)
        heavy = flat * np.tile(rod.MASS_PER_LENGTH * self.weights, 2)
        force = -(heavy @ centripetal.reshape(len(q), -1, 1))[..., 0]
        curvature = np.array([self.case.curvature(time) for time in t])[:, None]
        bent = q[:, :n] @ self.basis.T - curvature
        force[:, :n] -= rod.BENDING_STIFFNESS * (bent * self.weights) @ self.basis
        force[:, n:] -= rod.EXTENSION_STIFFNESS * ((stretch - 1) * self.weights) @ self.basis
        return np.linalg.solve(heavy @ flat.transpose(0, 2, 1), force[..., None])[..., 0]


class Gauss:
    """Three-point collocation of q'' = a(t, q, q'), in the accelerations of the stages."""

    def __init__(self, rod_: Spectral, step: float) -> None:
        root = np.sqrt(15.0)
        self.nodes = np.array([0.5 - root / 10, 0.5, 0.5 + root / 10])
        self.weights = np.array([5, 8, 5]) / 18
        powers = np.vander(self.nodes, 3, increasing=True)
        ends = self.nodes[:, None] ** np.arange(1, 4) / np.arange(1, 4)
        self.stages = ends @ np.linalg.inv(powers)
        self.rod, self.length = rod_, step
        self.factors: tuple[np.ndarray, np.ndarray] | None = None
        self.last = np.zeros((3, 2 * rod_.n))

    def step(self, t: float, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Coordinates and their rates one step later; simplified Newton iterations."""
        h, stages = self.length, self.stages
        times, a = t + self.nodes * h, self.last
        drift = q + self.nodes[:, None] * h * v
        for count in range(1, 40):
            if self.factors is None or count % 8 == 0:
                self.factors = self._factors(t, q, v)
            found = self.rod.acceleration(
                times, drift + h**2 * stages @ (stages @ a), v + h * stages @ a
            )
            change = lu_solve(self.factors, (found - a).ravel()).reshape(a.shape)
            a = a + change
            if h**2 * np.max(np.abs(change)) < TOLERANCE:
                break
        else:
            raise RuntimeError(f"no convergence at {t} s")
        if count > STALE:
            self.factors = None
        self.last = a
        late = self.weights * (1 - self.nodes)
        return q + h * v + h**2 * late @ a, v + h * self.weights @ a

    def _factors(self, t: float, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        size, still = len(q), np.zeros((4 * len(q), len(q)))
        step = np.repeat([1e-6, 1e-6 / self.length], size)
        nudge = np.hstack([still, still])
        nudge[: 2 * size] += np.diag(step)
        nudge[2 * size :] -= np.diag(step)
        state = np.concatenate([q, v]) + nudge
        a = self.rod.acceleration(np.full(len(state), t), state[:, :size], state[:, size:])
        slopes = (a[: 2 * size] - a[2 * size :]).T / (2 * step)
        once, twice = self.length * self.stages, self.length**2 * self.stages @ self.stages
        moved = np.kron(twice, slopes[:, :size]) + np.kron(once, slopes[:, size:])
        factored: tuple[np.ndarray, np.ndarray] = lu_factor(np.eye(3 * size) - moved)
        return factored


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
