"""The native loops give what their source gives in Python, and what formulas in one piece give."""

from __future__ import annotations

import threading
from dataclasses import replace
from types import SimpleNamespace

import casadi as ca
import numpy as np
import pytest
import scipy.sparse as sparse
from scipy.linalg import expm

from tests.unit.native.network import Network, formulas, network
from viscodesign.native.loops import IR_FILE, Loops, PythonLoops, native_loops, source_digest
from viscodesign.native.march import MarchSettings, MarchState, MarchStatus, march
from viscodesign.native.row_marches import march_rows, sums_of_rows
from viscodesign.native.sparse_lu import SparseLU
from viscodesign.native.tables import Assembly

REST = np.array([0.7, 1.0])


def both() -> list[Loops]:
    return [native_loops(), PythonLoops()]


def test_the_ir_is_made_from_its_source() -> None:
    first = IR_FILE.read_text(encoding="utf-8").splitlines()[0]
    assert first == f"; made from {source_digest()}", "run: python docs/make_loops.py"


@pytest.mark.parametrize("cells", [1, 5, 19])
def test_sums_over_elements_are_the_whole_formulas(cells: int) -> None:
    V, p, tail, *rates = formulas(cells)
    y = ca.vertcat(V, p, ca.SX.sym("integral"))
    right = ca.vertcat(*rates)
    drift = ca.jacobian(right, tail[0])
    whole = ca.Function("whole", [y, tail], [right, ca.jacobian(right, y), drift])
    at, time = np.random.default_rng(cells).uniform(-1, 1, 2 * cells + 1), 0.37
    wanted = [np.array(part) for part in whole(at, [time, *REST])]
    for loops in both():
        net = network(cells, loops)
        Y = net.y_of(at, time, REST)
        rates_u = net.assembly.drive(Y)
        np.testing.assert_allclose(net.assembly.residual(Y), wanted[0][:, 0], rtol=1e-13)
        J = net.assembly.jacobian(Y)
        np.testing.assert_allclose(dense(net, J), wanted[1], rtol=1e-13, atol=1e-15)
        slope = np.zeros(2 * cells + 1)
        np.add.at(slope, net.assembly.drive_rows, J[net.assembly.entries + 1 :] * rates_u[0])
        np.testing.assert_allclose(slope, wanted[2][:, 0], rtol=1e-13)


def dense(net: Network, J: np.ndarray) -> np.ndarray:
    n = net.assembly.unknowns
    return sparse.csr_matrix((J[: len(net.rows)], (net.rows, net.columns)), (n, n)).toarray()


@pytest.mark.parametrize("size", [1, 8, 120])
def test_lu_solves_what_scipy_solves(size: int) -> None:
    rng = np.random.default_rng(size)
    keys = np.unique(rng.integers(0, size * size, 3 * size))
    rows, columns = keys // size, keys % size
    values, mass, right = rng.standard_normal(len(keys)), rng.uniform(1, 2, size), rng.random(size)
    matrix = sparse.diags(mass * 9.0).tolil()
    matrix[rows, columns] -= values
    for loops in both():
        lu = SparseLU(size, rows, columns, loops=loops)
        assert len(np.unique(lu.slots)) == size
        found = lu.solve(lu.factor(values, mass, 9.0), right)
        np.testing.assert_allclose(matrix @ found, right, rtol=1e-11, atol=1e-12)


def test_fill_of_an_arrow_in_its_worst_place_is_avoided() -> None:
    k = np.arange(1, 40)
    lu = SparseLU(40, np.r_[k, 0 * k], np.r_[0 * k, k])
    assert lu.count == 4 * (3 * 19 + 1)


def test_a_singular_matrix_is_told() -> None:
    for loops in both():
        lu = SparseLU(2, np.array([0, 1]), np.array([0, 0]), loops=loops)
        with pytest.raises(ZeroDivisionError):
            lu.factor(np.array([1.0, 1.0]), np.zeros(2), 1.0)
        with pytest.raises(ZeroDivisionError):
            lu.factor(np.array([np.nan, 1.0]), np.ones(2), 1.0)


@pytest.mark.parametrize("seed", range(4))
def test_what_neighbours_hold_is_eliminated_after_them(seed: int) -> None:
    """Places along a chain, held by nothing but the strains between them: an exact solution."""
    rng = np.random.default_rng(seed)
    count, n = 30, 60
    matrix = np.diag(np.repeat([1, 0], count) * rng.integers(1, 9, n))
    for k in range(count):
        for node in (k - 1, k)[k == 0 :]:
            matrix[k, count + node] = rng.choice([-7, 7]) + (node == k)
            matrix[count + node, k] = rng.choice([-2, 2]) + (node == k)
    rows, columns = np.nonzero((matrix != 0) | np.eye(n, dtype=bool))
    order = rng.permutation(n)
    matrix, rows, columns = matrix[order][:, order], order.argsort()[rows], order.argsort()[columns]
    values, exact = -matrix[rows, columns].astype(float), rng.integers(-9, 9, n)
    weak = order >= count
    for loops in both():
        lu = SparseLU(n, rows, columns, weak=weak, loops=loops)
        found = lu.solve(lu.factor(values, np.zeros(n), 1.0), (matrix @ exact).astype(float))
        np.testing.assert_allclose(found, exact, rtol=0, atol=1e-9)
        for i, j in zip(rows[weak[rows]], columns[weak[rows]], strict=True):
            assert weak[j] or lu.slots[j] // 2 < lu.slots[i] // 2
        plain = SparseLU(n, rows, columns, loops=loops)
        with pytest.raises(ZeroDivisionError):
            plain.factor(values, np.zeros(n), 1.0)


def test_an_equation_without_its_own_unknown_goes_after_what_ties_it() -> None:
    rows, columns = np.array([0, 1, 1, 1, 2, 2]), np.array([1, 0, 1, 2, 1, 2])
    values, exact = np.array([3.0, 2.0, 1.0, 4.0, 5.0, 7.0]), np.array([2.0, -3.0, 5.0])
    right = np.bincount(rows, -values * exact[columns])
    for loops in both():
        lu = SparseLU(3, rows, columns, weak=np.array([True, False, False]), loops=loops)
        found = lu.solve(lu.factor(values, np.zeros(3), 1.0), right)
        np.testing.assert_allclose(found, exact, rtol=0, atol=1e-14)


def settings(net: Network, tolerance: float, largest: float, **others: float) -> MarchSettings:
    powers = np.zeros(net.assembly.unknowns - 1)
    return MarchSettings(tolerance, 1.0, powers, largest, 1e-14, **others)


def start(cells: int) -> MarchState:
    return MarchState(np.zeros(2 * cells + 1), 0.0, 1e-3)


def test_march_is_that_of_the_formulas_in_one_piece() -> None:
    """Step by step as `RosenbrockStep`, whose formulas CasADi interprets."""
    from viscodesign.solve.solvers.rodas_formulas import step_function

    cells = 3
    V, p, tail, dV, walls, rate = formulas(cells)
    step = step_function(
        SimpleNamespace(
            states=SimpleNamespace(vector=V, count=cells),
            algebraics=SimpleNamespace(vector=p, count=cells),
            quadrature=rate,
            ode=dV,
            alg=walls,
            time=tail[0],
            pieces=tail[1:],
            parameters=ca.SX.sym("none", 0),
        )
    )
    for loops in both():
        net = network(cells, loops)
        lu = SparseLU(net.assembly.unknowns, net.rows, net.columns, loops=loops)
        state, edges = start(cells), np.array([2.0])
        while state.edge == 0:
            before, time, size = state.y, state.time, state.size
            status, _ = march(
                net.assembly, lu, net.mass, REST, state, edges, settings(net, 1e-4, 0.2), 1
            )
            if state.time > time:
                after = np.array(step(before, time, state.time - time, REST, [])[0])[:, 0]
                np.testing.assert_allclose(state.y, after, rtol=1e-12, atol=1e-13)
            assert size > 0
        assert status is MarchStatus.FINISHED
        assert state.steps > 10


def test_native_and_python_marches_agree() -> None:
    edges = np.concatenate([np.linspace(0.01, 0.02, 3), np.linspace(0.3, 3.0, 7)])
    found = []
    for loops in both():
        net = network(5, loops)
        lu = SparseLU(net.assembly.unknowns, net.rows, net.columns, loops=loops)
        state = start(5)
        state.size = 0.5  # refused
        status, outputs = march(
            net.assembly, lu, net.mass, REST, state, edges, settings(net, 1e-5, 0.3), 1000
        )
        assert status is MarchStatus.FINISHED
        assert len(outputs) == len(edges)
        found.append((state, outputs))
    (one, first), (two, second) = found
    assert (one.steps, one.rejected, one.jacobians) == (two.steps, two.rejected, two.jacobians)
    assert one.rejected > 0
    assert one.residuals == 8 * one.steps
    np.testing.assert_allclose(first, second, rtol=1e-9, atol=1e-12)
    np.testing.assert_array_equal(first[-1], one.y)


def test_marching_in_parts_changes_nothing() -> None:
    net = network(4, native_loops())
    lu = SparseLU(net.assembly.unknowns, net.rows, net.columns)
    edges, how = np.linspace(0.1, 2.0, 9), settings(net, 1e-5, 0.1)
    whole, parts = start(4), start(4)
    _, wanted = march(net.assembly, lu, net.mass, REST, whole, edges, how, 1000)
    found, status = [], MarchStatus.STEP_LIMIT
    while status is MarchStatus.STEP_LIMIT:
        status, some = march(net.assembly, lu, net.mass, REST, parts, edges, how, 3)
        found.append(some)
    np.testing.assert_array_equal(np.concatenate(found), wanted)
    assert parts.steps == whole.steps


def test_rows_with_numbers_of_their_own_march_as_each_alone() -> None:
    edges = [np.linspace(0.1, end, 3) for end in (0.3, 0.6, 0.4)]
    chance, sizes = np.random.default_rng(1), np.array([1e-3, 0.1, 0.02])
    for loops in both():
        net = network(2, loops)
        lu = SparseLU(net.assembly.unknowns, net.rows, net.columns, loops=loops)
        factors = chance.uniform(0.5, 2.0, (3, len(net.assembly.all_numbers)))
        numbers = net.assembly.all_numbers * factors
        begun = np.array([net.y_of(np.full(5, 0.1 * k), 0.05 * k, REST) for k in range(3)])
        how = [replace(settings(net, 1e-4, 0.2), motion_time=1.0 + k) for k in range(3)]
        found = march_rows(net.assembly, lu, net.mass, numbers, begun, how, sizes, edges, 1000)
        J, residuals = sums_of_rows(net.assembly, numbers, begun.copy())
        assert found.finished.all()
        for k in range(3):
            alone = net.assembly.copy()
            alone.all_numbers[:] = numbers[k]
            Y = begun[k].copy()
            alone.drive(Y)
            np.testing.assert_array_equal(J[k], alone.jacobian(Y))
            np.testing.assert_array_equal(residuals[k], alone.residual(Y))
            state = MarchState(begun[k, :5], begun[k, 6], sizes[k])
            _, outputs = march(alone, lu, net.mass, REST, state, edges[k], how[k], 1000)
            np.testing.assert_array_equal(found.outputs[k], outputs)
            np.testing.assert_array_equal(found.y[k], state.y)
            assert (found.sizes[k], found.steps[k]) == (state.size, state.steps)
        few = march_rows(net.assembly, lu, net.mass, numbers, begun, how, sizes, edges, 9)
        assert few.finished.tolist() == (found.steps <= 9).tolist()


def test_rows_that_do_not_fit_are_refused() -> None:
    net = network(2, native_loops())
    with pytest.raises(ValueError, match="too short"):
        sums_of_rows(net.assembly, net.assembly.all_numbers[None], np.zeros((1, 5)))
    with pytest.raises(ValueError, match="numbers of shape"):
        sums_of_rows(net.assembly, net.assembly.all_numbers[None], np.zeros((2, 9)))


def test_order_five_and_dense_order_four_of_a_linear_system() -> None:
    system, decay = linear_system()
    errors = []
    for h in (0.1, 0.05, 0.025):
        state = MarchState(np.array([1.0, 0.0]), 0.0, h)
        edges = np.array([0.5 * h, 0.97, 1.0])
        how = MarchSettings(1e6, 1.0, np.zeros(2), h, 1e-14)
        lu = SparseLU(2, np.array([0, 0, 1, 1]), np.array([0, 1, 0, 1]))
        _, outputs = march(system, lu, np.ones(2), np.zeros(0), state, edges, how, 1000)
        exact = [expm(decay * t) @ [1.0, 0.0] for t in edges]
        errors.append(np.abs(outputs - exact).max(axis=1))
    slopes = np.log2(np.array(errors[:-1]) / np.array(errors[1:]))
    assert (slopes[:, 0] > 4.5).all()
    assert (slopes[:, 1] > 3.7).all()
    assert (slopes[:, 2] > 4.7).all()
    assert errors[-1][2] < 1e-7


def linear_system() -> tuple[Assembly, np.ndarray]:
    from viscodesign.native.source.primitives import PythonKernel
    from viscodesign.native.tables import ElementTable

    matrix = np.array([[-1.0, 2.0], [-2.0, -3.0]])

    def value(local: np.ndarray, _: np.ndarray, out: np.ndarray) -> None:
        out[:2] = matrix @ local[:2]

    def slope(_: np.ndarray, __: np.ndarray, out: np.ndarray) -> None:
        out[:4] = matrix.ravel()

    kernels: list[PythonKernel] = [value, slope]
    places = np.arange(2, dtype=np.int32).reshape(1, 2, 1)
    pos = np.arange(4, dtype=np.int32).reshape(1, 4, 1)
    table = ElementTable(*kernels, places, np.zeros((1, 0, 1)), places, pos)
    return Assembly([table], [], 2, 0, 4, loops=PythonLoops()), matrix


def test_what_is_not_finite_ends_the_march() -> None:
    net = network(2, native_loops())
    lu = SparseLU(net.assembly.unknowns, net.rows, net.columns)
    state = start(2)
    how = MarchSettings(1e-4, 1.0, np.zeros(4), 0.1, 1e-6)
    rest = np.array([np.nan, 1.0])
    status, outputs = march(net.assembly, lu, net.mass, rest, state, np.array([1.0]), how, 1000)
    assert status is MarchStatus.STEP_TOO_SMALL
    assert len(outputs) == 0
    assert state.time == 0.0


def test_untested_unknowns_do_not_limit_the_steps() -> None:
    net = network(2, native_loops())
    lu = SparseLU(net.assembly.unknowns, net.rows, net.columns)
    steps = []
    for power in (0.0, np.inf):
        state = start(2)
        how = MarchSettings(1e-9, 1.0, np.full(4, power), 1.0, 1e-14)
        march(net.assembly, lu, net.mass, REST, state, np.array([2.0]), how, 10_000)
        steps.append(state.steps)
    assert steps[1] < steps[0]


def test_threads_share_an_assembly() -> None:
    net = network(6, native_loops())
    lu = SparseLU(net.assembly.unknowns, net.rows, net.columns)
    ends: list[np.ndarray] = []

    def run() -> None:
        state = start(6)
        how = settings(net, 1e-6, 0.1)
        march(net.assembly, lu, net.mass, REST, state, np.array([3.0]), how, 10_000)
        ends.append(state.y)

    threads = [threading.Thread(target=run) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(ends) == 4
    assert all((end == ends[0]).all() for end in ends)


def test_indices_out_of_range_are_refused() -> None:
    net = network(2, native_loops())
    with pytest.raises(ValueError, match="too short"):
        net.assembly.residual(np.zeros(5))
    table = net.assembly.keeper[0]
    with pytest.raises(ValueError, match="rows is not below"):
        Assembly([table], [], 1, 0, 100)
