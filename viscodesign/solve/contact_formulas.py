"""Functions that a step with contact calls, and their results as matrices."""

from __future__ import annotations

import casadi as ca
import numpy as np

from viscodesign.model.formulas import Formulas
from viscodesign.model.jacobian import jacobian
from viscodesign.model.rod_equations import CONTACT_FORCES
from viscodesign.solve.numerics.dense_or_sparse import MAX_DENSE, Matrix, numeric

SX = ca.SX


def placed(entries: np.ndarray, pattern: ca.Sparsity) -> Matrix:
    """A matrix of its entries that are not zero by structure."""
    if max(pattern.shape) > MAX_DENSE:
        return numeric(ca.DM(pattern, entries))
    rows, columns = pattern.get_triplet()
    found = np.zeros(pattern.shape)
    found[rows, columns] = entries
    return found


def filled(values: np.ndarray, pattern: ca.Sparsity) -> np.ndarray:
    """Columns (m, rows) of results whose entries (m, nnz) a pattern places."""
    found = np.zeros((len(values), pattern.size1()))
    found[:, pattern.row()] = values
    return found


def implicit_step(e: Formulas) -> ca.Function:
    """(x, z, *tail, duration) -> (residuals, then gaps and slips; their Jacobian).

    Unknowns: states but for the forces of contact, algebraic unknowns, forces of contact.
    """
    arguments, rows, unknowns = _implicit(e)
    return ca.Function("implicit", arguments, [rows, jacobian(rows, unknowns)])


def implicit_residual(e: Formulas) -> ca.Function:
    """(x, z, *tail, duration) -> residuals, then gaps and slips."""
    arguments, rows, _ = _implicit(e)
    return ca.Function("implicit_residual", arguments, [rows])


def _implicit(e: Formulas) -> tuple[list[SX], SX, SX]:
    """Arguments, rows and unknowns of a step.

    Residuals: states minus their rates times the duration, of which those at the start of the step
    are to be subtracted, then the algebraic equations.
    """
    duration = SX.sym("duration")
    x, z = e.states.vector, e.algebraics.vector
    own, forces = ca.vertsplit(x, [0, e.states.blocks[CONTACT_FORCES].start, x.numel()])
    rates = e.ode[: own.numel()]
    rows = ca.densify(ca.vertcat(own - duration * rates, e.alg, e.contact_paths))
    return [x, z, *e.tail, duration], rows, ca.vertcat(own, z, forces)


def powers_and_paths(e: Formulas) -> ca.Function:
    """(x, z, *tail) -> (powers, gaps and slips)."""
    results = [ca.densify(e.quadrature), ca.densify(e.contact_paths)]
    return ca.Function("powers", [e.states.vector, e.algebraics.vector, *e.tail], results)


def friction_coefficients(e: Formulas) -> ca.Function:
    """Parameters -> coefficients of friction."""
    return ca.Function("friction", [e.tail[-1]], [ca.densify(e.contact_friction)])
