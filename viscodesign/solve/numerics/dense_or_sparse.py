"""Matrices that are dense where they are small, and their solutions for many right-hand sides."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import casadi as ca
import numpy as np

Matrix = Any
"""A dense array, or a sparse matrix of SciPy."""

Solve = Callable[[np.ndarray], np.ndarray]
MAX_DENSE = 200
"""Unknowns up to which matrices are factored densely."""


def numeric(matrix: ca.DM) -> Matrix:
    """Dense, or sparse where it is large."""
    if max(matrix.shape) <= MAX_DENSE:
        return np.asarray(matrix.full())
    return matrix.sparse()


def dense(matrix: Matrix) -> np.ndarray:
    return matrix if isinstance(matrix, np.ndarray) else np.asarray(matrix.toarray())


def diagonal_matrix(values: np.ndarray, like: Matrix) -> Matrix:
    if isinstance(like, np.ndarray):
        return np.diag(values)
    from scipy.sparse import diags

    return diags(values, format="csc")


def solver_of(matrix: Matrix) -> Solve:
    """Solves matrix x = b for many right-hand sides (n, m); raises `LinAlgError` if singular."""
    if isinstance(matrix, np.ndarray):
        diagonal = np.diag(matrix)
        if np.count_nonzero(matrix) == np.count_nonzero(diagonal) == len(diagonal):
            return lambda rhs: np.asarray(rhs / diagonal[:, None])
        inverse = np.linalg.inv(matrix)
        return lambda rhs: np.asarray(inverse @ rhs)
    from scipy.sparse.linalg import splu

    try:
        factors = splu(matrix.tocsc())
    except RuntimeError as error:  # raised for a singular matrix
        raise np.linalg.LinAlgError(str(error)) from error
    return lambda rhs: np.asarray(factors.solve(np.ascontiguousarray(rhs)))
