"""The same structure with other numbers, row by row: its sums, and its marches."""

from __future__ import annotations

from viscodesign.native.source.primitives import part
from viscodesign.native.source.steps import march
from viscodesign.native.source.sums import (
    DRIVE_ENTRIES,
    ENTRIES,
    UNKNOWNS,
    drive,
    jacobian,
    residual,
)

CLOCK, COUNTS, SETTINGS = 3, 6, 8
"""Numbers of a row: where its march is, what it counts, and what steers it."""


def sums_of_rows(
    layout, kernels, idx, rows, pos, count, own, numbers, length, Y, J, r, local, out
):  # fmt: skip
    """Set the drives in Y (count, length), and the Jacobians J and residuals r (count, n + 1).

    ``numbers`` (count, own): those of the assembly, row by row.
    """
    width = layout[ENTRIES] + 1 + layout[DRIVE_ENTRIES]
    for k in range(count):
        given, y = part(numbers, k * own), part(Y, k * length)
        drive(layout, kernels, idx, rows, given, y, local, out)
        jacobian(layout, kernels, idx, pos, given, y, part(J, k * width), local, out)
        values = part(r, k * (layout[UNKNOWNS] + 1))
        residual(layout, kernels, idx, rows, given, y, values, local, out)


def march_rows(
    layout, kernels, idx, rows, pos, drive_rows, drive_columns,
    blocks, slot, slots, lu_start, lu_columns, diagonal, mass, tested, powers, method,
    count, own, numbers, length, Y, y, settings, first_edges, edges, max_steps,
    state, counts, outputs, status, work,
):  # fmt: skip
    """One march for each row, each with ``own`` numbers and ``length`` entries of Y.

    ``first_edges`` (count + 1,): where the edges and the outputs of a row begin; ``status``
    (count,): how each march ended. The others: see `march`, with one row more in front.
    """
    n = layout[UNKNOWNS]
    for k in range(count):
        first = first_edges[k]
        status[k] = march(
            layout, kernels, idx, rows, pos, part(numbers, k * own), drive_rows, drive_columns,
            blocks, slot, slots, lu_start, lu_columns, diagonal, mass, tested, powers, method,
            part(settings, k * SETTINGS), part(edges, first), first_edges[k + 1] - first,
            max_steps, part(y, k * n), part(Y, k * length), part(state, k * CLOCK),
            part(counts, k * COUNTS), part(outputs, first * n), -1, 0, part(work, 0), work,
        )  # fmt: skip
