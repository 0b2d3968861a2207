"""Factors of 2 by 2 blocks, and solutions with them."""

from __future__ import annotations

import math

from viscodesign.native.source.primitives import part

SIDE = 8
"""Right sides that are solved for at once."""


def lu_fill(n, count, J, own, mass, scale, lu):
    """Set lu (4 count,) to diag(mass) scale - J, for J in the places of the factors.

    ``own`` (n + 1,): where the diagonal entries of the unknowns are, and that of nobody.
    """
    for p in range(4 * count):
        lu[p] = -J[p]
    for i in range(n):
        lu[own[i]] += mass[i] * scale
    if own[n] >= 0:
        lu[own[n]] = 1.0


def lu_factor(blocks, lu_start, lu_columns, diagonal, lu, row):
    """Factor in place: L without its unit diagonal, U with its diagonal blocks inverted.

    ``row`` (4 blocks,): to work with. Returns 0, or 1 + the first block that is singular or not
    finite.
    """
    for i in range(blocks):
        first, middle, last = lu_start[i], diagonal[i], lu_start[i + 1]
        for p in range(first, last):
            copy_block(lu, 4 * p, row, 4 * lu_columns[p])
        for p in range(first, middle):
            k = lu_columns[p]
            w, d, e = 4 * k, 4 * diagonal[k], 4 * p
            a = row[w] * lu[d] + row[w + 1] * lu[d + 2]
            b = row[w] * lu[d + 1] + row[w + 1] * lu[d + 3]
            c = row[w + 2] * lu[d] + row[w + 3] * lu[d + 2]
            f = row[w + 2] * lu[d + 1] + row[w + 3] * lu[d + 3]
            lu[e] = a
            lu[e + 1] = b
            lu[e + 2] = c
            lu[e + 3] = f
            for q in range(diagonal[k] + 1, lu_start[k + 1]):
                w, u = 4 * lu_columns[q], 4 * q
                row_0 = row[w] - a * lu[u] - b * lu[u + 2]
                row_1 = row[w + 1] - a * lu[u + 1] - b * lu[u + 3]
                row_2 = row[w + 2] - c * lu[u] - f * lu[u + 2]
                row_3 = row[w + 3] - c * lu[u + 1] - f * lu[u + 3]
                row[w] = row_0
                row[w + 1] = row_1
                row[w + 2] = row_2
                row[w + 3] = row_3
        for p in range(middle, last):
            copy_block(row, 4 * lu_columns[p], lu, 4 * p)
        d = 4 * middle
        a, b, c, f = lu[d], lu[d + 1], lu[d + 2], lu[d + 3]
        determinant = a * f - b * c
        if determinant == 0.0 or not math.isfinite(determinant):
            return i + 1
        inverse = 1.0 / determinant
        lu[d] = f * inverse
        lu[d + 1] = -b * inverse
        lu[d + 2] = -c * inverse
        lu[d + 3] = a * inverse
    return 0


def copy_block(source, at, target, to):
    """Copy four numbers."""
    for i in range(4):
        target[to + i] = source[at + i]


def lu_solve(n, slots, blocks, lu_start, lu_columns, diagonal, lu, right, solution, x):
    """Solution (n,) for a right side (n,).

    ``slots`` (n,): places of the unknowns in the order of elimination; ``x`` (2 blocks,): to work
    with.
    """
    for i in range(2 * blocks):
        x[i] = 0.0
    for i in range(n):
        x[slots[i]] = right[i]
    for i in range(blocks):
        first, second = x[2 * i], x[2 * i + 1]
        for p in range(lu_start[i], diagonal[i]):
            e, y, z = 4 * p, x[2 * lu_columns[p]], x[2 * lu_columns[p] + 1]
            first -= lu[e] * y + lu[e + 1] * z
            second -= lu[e + 2] * y + lu[e + 3] * z
        x[2 * i] = first
        x[2 * i + 1] = second
    for i in range(blocks - 1, -1, -1):
        first, second = x[2 * i], x[2 * i + 1]
        for p in range(diagonal[i] + 1, lu_start[i + 1]):
            e, y, z = 4 * p, x[2 * lu_columns[p]], x[2 * lu_columns[p] + 1]
            first -= lu[e] * y + lu[e + 1] * z
            second -= lu[e + 2] * y + lu[e + 3] * z
        d = 4 * diagonal[i]
        x[2 * i] = lu[d] * first + lu[d + 1] * second
        x[2 * i + 1] = lu[d + 2] * first + lu[d + 3] * second
    for i in range(n):
        solution[i] = x[slots[i]]


def lu_solve_transposed(n, slots, blocks, lu_start, lu_columns, diagonal, lu, right, solution, x):
    """The same for the transposed matrix."""
    for i in range(2 * blocks):
        x[i] = 0.0
    for i in range(n):
        x[slots[i]] = right[i]
    for i in range(blocks):
        d = 4 * diagonal[i]
        first = lu[d] * x[2 * i] + lu[d + 2] * x[2 * i + 1]
        second = lu[d + 1] * x[2 * i] + lu[d + 3] * x[2 * i + 1]
        x[2 * i] = first
        x[2 * i + 1] = second
        for p in range(diagonal[i] + 1, lu_start[i + 1]):
            e, c = 4 * p, 2 * lu_columns[p]
            x[c] -= lu[e] * first + lu[e + 2] * second
            x[c + 1] -= lu[e + 1] * first + lu[e + 3] * second
    for i in range(blocks - 1, -1, -1):
        first, second = x[2 * i], x[2 * i + 1]
        for p in range(lu_start[i], diagonal[i]):
            e, c = 4 * p, 2 * lu_columns[p]
            x[c] -= lu[e] * first + lu[e + 2] * second
            x[c + 1] -= lu[e + 1] * first + lu[e + 3] * second
    for i in range(n):
        solution[i] = x[slots[i]]


def lu_solve_sides(n, slots, blocks, lu_start, lu_columns, diagonal, lu, right, solution, x):
    """The same as `lu_solve` for SIDE right sides, (n, SIDE); ``x`` (2 blocks, SIDE)."""
    for i in range(2 * blocks * SIDE):
        x[i] = 0.0
    for i in range(n):
        for d in range(SIDE):
            x[slots[i] * SIDE + d] = right[i * SIDE + d]
    for i in range(blocks):
        own = part(x, 2 * i * SIDE)
        subtract_products(lu_start[i], diagonal[i], lu, lu_columns, x, own)
    for i in range(blocks - 1, -1, -1):
        at, d = 2 * i * SIDE, 4 * diagonal[i]
        own = part(x, at)
        subtract_products(diagonal[i] + 1, lu_start[i + 1], lu, lu_columns, x, own)
        a, b, c, f = lu[d], lu[d + 1], lu[d + 2], lu[d + 3]
        for k in range(SIDE):
            first, second = x[at + k], x[at + SIDE + k]
            x[at + k] = a * first + b * second
            x[at + SIDE + k] = c * first + f * second
    for i in range(n):
        for d in range(SIDE):
            solution[i * SIDE + d] = x[slots[i] * SIDE + d]


def subtract_products(first, last, lu, lu_columns, x, own):
    """own (2, SIDE) -= some blocks of a row times the pairs of rows of x, none of which it is."""
    for p in range(first, last):
        e, c = 4 * p, 2 * lu_columns[p] * SIDE
        for k in range(SIDE):
            one, two = x[c + k], x[c + SIDE + k]
            own[k] -= lu[e] * one + lu[e + 1] * two
            own[SIDE + k] -= lu[e + 2] * one + lu[e + 3] * two
