"""The rod by a bare SciPy script: lumped masses, straight edges, solve_ivp.

What somebody writes in an afternoon who knows the equations: nodes on a line, springs
along and between them, forces by hand, the Jacobian by SciPy's differences with its
sparsity told. Second order in space. At the clamp the first edge turns by half.
"""

from __future__ import annotations

from abc import ABC
from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np
import rod
from scipy.integrate import solve_ivp
from scipy.sparse import csr_matrix

LADDER = [(4, 1e-2), (8, 1e-2), (8, 1e-3), (16, 1e-3), (32, 1e-4), (64, 1e-5)]
"""Edges and relative tolerance, refined together."""
ABSOLUTE = 0.03
"""Absolute tolerance over the relative one and the size of the motion."""


class SolveIvp(ABC):
    """One method of solve_ivp."""

    name: ClassVar[str]
    method: ClassVar[str]

    def __init__(self, case: rod.RodCase) -> None:
        self.case = case

    def settings(self) -> list[dict[str, Any]]:
        """Edges and tolerances, coarse to fine."""
        return [{"edges": edges, "rtol": rtol} for edges, rtol in LADDER]

    def prepare(self, setting: dict[str, Any]) -> Callable[[], np.ndarray]:
        """The start and the Jacobian's sparsity."""
        case, edges = self.case, setting["edges"]
        z = np.arange(1, edges + 1) * rod.LENGTH / edges
        start = np.concatenate([np.zeros(edges), z, np.zeros(2 * edges)])
        options = {
            "method": self.method,
            "t_eval": case.times,
            "rtol": setting["rtol"],
            "atol": setting["rtol"] * ABSOLUTE * case.scale,
            "jac_sparsity": sparsity(edges),
        }

        def rate(t: float, y: np.ndarray) -> np.ndarray:
            return motion(case, edges, t, y)

        def run() -> np.ndarray:
            found = solve_ivp(rate, (0.0, case.duration), start, **options)
            if not found.success:
                raise RuntimeError(found.message)
            return np.asarray(found.y[[edges - 1, 2 * edges - 1]].T)

        return run


def motion(case: rod.RodCase, edges: int, t: float, y: np.ndarray) -> np.ndarray:
    """Rates of positions x, z and velocities (4n,) of the nodes after the clamp."""
    h = rod.LENGTH / edges
    nodes, velocity = y[: 2 * edges].reshape(2, edges), y[2 * edges :]
    edge = np.diff(nodes, axis=1, prepend=0.0)
    length = np.hypot(*edge)
    along = edge / length
    across = np.array([along[1], -along[0]])
    angle = np.unwrap(np.arctan2(edge[0], edge[1]))
    spans = np.full(edges, h)
    spans[0] = h / 2
    bent = np.diff(angle, prepend=0.0) / spans - case.curvature(t)
    moment = np.append(rod.BENDING_STIFFNESS * bent, 0.0)
    tension = rod.EXTENSION_STIFFNESS * (length / h - 1)
    force = tension * along + np.diff(moment) / length * -across
    mass = np.full(edges, rod.MASS_PER_LENGTH * h)
    mass[-1] /= 2
    acceleration = np.diff(force, axis=1, append=0.0) / mass
    acceleration[0] += case.gravity
    return np.concatenate([velocity, acceleration.ravel()])


def sparsity(edges: int) -> csr_matrix:
    """Which rates may depend on which states: two neighbours on either side."""
    near = np.abs(np.subtract.outer(np.arange(edges), np.arange(edges))) <= 2
    zero, one = np.zeros((2 * edges, 2 * edges)), np.eye(2 * edges)
    return csr_matrix(np.block([[zero, one], [np.tile(near, (2, 2)), zero]]))


class Radau(SolveIvp):
    """Radau IIA of order 5."""

    name = "SciPy Radau"
    method = "Radau"


class Bdf(SolveIvp):
    """Variable-order BDF."""

    name = "SciPy BDF"
    method = "BDF"
