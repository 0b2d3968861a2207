"""The network by a bare SciPy script: a linear rate, its constant Jacobian, solve_ivp.

What somebody writes in twenty lines who knows the equations and needs no more than this
one network: nothing is read, checked, chosen or reported.
"""

from __future__ import annotations

from abc import ABC
from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np
from network import BELLOWS, DURATION, TIMES, NetworkCase, inlet_pressure, rate_matrix
from scipy.integrate import solve_ivp
from scipy.sparse import csc_matrix

TOLERANCES = [3e-3, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8]
SIZE = 1e5
"""A pressure as large as those met [Pa]; the absolute tolerance is a part of it."""


class SolveIvp(ABC):
    """One method of solve_ivp, down a ladder of tolerances."""

    name: ClassVar[str]
    method: ClassVar[str]

    def __init__(self, case: NetworkCase) -> None:
        self.fluid = case.fluid

    def settings(self) -> list[dict[str, Any]]:
        """Tolerances, coarse to fine."""
        return [{"rtol": rtol} for rtol in TOLERANCES]

    def jacobian(self, a: np.ndarray) -> dict[str, Any]:
        """Options that hand over the exact Jacobian."""
        return {"jac": csc_matrix(a)}

    def prepare(self, setting: dict[str, Any]) -> Callable[[], np.ndarray]:
        """Matrices and options, once."""
        a, b = rate_matrix(self.fluid)
        start = np.full(BELLOWS, inlet_pressure(0.0))
        options = self.jacobian(a) | {
            "method": self.method,
            "t_eval": TIMES,
            "rtol": setting["rtol"],
            "atol": setting["rtol"] * SIZE,
        }

        def rate(t: float, p: np.ndarray) -> np.ndarray:
            return a @ p + b * inlet_pressure(t)

        def run() -> np.ndarray:
            found = solve_ivp(rate, (0.0, DURATION), start, **options)
            if not found.success:
                raise RuntimeError(found.message)
            return np.asarray(found.y.T)

        return run


class Bdf(SolveIvp):
    """Variable-order BDF, sparse Jacobian."""

    name = "SciPy BDF"
    method = "BDF"


class Radau(SolveIvp):
    """Radau IIA of order 5, sparse Jacobian."""

    name = "SciPy Radau"
    method = "Radau"


class Lsoda(SolveIvp):
    """LSODA in Fortran, banded Jacobian."""

    name = "SciPy LSODA"
    method = "LSODA"

    def jacobian(self, a: np.ndarray) -> dict[str, Any]:
        banded = np.zeros((3, BELLOWS))
        banded[0, 1:], banded[1], banded[2, :-1] = np.diag(a, 1), np.diag(a), np.diag(a, -1)
        return {"jac": lambda t, p: banded, "lband": 1, "uband": 1}
