"""Rates of a run along directions, over the steps that a march recorded.

The discrete solution itself is differentiated, as in `reverse`. Dots are rates of a quantity
along a direction.
"""

from __future__ import annotations

from viscodesign.native.source.factors import (
    SIDE,
    lu_solve_sides,
)
from viscodesign.native.source.primitives import (
    part,
)
from viscodesign.native.source.replay import (
    dense_rate,
    dense_weight,
    part_done,
    replay,
)
from viscodesign.native.source.slopes import (
    mark_moving,
    moving_groups,
    push_drive,
    push_jacobian,
    push_numbers,
    push_residual,
)
from viscodesign.native.source.steps import (
    C_AT,
    GAMMA_AT,
    NODES_AT,
    RECORD_HEAD,
    SLOPES_AT,
    STAGES,
    add_scaled,
    copy,
)
from viscodesign.native.source.sums import (
    DRIVE_ENTRIES,
    DRIVES,
    ENTRIES,
    UNKNOWNS,
    WIDTH_OF_SLOPES,
    drive,
    jacobian,
)


def forward(
    layout, kernels, derived, idx, rows, pos, numbers, drive_rows, drive_columns,
    blocks, own, slots, lu_start, lu_columns, diagonal,
    entry_count, entry_rows, entry_columns, entry_places,
    mass, method, record, step_count, step_length, edges, edge_count, directions,
    Y, y_dot, Y_dot, Y_length, numbers_dot, numbers_length, ends_dot, outputs, work,
):  # fmt: skip
    """Go along the recorded steps of a stretch in up to SIDE directions at once.

    ``y_dot`` (n, SIDE): rates of the unknowns at the beginning, then at the end; ``Y_dot``
    (directions, Y_length), of which what is behind the time is given; ``numbers_dot``
    (directions, numbers_length); ``ends_dot`` (SIDE, 2): of the times at which the stretch
    begins and ends; ``outputs`` (directions, edges, n). ``work``: see `derivatives.work_size`.
    """
    n, entries = layout[UNKNOWNS], layout[ENTRIES]
    clock, driven = n + layout[DRIVES], layout[DRIVE_ENTRIES]
    spread = entries + 1 + driven
    stages, places = part(work, 0), part(work, 8 * n)
    right, after, drift = part(work, 17 * n), part(work, 18 * n + 1), part(work, 19 * n + 1)
    row = part(work, 20 * n + 1)
    x = part(row, 4 * blocks)
    lu = part(x, 2 * blocks)
    J = part(lu, entries)
    J_dot = part(J, spread)
    rates = part(J_dot, spread)
    rates_dot = part(rates, layout[DRIVES] + 1)
    local = part(rates_dot, layout[DRIVES] + 1)
    out = part(local, layout[WIDTH_OF_SLOPES])
    moving = part(out, layout[WIDTH_OF_SLOPES])
    wide = part(moving, directions * moving_groups(layout))
    stages_dot, place_dot = part(wide, 0), part(wide, 8 * n * SIDE)
    sides, drift_dot = part(wide, 9 * n * SIDE), part(wide, 10 * n * SIDE)
    drives_dot = part(wide, 11 * n * SIDE)
    entries_dot = part(drives_dot, (layout[DRIVES] + 1) * SIDE)
    wide_x = part(entries_dot, entry_count * SIDE)
    for d in range(directions):
        mark_moving(layout, part(numbers_dot, d * numbers_length),
                    part(moving, d * moving_groups(layout)))  # fmt: skip
    start = 0
    for s in range(step_count):
        step = part(record, s * step_length)
        time, h, y = step[0], step[1], part(step, RECORD_HEAD)
        replay(
            layout, kernels, idx, rows, pos, numbers, drive_rows, drive_columns,
            blocks, own, slots, lu_start, lu_columns, diagonal, mass, method, step, step_length, Y,
            stages, places, J, rates, drift, lu, right, after, row, x, local, out,
        )  # fmt: skip
        scale = 1.0 / (h * method[GAMMA_AT])
        copy(n, y, Y)
        Y[clock] = time
        drive(layout, kernels, idx, rows, numbers, Y, local, out)
        for i in range(n * SIDE):
            drift_dot[i] = 0.0
        for d in range(directions):
            moved, dots = part(Y_dot, d * Y_length), part(numbers_dot, d * numbers_length)
            for i in range(n):
                moved[i] = y_dot[i * SIDE + d]
            moved[clock] = begin_rate(s, part(ends_dot, 2 * d))
            push_drive(layout, derived, idx, rows, numbers, Y, 0, moved, dots, part(moved, n),
                       local, out)  # fmt: skip
            push_drive(layout, derived, idx, rows, numbers, Y, 1, moved, dots, rates_dot,
                       local, out)  # fmt: skip
            push_jacobian(layout, derived, idx, pos, numbers, Y, moved, dots, J_dot, local, out)
            for k in range(entry_count):
                entries_dot[k * SIDE + d] = J_dot[entry_places[k]]
            for k in range(driven):
                drift_dot[drive_rows[k] * SIDE + d] += (
                    J_dot[entries + 1 + k] * rates[drive_columns[k]]
                    + J[entries + 1 + k] * rates_dot[drive_columns[k]]
                )
        for i in range(STAGES):
            stage, slope = part(stages, i * n), method[SLOPES_AT + i]
            copy(n, part(places, i * n), Y)
            Y[clock] = time + method[NODES_AT + i] * h
            drive(layout, kernels, idx, rows, numbers, Y, local, out)
            if i > 0:  # the first one is that of the step
                jacobian(layout, kernels, idx, pos, numbers, Y, J, local, out)
            for k in range(n):
                after[k] = 0.0
            for j in range(i):
                add_scaled(n, -method[C_AT + 8 * i + j] / h, part(stages, j * n), after)
            add_scaled(n, scale, stage, after)
            copy(n * SIDE, y_dot, place_dot)
            for k in range(n * SIDE):
                sides[k] = h * slope * drift_dot[k]
            for j in range(i):
                earlier = part(stages_dot, j * n * SIDE)
                add_scaled(n * SIDE, method[8 * i + j], earlier, place_dot)
                add_masses(n, mass, method[C_AT + 8 * i + j] / h, earlier, sides)
            for d in range(directions):
                moved, dots = part(Y_dot, d * Y_length), part(numbers_dot, d * numbers_length)
                ends = part(ends_dot, 2 * d)
                h_dot = size_rate(s, step_count, ends)
                moved[clock] = begin_rate(s, ends) + method[NODES_AT + i] * h_dot
                push_drive(layout, derived, idx, rows, numbers, Y, 0, moved, dots,
                           part(moved, n), local, out)  # fmt: skip
                for k in range(layout[DRIVES]):
                    drives_dot[k * SIDE + d] = moved[n + k]
                push_numbers(
                    layout, derived, idx, rows, numbers, Y, dots,
                    part(moving, d * moving_groups(layout)), part(sides, d), local, out,
                )  # fmt: skip
                if h_dot != 0.0:
                    for k in range(n):
                        share = mass[k] / h * after[k] + slope * drift[k]
                        sides[k * SIDE + d] += h_dot * share
            multiply_sides(
                entry_count, entry_rows, entry_columns, entry_places, J, entries_dot, stage,
                place_dot, sides,
            )  # fmt: skip
            for k in range(driven):
                add_scaled(
                    SIDE, J[entries + 1 + k], part(drives_dot, drive_columns[k] * SIDE),
                    part(sides, drive_rows[k] * SIDE),
                )  # fmt: skip
            lu_solve_sides(
                n, slots, blocks, lu_start, lu_columns, diagonal, lu, sides,
                part(stages_dot, i * n * SIDE), wide_x,
            )  # fmt: skip
        stop = start
        while stop < edge_count and edges[stop] <= step[2] * (1 + 1e-15):
            stop += 1
        add_scaled(n * SIDE, 1.0, part(stages_dot, (STAGES - 1) * n * SIDE), place_dot)
        for e in range(start, stop):
            theta = part_done(edges[e], step)
            dense_rate(n, method, theta, y, part(places, STAGES * n), stages, right)
            for k in range(n * SIDE):
                sides[k] = (1 - theta) * y_dot[k] + theta * place_dot[k]
            for j in range(STAGES):
                share = dense_weight(method, j, theta)
                add_scaled(n * SIDE, share, part(stages_dot, j * n * SIDE), sides)
            for d in range(directions):
                ends = part(ends_dot, 2 * d)
                theta_dot = -(begin_rate(s, ends) + theta * size_rate(s, step_count, ends)) / h
                found = part(outputs, (d * edge_count + e) * n)
                for k in range(n):
                    found[k] = sides[k * SIDE + d] + theta_dot * right[k]
        copy(n * SIDE, place_dot, y_dot)
        start = stop


def rates_at(
    layout, kernels, derived, idx, rows, numbers, Y, Y_dot, numbers_dot, r_dot, local, out
):  # fmt: skip
    """Rates (n + 1,) of the residual at Y along Y_dot, whose drives are set."""
    drives_dot = part(Y_dot, layout[UNKNOWNS])
    drive(layout, kernels, idx, rows, numbers, Y, local, out)
    push_drive(
        layout, derived, idx, rows, numbers, Y, 0, Y_dot, numbers_dot, drives_dot, local, out
    )
    push_residual(layout, derived, idx, rows, numbers, Y, Y_dot, numbers_dot, r_dot, local, out)


def add_masses(n, mass, factor, x, y):
    """y += factor mass x, for SIDE columns."""
    for k in range(n):
        share = factor * mass[k]
        for d in range(SIDE):
            y[k * SIDE + d] += share * x[k * SIDE + d]


def multiply_sides(count, rows, columns, places, J, entries_dot, stage, place_dot, sides):
    """sides += J place_dot + J_dot stage, entry by entry, for SIDE columns."""
    for k in range(count):
        row, column = SIDE * rows[k], SIDE * columns[k]
        own, known = J[places[k]], stage[columns[k]]
        for d in range(SIDE):
            sides[row + d] += own * place_dot[column + d] + known * entries_dot[SIDE * k + d]


def begin_rate(step, ends):
    """Rate of the time at which a step begins."""
    return ends[0] if step == 0 else 0.0


def size_rate(step, count, ends):
    """Rate of the size of a step."""
    rate = ends[1] if step == count - 1 else 0.0
    return rate - begin_rate(step, ends)
