"""Linear stability of a run's initial equilibrium.

Coefficients that are not reciprocal can feed work into a motion (`not_reciprocal`): the
model then is weakly unstable under load, which numerical damping must not hide.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from viscodesign.model.formulas import Formulas
from viscodesign.model.rod_equations import RodForm
from viscodesign.results.findings import Notice
from viscodesign.solve.problem import Problem, evaluate
from viscodesign.solve.statics import Start

MAX_STATES = 400
"""States up to which eigenvalues are computed: their cost grows with the third power."""
GROWTH_REL_TOL = 1e-6
"""Growth rate, over the slowest frequency, or over the fastest decay where nothing oscillates, from
which it is not round-off."""


def growth_notices(problem: Problem, start: Start) -> list[Notice]:
    """A warning where the initial equilibrium is unstable, with growth rate and frequency."""
    equations = problem.equations
    moving = equations.rod_form is RodForm.DYNAMIC
    if not moving or equations.states.count > MAX_STATES:
        return []
    values = eigenvalues(problem, start)
    fastest = values[int(np.argmax(values.real))]
    swings = values[np.abs(values.imag) > 0.0]
    scale = np.min(np.abs(swings)) if swings.size else np.max(np.abs(values))
    if fastest.real <= GROWTH_REL_TOL * scale or fastest.real <= 0.0:
        return []
    message = (
        f"the initial equilibrium is linearly unstable: perturbations grow at {fastest.real:.4g} "
        f"1/s and {abs(fastest.imag):.5g} rad/s, because the coefficients of the coupling are "
        "not reciprocal and do work on them"
    )
    return [Notice("self_excited", message, "bellows", 0.0)]


def eigenvalues(problem: Problem, start: Start) -> np.ndarray:
    """Eigenvalues (nx,) of the motion linearised about a start, inlets held [1/s]."""
    e = problem.equations
    function = e.compiled(_linearised)
    arguments = (start.states, start.algebraics, 0.0, problem.schedule.initial_piece)
    fx, fz, gx, gz = (m.full() for m in evaluate(function, *arguments, problem.numbers()))
    if start.algebraics.size:
        fx = fx - fz @ np.linalg.solve(gz, gx)
    return np.asarray(np.linalg.eigvals(fx))


def _linearised(e: Formulas) -> ca.Function:
    """(x, z, t, pieces, parameters) -> Jacobians of both sides in both kinds of unknowns."""
    x, z = e.states.vector, e.algebraics.vector
    given = [x, z, e.time, e.pieces, e.parameters]
    return ca.Function(
        "linearised", given, [ca.jacobian(f, v) for f in (e.ode, e.alg) for v in (x, z)]
    )
