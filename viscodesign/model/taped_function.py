"""Functions of the equations that are called with numbers, as tapes of their operations."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.row_blocks import BLOCK_ROWS, evaluate_rows
from viscodesign.native.tape import OperationTape, tape_of
from viscodesign.native.unavailable import NativeUnavailable
from viscodesign.storage.cached_property import cached_property

Pattern = tuple[int, int, tuple[int, ...], tuple[int, ...]]
"""Rows, columns, where each column begins, and rows of the entries."""


@dataclass(frozen=True, eq=False)
class TapeWithPatterns:
    """A tape, and which entries of its results are not zero by structure."""

    tape: OperationTape
    patterns: tuple[Pattern, ...]

    @classmethod
    def of(cls, function: ca.Function) -> TapeWithPatterns | None:
        """That of a function; None where it has no tape."""
        tape = tape_of(function)
        found = [function.sparsity_out(k) for k in range(function.n_out())]
        patterns = ((*s.shape, tuple(s.colind()), tuple(s.row())) for s in found)
        return None if tape is None else cls(tape, tuple(patterns))


class TapedFunction:
    """A function with the same results from its tape as from CasADi.

    ``make``: gives it in CasADi's form, where there is no tape or no native code.
    """

    def __init__(self, taped: TapeWithPatterns | None, make: Callable[[], ca.Function]) -> None:
        self._taped = taped
        self._make = make

    @cached_property
    def casadi(self) -> ca.Function:
        """The same in CasADi's form."""
        return self._make()

    @cached_property
    def _mapped(self) -> ca.Function:
        return self.casadi.map(BLOCK_ROWS)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names of the results."""
        return self._taped.tape.names if self._taped else tuple(self.casadi.name_out())

    @cached_property
    def sizes(self) -> tuple[int, ...]:
        """Entries of the results that are not zero by structure."""
        return tuple(s.nnz() for s in self.sparsities)

    @cached_property
    def sparsities(self) -> tuple[ca.Sparsity, ...]:
        """Sparsities of the results."""
        if self._taped is None:
            return tuple(self.casadi.sparsity_out(k) for k in range(self.casadi.n_out()))
        return tuple(ca.Sparsity(*pattern) for pattern in self._taped.patterns)

    def __call__(self, *arguments: float | np.ndarray) -> list[ca.DM]:
        """Results for numbers."""
        if self._taped is not None:
            columns = [np.asarray(values, dtype=float).reshape(-1) for values in arguments]
            try:
                found = self._taped.tape(columns, 1)
            except NativeUnavailable:
                pass  # CasADi answers the same
            else:
                both = zip(self.sparsities, found, strict=True)
                return [ca.DM(sparsity, values[0]) for sparsity, values in both]
        return list(self.casadi.call([ca.DM(values) for values in arguments]))

    def rows(self, arguments: Sequence[np.ndarray], count: int) -> list[np.ndarray]:
        """Entries (m, size) of the results for arguments (m, n), or (n,) where equal for all."""
        if self._taped is not None:
            try:
                return self._taped.tape(arguments, count)
            except NativeUnavailable:
                pass  # CasADi answers the same
        whole = [np.broadcast_to(a, (count, a.shape[-1])) for a in arguments]
        return evaluate_rows(self._mapped, whole, self.sizes)
