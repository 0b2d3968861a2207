"""Modes of constant matrices."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from viscodesign.solve.numerics.decoupling import balancing, decoupled


def shifted(matrix: np.ndarray) -> Callable[[float], Callable[[np.ndarray], np.ndarray]]:
    def make(shift: float) -> Callable[[np.ndarray], np.ndarray]:
        inverse = np.linalg.inv(shift * np.eye(len(matrix)) - matrix)
        return lambda rhs: inverse @ rhs

    return make


def chain(resistances: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Exchange of a row of stores of these sizes, the first one with an inlet."""
    conductance = 1 / resistances
    matrix = np.diag(conductance + np.append(conductance[1:], 0.0))
    matrix -= np.diag(conductance[1:], 1) + np.diag(conductance[1:], -1)
    return -matrix / sizes


def test_modes_rebuild_the_matrix() -> None:
    sizes = np.array([1.0, 3.0, 0.2, 5.0, 1.0])
    matrix = chain(np.arange(1.0, 6.0), sizes)
    modes = decoupled(matrix, shifted(matrix), 1.0)
    assert np.isrealobj(modes.rates)
    assert np.all(modes.rates > 0.0)
    rebuilt = modes.shapes @ np.diag(-modes.rates) @ modes.inverse
    assert np.max(np.abs(rebuilt - matrix)) <= 1e-14 * np.max(np.abs(matrix))


def test_what_is_sealed_has_a_rate_of_exactly_zero() -> None:
    matrix = np.array([[-1.0, 1.0, 0.0], [1.0, -3.0, 2.0], [0.0, 2.0, -2.0]])
    assert np.count_nonzero(decoupled(matrix, shifted(matrix), 1.0).rates == 0.0) == 1


def test_slow_modes_keep_their_digits_beside_fast_ones() -> None:
    """A wide tube in a chain makes one rate a billion times the others."""
    resistances = np.ones(6)
    resistances[2] = 1e-9
    matrix = chain(resistances, np.ones(6))

    def accurately(shift: float) -> Callable[[np.ndarray], np.ndarray]:
        # With the flow of the wide tube as an unknown: well conditioned.
        ends = np.zeros(6)
        ends[1], ends[2] = 1.0, -1.0
        cut = chain(np.where(resistances < 1.0, np.inf, resistances), np.ones(6))
        full = np.block(
            [[shift * np.eye(6) - cut, ends[:, None]], [ends[None, :], np.array([[-1e-9]])]]
        )
        return lambda rhs: np.linalg.solve(full, np.vstack([rhs, np.zeros((1, rhs.shape[1]))]))[:6]

    modes = decoupled(matrix, accurately, 1.0)
    joined = np.array([1.0, 2.0, 1.0, 1.0, 1.0])
    merged = chain(np.ones(5), joined)
    assert np.sort(modes.rates)[:5] == pytest.approx(
        np.sort(-np.linalg.eigvals(merged).real), rel=1e-8
    )
    assert np.max(modes.rates) == pytest.approx(2e9, rel=1e-8)
    exact = decoupled(merged, shifted(merged), 1.0)
    coarser = decoupled(matrix, accurately, 0.1)
    assert np.sort(coarser.rates)[0] == pytest.approx(np.sort(modes.rates)[0], rel=1e-12)
    assert exact.shift == 0.0


def test_oscillations_have_complex_modes() -> None:
    matrix = np.array([[0.0, 1.0], [-9.0, -0.2]])
    assert balancing(matrix) is None
    modes = decoupled(matrix, shifted(matrix), 1.0)
    assert np.abs(modes.rates) == pytest.approx([3.0, 3.0])
    rebuilt = modes.shapes @ np.diag(-modes.rates) @ modes.inverse
    assert np.max(np.abs(rebuilt - matrix)) <= 1e-14


@pytest.mark.parametrize(
    "matrix",
    [[[-1.0, 1.0], [0.0, -1.0]], [[0.1, 1.0], [-1.0, 0.1]], [[1.0, 0.0], [0.0, -1.0]]],
    ids=["coinciding", "growing oscillation", "growing"],
)
def test_systems_without_accurate_or_bounded_modes_are_refused(matrix: list[list[float]]) -> None:
    own = np.array(matrix)
    with pytest.raises(np.linalg.LinAlgError):
        decoupled(own, shifted(own), 1.0)
