"""Derivatives of recorded steps: native loops against their twin, differences and each other."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.sparse as sparse

from tests.unit.native.network import Network, network
from tests.unit.native.test_loops import REST, both, settings, start
from viscodesign.native.algebraic_part import AlgebraicPart
from viscodesign.native.derivatives import (
    Differentiable,
    Dots,
    Stretch,
    pull_back,
    push_forward,
)
from viscodesign.native.loops import Loops, native_loops
from viscodesign.native.march import MarchStatus, StepRecord, march
from viscodesign.native.sparse_lu import SparseLU

CELLS, DIRECTIONS = 3, 11
EDGES = np.array([0.07, 0.2, 0.31])
ANY_ERROR = 1e30
CHANGE = 1e-4


def recorded(
    loops: Loops,
    change: np.ndarray | None = None,
    end: float = 0.0,
    *,
    has_stages: bool = False,
) -> tuple[Network, Differentiable, Stretch, np.ndarray, np.ndarray]:
    """A march whose sizes of steps depend on times alone, its outputs and its end.

    ``change``: of begin, rest and numbers in one row; ``end``: of the last edge.
    """
    net = network(CELLS, loops)
    n, own = net.assembly.unknowns, len(REST)
    change = np.zeros(n + own + len(net.assembly.all_numbers)) if change is None else change
    net.assembly.all_numbers += change[n + own :]
    lu = SparseLU(n, net.rows, net.columns, loops=loops)
    state, edges = start(CELLS), EDGES + np.array([0.0, 0.0, end])
    record = StepRecord(chunk=3, has_stages=has_stages)
    state.y = 0.1 * np.arange(n) + change[:n]
    rest, found = REST + change[n : n + own], []
    while True:
        status, outputs = march(
            net.assembly, lu, net.mass, rest, state, edges, settings(net, ANY_ERROR, 0.05), 99,
            record,
        )  # fmt: skip
        found.append(outputs)
        if status is not MarchStatus.STEP_LIMIT:
            break
    places = net.rows.astype(np.int32), net.columns.astype(np.int32)
    algebraic = AlgebraicPart(net.mass, *places)
    structure = Differentiable(lu, net.mass, *places, algebraic, net.derived)
    stretch = Stretch(rest, edges, record.rows)
    return net, structure, stretch, np.concatenate(found), state.y


def directions(net: Network) -> Dots:
    chance, n = np.random.default_rng(8), net.assembly.unknowns
    numbers = chance.standard_normal((DIRECTIONS, len(net.assembly.all_numbers)))
    numbers[0] = 0.0
    return Dots(
        chance.standard_normal((DIRECTIONS, n)),
        chance.standard_normal((DIRECTIONS, len(REST))) * [1.0, 0.0],
        np.zeros((DIRECTIONS, 2)),
        numbers,
    )


def test_rates_are_those_of_differences_with_the_same_steps() -> None:
    net, structure, stretch, _, _ = recorded(native_loops())
    dots = directions(net)
    outputs, ends = push_forward(structure, net.assembly, stretch, dots)
    for k in range(DIRECTIONS):
        row = np.concatenate([dots.begin[k], dots.rest[k], dots.numbers[k]])
        more, less = (recorded(native_loops(), s * CHANGE * row) for s in (1, -1))
        wanted = (more[3] - less[3]) / (2 * CHANGE)
        assert outputs[k] == pytest.approx(wanted, abs=1e-6 * np.max(np.abs(wanted)))
        wanted = (more[4] - less[4]) / (2 * CHANGE)
        assert ends[k] == pytest.approx(wanted, abs=1e-6 * np.max(np.abs(wanted)))


def test_recorded_stages_are_those_that_are_solved_for_again() -> None:
    for loops in both():
        found = []
        for has_stages in (False, True):
            net, structure, stretch, outputs, end = recorded(loops, has_stages=has_stages)
            rates, ends = push_forward(structure, net.assembly, stretch, directions(net))
            bars = pull_back(structure, net.assembly, stretch, outputs, end)
            found.append(np.concatenate([rates.ravel(), ends.ravel(), bars.begin, bars.numbers]))
        assert found[1] == pytest.approx(found[0], rel=1e-12, abs=1e-12)


def test_the_end_of_a_stretch_may_move() -> None:
    net, structure, stretch, _, _ = recorded(native_loops())
    dots = directions(net).some(slice(0, 1))
    still = Dots(0 * dots.begin, 0 * dots.rest, np.array([[0.0, 1.0]]), 0 * dots.numbers)
    _, ends = push_forward(structure, net.assembly, stretch, still)
    more, less = (recorded(native_loops(), end=s * 1e-6) for s in (1, -1))
    assert len(more[2].steps) == len(less[2].steps) == len(stretch.steps)
    states = slice(0, CELLS)
    wanted = (more[4] - less[4])[states] / 2e-6
    # The last two steps share what is left, so that both sizes move with the end.
    assert ends[0, states] == pytest.approx(wanted, rel=1e-3)


def test_back_and_forward_agree_and_so_does_the_twin() -> None:
    chance = np.random.default_rng(9)
    found = []
    for loops in both():
        net, structure, stretch, outputs, end = recorded(loops)
        weights = np.random.default_rng(1).standard_normal(outputs.shape)
        last = np.random.default_rng(2).standard_normal(end.shape)
        bars = pull_back(structure, net.assembly, stretch, weights, last)
        dots = directions(net)
        dots.ends[:] = chance.standard_normal(dots.ends.shape)
        rates, ends = push_forward(structure, net.assembly, stretch, dots)
        along = np.einsum("en,den->d", weights, rates) + ends @ last
        parts = (bars.begin, bars.rest, bars.ends, bars.numbers)
        moved = (dots.begin, dots.rest, dots.ends, dots.numbers)
        known = sum(own @ bar for own, bar in zip(moved, parts, strict=True))
        assert along == pytest.approx(known, rel=1e-11, abs=1e-11)
        found.append(np.concatenate(parts))
    assert found[0] == pytest.approx(found[1], rel=1e-10, abs=1e-12)


@pytest.mark.parametrize("size", [1, 9, 60])
def test_transposed_solutions_are_those_of_scipy(size: int) -> None:
    chance = np.random.default_rng(size)
    dense = np.diag(chance.uniform(3, 5, size)) + np.diag(chance.uniform(-1, 1, size - 1), 1)
    dense[-1, 0] += 0.5
    matrix = sparse.coo_matrix(dense)
    lu = SparseLU(size, matrix.row, matrix.col)
    factors = lu.factor(-matrix.data, np.zeros(size), 1.0)
    right = chance.standard_normal(size)
    assert lu.solve_transposed(factors, right) == pytest.approx(np.linalg.solve(dense.T, right))


def test_weights_of_another_shape_are_refused() -> None:
    net, structure, stretch, outputs, end = recorded(native_loops())
    with pytest.raises(ValueError, match="a weight for every unknown"):
        pull_back(structure, net.assembly, stretch, outputs[:, :-1], end)
