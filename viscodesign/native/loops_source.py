"""Loops over plain arrays, in the part of Python that numba can compile.

`docs/make_loops.py` makes ``loops.ll`` of them, which is what runs; as plain Python they are the
twin that tests compare it with. Arrays are flat and never overlap. Nothing is checked here:
`tables`, `sparse_lu` and `march` do that.

``layout`` begins with HEADER numbers, then come FIELDS numbers for every table of elements, then
as many for every table of sources.
"""

from __future__ import annotations

import math

from viscodesign.native.loops_primitives import call_kernel, part

HEADER = 8
UNKNOWNS, DRIVES, ENTRIES, DRIVE_ENTRIES, ELEMENTS, SOURCES, WIDTH = 0, 1, 2, 3, 4, 5, 6
"""Counts at the head of ``layout``; WIDTH is the longest array of a kernel."""
FIELDS = 11
GROUPS, LANES, LOCALS, NUMBERS, VALUES, DERIVATIVES = 0, 1, 2, 3, 4, 5
"""Counts of a table: groups, lanes, and what one element has."""
IDX_AT, NUMBERS_AT, ROWS_AT, POS_AT, KERNEL = 6, 7, 8, 9, 10
"""Where the arrays of a table begin, and the first of its two kernels."""

STAGES = 8
SHARED = 5
"""Stages that add to the place of the one before, instead of to the start, come after this one."""
C_AT, NODES_AT, SLOPES_AT, DENSE_AT, GAMMA_AT, ORDER_AT = 64, 128, 136, 144, 168, 169
"""Places in the coefficients of the method; those of A come first."""
(
    TOLERANCE, MOTION_TIME, LARGEST, SMALLEST, SAFETY, MAX_FACTOR, MIN_FACTOR, MEMORY,
) = 0, 1, 2, 3, 4, 5, 6, 7  # fmt: skip
TIME, SIZE, BEFORE = 0, 1, 2
EDGE, STEPS, REJECTED, RESIDUALS, JACOBIANS = 0, 1, 2, 3, 4
FINISHED, STEP_LIMIT, STEP_TOO_SMALL = 0, 1, 2


def residual(layout, kernels, idx, rows, numbers, Y, r, local, out):
    """Sum the values of all elements into r (n + 1,)."""
    for i in range(layout[UNKNOWNS] + 1):
        r[i] = 0.0
    for k in range(layout[ELEMENTS]):
        table = HEADER + FIELDS * k
        values = layout[table + VALUES] * layout[table + LANES]
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


def lu_pattern(n, start, columns, capacity, lu_start, lu_columns, diagonal, follow):
    """Rows of the factors of a matrix whose rows are sorted and hold their diagonal.

    Returns the count of entries, or -1 where there are more than ``capacity``. ``follow``: int32
    (n + 1,) to work with; follow[c] is the column after c in the row, n ends it.
    """
    count = 0
    for i in range(n):
        head = n
        for p in range(start[i + 1] - 1, start[i] - 1, -1):
            follow[columns[p]] = head
            head = columns[p]
        k = head
        while k < i:
            before = k
            for q in range(diagonal[k] + 1, lu_start[k + 1]):
                column = lu_columns[q]
                while follow[before] < column:
                    before = follow[before]
                if follow[before] > column:
                    follow[column] = follow[before]
                    follow[before] = column
                before = column
            k = follow[k]
        lu_start[i] = count
        column = head
        while column < n:
            if count == capacity:
                return -1
            if column == i:
                diagonal[i] = count
            lu_columns[count] = column
            count += 1
            column = follow[column]
        lu_start[i + 1] = count
    return count


def lu_fill(n, count, entries, J, place, mass, scale, order, diagonal, lu):
    """Set lu (count,) to diag(mass) scale - J, in the order of elimination."""
    for p in range(count):
        lu[p] = 0.0
    for k in range(entries):
        lu[place[k]] -= J[k]
    for i in range(n):
        lu[diagonal[i]] += mass[order[i]] * scale


def lu_factor(n, lu_start, lu_columns, diagonal, lu, row):
    """Factor in place: L without its unit diagonal, U with its inverse diagonal.

    ``row`` (n,): to work with. Returns 0, or 1 + the place of a pivot that is zero or not finite.
    """
    for i in range(n):
        first, middle, last = lu_start[i], diagonal[i], lu_start[i + 1]
        for p in range(first, last):
            row[lu_columns[p]] = lu[p]
        for p in range(first, middle):
            k = lu_columns[p]
            multiplier = row[k] * lu[diagonal[k]]
            lu[p] = multiplier
            for q in range(diagonal[k] + 1, lu_start[k + 1]):
                row[lu_columns[q]] -= multiplier * lu[q]
        for p in range(middle, last):
            lu[p] = row[lu_columns[p]]
        pivot = lu[middle]
        if pivot == 0.0 or not math.isfinite(pivot):
            return i + 1
        lu[middle] = 1.0 / pivot
    return 0


def lu_solve(n, order, lu_start, lu_columns, diagonal, lu, right, solution, x):
    """Solution (n,) for a right side (n,); ``x`` (n,): to work with."""
    for i in range(n):
        rest = right[order[i]]
        for p in range(lu_start[i], diagonal[i]):
            rest -= lu[p] * x[lu_columns[p]]
        x[i] = rest
    for i in range(n - 1, -1, -1):
        rest = x[i]
        for p in range(diagonal[i] + 1, lu_start[i + 1]):
            rest -= lu[p] * x[lu_columns[p]]
        x[i] = rest * lu[diagonal[i]]
    for i in range(n):
        solution[order[i]] = x[i]


def add_scaled(n, factor, x, y):
    """y += factor x."""
    for i in range(n):
        y[i] += factor * x[i]


def copy(n, x, y):
    """y = x."""
    for i in range(n):
        y[i] = x[i]


def march(
    layout, kernels, idx, rows, pos, numbers, drive_rows, drive_columns,
    factors, place, order, lu_start, lu_columns, diagonal,
    mass, tested, powers, method, settings, edges, edge_count, max_steps,
    y, Y, state, counts, outputs, work,
):  # fmt: skip
    """Take steps from state[TIME] to the last edge; see `march.march`.

    ``factors``: entries of L and U; ``tested``: unknowns in front of the integrals; ``outputs``
    (edges from counts[EDGE] on, n); ``work``: see `march.work_size`. Returns how it ended.
    """
    n, entries = layout[UNKNOWNS], layout[ENTRIES]
    clock = n + layout[DRIVES]
    stages = part(work, 0)
    place_, right, after = part(work, 8 * n), part(work, 9 * n), part(work, 10 * n + 1)
    drift, row, x = part(work, 11 * n + 1), part(work, 12 * n + 1), part(work, 13 * n + 1)
    lu = part(work, 14 * n + 1)
    J = part(lu, factors)
    rates = part(J, entries + 1 + layout[DRIVE_ENTRIES])
    local = part(rates, layout[DRIVES] + 1)
    out = part(local, layout[WIDTH])
    last = edges[edge_count - 1]
    first_edge = counts[EDGE]
    fresh = False
    for _ in range(max_steps):
        time, size = state[TIME], state[SIZE]
        remaining = last - time
        final = size >= remaining * (1 - 1e-9)
        h = size
        if final:
            h = remaining
        elif size > remaining / 2:
            h = min(size, remaining / 2)
        if not fresh:
            copy(n, y, Y)
            Y[clock] = time
            drive(layout, kernels, idx, rows, numbers, Y, local, out)
            jacobian(layout, kernels, idx, pos, numbers, Y, J, local, out)
            drive_rates(layout, kernels, idx, rows, numbers, Y, rates, local, out)
            for i in range(n):
                drift[i] = 0.0
            for k in range(layout[DRIVE_ENTRIES]):
                drift[drive_rows[k]] += J[entries + 1 + k] * rates[drive_columns[k]]
            counts[JACOBIANS] += 1
            fresh = True
        scale = 1.0 / (h * method[GAMMA_AT])
        lu_fill(n, factors, entries, J, place, mass, scale, order, diagonal, lu)
        singular = lu_factor(n, lu_start, lu_columns, diagonal, lu, row)
        counts[STEPS] += 1
        error = math.inf
        if singular == 0:
            for i in range(STAGES):
                if i <= SHARED:
                    copy(n, y, place_)
                    for j in range(i):
                        add_scaled(n, method[8 * i + j], part(stages, j * n), place_)
                else:
                    add_scaled(n, 1.0, part(stages, (i - 1) * n), place_)
                copy(n, place_, Y)
                Y[clock] = time + method[NODES_AT + i] * h
                drive(layout, kernels, idx, rows, numbers, Y, local, out)
                residual(layout, kernels, idx, rows, numbers, Y, right, local, out)
                combine(n, i, part(method, C_AT + 8 * i), h, mass, stages, right, after)
                slope = h * method[SLOPES_AT + i]
                if slope != 0.0:
                    add_scaled(n, slope, drift, right)
                stage = part(stages, i * n)
                lu_solve(n, order, lu_start, lu_columns, diagonal, lu, right, stage, x)
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
            )  # fmt: skip
            counts[EDGE] = stop
        factor = step_factor(error, state[BEFORE], method[ORDER_AT], settings)
        copy(n, after, y)
        state[TIME] = until
        if final:
            state[SIZE] = max(size, h) * min(factor, 1.0 / settings[SAFETY])
            return FINISHED
        state[SIZE] = min(h * factor, settings[LARGEST])
        state[BEFORE] = max(error, 1e-4)
        fresh = False
    return STEP_LIMIT


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


def dense_output(n, y, after, stages, method, time, until, edges, count, outputs, inner):
    """Unknowns at the edges inside a step, by its dense output."""
    for e in range(count):
        theta = min((edges[e] - time) / (until - time), 1.0)
        target = part(outputs, e * n)
        if theta == 1.0:
            copy(n, after, target)
            continue
        for i in range(n):
            inner[i] = 0.0
        for j in range(STAGES):
            bend = method[DENSE_AT + STAGES + j] + theta * method[DENSE_AT + 2 * STAGES + j]
            add_scaled(n, method[DENSE_AT + j] + theta * bend, part(stages, j * n), inner)
        for i in range(n):
            target[i] = (1.0 - theta) * y[i] + theta * (after[i] + (1.0 - theta) * inner[i])
