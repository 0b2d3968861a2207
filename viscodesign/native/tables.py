"""Elements of a scene as index arrays around kernels, and their sums.

All unknowns and inputs of the elements stand in one array

    Y = [unknowns (n) | drives (nd) | time | rest],

where ``rest`` are coefficients of the inputs and constants: whatever does not change within a
smooth stretch of the inputs.
"""

from __future__ import annotations

import copy
from collections.abc import Sequence

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.native.loops import DTYPES, Kernel, Loops, native_loops
from viscodesign.native.source.sums import LINEAR

Scratch = tuple[np.ndarray, np.ndarray]
"""Arguments and results of one call of a kernel."""


@dataclass(frozen=True)
class ElementTable:
    """All elements of one kind, in groups of W lanes.

    The last group is padded with copies of an element whose rows and entries are the spare ones.
    """

    residual: Kernel | None
    """(local (nl, W), numbers (np, W)) -> values (nr, W); None: the local value times the number.

    Such terms have one of everything. They need no kernel, and take a fraction of the time.
    """
    jacobian: Kernel | None
    """The same arguments -> derivatives (nz, W); None: the number."""
    idx: np.ndarray
    """int32 (groups, nl, W): places of the local values in Y."""
    numbers: np.ndarray
    """float64 (groups, np, W)."""
    rows: np.ndarray
    """int32 (groups, nr, W): rows that the values add to; n is the spare one."""
    pos: np.ndarray
    """int32 (groups, nz, W): entries that the derivatives add to; nnz is the spare one.

    Entries nnz+1.. are the derivatives with respect to drives (`Assembly.drive_rows`,
    `drive_columns`).
    """


@dataclass(frozen=True)
class SourceTable:
    """Inputs of one kind: kernels that set drives from time and coefficients."""

    value: Kernel
    """(local (nl, W), numbers (np, W)) -> drives (nr, W)."""
    rate: Kernel
    """The same arguments -> their derivatives with respect to time (nr, W) [1/s]."""
    idx: np.ndarray
    """int32 (groups, nl, W): places of the local values in Y, such as time n + nd."""
    numbers: np.ndarray
    """float64 (groups, np, W)."""
    places: np.ndarray
    """int32 (groups, nr, W): drives that are set; nd is the spare one."""


class Assembly:
    """Sums over all elements: the residual r (n,) and its Jacobian.

    ``unknowns`` n, ``drives`` nd, ``entries`` nnz of the Jacobian (duplicates merged, any order);
    ``drive_rows``, ``drive_columns`` (ndr,): where derivatives with respect to drives belong.
    ``loops``: native ones by default, the twin in Python takes kernels in Python.
    """

    def __init__(
        self,
        elements: Sequence[ElementTable],
        sources: Sequence[SourceTable],
        unknowns: int,
        drives: int,
        entries: int,
        drive_rows: Sequence[int] | np.ndarray = (),
        drive_columns: Sequence[int] | np.ndarray = (),
        *,
        loops: Loops | None = None,
    ) -> None:
        self.loops = loops or native_loops()
        self.unknowns, self.drives, self.entries = unknowns, drives, entries
        self.drive_rows = np.ascontiguousarray(drive_rows, dtype=DTYPES["places"])
        self.drive_columns = np.ascontiguousarray(drive_columns, dtype=DTYPES["places"])
        tables: list[ElementTable | SourceTable] = [*elements, *sources]
        pairs = [(t.residual, t.jacobian) for t in elements] + [(t.value, t.rate) for t in sources]
        targets = [t.rows for t in elements] + [t.places for t in sources]
        derivatives = [t.pos for t in elements] + [t.places for t in sources]
        _check_range("drive_rows", [self.drive_rows], unknowns)
        _check_range("drive_columns", [self.drive_columns], drives)
        _check_range("rows", targets[: len(elements)], unknowns + 1)
        _check_range("places", targets[len(elements) :], drives + 1)
        _check_range("pos", derivatives[: len(elements)], entries + 1 + len(self.drive_rows))
        idx = [table.idx for table in tables]
        _check_range("idx", idx, np.iinfo(np.int32).max)
        self.reach = max((int(array.max()) + 1 for array in idx if array.size), default=0)
        """Entries of Y that the kernels read at most."""
        called = [pair for pair in pairs if pair[0] is not None]
        self.kernels = self.loops.kernels([k for pair in called for k in pair if k is not None])
        self.keeper = tables
        self.idx, idx_at = _joined(idx, "places")
        self.rows, rows_at = _joined(targets, "places")
        self.pos, pos_at = _joined(derivatives[: len(elements)], "places")
        self.all_numbers, numbers_at = _joined([table.numbers for table in tables], "reals")
        self._number_shapes = [table.numbers.shape for table in tables]
        self._numbers_at = numbers_at
        fields = []
        self.groups_with_kernels = sum(t.idx.shape[0] for t in elements if t.residual is not None)
        """Calls of kernels that one sum over all elements makes."""
        self.width = 1
        """Numbers that one call of a kernel takes or gives at most."""
        self.width_of_slopes = 1
        """The same of its derivatives."""
        for k, table in enumerate(tables):
            groups, locals_, lanes = table.idx.shape
            own, values, slopes = (
                _entries(array, groups, lanes)
                for array in (table.numbers, targets[k], derivatives[k])
            )
            self.width = max(self.width, lanes * max(locals_, values, slopes))
            most = max(values, slopes, locals_ + own)
            self.width_of_slopes = max(self.width_of_slopes, lanes * (locals_ + most))
            pos = pos_at[k] if k < len(elements) else 0
            counts = (groups, lanes, locals_, own, values, slopes)
            kernel = LINEAR if pairs[k][0] is None else 2 * called.index(pairs[k])
            if kernel == LINEAR and counts[2:] != (1, 1, 1, 1):
                raise ValueError("terms without a kernel have one of everything")
            fields += [*counts, idx_at[k], numbers_at[k], rows_at[k], pos, kernel]
        head = (unknowns, drives, entries, len(self.drive_rows), len(elements), len(sources))
        self.layout = np.array(
            [*head, self.width, self.width_of_slopes, *fields], dtype=DTYPES["counts"]
        )

    def copy(self) -> Assembly:
        """An assembly with numbers of its own; all else is shared."""
        other = copy.copy(self)
        other.all_numbers = self.all_numbers.copy()
        return other

    def numbers(self, k: int) -> np.ndarray:
        """Numbers (groups, np, W) of a table, to be read or written between calls.

        Tables of elements come first, then those of sources.
        """
        shape = self._number_shapes[k]
        at = self._numbers_at[k]
        return self.all_numbers[at : at + int(np.prod(shape))].reshape(shape)

    def scratch(self) -> Scratch:
        """What one call at a time works with."""
        return np.empty(self.width), np.empty(self.width)

    def drive(self, Y: np.ndarray) -> np.ndarray:
        """Set the drives in Y from its time and coefficients; returns their rates (nd,) [1/s]."""
        self._check(Y)
        rates = np.empty(self.drives + 1)
        scratch = self.scratch()
        tables = (self.layout, self.kernels, self.idx, self.rows, self.all_numbers)
        self.loops("drive", *tables, Y, *scratch)
        self.loops("drive_rates", *tables, Y, rates, *scratch)
        return rates[: self.drives]

    def residual(self, Y: np.ndarray) -> np.ndarray:
        """r (n,) at Y, whose drives are set."""
        self._check(Y)
        r = np.empty(self.unknowns + 1)
        tables = (self.layout, self.kernels, self.idx, self.rows, self.all_numbers)
        self.loops("residual", *tables, Y, r, *self.scratch())
        return r[: self.unknowns]

    def jacobian(self, Y: np.ndarray) -> np.ndarray:
        """Values (nnz + 1 + ndr,): dr/dunknowns, the spare entry, dr/ddrives."""
        self._check(Y)
        J = np.empty(self.entries + 1 + len(self.drive_rows))
        tables = (self.layout, self.kernels, self.idx, self.pos, self.all_numbers)
        self.loops("jacobian", *tables, Y, J, *self.scratch())
        return J

    def _check(self, Y: np.ndarray) -> None:
        if Y.ndim != 1 or len(Y) < max(self.reach, self.unknowns + self.drives + 1):
            raise ValueError(f"Y is too short: {Y.shape}, needs {self.reach}")


def _entries(array: np.ndarray, groups: int, lanes: int) -> int:
    """Entries of one element in an array (groups, entries, W)."""
    if array.ndim != 3 or (array.shape[0], array.shape[2]) != (groups, lanes):
        raise ValueError(f"an array has shape {array.shape}, needs ({groups}, any, {lanes})")
    return int(array.shape[1])


def _joined(arrays: Sequence[np.ndarray], kind: str) -> tuple[np.ndarray, list[int]]:
    """All arrays one after the other, and where each begins."""
    ends = np.cumsum([0, *(array.size for array in arrays)])
    parts = [np.zeros(0), *(array.reshape(-1) for array in arrays)]
    return np.concatenate(parts).astype(DTYPES[kind]), ends[:-1].tolist()


def _check_range(name: str, arrays: Sequence[np.ndarray], stop: int) -> None:
    """Raise `ValueError` where an index is not in 0..stop-1: native code would not notice."""
    for array in arrays:
        if array.size and not 0 <= int(array.min()) <= int(array.max()) < stop:
            raise ValueError(f"an index in {name} is not below {stop}")
