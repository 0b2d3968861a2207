"""The operations of a formula one after the other, each for several rows at once.

Every operation stands alone, so that nothing is contracted: results are CasADi's, bit for bit.
What an operation reads and writes may be the same place of ``room``, never a part of it.
"""

from __future__ import annotations

from viscodesign.native.source.primitives import part
from viscodesign.native.source.row_operations import (
    each_acos,
    each_add,
    each_and,
    each_asin,
    each_atan,
    each_atan_of_two,
    each_cos,
    each_cosh,
    each_div,
    each_equal,
    each_exp,
    each_exp_less_one,
    each_fabs,
    each_inv,
    each_larger,
    each_less,
    each_less_or_equal,
    each_log,
    each_log_of_more,
    each_mul,
    each_neg,
    each_not,
    each_or,
    each_pow,
    each_same,
    each_sign,
    each_sin,
    each_sinh,
    each_smaller,
    each_sqrt,
    each_sub,
    each_tan,
    each_tanh,
    each_unequal,
    each_where,
    fill,
    pick,
    put,
)

WIDTH = 32
"""Rows that an operation treats at once, at most: then ``room`` stays in the nearest cache."""
FIELDS_OF_STEP = 4
"""Operation, place of the result, and two operands: places or, at first, numbers of entries."""
CONST, INPUT, OUTPUT, ASSIGN, ADD, SUB, MUL, DIV, NEG, SQ, TWICE, INV = range(12)
SQRT, FABS, EXP, LOG, POW, SIN, COS, TAN, ASIN, ACOS, ATAN, ATAN2, SINH, COSH, TANH = range(12, 27)
LT, LE, EQ, NE, NOT, AND, OR, IF_ELSE_ZERO, FMIN, FMAX, SIGN, LOG1P, EXPM1 = range(27, 40)


def run_tape(steps, code, constants, starts, strides, given, to, hops, rows, room, found):
    """Evaluate all rows; returns 0, or 1 + the first step whose operation is unknown.

    ``code`` (4 steps,); ``given``: arguments, entry k of row r at starts[k] + r strides[k];
    ``found``: results, entry k of row r at to[k] + r hops[k]; ``room`` (places * WIDTH,).
    """
    for first in range(0, rows, WIDTH):
        n = min(WIDTH, rows - first)
        for k in range(steps):
            op, a, b = code[4 * k], code[4 * k + 2], code[4 * k + 3]
            z = part(room, code[4 * k + 1] * WIDTH)
            if op == CONST:
                fill(n, constants[a], z)
                continue
            if op == INPUT:
                pick(n, part(given, starts[a] + first * strides[a]), strides[a], z)
                continue
            x = part(room, a * WIDTH)
            y = part(room, b * WIDTH)
            if op == OUTPUT:
                put(n, x, hops[b], part(found, to[b] + first * hops[b]))
            elif op == ASSIGN:
                each_same(n, x, z)
            elif op == ADD:
                each_add(n, x, y, z)
            elif op == SUB:
                each_sub(n, x, y, z)
            elif op == MUL:
                each_mul(n, x, y, z)
            elif op == DIV:
                each_div(n, x, y, z)
            elif op == NEG:
                each_neg(n, x, z)
            elif op == SQ:
                each_mul(n, x, x, z)
            elif op == TWICE:
                each_add(n, x, x, z)
            elif op == INV:
                each_inv(n, x, z)
            elif op == SQRT:
                each_sqrt(n, x, z)
            elif op == FABS:
                each_fabs(n, x, z)
            elif op == EXP:
                each_exp(n, x, z)
            elif op == LOG:
                each_log(n, x, z)
            elif op == POW:
                each_pow(n, x, y, z)
            elif op == SIN:
                each_sin(n, x, z)
            elif op == COS:
                each_cos(n, x, z)
            elif op == TAN:
                each_tan(n, x, z)
            elif op == ASIN:
                each_asin(n, x, z)
            elif op == ACOS:
                each_acos(n, x, z)
            elif op == ATAN:
                each_atan(n, x, z)
            elif op == ATAN2:
                each_atan_of_two(n, x, y, z)
            elif op == SINH:
                each_sinh(n, x, z)
            elif op == COSH:
                each_cosh(n, x, z)
            elif op == TANH:
                each_tanh(n, x, z)
            elif op == LT:
                each_less(n, x, y, z)
            elif op == LE:
                each_less_or_equal(n, x, y, z)
            elif op == EQ:
                each_equal(n, x, y, z)
            elif op == NE:
                each_unequal(n, x, y, z)
            elif op == NOT:
                each_not(n, x, z)
            elif op == AND:
                each_and(n, x, y, z)
            elif op == OR:
                each_or(n, x, y, z)
            elif op == IF_ELSE_ZERO:
                each_where(n, x, y, z)
            elif op == FMIN:
                each_smaller(n, x, y, z)
            elif op == FMAX:
                each_larger(n, x, y, z)
            elif op == SIGN:
                each_sign(n, x, z)
            elif op == LOG1P:
                each_log_of_more(n, x, z)
            elif op == EXPM1:
                each_exp_less_one(n, x, z)
            else:
                return 1 + k
    return 0
