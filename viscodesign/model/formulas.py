"""The equations of one structure in symbols, and the functions that are made of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import casadi as ca

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.equation_layout import EquationLayout
from viscodesign.model.jacobian import jacobian
from viscodesign.model.local_equations import LocalEquations
from viscodesign.model.unknowns import SymbolicUnknowns

SX = ca.SX


@dataclass(frozen=True)
class Formulas:
    """The equations of one structure in symbols, valid for every scene of its kind."""

    layout: EquationLayout
    states: SymbolicUnknowns
    algebraics: SymbolicUnknowns
    statics: SymbolicUnknowns
    time: SX
    pieces: SX
    parameters: SX
    """Parameters of an integrator: load factor, sealed volumes, the scene's parameters."""
    tail: Sequence[SX]
    """(t, pieces, load_factor, sealed_volumes, parameters): what follows the unknowns in the
    functions below."""
    ode: SX
    alg: SX
    quadrature: SX
    """Powers over the size of an energy, for an integrator."""
    time_only_quadrature: SX
    """Those that depend on time alone, scaled likewise."""
    statics_rows: SX
    """Equations of the equilibrium."""
    statics_values: Sequence[SX]
    """Amounts beyond rest, intrinsic curvatures and stretches, in its unknowns."""
    outputs: dict[str, SX]
    contact_paths: SX
    """Gaps, then slips of all points that may touch something (2c,) [m]."""
    contact_friction: SX
    """Their coefficients of friction (c,) [1]."""
    quantities: Sequence[SX]
    take_apart: Callable[[], LocalEquations | None]
    """The equations as sums of local terms; None where they are not such sums."""


def balances(e: Formulas) -> ca.Function:
    """(x, z, t, pieces, load_factor, sealed_volumes, parameters) -> (ode, alg)."""
    return ca.Function("balances", [*_unknowns(e), *e.tail], [e.ode, e.alg])


def equilibrium(e: Formulas) -> ca.Function:
    """(y, t, pieces, load_factor, sealed_volumes, parameters) -> (residual, Jacobian,
    amounts beyond rest, intrinsic curvatures, intrinsic stretches)."""
    y = e.statics.vector
    results = [e.statics_rows, jacobian(e.statics_rows, y), *e.statics_values]
    return ca.Function("equilibrium", [y, *e.tail], results)


def constraints(e: Formulas) -> ca.Function:
    """Like `balances`, returning (alg, d alg/d z)."""
    results = [e.alg, jacobian(e.alg, e.algebraics.vector)]
    return ca.Function("constraints", [*_unknowns(e), *e.tail], results)


def outputs(e: Formulas) -> ca.Function:
    """Like `balances`, returning named outputs."""
    arguments = [*_unknowns(e), *e.tail]
    values = [ca.densify(value) for value in e.outputs.values()]
    names = [f"i{k}" for k in range(len(arguments))]
    return ca.Function("outputs", arguments, values, names, list(e.outputs))


def quantities(e: Formulas) -> ca.Function:
    """parameters -> (sealed_volumes, rest_amounts, filled_amounts, motion time, swing time,
    energy size, and the sizes of all blocks of states, algebraics and statics)."""
    return ca.Function("quantities", [e.tail[-1]], list(e.quantities))


def _unknowns(e: Formulas) -> list[SX]:
    return [e.states.vector, e.algebraics.vector]
