"""Sines and cosines of many angles.

Reduced to an eighth of a turn by pi/2 in three parts (Cody and Waite), then by the polynomials of
fdlibm (`k_sin.c`, `k_cos.c`; Sun Microsystems 1993).
"""

from __future__ import annotations

PER_ANGLE = 0.63661977236758134308
"""Quarter turns per radian."""
QUARTER = 1.57079632673412561417
QUARTER_REST = 6.07710050630396597660e-11
QUARTER_LAST = 2.02226624879595063154e-21
"""A quarter turn in three parts, of which multiples up to a million of the first two are exact."""
ROUNDING = 6755399441055744.0
"""1.5 times 2^52: what is added to it and taken away again is a whole number."""


def sines_and_cosines(count, angle, sine, cosine):
    """Of angles up to a million [rad], to a unit or two in the last place."""
    for i in range(count):
        whole = (angle[i] * PER_ANGLE + ROUNDING) - ROUNDING
        x = ((angle[i] - whole * QUARTER) - whole * QUARTER_REST) - whole * QUARTER_LAST
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
        sine[i] = across if abs(quarter - 0.5) < 1.0 else -across
        cosine[i] = along if abs(quarter + 0.5) < 1.0 else -along
