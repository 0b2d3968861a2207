"""Slopes of a run's result, back over the steps that a march recorded.

The discrete solution itself is differentiated: sizes of steps stand, but for the first and the
last step of a stretch, whose ends lie where the input says. Bars are slopes of the whole result
by a quantity.
"""

from __future__ import annotations

from viscodesign.native.source.factors import (
    lu_solve_transposed,
)
from viscodesign.native.source.primitives import (
    part,
)
from viscodesign.native.source.replay import (
    dense_rate,
    dense_weight,
    dot,
    first_edge_in,
    part_done,
    replay,
)
from viscodesign.native.source.slopes import (
    pull_drive,
    pull_jacobian,
    pull_residual,
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
)


def reverse(
    layout, kernels, derived, idx, rows, pos, numbers, drive_rows, drive_columns,
    blocks, own, slots, lu_start, lu_columns, diagonal,
    entry_count, entry_rows, entry_columns, entry_places,
    mass, method, record, step_count, step_length, edges, edge_count, weights,
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
        step = part(record, (step_count - 1 - back) * step_length)
        time, h, y = step[0], step[1], part(step, RECORD_HEAD)
        replay(
            layout, kernels, idx, rows, pos, numbers, drive_rows, drive_columns,
            blocks, own, slots, lu_start, lu_columns, diagonal, mass, method, step, step_length, Y,
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


def drives_bar(layout, derived, idx, rows, numbers, Y, Y_bar, numbers_bar, weights, local, out):
    """Pass the slopes by the drives in Y_bar on to what the drives are made of."""
    n = layout[UNKNOWNS]
    for k in range(layout[DRIVES]):
        weights[k] = Y_bar[n + k]
    weights[layout[DRIVES]] = 0.0
    pull_drive(layout, derived, idx, rows, numbers, Y, 0, weights, Y_bar, numbers_bar, local, out)
