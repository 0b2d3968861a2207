"""A small nonlinear network as elements, to compare the loops on: a chain of cells.

Cell k has a volume V_k (a state), a pressure p_k (algebraic, V = tanh p + p/2) and a flow from
its neighbour before, the first one from a drive u = sin(w t) c, and leaks p_k / 10. One integral:
of p_1 u.
Unknowns are [V (m) | p (m) | integral].
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from viscodesign.model.elements.kinds import pull_of, push_of
from viscodesign.native.kernels import compile_kernels
from viscodesign.native.loops import Loops, NativeLoops
from viscodesign.native.source.primitives import PythonKernel
from viscodesign.native.tables import Assembly, ElementTable, SourceTable

SX = ca.SX


@dataclass
class Network:
    """An assembly with what is needed around it."""

    assembly: Assembly
    rows: np.ndarray
    columns: np.ndarray
    mass: np.ndarray
    derived: object
    """Kernels of derivatives, four for each pair of kernels."""
    keeper: object

    def y_of(self, y: np.ndarray, time: float, rest: np.ndarray) -> np.ndarray:
        """Y with room for the drives, which are not set."""
        return np.concatenate([y, np.zeros(self.assembly.drives), [time], rest])


def python_kernel(function: ca.Function, lanes: int) -> PythonKernel:
    """The same kernel in CasADi's virtual machine, for the loops in Python."""
    locals_, numbers, values = function.numel_in(0), function.numel_in(1), function.numel_out(0)
    many = function.map(lanes)

    def kernel(local: np.ndarray, own: np.ndarray, out: np.ndarray) -> None:
        found = many(
            local[: locals_ * lanes].reshape(locals_, lanes),
            own[: numbers * lanes].reshape(numbers, lanes),
        )
        out[: values * lanes] = np.array(found).reshape(-1)

    return kernel


def network(cells: int, loops: Loops, lanes: int = 8) -> Network:
    """A chain of ``cells`` cells; Y ends with [time, coefficient c, 1]."""
    n = 2 * cells + 1
    place_u, place_t, place_c, place_one = n, n + 1, n + 2, n + 3
    p, V = cells, 0
    k = np.arange(cells)
    before = np.where(k == 0, place_u, p + k - 1)
    tubes = (
        _tube(),
        np.stack([before, p + k], 1),
        np.linspace(1.0, 3.0, cells)[:, None],
        np.stack([np.where(k == 0, n, k - 1), k], 1),
    )
    walls = (
        _wall(),
        np.stack([V + k, p + k], 1),
        np.full((cells, 0), 0.0),
        (p + k)[:, None],
    )
    work = (
        _work(),
        np.array([[p, place_u]]),
        np.zeros((1, 0)),
        np.array([[2 * cells]]),
    )
    kinds = [tubes, walls, work]
    functions = [f for kind in kinds for f in _pair(*kind[0])]
    functions += [*_source()]
    pairs = zip(functions[::2], functions[1::2], strict=True)
    derived_functions = [
        derive(own) for pair in pairs for derive in (pull_of, push_of) for own in pair
    ]
    kernels: Sequence[object]
    if isinstance(loops, NativeLoops):
        compiled = compile_kernels(functions, "network", lanes)
        kernels = [compiled.address(q) for q in range(len(functions))]
        own = compile_kernels(derived_functions, "derivatives of a network", lanes)
        derived: object = np.array([own.address(q) for q in range(len(own))], dtype=np.int64)
        keeper: object = (compiled, own)
    else:
        kernels, keeper = [python_kernel(f, lanes) for f in functions], None
        derived = [python_kernel(f, lanes) for f in derived_functions]
    triplets = []
    for (local, _, out), idx, _, rows in kinds:
        r, c = (np.array(q) for q in ca.jacobian(out, local).sparsity().get_triplet())
        triplets.append((rows[:, r], idx[:, c]))
    all_rows = np.concatenate([r.ravel() for r, _ in triplets])
    all_columns = np.concatenate([c.ravel() for _, c in triplets])
    inside = (all_rows < n) & (all_columns < n)
    keys, own = np.unique(all_rows[inside] * n + all_columns[inside], return_inverse=True)
    driven = np.flatnonzero((all_rows < n) & (all_columns == place_u))
    pos = np.full(len(all_rows), len(keys))
    pos[inside] = own
    pos[driven] = len(keys) + 1 + np.arange(len(driven))
    tables, at = [], 0
    for q, (_, idx, numbers, rows) in enumerate(kinds):
        count = triplets[q][0].size
        entries = pos[at : at + count].reshape(len(idx), -1)
        at += count
        tables.append(
            ElementTable(
                kernels[2 * q],
                kernels[2 * q + 1],
                _lanes(idx, lanes, 0),
                _lanes(numbers, lanes, 1.0),
                _lanes(rows, lanes, n),
                _lanes(entries, lanes, len(keys)),
            )
        )
    leaks = np.full((cells, 1), -0.1)
    own_entry = np.searchsorted(keys, (V + k) * n + p + k)[:, None]
    tables.append(
        ElementTable(
            None,
            None,
            _lanes((p + k)[:, None], lanes, 0),
            _lanes(leaks, lanes, 0.0),
            _lanes((V + k)[:, None], lanes, n),
            _lanes(own_entry, lanes, len(keys)),
        )
    )
    source = SourceTable(
        kernels[-2],
        kernels[-1],
        _lanes(np.array([[place_t, place_c, place_one]]), lanes, 0),
        _lanes(np.array([[2.0]]), lanes, 1.0),
        _lanes(np.array([[0]]), lanes, 1),
    )
    assembly = Assembly(
        tables,
        [source],
        n,
        1,
        len(keys),
        all_rows[driven],
        np.zeros(len(driven)),
        loops=loops,
    )
    mass = np.concatenate([np.ones(cells), np.zeros(cells), [1.0]])
    return Network(assembly, keys // n, keys % n, mass, derived, keeper)


def formulas(cells: int) -> tuple[SX, SX, SX, SX, SX, SX]:
    """The same in one piece: V, p, (time, [c, 1]), rates of V, residual of p, rate of the integral."""
    V, p, t, rest = SX.sym("V", cells), SX.sym("p", cells), SX.sym("t"), SX.sym("rest", 2)
    u = _drive(ca.vertcat(t, rest), SX(2.0))
    resistance = np.linspace(1.0, 3.0, cells)
    q = [_flow(u if k == 0 else p[k - 1], p[k], resistance[k]) for k in range(cells)]
    rates = [q[k] - (q[k + 1] if k + 1 < cells else 0) - 0.1 * p[k] for k in range(cells)]
    walls = [V[k] - ca.tanh(p[k]) - p[k] / 2 for k in range(cells)]
    return V, p, ca.vertcat(t, rest), ca.vertcat(*rates), ca.vertcat(*walls), p[0] * u


def _flow(start: SX, end: SX, resistance: SX | float) -> SX:
    fall = start - end
    return fall / resistance * (1 + 0.3 * fall**2)


def _drive(local: SX, numbers: SX) -> SX:
    return local[1] * ca.sin(numbers * local[0]) * local[2]


def _tube() -> tuple[SX, SX, SX]:
    local, numbers = SX.sym("l", 2), SX.sym("n", 1)
    q = _flow(local[0], local[1], numbers)
    return local, numbers, ca.vertcat(-q, q)


def _wall() -> tuple[SX, SX, SX]:
    local = SX.sym("l", 2)
    return local, SX.sym("n", 0), local[0] - ca.tanh(local[1]) - local[1] / 2


def _work() -> tuple[SX, SX, SX]:
    local = SX.sym("l", 2)
    return local, SX.sym("n", 0), local[0] * local[1]


def _pair(local: SX, numbers: SX, out: SX) -> tuple[ca.Function, ca.Function]:
    slopes = ca.jacobian(out, local)
    return (
        ca.Function("F", [local, numbers], [ca.densify(out)]),
        ca.Function("J", [local, numbers], [ca.vertcat(*slopes.nonzeros())]),
    )


def _source() -> tuple[ca.Function, ca.Function]:
    local, numbers = SX.sym("l", 3), SX.sym("n", 1)
    value = _drive(local, numbers)
    return (
        ca.Function("u", [local, numbers], [value]),
        ca.Function("u_t", [local, numbers], [ca.jacobian(value, local[0])]),
    )


def _lanes(array: np.ndarray, lanes: int, spare: float) -> np.ndarray:
    """(elements, entries) -> (groups, entries, W), padded."""
    groups = -(-len(array) // lanes)
    padded = np.full((groups * lanes, array.shape[1]), spare)
    padded[: len(array)] = array
    kind = np.float64 if array.dtype == float else np.int32
    return np.ascontiguousarray(padded.reshape(groups, lanes, -1).transpose(0, 2, 1).astype(kind))
