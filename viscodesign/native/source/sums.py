"""Sums over the elements of all tables.

``layout`` begins with HEADER numbers, then come FIELDS numbers for every table of elements, then
as many for every table of sources.
"""

from __future__ import annotations

from viscodesign.native.source.primitives import call_kernel, part

HEADER = 8
UNKNOWNS, DRIVES, ENTRIES, DRIVE_ENTRIES, ELEMENTS, SOURCES = 0, 1, 2, 3, 4, 5
WIDTH, WIDTH_OF_SLOPES = 6, 7
"""Counts at the head of ``layout``; the last are the longest arrays of a kernel and of its
derivatives."""
FIELDS = 11
GROUPS, LANES, LOCALS, NUMBERS, VALUES, DERIVATIVES = 0, 1, 2, 3, 4, 5
"""Counts of a table: groups, lanes, and what one element has."""
IDX_AT, NUMBERS_AT, ROWS_AT, POS_AT, KERNEL = 6, 7, 8, 9, 10
"""Where the arrays of a table begin, and the first of its two kernels or, without, LINEAR."""
LINEAR = -1
"""Elements with one local value, that times their number."""


def residual(layout, kernels, idx, rows, numbers, Y, r, local, out):
    """Sum the values of all elements into r (n + 1,)."""
    for i in range(layout[UNKNOWNS] + 1):
        r[i] = 0.0
    for k in range(layout[ELEMENTS]):
        table = HEADER + FIELDS * k
        values = layout[table + VALUES] * layout[table + LANES]
        if layout[table + KERNEL] == LINEAR:
            given = part(numbers, layout[table + NUMBERS_AT])
            sources, places = part(idx, layout[table + IDX_AT]), part(rows, layout[table + ROWS_AT])
            for i in range(values * layout[table + GROUPS]):
                r[places[i]] += given[i] * Y[sources[i]]
            continue
        for g in range(layout[table + GROUPS]):
            run_group(layout, table, 0, g, kernels, idx, numbers, Y, local, out)
            scatter(values, part(rows, layout[table + ROWS_AT] + g * values), out, r)


def jacobian(layout, kernels, idx, pos, numbers, Y, J, local, out):
    """Sum the derivatives of all elements into J (nnz + 1 + ndr,)."""
    for i in range(layout[ENTRIES] + 1 + layout[DRIVE_ENTRIES]):
        J[i] = 0.0
    for k in range(layout[ELEMENTS]):
        table = HEADER + FIELDS * k
        values = layout[table + DERIVATIVES] * layout[table + LANES]
        if layout[table + KERNEL] == LINEAR:
            given, places = part(numbers, layout[table + NUMBERS_AT]), layout[table + POS_AT]
            scatter(values * layout[table + GROUPS], part(pos, places), given, J)
            continue
        for g in range(layout[table + GROUPS]):
            run_group(layout, table, 1, g, kernels, idx, numbers, Y, local, out)
            scatter(values, part(pos, layout[table + POS_AT] + g * values), out, J)


def drive(layout, kernels, idx, rows, numbers, Y, local, out):
    """Set the drives in Y from its time and coefficients."""
    drives = part(Y, layout[UNKNOWNS])
    for k in range(layout[SOURCES]):
        table = HEADER + FIELDS * (layout[ELEMENTS] + k)
        values = layout[table + VALUES] * layout[table + LANES]
        for g in range(layout[table + GROUPS]):
            run_group(layout, table, 0, g, kernels, idx, numbers, Y, local, out)
            places = part(rows, layout[table + ROWS_AT] + g * values)
            for i in range(values):
                # The spare place is that of the time.
                if places[i] < layout[DRIVES]:
                    drives[places[i]] = out[i]


def drive_rates(layout, kernels, idx, rows, numbers, Y, rates, local, out):
    """Derivatives (nd + 1,) of the drives by time."""
    for i in range(layout[DRIVES] + 1):
        rates[i] = 0.0
    for k in range(layout[SOURCES]):
        table = HEADER + FIELDS * (layout[ELEMENTS] + k)
        values = layout[table + VALUES] * layout[table + LANES]
        for g in range(layout[table + GROUPS]):
            run_group(layout, table, 1, g, kernels, idx, numbers, Y, local, out)
            places = part(rows, layout[table + ROWS_AT] + g * values)
            for i in range(values):
                rates[places[i]] = out[i]


def run_group(layout, table, which, group, kernels, idx, numbers, Y, local, out):
    """Call one of a table's two kernels for one group of elements."""
    lanes = layout[table + LANES]
    count = layout[table + LOCALS] * lanes
    gather(count, part(idx, layout[table + IDX_AT] + group * count), Y, local)
    own = layout[table + NUMBERS_AT] + group * layout[table + NUMBERS] * lanes
    call_kernel(kernels, layout[table + KERNEL] + which, local, part(numbers, own), out)


def gather(count, places, source, target):
    """target[i] = source[places[i]]."""
    for i in range(count):
        target[i] = source[places[i]]


def scatter(count, places, source, target):
    """target[places[i]] += source[i]; places may repeat."""
    for i in range(count):
        target[places[i]] += source[i]
