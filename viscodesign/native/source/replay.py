"""Steps of Rodas5P that a march recorded, taken again for their derivatives."""

from __future__ import annotations

from viscodesign.native.source.factors import (
    lu_factor,
    lu_fill,
)
from viscodesign.native.source.primitives import (
    part,
)
from viscodesign.native.source.steps import (
    DENSE_AT,
    GAMMA_AT,
    RECORD_HEAD,
    STAGES,
    add_scaled,
    copy,
    linearise,
    set_place,
    solve_stages,
)
from viscodesign.native.source.sums import (
    UNKNOWNS,
)


def replay(
    layout, kernels, idx, rows, pos, numbers, drive_rows, drive_columns,
    blocks, own, slots, lu_start, lu_columns, diagonal, mass, method, step, step_length, Y,
    stages, places, J, rates, drift, lu, right, after, row, x, local, out,
):  # fmt: skip
    """Stages (STAGES, n) of a recorded step, places (STAGES + 1, n) with its end, and factors.

    Stages are solved for again unless the ``step`` (step_length,) has them.
    """
    n = layout[UNKNOWNS]
    time, h, y = step[0], step[1], part(step, RECORD_HEAD)
    linearise(
        layout, kernels, idx, rows, pos, numbers, drive_rows, drive_columns,
        time, y, Y, J, rates, drift, local, out,
    )  # fmt: skip
    lu_fill(n, lu_start[blocks], J, own, mass, 1.0 / (h * method[GAMMA_AT]), lu)
    lu_factor(blocks, lu_start, lu_columns, diagonal, lu, row)
    if step_length > RECORD_HEAD + n:
        copy(STAGES * n, part(step, RECORD_HEAD + n), stages)
        for i in range(STAGES):
            set_place(n, i, method, y, stages, places, n)
    else:
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
