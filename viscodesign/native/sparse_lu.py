"""Sparse LU of 2 by 2 blocks, in an order that keeps the factors sparse.

Unknowns are paired whose rows look alike, such as the two coordinates of a node, and pairs with
few neighbours are eliminated first. Within a pair the pivots are free, between pairs there
is no pivoting: the matrices of a step of an implicit method have masses, compliances and
stiffnesses on their diagonal. Where an own entry may vanish, as at a node of a straight axis that
only the strains beside it hold, these strains are eliminated before: they leave their stiffness.
"""

from __future__ import annotations

import numpy as np

from viscodesign.native.loops import DTYPES, Loops, native_loops
from viscodesign.native.source.sums import ENTRIES
from viscodesign.storage.distinct import distinct

PLACES = DTYPES["places"]
FIRST_GUESS = 3
"""Blocks of the factors over those of the matrix that are tried first."""


class SparseLU:
    """Factors of matrices diag(mass) scale - J of one pattern.

    ``rows``, ``columns`` (nnz,): places of the entries of J (n, n). The diagonal always belongs
    to the pattern. ``weak`` (n,): whether an own entry may be zero or round-off; such unknowns go
    after all others that depend on them and on which they depend. A pair without masses and
    without own entries may turn out singular all the same: `factor` says so.
    """

    def __init__(
        self,
        size: int,
        rows: np.ndarray,
        columns: np.ndarray,
        *,
        weak: np.ndarray | None = None,
        loops: Loops | None = None,
    ) -> None:
        self.loops = loops or native_loops()
        self._weak = np.zeros(size, bool) if weak is None else np.asarray(weak, dtype=bool)
        self.size, self.entries = size, len(rows)
        self.blocks = (size + 1) // 2
        rows, columns = np.asarray(rows, dtype=np.int64), np.asarray(columns, dtype=np.int64)
        self.slots = self._slots(rows, columns)
        """Places of the unknowns in the order of elimination (n,); slots 2k, 2k + 1 are pair k."""
        i, j = self.slots[rows].astype(np.int64), self.slots[columns].astype(np.int64)
        self.lu_start, self.lu_columns, self.diagonal = self._pattern(i // 2, j // 2)
        """Rows of blocks: first entries (blocks + 1,), columns, entries of the diagonal."""
        lu_rows = np.repeat(np.arange(self.blocks), np.diff(self.lu_start))
        keys = lu_rows * self.blocks + self.lu_columns
        block = np.searchsorted(keys, (i // 2) * self.blocks + j // 2)
        self.place = (4 * block + 2 * (i % 2) + j % 2).astype(PLACES)
        """Where the entries of J are among those of the factors (nnz,)."""
        taken = np.zeros(2 * self.blocks, dtype=bool)
        taken[self.slots] = True
        free = np.flatnonzero(~taken)
        at = np.append(self.slots, free)
        diagonal = 4 * self.diagonal[at // 2] + 3 * (at % 2)
        self.own = np.append(diagonal, [] if len(free) else [-1]).astype(PLACES)
        """Where the diagonal entries of the unknowns are, and of a free slot or -1 (n + 1,)."""

    @property
    def count(self) -> int:
        """Entries of the factors, four a block."""
        return 4 * len(self.lu_columns)

    def entries_of(self, pos: np.ndarray) -> np.ndarray:
        """Entries of the Jacobian as entries of the factors; the spare one and others follow."""
        beyond = np.arange(self.count, self.count + max(int(pos.max(initial=0)) + 1, 1))
        every = np.concatenate([self.place, beyond]).astype(PLACES)
        return np.take(every, pos)

    def layout_of(self, layout: np.ndarray) -> np.ndarray:
        """The layout of an assembly whose entries are those of the factors."""
        own = layout.copy()
        own[ENTRIES] = self.count
        return own

    def factor(self, entries: np.ndarray, mass: np.ndarray, scale: float) -> np.ndarray:
        """Factors of diag(mass) scale - J for J's entries (nnz,).

        Raises `ZeroDivisionError` at a pair that is singular or not finite.
        """
        if len(entries) < self.entries or len(mass) != self.size:
            raise ValueError("needs all entries of J and the masses of all rows")
        J, lu = np.zeros(self.count), np.empty(self.count)
        J[self.place] = entries[: self.entries]
        self.loops("lu_fill", self.size, self.count // 4, J, self.own, mass, scale, lu)
        pattern = (self.lu_start, self.lu_columns, self.diagonal)
        failed = self.loops("lu_factor", self.blocks, *pattern, lu, np.empty(4 * self.blocks))
        if failed:
            pair = np.flatnonzero(self.slots // 2 == failed - 1)
            raise ZeroDivisionError(f"no pivots for unknowns {pair.tolist()}")
        return lu

    def solve(self, factors: np.ndarray, right: np.ndarray) -> np.ndarray:
        """Solution (n,) for a right side (n,)."""
        return self._solved("lu_solve", factors, right)

    def solve_transposed(self, factors: np.ndarray, right: np.ndarray) -> np.ndarray:
        """Solution (n,) for a right side (n,) and the transposed matrix."""
        return self._solved("lu_solve_transposed", factors, right)

    def _solved(self, loop: str, factors: np.ndarray, right: np.ndarray) -> np.ndarray:
        if len(factors) != self.count or len(right) != self.size:
            raise ValueError("needs the factors of this pattern and one right side")
        solution, work = np.empty(self.size), np.empty(2 * self.blocks)
        pattern = (self.lu_start, self.lu_columns, self.diagonal)
        given = (self.size, self.slots, self.blocks)
        self.loops(loop, *given, *pattern, factors, right, solution, work)
        return solution

    def _slots(self, rows: np.ndarray, columns: np.ndarray) -> np.ndarray:
        size = self.size
        everyone = np.arange(size)
        i = np.concatenate([rows, columns, everyone])
        j = np.concatenate([columns, rows, everyone])
        start, sorted_columns = _rows_of(i, j, size)
        partner, common, seen = (np.empty(size, PLACES) for _ in range(3))
        weak = self._weak.astype(PLACES)
        self.loops("pair_up", size, start, sorted_columns, weak, partner, common, seen)
        single = np.flatnonzero(partner < 0)
        single = single[np.argsort(weak[single], kind="stable")]
        # Whoever is left over is paired all the same; one may stay alone.
        partner[single[0::2][: len(single) // 2]] = single[1::2]
        partner[single[1::2]] = single[0::2][: len(single) // 2]
        partner[partner < 0] = size
        second = everyone > partner
        pair = np.empty(size, dtype=np.int64)
        pair[~second] = np.arange(np.sum(~second))
        pair[second] = pair[partner[second]]
        order = self._order(pair[rows], pair[columns], *self._waiting(pair, rows, columns))
        turn = np.argsort(order)
        return (2 * turn[pair] + second).astype(PLACES)

    def _waiting(
        self, pair: np.ndarray, rows: np.ndarray, columns: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Pairs with weak unknowns, and others that must go before: neighbours both ways."""
        if not self._weak.any():
            return np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.int64)
        late = np.zeros(self.blocks, dtype=bool)
        late[pair[self._weak]] = True
        held = self._weak[rows] & ~late[pair[columns]]
        i, j = rows[held], columns[held]
        both = np.isin(j * self.size + i, rows * self.size + columns)
        keys = distinct(pair[i[both]] * self.blocks + pair[j[both]])
        return keys // self.blocks, keys % self.blocks

    def _order(
        self, rows: np.ndarray, columns: np.ndarray, waiting: np.ndarray, on: np.ndarray
    ) -> np.ndarray:
        """Pairs in the order of their elimination, for pairs in a row and a column each."""
        size = self.blocks
        waits = np.bincount(waiting, minlength=size).astype(PLACES)
        first, awaiting = _rows_of(on, waiting, size)
        off = rows != columns
        rows, columns = rows[off], columns[off]
        lists, others = np.append(rows, size + columns), np.append(columns, rows)
        start, members = _rows_of(lists, others, 2 * size)
        capacity = FIRST_GUESS * len(members) + size
        while True:
            order, at, count, room, *rest = (np.empty(2 * size, PLACES) for _ in range(9))
            given = (size, start, members, first, awaiting, waits.copy(), capacity)
            work = (at, count, room, np.empty(capacity, PLACES), *rest)
            if self.loops("elimination_order", *given, order, *work) == 0:
                return order[:size]
            capacity *= 2

    def _pattern(self, i: np.ndarray, j: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Rows of the blocks of the factors, for blocks (i, j) in the order of elimination."""
        size, everyone = self.blocks, np.arange(self.blocks)
        start, columns = _rows_of(np.append(i, everyone), np.append(j, everyone), size)
        lu_start, diagonal = np.zeros(size + 1, PLACES), np.zeros(size, PLACES)
        follow = np.zeros(size + 1, PLACES)
        capacity = FIRST_GUESS * len(columns)
        while True:
            lu_columns = np.empty(capacity, PLACES)
            result = (lu_start, lu_columns, diagonal, follow)
            count = self.loops("lu_pattern", size, start, columns, capacity, *result)
            if count >= 0:
                return lu_start, lu_columns[:count].copy(), diagonal
            capacity *= 2


def _rows_of(i: np.ndarray, j: np.ndarray, size: int) -> tuple[np.ndarray, np.ndarray]:
    """Sorted rows of a pattern, without repetitions: where they begin, and their columns."""
    # Ten times faster than numpy's unique.
    keys = np.sort(i * size + j)
    keys = keys[np.append(True, keys[1:] != keys[:-1])] if len(keys) else keys
    start = np.searchsorted(keys, np.arange(size + 1) * size)
    return start.astype(PLACES), (keys % size).astype(PLACES)
