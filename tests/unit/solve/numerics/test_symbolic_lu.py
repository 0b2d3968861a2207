"""Symbolic LU against a dense solver."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from viscodesign.solve.numerics.symbolic_lu import SymbolicLU


@given(size=st.integers(1, 25), density=st.floats(0.0, 1.0), seed=st.integers(0, 2**31))
def test_solutions_equal_those_of_a_dense_solver(size: int, density: float, seed: int) -> None:
    random = np.random.default_rng(seed)
    entries = (random.random((size, size)) < density) * random.normal(size=(size, size))
    matrix = entries + np.diag(1 + np.sum(np.abs(entries), axis=1))
    right = random.normal(size=size)
    sparse = ca.sparsify(ca.DM(matrix))
    symbol = ca.SX.sym("matrix", sparse.sparsity())
    elimination = SymbolicLU(sparse.sparsity())
    solve = ca.Function(
        "solve", [symbol], [elimination.solution(elimination.factors(symbol), right)]
    )
    found = np.array(solve(sparse)).ravel()
    assert found == pytest.approx(np.linalg.solve(matrix, right), rel=1e-12, abs=1e-13)


def test_work_for_a_chain_is_linear_in_its_length() -> None:
    def work(size: int) -> int:
        chain = ca.Sparsity.band(size, 1) + ca.Sparsity.band(size, -1) + ca.Sparsity.diag(size)
        symbol = ca.SX.sym("matrix", chain)
        return int(ca.Function("f", [symbol], [SymbolicLU(chain).factors(symbol)]).n_instructions())

    assert work(400) <= 2.1 * work(200)


def test_a_structurally_zero_pivot_is_refused() -> None:
    with pytest.raises(ValueError, match="structurally zero"):
        SymbolicLU(ca.Sparsity.band(4, 1))
