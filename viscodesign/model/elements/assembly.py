"""Index arrays around the kernels of a structure, and the numbers of one scene in them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.elements import kinds as kinds_module
from viscodesign.model.elements.kinds import (
    MAX_KINDS,
    Elements,
    pull_of,
    push_of,
    rate_of,
    slopes_of,
    value_of,
)
from viscodesign.model.elements.local_form import LINEAR, LocalForm
from viscodesign.native.algebraic_part import AlgebraicPart
from viscodesign.native.code_cache import written_by
from viscodesign.native.derivatives import Differentiable
from viscodesign.native.kernels import LANES, CompiledKernels, Wanted, compile_if_missing
from viscodesign.native.sparse_lu import SparseLU
from viscodesign.native.tables import Assembly, ElementTable, SourceTable
from viscodesign.native.tape import OperationTape, tape_of
from viscodesign.storage.cached_property import cached_property
from viscodesign.storage.lru_cache import LruCache

MIN_IN_LANES = 3
"""Elements of a kind from which it pays to treat several at once."""


@dataclass(frozen=True)
class KindTable:
    """All elements of one kind in groups of lanes."""

    kernels: tuple[int, ...] | None
    """Addresses of those that give values and slopes; None for what is linear."""
    variables: np.ndarray
    """int32 (groups, v, lanes) places among the variables."""
    numbers: np.ndarray
    """(groups, m, lanes) places among the numbers of the scene."""
    rows: np.ndarray
    """int32 (groups, r, lanes) equations, or drives."""
    entries: np.ndarray
    """int32 (groups, z, lanes) places among the values of the Jacobian."""

    def element_table(self) -> ElementTable:
        """The same with room for numbers, as a table of terms."""
        value, slopes = self.kernels or (None, None)
        room = np.zeros(self.numbers.shape)
        return ElementTable(value, slopes, self.variables, room, self.rows, self.entries)

    def source_table(self) -> SourceTable:
        """The same as a table of inputs."""
        assert self.kernels is not None, "an input has a kernel, even if it is linear"
        value, rate = self.kernels
        return SourceTable(value, rate, self.variables, np.zeros(self.numbers.shape), self.rows)


class CompiledForm:
    """One structure in native code; serves all its scenes, in any thread.

    Raises `NativeUnavailable` where there is no native code.
    """

    def __init__(self, form: LocalForm) -> None:
        self.form = form
        self._code = _kernels([*form.kinds, *form.sources], _functions, 2)
        kernels, of_sources = self._code[: len(form.kinds)], self._code[len(form.kinds) :]
        patterns = [
            _places(kind, _pattern(code)) for kind, code in zip(form.kinds, kernels, strict=True)
        ]
        rows = np.concatenate([own[0].ravel() for own in patterns] or [np.zeros(0, np.int64)])
        columns = np.concatenate([own[1].ravel() for own in patterns] or [np.zeros(0, np.int64)])
        size, moving = form.size, form.size + form.drives
        own, driven = columns < size, (columns >= size) & (columns < moving)
        self.rows, self.columns, place = _distinct(rows[own], columns[own], size)
        self.drive_rows, drive_columns, drive_place = _distinct(
            rows[driven], columns[driven], moving
        )
        self.drive_columns = drive_columns - size
        entries = np.full(len(rows), len(self.rows))
        entries[own] = place
        entries[driven] = len(self.rows) + 1 + drive_place
        ends = np.cumsum([own[0].size for own in patterns])
        split = np.split(entries, ends[:-1]) if patterns else []
        shaped = [e.reshape(own[0].shape) for e, own in zip(split, patterns, strict=True)]
        self._tables = self._tabulated(form.kinds, kernels, shaped, size, len(self.rows))
        drives = [np.array(kind.rows, dtype=np.int64) for kind in form.sources]
        self._sources = self._tabulated(form.sources, of_sources, drives, form.drives, form.drives)
        self.lu = SparseLU(size, self.rows, self.columns, weak=form.balances.weak)
        self._blank = self._assembled()

    @cached_property
    def differentiable(self) -> Differentiable:
        """What derivatives of its marches need; their kernels are compiled when first asked for."""
        derived = _kernels([*self.form.kinds, *self.form.sources], _derived, 4)
        self._code += derived
        return Differentiable(
            lu=self.lu,
            mass=self.form.balances.mass,
            rows=self.rows.astype(np.int32),
            columns=self.columns.astype(np.int32),
            algebraic=self.algebraic,
            kernels=np.array([a for c in derived if c for a in _addresses(c)], dtype=np.int64),
        )

    @cached_property
    def algebraic(self) -> AlgebraicPart:
        """The equations without rates."""
        return AlgebraicPart(self.form.balances.mass, self.rows, self.columns)

    def _tabulated(
        self,
        kinds: Sequence[Elements],
        kernels: Sequence[CompiledKernels | None],
        entries: Sequence[np.ndarray],
        spare_row: int,
        spare_entry: int,
    ) -> list[KindTable]:
        """Tables of some kinds around their kernels."""
        given = zip(kinds, kernels, entries, map(_lanes, kinds), strict=True)
        return [
            KindTable(
                None if code is None else _addresses(code),
                _in_lanes(np.array(kind.variables), width).astype(np.int32),
                _in_lanes(np.array(kind.numbers, dtype=np.int64), width),
                _in_lanes(np.array(kind.rows), width, spare_row).astype(np.int32),
                _in_lanes(own, width, spare_entry).astype(np.int32),
            )
            for kind, code, own, width in given
        ]

    def _assembled(self) -> Assembly:
        """The elements without the numbers of any scene."""
        return Assembly(
            [table.element_table() for table in self._tables],
            [table.source_table() for table in self._sources],
            unknowns=self.form.size,
            drives=self.form.drives,
            entries=len(self.rows),
            drive_rows=self.drive_rows,
            drive_columns=self.drive_columns,
        )

    def bound(self, parameters: np.ndarray) -> Assembly:
        """The elements with the numbers of a scene; owned by one user at a time."""
        assembly = self._blank.copy()
        assembly.all_numbers[:] = self.numbers_of(parameters[None])[0]
        return assembly

    def numbers_of(self, parameters: np.ndarray) -> np.ndarray:
        """The numbers of the assembly (m, nn) for the parameters of m scenes (m, p)."""
        if self._tape is None:
            found = np.array([np.array(self.form.numbers(row)).ravel() for row in parameters])
        else:
            (found,) = self._tape([parameters], len(parameters))
        return np.take(found, self.places_of_numbers, axis=1)

    @cached_property
    def _tape(self) -> OperationTape | None:
        """The formulas of all numbers."""
        return tape_of(self.form.numbers)

    @cached_property
    def places_of_numbers(self) -> np.ndarray:
        """Which of the numbers of `LocalForm` each of the assembly's is (nn,)."""
        own = [table.numbers.ravel() for table in (*self._tables, *self._sources)]
        return np.concatenate([np.zeros(0, dtype=np.int64), *own])


def _kernels(
    kinds: Sequence[Elements],
    functions_of: Callable[[Elements], Sequence[ca.Function]],
    count: int,
) -> list[CompiledKernels | None]:
    """``count`` kernels of every kind that is not linear, compiled once for all structures."""
    called = [kind for kind in kinds if kind.law != LINEAR or kind.is_source]
    writer = written_by(kinds_module)
    wanted = [
        Wanted(
            (writer, f"{count} kernels each", f"{kind.law} {kind.is_source} {kind.time}"),
            count,
            _lanes(kind),
            partial(functions_of, kind),
            partial(_pattern_bytes, kind),
        )
        for kind in called
    ]
    found = compile_if_missing(wanted)
    for kernels in found:
        _recent.keep(id(kernels), kernels)
    made = iter(found)
    return [next(made) if kind.law != LINEAR or kind.is_source else None for kind in kinds]


_recent: LruCache[CompiledKernels] = LruCache(MAX_KINDS)
"""Those of other structures stay loaded for the next one."""


def _addresses(code: CompiledKernels) -> tuple[int, ...]:
    return tuple(code.address(k) for k in range(len(code)))


def _functions(kind: Elements) -> tuple[ca.Function, ca.Function]:
    """Values and slopes of an element, or values and rates of a source."""
    second = rate_of(kind.law, kind.time) if kind.is_source else slopes_of(kind.law).function
    return value_of(kind.law), second


def _derived(kind: Elements) -> tuple[ca.Function, ...]:
    """In the order of `Differentiable.kernels`."""
    value, second = _functions(kind)
    return pull_of(value), pull_of(second), push_of(value), push_of(second)


def _lanes(kind: Elements) -> int:
    """How many elements of a kind are treated at once."""
    return LANES if len(kind.rows) >= MIN_IN_LANES else 1


def _pattern_bytes(kind: Elements) -> bytes:
    """Kept beside the kernels: finding it means to differentiate the law."""
    return b"" if kind.is_source else slopes_of(kind.law).pattern.tobytes()


def _pattern(code: CompiledKernels | None) -> np.ndarray:
    """Result and variable of every entry of a kind's Jacobian (2, z)."""
    if code is None:
        return np.zeros((2, 1), dtype=np.int64)
    return np.frombuffer(code.told, dtype=np.int64).reshape(2, -1)


def _places(kind: Elements, pattern: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Equation and variable of every entry of every element's Jacobian (e, z)."""
    return np.array(kind.rows)[:, pattern[0]], np.array(kind.variables)[:, pattern[1]]


def _distinct(
    rows: np.ndarray, columns: np.ndarray, width: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Different places of a matrix: rows, columns, and which of them each given one is."""
    keys, place = np.unique(rows * np.int64(width) + columns, return_inverse=True)
    return keys // width, keys % width, place


def _in_lanes(values: np.ndarray, lanes: int, spare: int | None = None) -> np.ndarray:
    """(e, k) -> (groups, k, lanes), filled up with ``spare``, or with the last element."""
    count, width = values.shape
    missing = -count % lanes
    last = values[-1:] if spare is None else np.full((1, width), spare, dtype=values.dtype)
    padded = np.concatenate([values, np.repeat(last, missing, axis=0)])
    groups = len(padded) // lanes
    grouped = padded.reshape(groups, lanes, width).transpose(0, 2, 1)
    return np.ascontiguousarray(grouped)
