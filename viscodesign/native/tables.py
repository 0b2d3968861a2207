"""Elements of a scene as index arrays around kernels, and their sums.

All unknowns and inputs of the elements stand in one array

    Y = [unknowns (n) | drives (nd) | time | rest],

where ``rest`` are coefficients of the inputs and constants: whatever does not change within a
smooth stretch of the inputs.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

Kernel = int | Callable[[np.ndarray, np.ndarray, np.ndarray], None]
"""An address of machine code, or (local, numbers, out) in Python for the loops in Python.

Arrays of the latter are flat, laid out (entry, lane).
"""


@dataclass(frozen=True)
class ElementTable:
    """All elements of one kind, in groups of W lanes.

    The last group is padded with copies of an element whose rows and entries are the spare ones.
    """

    residual: Kernel
    """(local (nl, W), numbers (np, W)) -> values (nr, W)."""
    jacobian: Kernel
    """The same arguments -> derivatives (nz, W)."""
    idx: np.ndarray
    """int32 (groups, nl, W): places of the local values in Y."""
    numbers: np.ndarray
    """float64 (groups, np, W)."""
    rows: np.ndarray
    """int32 (groups, nr, W): rows that the values add to; n is the spare one."""
    pos: np.ndarray
    """int32 (groups, nz, W): entries that the derivatives add to; nnz is the spare one.

    Entries nnz+1.. are the derivatives by drives (`Assembly.drive_rows`, `drive_columns`).
    """


@dataclass(frozen=True)
class SourceTable:
    """Inputs of one kind: kernels that set drives from time and coefficients."""

    value: Kernel
    """(local (nl, W), numbers (np, W)) -> drives (nr, W)."""
    rate: Kernel
    """The same arguments -> their derivatives by time (nr, W) [1/s]."""
    idx: np.ndarray
    """int32 (groups, nl, W): places of the local values in Y, such as time n + nd."""
    numbers: np.ndarray
    """float64 (groups, np, W)."""
    places: np.ndarray
    """int32 (groups, nr, W): drives that are set; nd is the spare one."""


class Assembly:
    """Sums over all elements: the residual r (n,) and its Jacobian.

    ``unknowns`` n, ``drives`` nd, ``entries`` nnz of the Jacobian (duplicates merged, any order);
    ``drive_rows``, ``drive_columns`` (ndr,): where the derivatives by drives belong.
    """

    def __init__(
        self,
        elements: Sequence[ElementTable],
        sources: Sequence[SourceTable],
        unknowns: int,
        drives: int,
        entries: int,
        drive_rows: np.ndarray | None = None,
        drive_columns: np.ndarray | None = None,
    ) -> None:
        raise NotImplementedError

    def numbers(self, k: int) -> np.ndarray:
        """Numbers (groups, np, W) of element table k, to be read or written between calls."""
        raise NotImplementedError

    def drive(self, Y: np.ndarray) -> np.ndarray:
        """Set the drives in Y from its time and coefficients; returns their rates (nd,) [1/s]."""
        raise NotImplementedError

    def residual(self, Y: np.ndarray) -> np.ndarray:
        """r (n,) at Y, whose drives are set."""
        raise NotImplementedError

    def jacobian(self, Y: np.ndarray) -> np.ndarray:
        """Values (nnz + 1 + ndr,): dr/dunknowns, the spare entry, dr/ddrives."""
        raise NotImplementedError
