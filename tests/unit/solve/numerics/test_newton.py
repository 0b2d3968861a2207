"""Newton's iteration and continuation."""

from __future__ import annotations

import itertools

import casadi as ca
import numpy as np
import pytest

from viscodesign.solve.numerics.newton import NewtonError, continuation, newton


def test_growing_corrections_are_divergence() -> None:
    """A power of y has no root; every correction is longer than the one before."""
    evaluations = itertools.count()

    def without_zero(y: np.ndarray) -> tuple[np.ndarray, ca.DM]:
        next(evaluations)
        return y**-0.5, ca.DM(-0.5 * y**-1.5)

    with pytest.raises(NewtonError):
        newton(without_zero, np.array([1.0]))
    assert next(evaluations) < 10


@pytest.mark.parametrize("start", [0.5, 5.0, 20.0])
def test_converges_from_a_distant_start(start: float) -> None:
    def bent(y: np.ndarray) -> tuple[np.ndarray, ca.DM]:
        return np.arctan(y), ca.DM(1 / (1 + y**2))

    assert newton(bent, np.array([start])) == pytest.approx(0.0, abs=1e-12)


def test_continuation_extrapolates_from_the_previous_solution() -> None:
    evaluations = itertools.count()

    def family(y: np.ndarray, share: float) -> tuple[np.ndarray, ca.DM]:
        """sinh y = 2 + s/10."""
        next(evaluations)
        return np.sinh(y) - 2 - share / 10, ca.DM(np.cosh(y))

    begin, before, end = (np.array([np.arcsinh(2 + s / 10)]) for s in (0, -1, 1))
    plain = continuation(family, begin)
    alone = next(evaluations)
    foreseen = continuation(family, begin, previous=(before, -1.0))
    assert next(evaluations) - alone - 1 < alone
    assert plain == pytest.approx(end, abs=1e-12)
    assert foreseen == pytest.approx(end, abs=1e-12)
