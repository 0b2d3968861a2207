"""Steps of Rodas5P."""

from __future__ import annotations

import math

from viscodesign.native.source.factors import lu_factor, lu_fill, lu_solve
from viscodesign.native.source.primitives import part
from viscodesign.native.source.sums import (
    DRIVE_ENTRIES,
    DRIVES,
    ENTRIES,
    UNKNOWNS,
    WIDTH,
    drive,
    drive_rates,
    jacobian,
    residual,
)

STAGES = 8
SHARED = 5
"""Stages that add to the place of the one before, instead of to the start, come after this one."""
C_AT, NODES_AT, SLOPES_AT, DENSE_AT, GAMMA_AT, ORDER_AT = 64, 128, 136, 144, 168, 169
"""Places in the coefficients of the method; those of A come first."""
(
    TOLERANCE, MOTION_TIME, LARGEST, SMALLEST, SAFETY, MAX_FACTOR, MIN_FACTOR, MEMORY,
) = 0, 1, 2, 3, 4, 5, 6, 7  # fmt: skip
TIME, SIZE, BEFORE = 0, 1, 2
EDGE, STEPS, REJECTED, RESIDUALS, JACOBIANS, RECORDED = 0, 1, 2, 3, 4, 5
RECORD_HEAD = 3
"""Numbers in front of the unknowns in a record of a step."""
FINISHED, STEP_LIMIT, STEP_TOO_SMALL = 0, 1, 2


def march(
    layout, kernels, idx, rows, pos, numbers, drive_rows, drive_columns,
    blocks, own, slots, lu_start, lu_columns, diagonal,
    mass, tested, powers, method, settings, edges, edge_count, max_steps,
    y, Y, state, counts, outputs, most_recorded, record_length, record, work,
):  # fmt: skip
    """Take steps from state[TIME] to the last edge; see `march.march`.

    ``pos`` and layout[ENTRIES] are those of the factors; ``tested``: unknowns in front of the
    integrals; ``outputs`` (edges from counts[EDGE] on, n); ``record`` (most_recorded,
    record_length): begin, size, end and first unknowns of the steps taken, where
    ``most_recorded`` is not negative; then no more are taken. Rows that are longer have the stages
    as well. ``work``: see `march.work_size`. Returns how it ended.
    """
    n, entries = layout[UNKNOWNS], layout[ENTRIES]
    stages = part(work, 0)
    place_, right, after = part(work, 8 * n), part(work, 9 * n), part(work, 10 * n + 1)
    drift, row = part(work, 11 * n + 1), part(work, 12 * n + 1)
    x = part(row, 4 * blocks)
    lu = part(x, 2 * blocks)
    J = part(lu, entries)
    rates = part(J, entries + 1 + layout[DRIVE_ENTRIES])
    local = part(rates, layout[DRIVES] + 1)
    out = part(local, layout[WIDTH])
    last = edges[edge_count - 1]
    first_edge = counts[EDGE]
    recorded = 0
    fresh = False
    for _ in range(max_steps):
        if recorded == most_recorded:
            return STEP_LIMIT
        time, size = state[TIME], state[SIZE]
        remaining = last - time
        final = size >= remaining * (1 - 1e-9)
        h = size
        if final:
            h = remaining
        elif size > remaining / 2:
            h = min(size, remaining / 2)
        if not fresh:
            linearise(
                layout, kernels, idx, rows, pos, numbers, drive_rows, drive_columns,
                time, y, Y, J, rates, drift, local, out,
            )  # fmt: skip
            counts[JACOBIANS] += 1
            fresh = True
        scale = 1.0 / (h * method[GAMMA_AT])
        lu_fill(n, lu_start[blocks], J, own, mass, scale, lu)
        singular = lu_factor(blocks, lu_start, lu_columns, diagonal, lu, row)
        counts[STEPS] += 1
        error = math.inf
        if singular == 0:
            solve_stages(
                layout, kernels, idx, rows, numbers, blocks, slots, lu_start, lu_columns, diagonal,
                mass, method, time, h, y, Y, drift, lu, stages, place_, 0, right, after, x, local,
                out,
            )  # fmt: skip
            counts[RESIDUALS] += STAGES
            apart = part(stages, (STAGES - 1) * n)
            copy(n, place_, after)
            add_scaled(n, 1.0, apart, after)
            lead = min(1.0, h / settings[MOTION_TIME])
            error = step_error(n, tested, y, after, apart, powers, lead, settings[TOLERANCE])
        if not error <= 1.0:
            counts[REJECTED] += 1
            state[SIZE] = h * step_factor(error, 1.0, method[ORDER_AT], settings)
            if state[SIZE] < settings[SMALLEST]:
                return STEP_TOO_SMALL
            continue
        until = time + h
        if final:
            until = last
        stop = counts[EDGE]
        while stop < edge_count and edges[stop] <= until * (1 + 1e-15):
            stop += 1
        if stop > counts[EDGE]:
            dense_output(
                n, y, after, stages, method, time, until, part(edges, counts[EDGE]),
                stop - counts[EDGE], part(outputs, (counts[EDGE] - first_edge) * n), right,
                row, x,
            )  # fmt: skip
            counts[EDGE] = stop
        factor = step_factor(error, state[BEFORE], method[ORDER_AT], settings)
        if most_recorded > 0:
            entry = part(record, recorded * record_length)
            entry[0], entry[1], entry[2] = time, h, until
            copy(n, y, part(entry, RECORD_HEAD))
            if record_length > RECORD_HEAD + n:
                copy(STAGES * n, stages, part(entry, RECORD_HEAD + n))
            recorded += 1
            counts[RECORDED] = recorded
        copy(n, after, y)
        state[TIME] = until
        if final:
            state[SIZE] = max(size, h) * min(factor, 1.0 / settings[SAFETY])
            return FINISHED
        state[SIZE] = min(h * factor, settings[LARGEST])
        state[BEFORE] = max(error, 1e-4)
        fresh = False
    return STEP_LIMIT


def linearise(
    layout, kernels, idx, rows, pos, numbers, drive_rows, drive_columns,
    time, y, Y, J, rates, drift, local, out,
):  # fmt: skip
    """Set Y, the Jacobian J, the rates of the drives and their part of the residual's rate."""
    n, entries = layout[UNKNOWNS], layout[ENTRIES]
    copy(n, y, Y)
    Y[n + layout[DRIVES]] = time
    drive(layout, kernels, idx, rows, numbers, Y, local, out)
    jacobian(layout, kernels, idx, pos, numbers, Y, J, local, out)
    drive_rates(layout, kernels, idx, rows, numbers, Y, rates, local, out)
    for i in range(n):
        drift[i] = 0.0
    for k in range(layout[DRIVE_ENTRIES]):
        drift[drive_rows[k]] += J[entries + 1 + k] * rates[drive_columns[k]]


def solve_stages(
    layout, kernels, idx, rows, numbers, blocks, slots, lu_start, lu_columns, diagonal,
    mass, method, time, h, y, Y, drift, lu, stages, place_, stride, right, after, x, local, out,
):  # fmt: skip
    """Stages (STAGES, n) of a step, and places at which they are taken, ``stride`` apart."""
    n = layout[UNKNOWNS]
    for i in range(STAGES):
        set_place(n, i, method, y, stages, place_, stride)
        copy(n, part(place_, i * stride), Y)
        Y[n + layout[DRIVES]] = time + method[NODES_AT + i] * h
        drive(layout, kernels, idx, rows, numbers, Y, local, out)
        residual(layout, kernels, idx, rows, numbers, Y, right, local, out)
        combine(n, i, part(method, C_AT + 8 * i), h, mass, stages, right, after)
        slope = h * method[SLOPES_AT + i]
        if slope != 0.0:
            add_scaled(n, slope, drift, right)
        stage = part(stages, i * n)
        lu_solve(n, slots, blocks, lu_start, lu_columns, diagonal, lu, right, stage, x)


def set_place(n, i, method, y, stages, place_, stride):
    """Where stage ``i`` is taken, by those before it; places are ``stride`` apart."""
    here = part(place_, i * stride)
    if i <= SHARED:
        copy(n, y, here)
        for j in range(i):
            add_scaled(n, method[8 * i + j], part(stages, j * n), here)
    else:
        if stride != 0:
            copy(n, part(place_, (i - 1) * stride), here)
        add_scaled(n, 1.0, part(stages, (i - 1) * n), here)


def combine(n, count, weights, h, mass, stages, right, pull):
    """right += mass sum_j weights_j stages_j / h, over the first ``count`` stages."""
    if count == 0:
        return
    for i in range(n):
        pull[i] = 0.0
    for j in range(count):
        add_scaled(n, weights[j], part(stages, j * n), pull)
    for i in range(n):
        right[i] += mass[i] * pull[i] / h


def step_error(n, tested, y, after, apart, powers, lead, tolerance):
    """Largest error estimate over what is allowed; infinite where anything is not finite."""
    worst = 0.0
    for i in range(n):
        if not (math.isfinite(after[i]) and math.isfinite(apart[i])):
            return math.inf
    for i in range(tested):
        if powers[i] < math.inf:
            size = max(abs(y[i]), abs(after[i]))
            error = abs(apart[i]) / (tolerance * (1.0 + size))
            if powers[i] != 0.0:
                error *= lead ** powers[i]
            worst = max(worst, error)
    # Steps that resolve the unknowns well may still integrate their work badly.
    for i in range(tested, n):
        error = abs(apart[i]) / (tolerance * (1.0 + abs(after[i] - y[i])))
        worst = max(worst, error)
    return worst


def step_factor(error, before, order, settings):
    """Ratio of the next step to the one with this error."""
    if not math.isfinite(error):
        return settings[MIN_FACTOR]
    limited = max(error, 1e-10)
    if before == 1.0:
        wanted = settings[SAFETY] * limited ** (-1.0 / order)
    else:
        memory = settings[MEMORY]
        wanted = settings[SAFETY] * limited ** (memory - 1.0 / order) * before ** (-memory)
    return min(settings[MAX_FACTOR], max(settings[MIN_FACTOR], wanted))


def dense_output(
    n, y, after, stages, method, time, until, edges, count, outputs, first, second, third
):
    """Unknowns at the edges inside a step, by its dense output."""
    for i in range(n):
        first[i], second[i], third[i] = 0.0, 0.0, 0.0
    for j in range(STAGES):
        stage = part(stages, j * n)
        add_scaled(n, method[DENSE_AT + j], stage, first)
        add_scaled(n, method[DENSE_AT + STAGES + j], stage, second)
        add_scaled(n, method[DENSE_AT + 2 * STAGES + j], stage, third)
    for e in range(count):
        theta = min((edges[e] - time) / (until - time), 1.0)
        target = part(outputs, e * n)
        if theta == 1.0:
            copy(n, after, target)
            continue
        for i in range(n):
            inner = first[i] + theta * (second[i] + theta * third[i])
            target[i] = (1.0 - theta) * y[i] + theta * (after[i] + (1.0 - theta) * inner)


def add_scaled(n, factor, x, y):
    """y += factor x."""
    for i in range(n):
        y[i] += factor * x[i]


def copy(n, x, y):
    """y = x."""
    for i in range(n):
        y[i] = x[i]
