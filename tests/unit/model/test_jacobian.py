"""Jacobians with rows that depend on all unknowns."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from viscodesign.model.jacobian import jacobian

COUNT = 40


def system(dense: int) -> tuple[ca.SX, ca.SX]:
    """A chain, some rows that depend on all of it, and a column on which all depend."""
    y = ca.SX.sym("y", COUNT + 1)
    chain = [ca.sin(y[k] * y[k + 1]) + y[COUNT] ** 2 for k in range(COUNT)]
    sums = [ca.sumsqr(y) * y[k] for k in range(dense)]
    return ca.vertcat(*chain[:7], *sums, *chain[7:]), y


@pytest.mark.parametrize("dense", [0, 1, 3, COUNT])
def test_equals_casadis_jacobian(dense: int) -> None:
    rows, y = system(dense)
    at = np.linspace(0.3, 1.7, COUNT + 1)
    found, want = (
        ca.Function("j", [y], [j])(at) for j in (jacobian(rows, y), ca.jacobian(rows, y))
    )
    assert found.sparsity() == want.sparsity()
    assert np.array(found) == pytest.approx(np.array(want), rel=1e-13, abs=1e-15)


def test_empty_systems_have_empty_jacobians() -> None:
    y = ca.SX.sym("y", 3)
    assert jacobian(ca.SX(0, 1), y).shape == (0, 3)
    assert jacobian(ca.vertcat(y[0]), y).shape == (1, 3)


def test_a_chain_with_one_long_row_needs_few_passes(monkeypatch: pytest.MonkeyPatch) -> None:
    passes = []
    differentiate = ca.jacobian

    def counted(rows: ca.SX, unknowns: ca.SX) -> ca.SX:
        found = differentiate(rows, unknowns)
        columns = found.sparsity().uni_coloring().size2()
        passes.append(min(columns, found.size1()))
        return found

    monkeypatch.setattr(ca, "jacobian", counted)
    jacobian(*system(1))
    assert sum(passes) < 10
