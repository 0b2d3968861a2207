"""One structure with other numbers in every row: its sums, and its marches side by side."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.native.loops import DTYPES
from viscodesign.native.march import METHOD, MarchSettings, MarchStatus, work_size
from viscodesign.native.source.rows import CLOCK, COUNTS
from viscodesign.native.source.steps import SIZE, STEPS
from viscodesign.native.sparse_lu import SparseLU
from viscodesign.native.tables import Assembly


def sums_of_rows(
    assembly: Assembly, numbers: np.ndarray, Y: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Jacobians (m, nnz + 1 + ndr) and residuals (m, n) at Y (m, length), whose drives are set.

    ``numbers`` (m, nn): of the assembly, row by row.
    """
    count, n = len(Y), assembly.unknowns
    _check(assembly, numbers, Y)
    J = np.empty((count, assembly.entries + 1 + len(assembly.drive_rows)))
    r = np.empty((count, n + 1))
    assembly.loops(
        "sums_of_rows",
        *(assembly.layout, assembly.kernels, assembly.idx, assembly.rows, assembly.pos),
        *(count, numbers.shape[1], numbers.reshape(-1), Y.shape[1], Y.reshape(-1)),
        *(J.reshape(-1), r.reshape(-1), *assembly.scratch()),
    )
    return J, r[:, :n]


@dataclass(frozen=True)
class RowMarches:
    """How the marches of m rows over one stretch each ended."""

    y: np.ndarray
    """(m, n): unknowns at the end."""
    sizes: np.ndarray
    """(m,): first step that suits what follows [s]."""
    steps: np.ndarray
    """(m,): steps taken."""
    finished: np.ndarray
    """(m,): whether the last edge was reached; of others nothing counts."""
    outputs: list[np.ndarray]
    """(edges, n) of each row."""


def march_rows(
    assembly: Assembly,
    lu: SparseLU,
    mass: np.ndarray,
    numbers: np.ndarray,
    Y: np.ndarray,
    settings: Sequence[MarchSettings],
    sizes: np.ndarray,
    edges: Sequence[np.ndarray],
    max_steps: int,
) -> RowMarches:
    """Marches from Y (m, length), each with its own numbers (m, nn) and edges.

    Those of `march` in every digit. ``sizes`` (m,): of the first steps [s]; the powers of all
    settings are those of the first.
    """
    count, n = len(Y), assembly.unknowns
    _check(assembly, numbers, Y)
    if (lu.size, lu.entries, len(mass)) != (n, assembly.entries, n):
        raise ValueError("assembly, LU and masses are not of one system")
    ends = np.cumsum([0, *map(len, edges)]).astype(DTYPES["counts"])
    y, powers = Y[:, :n].copy(), settings[0].powers
    state = np.ones((count, CLOCK))
    state[:, 0], state[:, SIZE] = Y[:, n + assembly.drives], sizes
    counts, status = (np.zeros(shape, DTYPES["counts"]) for shape in ((count, COUNTS), count))
    outputs = np.empty((ends[-1], n))
    given = np.array([own.row for own in settings])
    assembly.loops(
        "march_rows",
        *(lu.layout_of(assembly.layout), assembly.kernels, assembly.idx, assembly.rows),
        *(lu.entries_of(assembly.pos), assembly.drive_rows, assembly.drive_columns),
        *(lu.blocks, lu.own, lu.slots, lu.lu_start, lu.lu_columns, lu.diagonal),
        *(mass, len(powers), powers, METHOD),
        *(count, numbers.shape[1], numbers.reshape(-1), Y.shape[1], Y.flatten()),
        *(y.reshape(-1), given.reshape(-1), ends, np.concatenate(edges), max_steps),
        *(state.reshape(-1), counts.reshape(-1), outputs.reshape(-1), status),
        np.empty(work_size(assembly, lu)),
    )
    return RowMarches(
        y=y,
        sizes=state[:, SIZE],
        steps=counts[:, STEPS],
        finished=status == MarchStatus.FINISHED,
        outputs=np.split(outputs, ends[1:-1]),
    )


def _check(assembly: Assembly, numbers: np.ndarray, Y: np.ndarray) -> None:
    """Raise `ValueError` where sizes do not fit: native code would not notice."""
    length = max(assembly.reach, assembly.unknowns + assembly.drives + 1)
    if Y.ndim != 2 or Y.shape[1] < length:
        raise ValueError(f"Y is too short: {Y.shape}, needs {length}")
    if numbers.shape != (len(Y), len(assembly.all_numbers)):
        raise ValueError(f"numbers of shape {numbers.shape} do not belong to the assembly")
