"""Sines, cosines and exponentials, such that loops over them become vectors.

Angles are reduced to an eighth of a turn by pi/2 in three parts (Cody and Waite); then the
polynomials of fdlibm serve (`k_sin.c`, `k_cos.c`; Sun Microsystems 1993).
"""

from __future__ import annotations

from viscodesign.native.source.primitives import power_of_two

PER_ANGLE = 0.63661977236758134308
"""Quarter turns per radian."""
QUARTER = 1.57079632673412561417
QUARTER_REST = 6.07710050630396597660e-11
QUARTER_LAST = 2.02226624879595063154e-21
"""A quarter turn in three parts, of which multiples up to a million of the first two are exact."""
ROUNDING = 6755399441055744.0
"""1.5 times 2^52: what is added to it and taken away again is a whole number."""
MIN_EXPONENT, MAX_EXPONENT = -708.0, 710.0
"""Between the least number with all digits and infinity."""
PER_EXPONENT = 1.44269504088896338700
"""Doublings per unit of an exponent."""
DOUBLING = 6.93147180369123816490e-01
DOUBLING_REST = 1.90821492927058770002e-10
"""The logarithm of two in two parts, of which multiples up to a million of the first are exact."""


def sine_and_cosine(angle):
    """Of an angle up to a million [rad], to a unit or two in the last place."""
    whole = (angle * PER_ANGLE + ROUNDING) - ROUNDING
    x = ((angle - whole * QUARTER) - whole * QUARTER_REST) - whole * QUARTER_LAST
    # Of these quarters -2 to 2 are left.
    quarter = whole - 4 * ((whole / 4 + ROUNDING) - ROUNDING)
    z = x * x
    s = -2.50507602534068634195e-08 + z * 1.58969099521155010221e-10
    s = -1.98412698298579493134e-04 + z * (2.75573137070700676789e-06 + z * s)
    s = -1.66666666666666324348e-01 + z * (8.33333333332248946124e-03 + z * s)
    s = x + x * z * s
    c = 2.08757232129817482790e-09 - z * 1.13596475577881948265e-11
    c = 2.48015872894767294178e-05 + z * (-2.75573143513906633035e-07 + z * c)
    c = 4.16666666666666019037e-02 + z * (-1.38888888888741095749e-03 + z * c)
    c = 1 - (z / 2 - z * z * c)
    is_odd = quarter * quarter == 1.0
    across, along = c if is_odd else s, s if is_odd else c
    sine = across if abs(quarter - 0.5) < 1.0 else -across
    cosine = along if abs(quarter + 0.5) < 1.0 else -along
    return sine, cosine


def exponential(x):
    """To two units in the last place; not below 1e-308, and infinite beyond all numbers."""
    held = x if x > MIN_EXPONENT else MIN_EXPONENT
    held = held if held < MAX_EXPONENT else MAX_EXPONENT
    whole = (held * PER_EXPONENT + ROUNDING) - ROUNDING
    r = (held - whole * DOUBLING) - whole * DOUBLING_REST
    # Taylor's series, whose next term is below a unit in the last place.
    y = 1 + r * (1 / 13)
    y = 1 + r * y * (1 / 12)
    y = 1 + r * y * (1 / 11)
    y = 1 + r * y * (1 / 10)
    y = 1 + r * y * (1 / 9)
    y = 1 + r * y * (1 / 8)
    y = 1 + r * y * (1 / 7)
    y = 1 + r * y * (1 / 6)
    y = 1 + r * y * (1 / 5)
    y = 1 + r * y * (1 / 4)
    y = 1 + r * y * (1 / 3)
    y = 1 + r * y * (1 / 2)
    y = 1 + r * y
    return y * power_of_two(whole)


def sines_and_cosines(count, angle, sine, cosine):
    """Of angles up to a million [rad]."""
    for i in range(count):
        sine[i], cosine[i] = sine_and_cosine(angle[i])
