"""Derivatives of the steps of Rodas5P that a march recorded.

The discrete solution itself is differentiated: sizes of steps stand, but for the first and the
last step of a stretch, whose ends lie where the input says. Bars are slopes of the whole result
by a quantity, dots are rates of a quantity along a direction.
"""

from __future__ import annotations

from viscodesign.native.source.factors import (
    SIDE,
    lu_factor,
    lu_fill,
    lu_solve_sides,
    lu_solve_transposed,
)
from viscodesign.native.source.primitives import part
from viscodesign.native.source.slopes import (
    mark_moving,
    moving_groups,
    pull_drive,
    pull_jacobian,
    pull_residual,
    push_drive,
    push_jacobian,
    push_numbers,
    push_residual,
)
from viscodesign.native.source.steps import (
    C_AT,
    DENSE_AT,
    GAMMA_AT,
    NODES_AT,
    RECORD_HEAD,
    SLOPES_AT,
    STAGES,
    add_scaled,
    copy,
    linearise,
    solve_stages,
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


def replay(
    layout, kernels, idx, rows, pos, numbers, drive_rows, drive_columns,
    blocks, own, slots, lu_start, lu_columns, diagonal, mass, method, step, Y,
    stages, places, J, rates, drift, lu, right, after, row, x, local, out,
):  # fmt: skip
    """Stages (STAGES, n) of a recorded step, places (STAGES + 1, n) with its end, and factors."""
    n = layout[UNKNOWNS]
    time, h, y = step[0], step[1], part(step, RECORD_HEAD)
    linearise(
        layout, kernels, idx, rows, pos, numbers, drive_rows, drive_columns,
        time, y, Y, J, rates, drift, local, out,
    )  # fmt: skip
    lu_fill(n, lu_start[blocks], J, own, mass, 1.0 / (h * method[GAMMA_AT]), lu)
    lu_factor(blocks, lu_start, lu_columns, diagonal, lu, row)
    solve_stages(
        layout, kernels, idx, rows, numbers, blocks, slots, lu_start, lu_columns, diagonal,
        mass, method, time, h, y, Y, drift, lu, stages, places, n, right, after, x, local, out,
    )  # fmt: skip
    end = part(places, STAGES * n)
    copy(n, part(places, (STAGES - 1) * n), end)
    add_scaled(n, 1.0, part(stages, (STAGES - 1) * n), end)


def first_edge_in(edges, stop, time):
    """The first of the edges before ``stop`` that lie in a step from ``time`` on."""
    first = stop
    while first > 0 and edges[first - 1] > time * (1 + 1e-15):
        first -= 1
    return first


def dot(n, x, y):
    """Scalar product."""
    total = 0.0
    for i in range(n):
        total += x[i] * y[i]
    return total


def dense_rate(n, method, theta, y, end, stages, rate):
    """Derivative of the dense output by the part of the step that is done, in ``rate`` (n,)."""
    for i in range(n):
        rate[i] = end[i] - y[i]
    for j in range(STAGES):
        first, second, third = (
            method[DENSE_AT + j],
            method[DENSE_AT + STAGES + j],
            method[DENSE_AT + 2 * STAGES + j],
        )
        inner = first + theta * (second + theta * third)
        slope = (1 - 2 * theta) * inner + theta * (1 - theta) * (second + 2 * theta * third)
        add_scaled(n, slope, part(stages, j * n), rate)


def dense_weight(method, j, theta):
    """Weight of stage j in the dense output."""
    inner = method[DENSE_AT + STAGES + j] + theta * method[DENSE_AT + 2 * STAGES + j]
    return theta * (1 - theta) * (method[DENSE_AT + j] + theta * inner)


def part_done(edge, step):
    """How much of a step is done at an edge within it."""
    return min((edge - step[0]) / (step[2] - step[0]), 1.0)


def reverse(
    layout, kernels, derived, idx, rows, pos, numbers, drive_rows, drive_columns,
    blocks, own, slots, lu_start, lu_columns, diagonal,
    entry_count, entry_rows, entry_columns, entry_places,
    mass, method, record, step_count, edges, edge_count, weights,
    Y, y_bar, Y_bar, numbers_bar, ends_bar, work,
):  # fmt: skip
    """Go back over the recorded steps of a stretch.

    ``weights`` (edges, n): slopes by the outputs; ``y_bar`` (n,): by the unknowns at the end, then
    at the beginning; what is behind the time in ``Y_bar``, ``numbers_bar`` and ``ends_bar`` (2,),
    by the times at which the stretch begins and ends, are added to. ``work``: see
    `derivatives.work_size`.
    """
    n, entries = layout[UNKNOWNS], layout[ENTRIES]
    clock, driven = n + layout[DRIVES], layout[DRIVE_ENTRIES]
    spread = entries + 1 + driven
    stages, places = part(work, 0), part(work, 8 * n)
    stages_bar, solved = part(work, 17 * n), part(work, 25 * n)
    right, after, drift = part(work, 33 * n), part(work, 34 * n + 1), part(work, 35 * n + 1)
    drift_bar, begin_bar = part(work, 36 * n + 1), part(work, 37 * n + 1)
    row = part(work, 38 * n + 1)
    x = part(row, 4 * blocks)
    lu = part(x, 2 * blocks)
    J = part(lu, entries)
    J_bar = part(J, spread)
    rates = part(J_bar, spread)
    rates_bar = part(rates, layout[DRIVES] + 1)
    local = part(rates_bar, layout[DRIVES] + 1)
    out = part(local, layout[WIDTH_OF_SLOPES])
    stop = edge_count
    for back in range(step_count):
        step = part(record, (step_count - 1 - back) * (n + RECORD_HEAD))
        time, h, y = step[0], step[1], part(step, RECORD_HEAD)
        replay(
            layout, kernels, idx, rows, pos, numbers, drive_rows, drive_columns,
            blocks, own, slots, lu_start, lu_columns, diagonal, mass, method, step, Y,
            stages, places, J, rates, drift, lu, right, after, row, x, local, out,
        )  # fmt: skip
        end = part(places, STAGES * n)
        h_bar, time_bar = 0.0, 0.0
        for i in range(STAGES * n):
            stages_bar[i] = 0.0
        for i in range(n):
            begin_bar[i], drift_bar[i] = 0.0, 0.0
        first = first_edge_in(edges, stop, time)
        for e in range(first, stop):
            weight, theta = part(weights, e * n), part_done(edges[e], step)
            add_scaled(n, 1 - theta, weight, begin_bar)
            add_scaled(n, theta, weight, y_bar)
            for j in range(STAGES):
                share = dense_weight(method, j, theta)
                add_scaled(n, share, weight, part(stages_bar, j * n))
            dense_rate(n, method, theta, y, end, stages, right)
            theta_bar = dot(n, weight, right)
            h_bar -= theta_bar * theta / h
            time_bar -= theta_bar / h
        stop = first
        add_scaled(n, 1.0, y_bar, part(stages_bar, (STAGES - 1) * n))
        scale = 1.0 / (h * method[GAMMA_AT])
        for late in range(STAGES):
            i = STAGES - 1 - late
            weight = part(solved, i * n)
            lu_solve_transposed(
                n, slots, blocks, lu_start, lu_columns, diagonal, lu, part(stages_bar, i * n),
                weight, x,
            )  # fmt: skip
            copy(n, part(places, i * n), Y)
            Y[clock] = time + method[NODES_AT + i] * h
            drive(layout, kernels, idx, rows, numbers, Y, local, out)
            for k in range(clock + 1):
                Y_bar[k] = 0.0
            copy(n, weight, right)
            right[n] = 0.0
            pull_residual(
                layout, derived, idx, rows, numbers, Y, right, Y_bar, numbers_bar, local, out
            )
            drives_bar(layout, derived, idx, rows, numbers, Y, Y_bar, numbers_bar, rates_bar,
                       local, out)  # fmt: skip
            if i == STAGES - 1:
                add_scaled(n, 1.0, y_bar, Y_bar)
            add_scaled(n, 1.0, Y_bar, begin_bar)
            h_bar += method[NODES_AT + i] * Y_bar[clock]
            time_bar += Y_bar[clock]
            for k in range(n):
                after[k] = mass[k] * weight[k] / h
            for j in range(i):
                bar = part(stages_bar, j * n)
                add_scaled(n, method[8 * i + j], Y_bar, bar)
                add_scaled(n, method[C_AT + 8 * i + j], after, bar)
                h_bar -= method[C_AT + 8 * i + j] * dot(n, after, part(stages, j * n)) / h
            h_bar += scale * dot(n, after, part(stages, i * n))
            h_bar += method[SLOPES_AT + i] * dot(n, weight, drift)
            add_scaled(n, h * method[SLOPES_AT + i], weight, drift_bar)
        for k in range(spread):
            J_bar[k] = 0.0
        for k in range(entry_count):
            total = 0.0
            for i in range(STAGES):
                total += solved[i * n + entry_rows[k]] * stages[i * n + entry_columns[k]]
            J_bar[entry_places[k]] = total
        for k in range(layout[DRIVES] + 1):
            rates_bar[k] = 0.0
        for k in range(driven):
            J_bar[entries + 1 + k] = drift_bar[drive_rows[k]] * rates[drive_columns[k]]
            rates_bar[drive_columns[k]] += drift_bar[drive_rows[k]] * J[entries + 1 + k]
        copy(n, y, Y)
        Y[clock] = time
        drive(layout, kernels, idx, rows, numbers, Y, local, out)
        for k in range(clock + 1):
            Y_bar[k] = 0.0
        pull_drive(
            layout, derived, idx, rows, numbers, Y, 1, rates_bar, Y_bar, numbers_bar, local, out
        )
        pull_jacobian(layout, derived, idx, pos, numbers, Y, J_bar, Y_bar, numbers_bar, local, out)
        drives_bar(layout, derived, idx, rows, numbers, Y, Y_bar, numbers_bar, rates_bar,
                   local, out)  # fmt: skip
        time_bar += Y_bar[clock]
        copy(n, begin_bar, y_bar)
        add_scaled(n, 1.0, Y_bar, y_bar)
        if back == 0:
            ends_bar[1] += h_bar
        if back == step_count - 1:
            ends_bar[0] += time_bar - h_bar


def drives_bar(layout, derived, idx, rows, numbers, Y, Y_bar, numbers_bar, weights, local, out):
    """Pass the slopes by the drives in Y_bar on to what the drives are made of."""
    n = layout[UNKNOWNS]
    for k in range(layout[DRIVES]):
        weights[k] = Y_bar[n + k]
    weights[layout[DRIVES]] = 0.0
    pull_drive(layout, derived, idx, rows, numbers, Y, 0, weights, Y_bar, numbers_bar, local, out)


def slopes_at(
    layout, kernels, derived, idx, rows, numbers, Y, weights, Y_bar, numbers_bar, drive_weights,
    local, out,
):  # fmt: skip
    """Add the slopes of weights (n + 1,) times the residual at Y, drives resolved."""
    drive(layout, kernels, idx, rows, numbers, Y, local, out)
    pull_residual(layout, derived, idx, rows, numbers, Y, weights, Y_bar, numbers_bar, local, out)
    drives_bar(
        layout, derived, idx, rows, numbers, Y, Y_bar, numbers_bar, drive_weights, local, out
    )


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


def forward(
    layout, kernels, derived, idx, rows, pos, numbers, drive_rows, drive_columns,
    blocks, own, slots, lu_start, lu_columns, diagonal,
    entry_count, entry_rows, entry_columns, entry_places,
    mass, method, record, step_count, edges, edge_count, directions,
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
        step = part(record, s * (n + RECORD_HEAD))
        time, h, y = step[0], step[1], part(step, RECORD_HEAD)
        replay(
            layout, kernels, idx, rows, pos, numbers, drive_rows, drive_columns,
            blocks, own, slots, lu_start, lu_columns, diagonal, mass, method, step, Y,
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
