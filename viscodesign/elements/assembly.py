"""Index arrays around the kernels of a structure, and the numbers of one scene in them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

import casadi as ca
import numpy as np

from viscodesign._version import __version__
from viscodesign.elements import kinds as kinds_module
from viscodesign.elements.kinds import (
    Elements,
    pull_of,
    push_of,
    rate_of,
    slopes_of,
    value_of,
)
from viscodesign.elements.local_form import LINEAR, LocalForm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.native.code_cache import cached, written_by
from viscodesign.native.derivatives import Differentiable
from viscodesign.native.kernels import LANES, CompiledKernels, compile_if_missing
from viscodesign.native.sparse_lu import SparseLU
from viscodesign.native.tables import Assembly, ElementTable, SourceTable
from viscodesign.storage.cached_property import cached_property

FEWEST_IN_LANES = 3
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
        patterns = [
            _places(kind, own) for kind, own in zip(form.kinds, _patterns(form.kinds), strict=True)
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
        self._code: list[CompiledKernels] = []
        ends = np.cumsum([own[0].size for own in patterns])
        split = np.split(entries, ends[:-1]) if patterns else []
        shaped = [e.reshape(own[0].shape) for e, own in zip(split, patterns, strict=True)]
        self._tables = self._compiled(
            form.kinds,
            _of_element,
            shaped,
            size,
            len(self.rows),
        )
        drives = [np.array(kind.rows, dtype=np.int64) for kind in form.sources]
        self._sources = self._compiled(
            form.sources,
            _of_source,
            drives,
            form.drives,
            form.drives,
        )
        self.lu = SparseLU(size, self.rows, self.columns, weak=form.balances.weak)
        self._blank = self._assembled()

    @cached_property
    def differentiable(self) -> Differentiable:
        """What derivatives of its marches need; their kernels are compiled when first asked for."""
        derived = [
            *self._addresses(self.form.kinds, _derived_of_element, 4, alone=True),
            *self._addresses(self.form.sources, _derived_of_source, 4, alone=True),
        ]
        kernels = [address for own in derived if own is not None for address in own]
        return Differentiable(
            lu=self.lu,
            mass=self.form.balances.mass,
            rows=self.rows.astype(np.int32),
            columns=self.columns.astype(np.int32),
            kernels=np.array(kernels, dtype=np.int64),
        )

    def _addresses(
        self,
        kinds: Sequence[Elements],
        functions_of: Callable[[Elements], Sequence[ca.Function]],
        count: int,
        *,
        alone: bool = False,
    ) -> list[tuple[int, ...] | None]:
        """Addresses of ``count`` kernels of every kind that is not linear.

        ``alone``: every kind is compiled by itself, once for all structures that have it; kinds
        compiled together are loaded faster.
        """
        lanes = _lanes(kinds)
        addresses: list[tuple[int, ...] | None] = [None] * len(kinds)
        called = [k for k, kind in enumerate(kinds) if kind.law != LINEAR or kind.is_source]
        together = [[k for k in called if lanes[k] == width] for width in sorted(set(lanes))]
        for chosen in [[k] for k in called] if alone else filter(None, together):
            laws = (f"{kinds[k].law} {kinds[k].time}" for k in chosen)
            key = (written_by(kinds_module), f"{count} kernels each", *laws)
            make = partial(_functions, [kinds[k] for k in chosen], functions_of)
            code = compile_if_missing(make, count * len(chosen), key, lanes[chosen[0]])
            self._code.append(code)
            for i, k in enumerate(chosen):
                addresses[k] = tuple(code.address(count * i + j) for j in range(count))
        return addresses

    def _compiled(
        self,
        kinds: Sequence[Elements],
        functions_of: Callable[[Elements], tuple[ca.Function, ca.Function]],
        entries: Sequence[np.ndarray],
        spare_row: int,
        spare_entry: int,
    ) -> list[KindTable]:
        """Tables of some kinds, compiled together for each number of lanes."""
        addresses = self._addresses(kinds, functions_of, 2)
        return [
            KindTable(
                addresses[k],
                _in_lanes(np.array(kind.variables), width).astype(np.int32),
                _in_lanes(np.array(kind.numbers, dtype=np.int64), width),
                _in_lanes(np.array(kind.rows), width, spare_row).astype(np.int32),
                _in_lanes(own, width, spare_entry).astype(np.int32),
            )
            for k, (kind, own, width) in enumerate(zip(kinds, entries, _lanes(kinds), strict=True))
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
        numbers = np.array(self.form.numbers(parameters)).ravel()
        assembly = self._blank.copy()
        assembly.all_numbers[:] = numbers[self.places_of_numbers]
        return assembly

    @cached_property
    def places_of_numbers(self) -> np.ndarray:
        """Which of the numbers of `LocalForm` each of the assembly's is (nn,)."""
        own = [table.numbers.ravel() for table in (*self._tables, *self._sources)]
        return np.concatenate([np.zeros(0, dtype=np.int64), *own])


def _of_element(kind: Elements) -> tuple[ca.Function, ca.Function]:
    return value_of(kind.law), slopes_of(kind.law).function


def _of_source(kind: Elements) -> tuple[ca.Function, ca.Function]:
    return value_of(kind.law), rate_of(kind.law, kind.time)


def _derived_of_element(kind: Elements) -> tuple[ca.Function, ...]:
    return _derived(*_of_element(kind))


def _derived_of_source(kind: Elements) -> tuple[ca.Function, ...]:
    return _derived(*_of_source(kind))


def _derived(value: ca.Function, second: ca.Function) -> tuple[ca.Function, ...]:
    """In the order of `Differentiable.kernels`."""
    return pull_of(value), pull_of(second), push_of(value), push_of(second)


def _lanes(kinds: Sequence[Elements]) -> list[int]:
    """How many elements of each kind are treated at once."""
    return [LANES if len(kind.rows) >= FEWEST_IN_LANES else 1 for kind in kinds]


def _functions(
    kinds: Sequence[Elements], functions_of: Callable[[Elements], Sequence[ca.Function]]
) -> list[ca.Function]:
    return [function for kind in kinds for function in functions_of(kind)]


def _patterns(kinds: Sequence[Elements]) -> list[np.ndarray]:
    """Result and variable of every entry of the kinds' Jacobians, each (2, z).

    Kept between processes: differentiating the laws for it takes longer than all the rest.
    """

    def make() -> bytes:
        found = [slopes_of(kind.law).pattern for kind in kinds]
        sizes = np.array([len(found), *(own.shape[1] for own in found)], dtype=np.int64)
        return b"".join(own.tobytes() for own in (sizes, *found))

    laws = (str(kind.law) for kind in kinds)
    writer = __version__, written_by(kinds_module), ca.CasadiMeta.version()
    stored = np.frombuffer(cached(("patterns", *writer, *laws), make), dtype=np.int64)
    count = int(stored[0])
    found, first = [], 1 + count
    for size in stored[1 : 1 + count].tolist():
        found.append(stored[first : first + 2 * size].reshape(2, -1))
        first += 2 * size
    return found


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
