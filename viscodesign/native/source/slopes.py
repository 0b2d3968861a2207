"""Derivatives of the sums over elements, along given directions or of weighted results.

Tables are those of `sums`; of each kernel's two functions there are two derivatives: slopes of
their weighted results, and their rates along a direction. "Bars" are slopes of the whole result
of a run by a quantity, "dots" are rates of a quantity.
"""

from __future__ import annotations

from viscodesign.native.source.factors import SIDE
from viscodesign.native.source.primitives import call_kernel, part
from viscodesign.native.source.sums import (
    DERIVATIVES,
    DRIVE_ENTRIES,
    DRIVES,
    ELEMENTS,
    ENTRIES,
    FIELDS,
    GROUPS,
    HEADER,
    IDX_AT,
    KERNEL,
    LANES,
    LINEAR,
    LOCALS,
    NUMBERS,
    NUMBERS_AT,
    POS_AT,
    ROWS_AT,
    SOURCES,
    UNKNOWNS,
    VALUES,
    gather,
    scatter,
)

PULL, PUSH = 0, 2
"""Places of the derivatives of a table's kernels among its four."""


def pull_residual(layout, derived, idx, rows, numbers, Y, weights, Y_bar, numbers_bar, local, out):
    """Add the slopes of weights (n + 1,) times the residual to Y_bar and numbers_bar."""
    for k in range(layout[ELEMENTS]):
        table = HEADER + FIELDS * k
        if layout[table + KERNEL] == LINEAR:
            own = layout[table + NUMBERS_AT]
            sources, places = part(idx, layout[table + IDX_AT]), part(rows, layout[table + ROWS_AT])
            for i in range(layout[table + LANES] * layout[table + GROUPS]):
                Y_bar[sources[i]] += numbers[own + i] * weights[places[i]]
                numbers_bar[own + i] += Y[sources[i]] * weights[places[i]]
            continue
        pull(
            layout, table, 0, layout[table + VALUES], part(rows, layout[table + ROWS_AT]),
            derived, idx, numbers, Y, weights, Y_bar, numbers_bar, local, out,
        )  # fmt: skip


def pull_jacobian(layout, derived, idx, pos, numbers, Y, weights, Y_bar, numbers_bar, local, out):
    """The same for weights (nnz + 1 + ndr,) times the entries of the Jacobian."""
    for k in range(layout[ELEMENTS]):
        table = HEADER + FIELDS * k
        places = part(pos, layout[table + POS_AT])
        if layout[table + KERNEL] == LINEAR:
            own = part(numbers_bar, layout[table + NUMBERS_AT])
            for i in range(layout[table + LANES] * layout[table + GROUPS]):
                own[i] += weights[places[i]]
            continue
        pull(
            layout, table, 1, layout[table + DERIVATIVES], places,
            derived, idx, numbers, Y, weights, Y_bar, numbers_bar, local, out,
        )  # fmt: skip


def pull_drive(layout, derived, idx, rows, numbers, Y, which, weights, Y_bar, numbers_bar, local,
               out):  # fmt: skip
    """The same for weights (nd + 1,) times the drives (which 0) or their rates (1)."""
    for k in range(layout[SOURCES]):
        table = HEADER + FIELDS * (layout[ELEMENTS] + k)
        pull(
            layout, table, which, layout[table + VALUES], part(rows, layout[table + ROWS_AT]),
            derived, idx, numbers, Y, weights, Y_bar, numbers_bar, local, out,
        )  # fmt: skip


def pull(layout, table, which, results, places, derived, idx, numbers, Y, weights, Y_bar,
         numbers_bar, local, out):  # fmt: skip
    """Vector-Jacobian product of one table's results."""
    lanes = layout[table + LANES]
    values, own = results * lanes, layout[table + NUMBERS] * lanes
    count = layout[table + LOCALS] * lanes
    kernel = 2 * layout[table + KERNEL] + PULL + which
    for g in range(layout[table + GROUPS]):
        read = part(idx, layout[table + IDX_AT] + g * count)
        at = layout[table + NUMBERS_AT] + g * own
        gather(count, read, Y, local)
        gather(values, part(places, g * values), weights, part(local, count))
        call_kernel(derived, kernel, local, part(numbers, at), out)
        scatter(count, read, out, Y_bar)
        for i in range(own):
            numbers_bar[at + i] += out[count + i]


def push_residual(layout, derived, idx, rows, numbers, Y, Y_dot, numbers_dot, r_dot, local, out):
    """Rates (n + 1,) of the residual along Y_dot and numbers_dot."""
    for i in range(layout[UNKNOWNS] + 1):
        r_dot[i] = 0.0
    for k in range(layout[ELEMENTS]):
        table = HEADER + FIELDS * k
        places = part(rows, layout[table + ROWS_AT])
        if layout[table + KERNEL] == LINEAR:
            own, sources = layout[table + NUMBERS_AT], part(idx, layout[table + IDX_AT])
            for i in range(layout[table + LANES] * layout[table + GROUPS]):
                rate = numbers[own + i] * Y_dot[sources[i]]
                r_dot[places[i]] += rate + numbers_dot[own + i] * Y[sources[i]]
            continue
        values = layout[table + VALUES] * layout[table + LANES]
        for g in range(layout[table + GROUPS]):
            push(layout, table, 0, g, derived, idx, numbers, Y, Y_dot, numbers_dot, local, out)
            scatter(values, part(places, g * values), out, r_dot)


def push_jacobian(layout, derived, idx, pos, numbers, Y, Y_dot, numbers_dot, J_dot, local, out):
    """The same for the entries of the Jacobian (nnz + 1 + ndr,)."""
    for i in range(layout[ENTRIES] + 1 + layout[DRIVE_ENTRIES]):
        J_dot[i] = 0.0
    for k in range(layout[ELEMENTS]):
        table = HEADER + FIELDS * k
        places = part(pos, layout[table + POS_AT])
        values = layout[table + DERIVATIVES] * layout[table + LANES]
        if layout[table + KERNEL] == LINEAR:
            own = part(numbers_dot, layout[table + NUMBERS_AT])
            scatter(values * layout[table + GROUPS], places, own, J_dot)
            continue
        for g in range(layout[table + GROUPS]):
            push(layout, table, 1, g, derived, idx, numbers, Y, Y_dot, numbers_dot, local, out)
            scatter(values, part(places, g * values), out, J_dot)


def push_drive(layout, derived, idx, rows, numbers, Y, which, Y_dot, numbers_dot, rates_dot, local,
               out):  # fmt: skip
    """Rates (nd,) of the drives (which 0) or of their own rates (1)."""
    for k in range(layout[SOURCES]):
        table = HEADER + FIELDS * (layout[ELEMENTS] + k)
        values = layout[table + VALUES] * layout[table + LANES]
        for g in range(layout[table + GROUPS]):
            push(layout, table, which, g, derived, idx, numbers, Y, Y_dot, numbers_dot, local, out)
            places = part(rows, layout[table + ROWS_AT] + g * values)
            for i in range(values):
                if places[i] < layout[DRIVES]:
                    rates_dot[places[i]] = out[i]


def push(layout, table, which, group, derived, idx, numbers, Y, Y_dot, numbers_dot, local, out):
    """Rates of one group of elements along a direction."""
    lanes = layout[table + LANES]
    count, own = layout[table + LOCALS] * lanes, layout[table + NUMBERS] * lanes
    read = part(idx, layout[table + IDX_AT] + group * count)
    at = layout[table + NUMBERS_AT] + group * own
    gather(count, read, Y, local)
    gather(count, read, Y_dot, part(local, count))
    rates = part(local, 2 * count)
    for i in range(own):
        rates[i] = numbers_dot[at + i]
    kernel = 2 * layout[table + KERNEL] + PUSH + which
    call_kernel(derived, kernel, local, part(numbers, at), out)


def moving_groups(layout):
    """Number of all groups of elements that have kernels."""
    count = 0
    for k in range(layout[ELEMENTS]):
        table = HEADER + FIELDS * k
        if layout[table + KERNEL] != LINEAR:
            count += layout[table + GROUPS]
    return count


def mark_moving(layout, numbers_dot, moving):
    """Set moving (groups,) to one for every group of which a number has a rate, else to zero."""
    at = 0
    for k in range(layout[ELEMENTS]):
        table = HEADER + FIELDS * k
        if layout[table + KERNEL] == LINEAR:
            continue
        own = layout[table + NUMBERS] * layout[table + LANES]
        for g in range(layout[table + GROUPS]):
            first = layout[table + NUMBERS_AT] + g * own
            moving[at] = 0.0
            for i in range(own):
                if numbers_dot[first + i] != 0.0:
                    moving[at] = 1.0
            at += 1


def push_numbers(layout, derived, idx, rows, numbers, Y, numbers_dot, moving, r_dot, local, out):
    """Add the rates of the residual with the unknowns held, SIDE apart; see `mark_moving`."""
    at = 0
    for k in range(layout[ELEMENTS]):
        table = HEADER + FIELDS * k
        places, lanes = part(rows, layout[table + ROWS_AT]), layout[table + LANES]
        first = layout[table + NUMBERS_AT]
        if layout[table + KERNEL] == LINEAR:
            sources = part(idx, layout[table + IDX_AT])
            for i in range(lanes * layout[table + GROUPS]):
                if numbers_dot[first + i] != 0.0 and places[i] < layout[UNKNOWNS]:
                    r_dot[SIDE * places[i]] += numbers_dot[first + i] * Y[sources[i]]
            continue
        count, own = layout[table + LOCALS] * lanes, layout[table + NUMBERS] * lanes
        values = layout[table + VALUES] * lanes
        for g in range(layout[table + GROUPS]):
            if moving[at] != 0.0:
                gather(count, part(idx, layout[table + IDX_AT] + g * count), Y, local)
                rates = part(local, count)
                for i in range(count):
                    rates[i] = 0.0
                for i in range(own):
                    rates[count + i] = numbers_dot[first + g * own + i]
                kernel = 2 * layout[table + KERNEL] + PUSH
                call_kernel(derived, kernel, local, part(numbers, first + g * own), out)
                targets = part(places, g * values)
                for i in range(values):
                    if targets[i] < layout[UNKNOWNS]:
                        r_dot[SIDE * targets[i]] += out[i]
            at += 1
