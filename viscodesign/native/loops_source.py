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
"""Where the arrays of a table begin, and the first of its two kernels or, without, LINEAR."""
LINEAR = -1
"""Elements with one local value, that times their number."""

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


def pair_up(n, start, columns, partner, common, seen):
    """Pair unknowns whose rows of a symmetric pattern overlap most: partner (n,), -1 for none.

    ``common``, ``seen`` int32 (n,): to work with.
    """
    for i in range(n):
        partner[i] = -1
        common[i] = 0
    for i in range(n):
        if partner[i] >= 0:
            continue
        count = 0
        for p in range(start[i], start[i + 1]):
            k = columns[p]
            for q in range(start[k], start[k + 1]):
                j = columns[q]
                if j > i and partner[j] < 0:
                    if common[j] == 0:
                        seen[count] = j
                        count += 1
                    common[j] += 1
        best, most = -1, 0.0
        for c in range(count):
            j = seen[c]
            union = start[i + 1] - start[i] + start[j + 1] - start[j] - common[j]
            share = common[j] / union
            if share > most:
                best, most = j, share
            common[j] = 0
        if best >= 0:
            partner[i] = best
            partner[best] = i


def elimination_order(
    n, start, members, capacity, order, at, count, room, pool, degree, head, after, before, mark
):
    """Order of elimination (n,) that keeps the factors sparse.

    Next is whoever has the fewest others in its row and its column together: rows of positions
    are short, their columns long, so that they go early. Lists 0..n-1 of ``members`` are the
    rows, n..2n-1 the columns, all without the diagonal. ``pool``: int32 (capacity,), no fewer
    than the members; the others int32 (2 n,), to work with. Returns 0, or -1 where ``pool`` is
    too short.
    """
    free = start[2 * n]
    for i in range(2 * n):
        at[i] = start[i]
        count[i] = room[i] = start[i + 1] - start[i]
        head[i] = mark[i] = -1
    for p in range(free):
        pool[p] = members[p]
    for k in range(n):
        i = n - 1 - k
        degree[i] = count[i] + count[n + i]
        enlist(i, degree, head, after, before)
    least = 0
    for k in range(n):
        while head[least] < 0:
            least += 1
        pivot = head[least]
        delist(pivot, degree, head, after, before)
        order[k] = pivot
        # Whatever is in the pivot's column gets its row, and the other way round.
        for side in range(2):
            source, across = pivot + side * n, pivot + (1 - side) * n
            for a in range(count[across]):
                i = pool[at[across] + a]
                free = merge(
                    i + side * n, source, i, pivot, free, capacity, at, count, room, pool, mark
                )
                if free < 0:
                    return -1
                delist(i, degree, head, after, before)
                degree[i] = count[i] + count[n + i]
                enlist(i, degree, head, after, before)
                least = min(least, degree[i])
    return 0


def merge(target, source, own, gone, free, capacity, at, count, room, pool, mark):
    """Add a list to another, without two members; returns where the pool is free then, or -1."""
    if free + count[target] + count[source] > capacity:
        return -1
    # Marks are the free place, or -1 again where that does not move on.
    mark[own] = mark[gone] = free
    end = free
    for side in range(2):
        given = target if side == 0 else source
        for c in range(count[given]):
            j = pool[at[given] + c]
            if mark[j] != free:
                mark[j] = free
                pool[end] = j
                end += 1
    size = end - free
    count[target] = size
    if size > room[target]:
        at[target] = free
        room[target] = size
        return end
    for c in range(size):
        pool[at[target] + c] = pool[free + c]
        mark[pool[free + c]] = -1
    mark[own] = mark[gone] = -1
    return free


def enlist(i, degree, head, after, before):
    """Put i first in the list of its degree."""
    other = head[degree[i]]
    after[i] = other
    before[i] = -1
    if other >= 0:
        before[other] = i
    head[degree[i]] = i


def delist(i, degree, head, after, before):
    """Take i out of the list of its degree."""
    if before[i] >= 0:
        after[before[i]] = after[i]
    else:
        head[degree[i]] = after[i]
    if after[i] >= 0:
        before[after[i]] = before[i]


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


def lu_fill(n, count, J, own, mass, scale, lu):
    """Set lu (4 count,) to diag(mass) scale - J, for J in the places of the factors.

    ``own`` (n + 1,): where the diagonal entries of the unknowns are, and that of nobody.
    """
    for p in range(4 * count):
        lu[p] = -J[p]
    for i in range(n):
        lu[own[i]] += mass[i] * scale
    if own[n] >= 0:
        lu[own[n]] = 1.0


def lu_factor(blocks, lu_start, lu_columns, diagonal, lu, row):
    """Factor in place: L without its unit diagonal, U with its diagonal blocks inverted.

    ``row`` (4 blocks,): to work with. Returns 0, or 1 + the first block that is singular or not
    finite.
    """
    for i in range(blocks):
        first, middle, last = lu_start[i], diagonal[i], lu_start[i + 1]
        for p in range(first, last):
            copy_block(lu, 4 * p, row, 4 * lu_columns[p])
        for p in range(first, middle):
            k = lu_columns[p]
            w, d, e = 4 * k, 4 * diagonal[k], 4 * p
            a = row[w] * lu[d] + row[w + 1] * lu[d + 2]
            b = row[w] * lu[d + 1] + row[w + 1] * lu[d + 3]
            c = row[w + 2] * lu[d] + row[w + 3] * lu[d + 2]
            f = row[w + 2] * lu[d + 1] + row[w + 3] * lu[d + 3]
            lu[e] = a
            lu[e + 1] = b
            lu[e + 2] = c
            lu[e + 3] = f
            for q in range(diagonal[k] + 1, lu_start[k + 1]):
                w, u = 4 * lu_columns[q], 4 * q
                row_0 = row[w] - a * lu[u] - b * lu[u + 2]
                row_1 = row[w + 1] - a * lu[u + 1] - b * lu[u + 3]
                row_2 = row[w + 2] - c * lu[u] - f * lu[u + 2]
                row_3 = row[w + 3] - c * lu[u + 1] - f * lu[u + 3]
                row[w] = row_0
                row[w + 1] = row_1
                row[w + 2] = row_2
                row[w + 3] = row_3
        for p in range(middle, last):
            copy_block(row, 4 * lu_columns[p], lu, 4 * p)
        d = 4 * middle
        a, b, c, f = lu[d], lu[d + 1], lu[d + 2], lu[d + 3]
        determinant = a * f - b * c
        if determinant == 0.0 or not math.isfinite(determinant):
            return i + 1
        inverse = 1.0 / determinant
        lu[d] = f * inverse
        lu[d + 1] = -b * inverse
        lu[d + 2] = -c * inverse
        lu[d + 3] = a * inverse
    return 0


def copy_block(source, at, target, to):
    """Copy four numbers."""
    for i in range(4):
        target[to + i] = source[at + i]


def lu_solve(n, slots, blocks, lu_start, lu_columns, diagonal, lu, right, solution, x):
    """Solution (n,) for a right side (n,).

    ``slots`` (n,): places of the unknowns in the order of elimination; ``x`` (2 blocks,): to work
    with.
    """
    for i in range(2 * blocks):
        x[i] = 0.0
    for i in range(n):
        x[slots[i]] = right[i]
    for i in range(blocks):
        first, second = x[2 * i], x[2 * i + 1]
        for p in range(lu_start[i], diagonal[i]):
            e, y, z = 4 * p, x[2 * lu_columns[p]], x[2 * lu_columns[p] + 1]
            first -= lu[e] * y + lu[e + 1] * z
            second -= lu[e + 2] * y + lu[e + 3] * z
        x[2 * i] = first
        x[2 * i + 1] = second
    for i in range(blocks - 1, -1, -1):
        first, second = x[2 * i], x[2 * i + 1]
        for p in range(diagonal[i] + 1, lu_start[i + 1]):
            e, y, z = 4 * p, x[2 * lu_columns[p]], x[2 * lu_columns[p] + 1]
            first -= lu[e] * y + lu[e + 1] * z
            second -= lu[e + 2] * y + lu[e + 3] * z
        d = 4 * diagonal[i]
        x[2 * i] = lu[d] * first + lu[d + 1] * second
        x[2 * i + 1] = lu[d + 2] * first + lu[d + 3] * second
    for i in range(n):
        solution[i] = x[slots[i]]


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
    blocks, own, slots, lu_start, lu_columns, diagonal,
    mass, tested, powers, method, settings, edges, edge_count, max_steps,
    y, Y, state, counts, outputs, work,
):  # fmt: skip
    """Take steps from state[TIME] to the last edge; see `march.march`.

    ``pos`` and layout[ENTRIES] are those of the factors; ``tested``: unknowns in front of the
    integrals; ``outputs`` (edges from counts[EDGE] on, n); ``work``: see `march.work_size`.
    Returns how it ended.
    """
    n, entries = layout[UNKNOWNS], layout[ENTRIES]
    clock = n + layout[DRIVES]
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
        lu_fill(n, lu_start[blocks], J, own, mass, scale, lu)
        singular = lu_factor(blocks, lu_start, lu_columns, diagonal, lu, row)
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
                lu_solve(n, slots, blocks, lu_start, lu_columns, diagonal, lu, right, stage, x)
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
