"""CasADi's operations on n numbers at once, each in a loop of its own.

What is read and written may be the same numbers, but never only partly so. Every result is the one
that CasADi has: nothing is contracted, and functions are those of the C library.
"""

from __future__ import annotations

import math


def fill(n, value, z):
    for i in range(n):
        z[i] = value


def pick(n, x, stride, z):
    for i in range(n):
        z[i] = x[i * stride]


def put(n, x, hop, z):
    for i in range(n):
        z[i * hop] = x[i]


def each_same(n, x, z):
    for i in range(n):
        z[i] = x[i]


def each_add(n, x, y, z):
    for i in range(n):
        z[i] = x[i] + y[i]


def each_sub(n, x, y, z):
    for i in range(n):
        z[i] = x[i] - y[i]


def each_mul(n, x, y, z):
    for i in range(n):
        z[i] = x[i] * y[i]


def each_div(n, x, y, z):
    for i in range(n):
        z[i] = x[i] / y[i]


def each_neg(n, x, z):
    for i in range(n):
        z[i] = -x[i]


def each_inv(n, x, z):
    for i in range(n):
        z[i] = 1.0 / x[i]


def each_sqrt(n, x, z):
    for i in range(n):
        z[i] = math.sqrt(x[i])


def each_fabs(n, x, z):
    for i in range(n):
        z[i] = math.fabs(x[i])


def each_exp(n, x, z):
    for i in range(n):
        z[i] = math.exp(x[i])


def each_log(n, x, z):
    for i in range(n):
        z[i] = math.log(x[i])


def each_pow(n, x, y, z):
    for i in range(n):
        z[i] = math.pow(x[i], y[i])


def each_sin(n, x, z):
    for i in range(n):
        z[i] = math.sin(x[i])


def each_cos(n, x, z):
    for i in range(n):
        z[i] = math.cos(x[i])


def each_tan(n, x, z):
    for i in range(n):
        z[i] = math.tan(x[i])


def each_asin(n, x, z):
    for i in range(n):
        z[i] = math.asin(x[i])


def each_acos(n, x, z):
    for i in range(n):
        z[i] = math.acos(x[i])


def each_atan(n, x, z):
    for i in range(n):
        z[i] = math.atan(x[i])


def each_atan_of_two(n, x, y, z):
    for i in range(n):
        z[i] = math.atan2(x[i], y[i])


def each_sinh(n, x, z):
    for i in range(n):
        z[i] = math.sinh(x[i])


def each_cosh(n, x, z):
    for i in range(n):
        z[i] = math.cosh(x[i])


def each_tanh(n, x, z):
    for i in range(n):
        z[i] = math.tanh(x[i])


def each_less(n, x, y, z):
    for i in range(n):
        z[i] = 1.0 if x[i] < y[i] else 0.0


def each_less_or_equal(n, x, y, z):
    for i in range(n):
        z[i] = 1.0 if x[i] <= y[i] else 0.0


def each_equal(n, x, y, z):
    for i in range(n):
        z[i] = 1.0 if x[i] == y[i] else 0.0


def each_unequal(n, x, y, z):
    for i in range(n):
        z[i] = 1.0 if x[i] != y[i] else 0.0


def each_not(n, x, z):
    for i in range(n):
        z[i] = 1.0 if x[i] == 0.0 else 0.0


def each_and(n, x, y, z):
    for i in range(n):
        z[i] = 1.0 if x[i] != 0.0 and y[i] != 0.0 else 0.0


def each_or(n, x, y, z):
    for i in range(n):
        z[i] = 1.0 if x[i] != 0.0 or y[i] != 0.0 else 0.0


def each_where(n, x, y, z):
    for i in range(n):
        z[i] = y[i] if x[i] != 0.0 else 0.0


def each_smaller(n, x, y, z):
    for i in range(n):
        z[i] = x[i] if x[i] <= y[i] or y[i] != y[i] else y[i]


def each_larger(n, x, y, z):
    for i in range(n):
        z[i] = x[i] if x[i] >= y[i] or y[i] != y[i] else y[i]


def each_sign(n, x, z):
    for i in range(n):
        z[i] = 1.0 if x[i] > 0.0 else (-1.0 if x[i] < 0.0 else x[i])


def each_log_of_more(n, x, z):
    for i in range(n):
        z[i] = math.log1p(x[i])


def each_exp_less_one(n, x, z):
    for i in range(n):
        z[i] = math.expm1(x[i])
