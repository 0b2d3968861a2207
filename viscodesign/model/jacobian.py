"""Jacobians of systems in which a few rows depend on everything."""

from __future__ import annotations

import casadi as ca
import numpy as np

SX = ca.SX

MAX_LONG_ROWS = 64
"""Rows that may be differentiated one by one."""
MIN_SAVING = 2
"""Ratio of passes without and with separate rows from which separating them pays."""


def jacobian(rows: SX, unknowns: SX) -> SX:
    """Derivatives of ``rows`` (m, 1) by ``unknowns`` (n, 1), sparse (m, n).

    CasADi differentiates along columns that share no row, all at once. One row that depends on
    all unknowns, as the volume of a long section does, prevents that: every unknown takes a
    pass of its own. Such rows are separated and differentiated in reverse mode.
    """
    pattern = ca.jacobian_sparsity(rows, unknowns)
    lengths = np.bincount(np.array(pattern.row(), dtype=int), minlength=pattern.size1())
    order = np.argsort(lengths, kind="stable")
    # Passes with the k longest rows separate: the length of the next row, and one for each of them.
    most = min(MAX_LONG_ROWS, len(order) - 1)
    passes = [int(lengths[order[-k - 1]]) + k for k in range(most + 1)]
    dense = int(np.argmin(passes)) if passes else 0
    if not dense or MIN_SAVING * passes[dense] > passes[0]:
        return ca.jacobian(rows, unknowns)
    long, short = np.sort(order[-dense:]), np.sort(order[:-dense])
    parts = [ca.jacobian(rows[own.tolist()], unknowns) for own in (short, long)]
    place = np.argsort(np.concatenate([short, long]))
    return ca.vertcat(*parts)[place.tolist(), :]
