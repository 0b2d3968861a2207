"""Pairs, their order of elimination, and the pattern of the factors."""

from __future__ import annotations


def pair_up(n, start, columns, weak, partner, common, seen):
    """Pair unknowns whose rows of a symmetric pattern overlap most: partner (n,), -1 for none.

    ``weak`` (n,): 1 for those that only pair with each other, else 0; ``common``, ``seen``
    int32 (n,): to work with.
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
                if j > i and partner[j] < 0 and weak[j] == weak[i]:
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
    n, start, members, first, awaiting, waits,
    capacity, order, at, count, room, pool, degree, head, after, before, mark,
):  # fmt: skip
    """Order of elimination (n,) that keeps the factors sparse.

    Next is whoever has the fewest others in its row and its column together: rows of positions
    are short, their columns long, so that they go early. Lists 0..n-1 of ``members`` are the
    rows, n..2n-1 the columns, all without the diagonal. ``waits`` (n,): how many must go before
    each, counted down; those that wait for i are ``awaiting`` from first[i] to first[i + 1].
    ``pool``: int32 (capacity,), no fewer than the members; the others int32 (2 n,), to work
    with. Returns 0, or -1 where ``pool`` is too short.
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
        if waits[i] == 0:
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
                if waits[i] == 0:
                    delist(i, degree, head, after, before)
                degree[i] = count[i] + count[n + i]
                if waits[i] == 0:
                    enlist(i, degree, head, after, before)
                    least = min(least, degree[i])
        for p in range(first[pivot], first[pivot + 1]):
            i = awaiting[p]
            waits[i] -= 1
            if waits[i] == 0:
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
