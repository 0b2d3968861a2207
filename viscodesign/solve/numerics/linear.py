"""Which linear solver suits a system of a given size."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import splu

MOST_FOR_LU = 200
"""Unknowns up to which LU is as cheap as QR (measured: 6 ms against 0.3 ms at 577, 335 ms
against 1.4 ms at 2305)."""
FEW = 60
"""Unknowns up to which CSparse's LU is done before SuperLU is called (measured: equal at 60; 20 ms
against 1 ms at 386, where its factors have filled up)."""


def direct_solver(unknowns: int) -> str:
    """CasADi's name of it.

    LU by CSparse has pivots that do not mind a mirrored sign, which Householder's QR does;
    but its factors fill up, and those of QR stay sparse.
    """
    return "csparse" if unknowns <= MOST_FOR_LU else "qr"


def factorised(matrix: ca.DM) -> Callable[[np.ndarray], np.ndarray]:
    """Solver of the linear system, right side (n,) -> (n,).

    Raises `RuntimeError` where the matrix is singular.
    """
    pattern, count = matrix.sparsity(), matrix.size1()
    if count > FEW:
        values = np.array(matrix.nonzeros())
        found = splu(csc_matrix((values, pattern.row(), pattern.colind()), (count, count)))
        return lambda right: np.asarray(found.solve(right))
    factors = ca.Linsol("few", "csparse", pattern)
    factors.nfact(matrix)
    return lambda right: np.array(factors.solve(matrix, ca.DM(right))).ravel()
