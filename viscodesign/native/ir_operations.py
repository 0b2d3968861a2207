"""CasADi's operations on scalars in LLVM's terms."""

from __future__ import annotations

from functools import cache

import casadi as ca
import numpy as np

ARITHMETIC = {
    "ADD": ("fadd contract", "{x}, {y}"),
    "SUB": ("fsub contract", "{x}, {y}"),
    "MUL": ("fmul contract", "{x}, {y}"),
    "DIV": ("fdiv contract arcp", "{x}, {y}"),
    "NEG": ("fneg", "{x}"),
    "SQ": ("fmul contract", "{x}, {x}"),
    "TWICE": ("fadd contract", "{x}, {x}"),
    "INV": ("fdiv contract arcp", "{one}, {x}"),
}
"""Instruction, and its operands. Quotients by one divisor may share its reciprocal."""

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
LOGIC = ("NOT", "AND", "OR", "IF_ELSE_ZERO", "SIGN")


@cache
def expansion(name: str) -> ca.Function | None:
    """An operation as a function of simpler ones, if it is one.

    The angle is one because it is in every bend of a rod: the library's takes lane by lane.
    """
    x, y = ca.SX.sym("x"), ca.SX.sym("y")
    match name:
        case "ATAN":
            return ca.Function("atan", [x], [_atan2(x, ca.SX(1))])
        case "ATAN2":
            return ca.Function("atan2", [x, y], [_atan2(x, y)])
        case "ERFINV":
            return ca.Function("erfinv", [x], [_erfinv(x)])
    return None


def _atan2(y: ca.SX, x: ca.SX) -> ca.SX:
    """Angle of (x, y) to two units in the last place, by the rational function of Cephes.

    Source: S. L. Moshier, Cephes mathematical library, atan.c (double precision).
    """
    width, height = ca.fabs(x), ca.fabs(y)
    # Written so that what is not a number stays in one of the two.
    upright = height > width
    less, more = ca.if_else(upright, width, height), ca.if_else(upright, height, width)
    # Of two zeros the angle is that of the axis, of two infinities that of the diagonal.
    infinite = ca.logic_and(less == np.inf, more == np.inf)
    less, more = (ca.if_else(infinite, 1.0, q) for q in (less, more))
    more = ca.if_else(more == 0.0, 1.0, more)
    steep = less > 0.66 * more
    ratio = ca.if_else(steep, less - more, less) / ca.if_else(steep, less + more, more)
    z = ratio * ratio
    angle = ratio + ratio * (z * _polynomial(z, ATAN_ABOVE) / _polynomial(z, ATAN_BELOW))
    angle = ca.if_else(steep, np.pi / 4 + (angle + PI_REST / 4), angle)
    angle = ca.if_else(upright, np.pi / 2 + (PI_REST / 2 - angle), angle)
    angle = ca.if_else(ca.copysign(1.0, x) < 0.0, np.pi + (PI_REST - angle), angle)
    return ca.copysign(angle, y)


PI_REST = 1.2246467991473532e-16
"""What pi is beyond its double."""
ATAN_ABOVE = (
    -8.750608600031904122785e-1, -1.615753718733365076637e1, -7.500855792314704667340e1,
    -1.228866684490136173410e2, -6.485021904942025371773e1,
)  # fmt: skip
ATAN_BELOW = (
    1.0, 2.485846490142306297962e1, 1.650270098316988542046e2, 4.328810604912902668951e2,
    4.853903996359136964868e2, 1.945506571482613964425e2,
)  # fmt: skip
"""Coefficients of (atan(x)/x - 1)/x^2 in x^2, the highest power first."""


def _polynomial(x: ca.SX, coefficients: tuple[float, ...]) -> ca.SX:
    value = ca.SX(coefficients[0])
    for coefficient in coefficients[1:]:
        value = value * x + coefficient
    return value


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
