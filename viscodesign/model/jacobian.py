"""Jacobians of systems in which a few rows depend on everything."""

from __future__ import annotations

import casadi as ca
import numpy as np

SX = ca.SX

MOST_DENSE = 64
"""Rows that may be differentiated each by itself."""
WORTH = 2
"""How many times fewer passes make it worth while to part the rows."""


def jacobian(rows: SX, unknowns: SX) -> SX:
    """Derivatives of ``rows`` (m, 1) by ``unknowns`` (n, 1), sparse (m, n).

    CasADi differentiates along columns that share no row, all at once. One row that depends on
    all unknowns, as the volume of a long section does, lets no two columns go together: it
    takes a pass for every unknown. Such rows are taken apart and differentiated backwards.
    """
    pattern = ca.jacobian_sparsity(rows, unknowns)
    lengths = np.bincount(np.array(pattern.row(), dtype=int), minlength=pattern.size1())
    order = np.argsort(lengths, kind="stable")
    # Passes without the k longest rows: as many as the next one is long, and one for each of them.
    most = min(MOST_DENSE, len(order) - 1)
    passes = [int(lengths[order[-k - 1]]) + k for k in range(most + 1)]
    dense = int(np.argmin(passes)) if passes else 0
    if not dense or WORTH * passes[dense] > passes[0]:
        return ca.jacobian(rows, unknowns)
    long, short = np.sort(order[-dense:]), np.sort(order[:-dense])
    parts = [ca.jacobian(rows[own.tolist()], unknowns) for own in (short, long)]
    place = np.argsort(np.concatenate([short, long]))
    return ca.vertcat(*parts)[place.tolist(), :]
