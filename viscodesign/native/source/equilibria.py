"""Equilibria that follow each other in time, each from the two before it."""

from __future__ import annotations

import math

from viscodesign.native.source.factors import lu_factor, lu_fill, lu_solve
from viscodesign.native.source.primitives import part
from viscodesign.native.source.steps import add_scaled, copy
from viscodesign.native.source.sums import (
    DRIVE_ENTRIES,
    DRIVES,
    ENTRIES,
    UNKNOWNS,
    WIDTH,
    drive,
    jacobian,
    residual,
)

CONVERGED, LARGEST_LEFT, MAX_CORRECTIONS, MAX_AHEAD, NEAR = 0, 1, 2, 3, 4
"""Places in the numbers that steer it; see `equilibria.follow_equilibria`."""


def follow_equilibria(
    layout, kernels, idx, rows, pos, numbers, blocks, own, slots, lu_start, lu_columns, diagonal,
    mass, count, times, first, last, settings, before, now, clock, Y, outputs, work,
):  # fmt: skip
    """Solutions (count, n) of 0 = r(y, t) at ``times`` (count,), as far as full steps lead there.

    ``now`` (n,), ``before`` (n,): the two solutions at clock[1] and clock[0]; rows with a ``mass``
    (n,) are left out. Unknowns from ``first`` to ``last`` stay near what is expected of them.
    ``Y``: its end is given. Returns how many were found.
    """
    n, entries = layout[UNKNOWNS], layout[ENTRIES]
    guess, right, step = part(work, 0), part(work, n), part(work, 2 * n + 1)
    row = part(step, n)
    x = part(row, 4 * blocks)
    lu = part(x, 2 * blocks)
    J = part(lu, entries)
    local = part(J, entries + 1 + layout[DRIVE_ENTRIES])
    out = part(local, layout[WIDTH])
    for k in range(count):
        passed, ahead = clock[1] - clock[0], times[k] - clock[1]
        copy(n, now, guess)
        if ahead <= settings[MAX_AHEAD] * passed:
            for i in range(n):
                guess[i] += ahead / passed * (now[i] - before[i])
        copy(n, guess, Y)
        Y[n + layout[DRIVES]] = times[k]
        drive(layout, kernels, idx, rows, numbers, Y, local, out)
        size, solved = math.inf, 0
        for _ in range(int(settings[MAX_CORRECTIONS])):
            residual(layout, kernels, idx, rows, numbers, Y, right, local, out)
            jacobian(layout, kernels, idx, pos, numbers, Y, J, local, out)
            for i in range(n):
                if mass[i] != 0.0:
                    right[i] = 0.0
            lu_fill(n, lu_start[blocks], J, own, mass, 1.0, lu)
            if lu_factor(blocks, lu_start, lu_columns, diagonal, lu, row) != 0:
                break
            lu_solve(n, slots, blocks, lu_start, lu_columns, diagonal, lu, right, step, x)
            largest = largest_of(n, step)
            if not math.isfinite(largest) or largest > settings[LARGEST_LEFT] * size:
                break
            add_scaled(n, 1.0, step, Y)
            size = largest
            if size <= settings[CONVERGED]:
                solved = 1
                break
        if solved == 0 or is_far(first, last, settings[NEAR], Y, guess, now) != 0:
            return k
        copy(n, now, before)
        copy(n, Y, now)
        copy(n, Y, part(outputs, k * n))
        clock[0] = clock[1]
        clock[1] = times[k]
    return count


def largest_of(n, values):
    """The largest size of ``values`` (n,); infinite where one is not finite."""
    largest = 0.0
    for i in range(n):
        if not math.isfinite(values[i]):
            return math.inf
        largest = max(largest, abs(values[i]))
    return largest


def is_far(first, last, near, found, guess, now):
    """1 if some of a solution lies far from its guess and from the solution before it, else 0."""
    size, apart, moved = 1.0, 0.0, 0.0
    for i in range(first, last):
        size = max(size, abs(found[i]))
        apart = max(apart, abs(found[i] - guess[i]))
        moved = max(moved, abs(found[i] - now[i]))
    if min(apart, moved) > near * size:
        return 1
    return 0
