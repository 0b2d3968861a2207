"""Formulas of linear equations with constant coefficients, for their modes.

Whether equations are of this kind is read from their formulas, whatever effects these are made
of: all derivatives with respect to the unknowns are free of unknowns, time and inputs.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from viscodesign.model.formulas import Formulas
from viscodesign.model.jacobian import jacobian

SX = ca.SX


def linear_parts(e: Formulas) -> ca.Function:
    """numbers -> derivatives of the rows by the unknowns; the rates' slopes at zero unknowns,
    where these do not depend on time; their second derivatives.

    A function of no results where the equations are not linear.
    """
    none = ca.Function("linear", [e.parameters], [])
    unknowns, clock, rows = _symbols(e)
    if any(ca.which_depends(rows, unknowns, 2, True)):
        return none
    matrix, slopes = jacobian(rows, unknowns), jacobian(e.quadrature, unknowns)
    hessians = [ca.jacobian(slopes[k, :].T, unknowns) for k in range(slopes.size1())]
    _, idle = live_and_idle(matrix.sparsity(), e.states.count)
    varies = ca.depends_on(ca.veccat(matrix, *hessians), ca.vertcat(unknowns, clock))
    if varies or (len(idle) and ca.depends_on(e.quadrature, unknowns[idle.tolist()])):
        return none
    zero = ca.substitute([slopes], [unknowns], [SX.zeros(unknowns.shape)])[0]
    return ca.Function("linear", [e.parameters], [matrix, _parted(zero, clock)[0], *hessians])


def input_parts(e: Formulas) -> ca.Function:
    """(time, pieces, numbers, unknowns) -> what depends on time of rows and slopes; all rates."""
    unknowns, clock, rows = _symbols(e)
    slopes = jacobian(e.quadrature, unknowns)
    results = [_parted(rows, clock)[1], ca.densify(e.quadrature), _parted(slopes, clock)[1]]
    given = [e.time, e.pieces, e.parameters, unknowns]
    return ca.Function("inputs", given, ca.cse(results))


def _symbols(e: Formulas) -> tuple[SX, SX, SX]:
    """Unknowns, time with all coefficients of inputs, and rows."""
    unknowns = ca.vertcat(e.states.vector, e.algebraics.vector)
    return unknowns, ca.vertcat(e.time, e.pieces), ca.vertcat(e.ode, e.alg)


def _parted(values: SX, clock: SX) -> tuple[SX, SX]:
    """The entries that do not depend on time, and those that do, each sparse."""
    values = ca.sparsify(values)
    parts = []
    entries = values.nz[:] if values.nnz() else SX(0, 1)
    depends = np.array(ca.which_depends(entries, clock, 1, True), dtype=bool)
    rows, columns = (np.array(k, dtype=int) for k in values.sparsity().get_triplet())
    for own in (~depends, depends):
        chosen = np.flatnonzero(own)
        pattern = ca.Sparsity.triplet(
            *values.shape, rows[chosen].tolist(), columns[chosen].tolist()
        )
        parts.append(SX(pattern, entries[chosen.tolist()]) if len(chosen) else SX(*values.shape))
    return parts[0], parts[1]


def live_and_idle(pattern: ca.Sparsity, states: int) -> tuple[np.ndarray, np.ndarray]:
    """States on which any row depends, and the others."""
    used = np.diff(np.array(pattern.colind())[: states + 1]) > 0
    return np.flatnonzero(used), np.flatnonzero(~used)
