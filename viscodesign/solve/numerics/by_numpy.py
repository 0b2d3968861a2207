"""Small formulas at many arguments at once, each operation by NumPy on all of them.

CasADi's virtual machine takes one argument after the other, and its transcendental functions are
those of C; where the formula is small and the arguments are thousands, this is ten times faster.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import casadi as ca
import numpy as np

UNARY: dict[int, Callable[[Any], Any]] = {
    ca.OP_ASSIGN: lambda a: a,
    ca.OP_NEG: np.negative,
    ca.OP_EXP: np.exp,
    ca.OP_LOG: np.log,
    ca.OP_SQRT: np.sqrt,
    ca.OP_SQ: np.square,
    ca.OP_TWICE: lambda a: 2 * a,
    ca.OP_INV: np.reciprocal,
    ca.OP_SIN: np.sin,
    ca.OP_COS: np.cos,
    ca.OP_TAN: np.tan,
    ca.OP_LOG1P: np.log1p,
    ca.OP_EXPM1: np.expm1,
    ca.OP_NOT: np.logical_not,
    ca.OP_TANH: np.tanh,
    ca.OP_SINH: np.sinh,
    ca.OP_COSH: np.cosh,
    ca.OP_FABS: np.abs,
    ca.OP_SIGN: np.sign,
    ca.OP_FLOOR: np.floor,
    ca.OP_CEIL: np.ceil,
}
BINARY: dict[int, Callable[[Any, Any], Any]] = {
    ca.OP_ADD: np.add,
    ca.OP_SUB: np.subtract,
    ca.OP_MUL: np.multiply,
    ca.OP_DIV: np.divide,
    ca.OP_POW: np.power,
    ca.OP_CONSTPOW: np.power,
    ca.OP_FMIN: np.minimum,
    ca.OP_FMAX: np.maximum,
    ca.OP_LT: np.less,
    ca.OP_LE: np.less_equal,
    ca.OP_EQ: np.equal,
    ca.OP_NE: np.not_equal,
    ca.OP_AND: np.logical_and,
    ca.OP_OR: np.logical_or,
    ca.OP_IF_ELSE_ZERO: lambda a, b: np.where(a, b, 0.0),
    ca.OP_FMOD: np.fmod,
    ca.OP_ATAN2: np.arctan2,
}


class NumpyFunction:
    """A CasADi function of SX, called with one number or N numbers for every argument's entry.

    Raises `NotImplementedError` for an operation that is not in these tables.
    """

    def __init__(self, function: ca.Function) -> None:
        steps: list[tuple[int, list[int], list[int], float]] = []
        for k in range(function.n_instructions()):
            op = function.instruction_id(k)
            known = op in UNARY or op in BINARY or op in (ca.OP_CONST, ca.OP_INPUT, ca.OP_OUTPUT)
            if not known:
                raise NotImplementedError(f"operation {op}")
            constant = function.instruction_constant(k) if op == ca.OP_CONST else 0.0
            places = function.instruction_input(k), function.instruction_output(k)
            steps.append((op, *places, constant))
        self._steps = steps
        self._size = function.sz_w()
        self._offsets = np.cumsum([0, *(function.nnz_out(k) for k in range(function.n_out()))])

    def __call__(self, arguments: Sequence[Sequence[Any]], count: int) -> np.ndarray:
        """All nonzeros of all results (n, N), for arguments of entries that are () or (N,)."""
        work: list[Any] = [0.0] * self._size
        found = np.zeros((self._offsets[-1], count))
        for op, given, place, constant in self._steps:
            if op == ca.OP_CONST:
                work[place[0]] = constant
            elif op == ca.OP_INPUT:
                work[place[0]] = arguments[given[0]][given[1]]
            elif op == ca.OP_OUTPUT:
                found[self._offsets[place[0]] + place[1]] = work[given[0]]
            elif op in UNARY:
                work[place[0]] = UNARY[op](work[given[0]])
            else:
                work[place[0]] = BINARY[op](work[given[0]], work[given[1]])
        return found
