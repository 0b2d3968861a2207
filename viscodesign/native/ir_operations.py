"""CasADi's operations on scalars in LLVM's terms."""

from __future__ import annotations

from functools import cache

import casadi as ca
import numpy as np

ARITHMETIC = {
    "ADD": ("fadd contract", "{x}, {y}"),
    "SUB": ("fsub contract", "{x}, {y}"),
    "MUL": ("fmul contract", "{x}, {y}"),
    "DIV": ("fdiv contract", "{x}, {y}"),
    "NEG": ("fneg", "{x}"),
    "SQ": ("fmul contract", "{x}, {x}"),
    "TWICE": ("fadd contract", "{x}, {x}"),
    "INV": ("fdiv contract", "{one}, {x}"),
}
"""Instruction, and its operands."""

INTRINSICS = {
    "SQRT": "sqrt",
    "FABS": "fabs",
    "FLOOR": "floor",
    "CEIL": "ceil",
    "FMIN": "minnum",
    "FMAX": "maxnum",
    "COPYSIGN": "copysign",
}
"""Operations that LLVM knows for vectors, on every processor."""

LIBRARY = {
    "SIN": "sin",
    "COS": "cos",
    "TAN": "tan",
    "ASIN": "asin",
    "ACOS": "acos",
    "ATAN": "atan",
    "ATAN2": "atan2",
    "SINH": "sinh",
    "COSH": "cosh",
    "TANH": "tanh",
    "ASINH": "asinh",
    "ACOSH": "acosh",
    "ATANH": "atanh",
    "EXP": "exp",
    "LOG": "log",
    "LOG1P": "log1p",
    "EXPM1": "expm1",
    "POW": "pow",
    "CONSTPOW": "pow",
    "HYPOT": "hypot",
    "FMOD": "fmod",
    "REMAINDER": "remainder",
    "ERF": "erf",
}
"""Functions of the C library, the same that CasADi calls."""

COMPARISONS = {"LT": "olt", "LE": "ole", "EQ": "oeq", "NE": "une"}


@cache
def expansion(name: str) -> ca.Function | None:
    """An operation as a function of simpler ones, if it is one."""
    if name != "ERFINV":
        return None
    x = ca.SX.sym("x")
    return ca.Function("erfinv", [x], [_erfinv(x)])


def _erfinv(x: ca.SX) -> ca.SX:
    """CasADi's inverse of the error function: a rational guess and two steps of Newton's method."""
    square = x * x
    inner = (
        x
        * (((-0.140543331 * square + 0.914624893) * square - 1.645349621) * square + 0.886226899)
        / (
            (((0.012229801 * square - 0.329097515) * square + 1.442710462) * square - 2.118377725)
            * square
            + 1.0
        )
    )
    z = ca.sqrt(-ca.log((1.0 - ca.fabs(x)) / 2.0))
    outer = (((1.641345311 * z + 3.429567803) * z - 1.624906493) * z - 1.970840454) / (
        (1.637067800 * z + 3.543889200) * z + 1.0
    )
    y = ca.if_else(ca.fabs(x) < 0.7, inner, ca.copysign(outer, x))
    for _ in range(2):
        y -= (ca.erf(y) - x) / (2.0 / np.sqrt(np.pi) * ca.exp(-y * y))
    beyond = ca.if_else(ca.fabs(x) == 1.0, ca.copysign(np.inf, x), np.nan)
    return ca.if_else(ca.fabs(x) < 1.0, y, beyond)
