"""Equilibria that follow each other in time, in native code."""

from __future__ import annotations

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.native.algebraic_part import ALGEBRAIC_TOL, LARGEST_LEFT, MAX_CORRECTIONS
from viscodesign.native.march import work_size
from viscodesign.native.sparse_lu import SparseLU
from viscodesign.native.tables import Assembly


@dataclass
class FollowState:
    """Where a sequence of equilibria is; it is moved on in place."""

    now: np.ndarray
    """(n,): the latest solution."""
    time: float
    before: np.ndarray
    """(n,): the solution before it."""
    time_before: float
    """Equal to ``time`` where there is none [s]."""


def follow_equilibria(
    assembly: Assembly,
    lu: SparseLU,
    mass: np.ndarray,
    rest: np.ndarray,
    state: FollowState,
    times: np.ndarray,
    span: slice,
    *,
    most_ahead: float,
    near: float,
) -> np.ndarray:
    """Solutions (m, n) of the rows without masses, 0 = r(y, t), at the first m of ``times``.

    By Newton's full steps from what the two solutions before extrapolate to, at most ``most_ahead``
    times as far ahead as they are apart; it ends where these do not converge, or where unknowns in
    ``span`` are farther than ``near``, relative to the largest of them, from their guess and from
    the solution before. ``mass`` (n,): that of other rows, whose unknowns stay; ``rest``: see
    `march`.
    """
    n = assembly.unknowns
    Y = np.concatenate([np.zeros(n + assembly.drives + 1), rest])
    fits = (lu.size, lu.entries, len(mass)) == (n, assembly.entries, n)
    if not fits or len(state.now) != n or len(state.before) != n or len(Y) < assembly.reach:
        raise ValueError("assembly, LU, masses, unknowns and inputs are not of one system")
    if not 0 <= span.start <= span.stop <= n:
        raise ValueError(f"no unknowns {span.start} to {span.stop} among {n}")
    before, now = state.before.astype(float), state.now.astype(float)
    clock = np.array([state.time_before, state.time])
    outputs = np.empty((len(times), n))
    count = assembly.loops(
        "follow_equilibria",
        *(lu.layout_of(assembly.layout), assembly.kernels, assembly.idx, assembly.rows),
        *(lu.entries_of(assembly.pos), assembly.all_numbers),
        *(lu.blocks, lu.own, lu.slots, lu.lu_start, lu.lu_columns, lu.diagonal),
        *(mass, len(times), np.ascontiguousarray(times, dtype=float), span.start, span.stop),
        np.array([ALGEBRAIC_TOL, LARGEST_LEFT, MAX_CORRECTIONS, most_ahead, near], dtype=float),
        *(before, now, clock, Y, outputs.reshape(-1), np.empty(work_size(assembly, lu))),
    )
    state.before, state.now = before, now
    state.time_before, state.time = clock.tolist()
    return outputs[:count]
