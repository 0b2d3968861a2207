"""Steps of Rodas5P over one smooth stretch of the inputs, in native code."""

from __future__ import annotations

from dataclasses import field
from enum import IntEnum

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.native import rodas
from viscodesign.native.loops import DTYPES
from viscodesign.native.source.steps import RECORD_HEAD, RECORDED, STAGES
from viscodesign.native.sparse_lu import SparseLU
from viscodesign.native.tables import Assembly


def _square(rows: tuple[tuple[float, ...], ...]) -> np.ndarray:
    """Rows of growing length as one square, row by row."""
    return np.concatenate([[*row, *[0.0] * (rodas.STAGES - len(row))] for row in rows])


METHOD = np.concatenate([
    _square(rodas.A), _square(rodas.C), rodas.NODES, rodas.SLOPES, rodas.DENSE.ravel(),
    [rodas.GAMMA, rodas.ORDER],
])  # fmt: skip
"""Coefficients in the order that `source.steps` expects."""


class MarchStatus(IntEnum):
    """How a march ended."""

    FINISHED = 0
    STEP_LIMIT = 1
    """All steps allowed were taken; the same call again continues."""
    STEP_TOO_SMALL = 2


@dataclass(frozen=True)
class MarchSettings:
    """Numbers that steer the steps."""

    tolerance: float
    motion_time: float
    """An error of a rate counts by (h/motion_time)^power [s]."""
    powers: np.ndarray
    """(unknowns without integrals,): power of each; infinite: not tested."""
    largest: float
    """Largest step [s]."""
    smallest: float
    """Smallest step [s]; below it the march ends."""
    safety: float = 0.9
    max_factor: float = 5.0
    min_factor: float = 0.2
    memory: float = 0.08

    @property
    def row(self) -> np.ndarray:
        """In the order that `source.steps` expects."""
        return np.array([
            self.tolerance, self.motion_time, self.largest, self.smallest,
            self.safety, self.max_factor, self.min_factor, self.memory,
        ])  # fmt: skip


@dataclass
class MarchState:
    """Where a march is; it is moved on in place."""

    y: np.ndarray
    """(n,): unknowns, then integrals, whose rows have mass 1 and of which nothing depends."""
    time: float
    size: float
    """Size of the next step [s]."""
    before: float = 1.0
    """Error of the step before, over what is allowed; 1 at the start of a stretch."""
    edge: int = 0
    """Edges passed so far."""
    steps: int = 0
    rejected: int = 0
    residuals: int = 0
    jacobians: int = 0


@dataclass
class StepRecord:
    """Steps that were taken, one row each: begin, size and end [s], unknowns at the beginning.

    For derivatives also the stages: they need not be solved for again.
    """

    chunk: int = 256
    """Steps for which there is room in one call of a march."""
    chunks: list[np.ndarray] = field(default_factory=list)
    has_stages: bool = False

    @property
    def rows(self) -> np.ndarray:
        """All of them (steps, RECORD_HEAD + n), or longer by STAGES n."""
        return self.chunks[0] if len(self.chunks) == 1 else np.concatenate(self.chunks)

    def room(self, unknowns: int) -> np.ndarray:
        """Room for the next ones."""
        return np.empty((self.chunk, RECORD_HEAD + unknowns * (1 + STAGES * self.has_stages)))


def march(
    assembly: Assembly,
    lu: SparseLU,
    mass: np.ndarray,
    rest: np.ndarray,
    state: MarchState,
    edges: np.ndarray,
    settings: MarchSettings,
    max_steps: int,
    record: StepRecord | None = None,
) -> tuple[MarchStatus, np.ndarray]:
    """March from state.time to edges[-1]; returns unknowns (m, n) at the edges that it passed.

    ``mass`` (n,): 0 for algebraic rows; ``rest``: coefficients of the inputs and constants, the
    end of Y; ``edges`` (ne,): rising times after the start [s], the last one ends the stretch;
    ``max_steps``: tried in this call, accepted or not. Edges before state.edge were passed by an
    earlier call. Steps are those of `rodas`, with dense output at edges within them. ``record``: to
    be added to; a call that fills its room ends like one that took all its steps.
    """
    n = assembly.unknowns
    Y = np.concatenate([np.zeros(n + assembly.drives + 1), rest])
    _check(assembly, lu, mass, state, edges, settings, Y)
    clock = np.array([state.time, state.size, state.before])
    counts = np.array(
        [state.edge, state.steps, state.rejected, state.residuals, state.jacobians, 0],
        dtype=DTYPES["counts"],
    )
    y = np.array(state.y, dtype=float)
    outputs = np.empty((len(edges) - state.edge, n))
    layout = lu.layout_of(assembly.layout)
    room = np.empty((0, 0)) if record is None else record.room(n)
    status = assembly.loops(
        "march",
        *(layout, assembly.kernels, assembly.idx, assembly.rows, lu.entries_of(assembly.pos)),
        *(assembly.all_numbers, assembly.drive_rows, assembly.drive_columns),
        *(lu.blocks, lu.own, lu.slots, lu.lu_start, lu.lu_columns, lu.diagonal),
        *(mass, len(settings.powers), settings.powers, METHOD, settings.row, edges, len(edges)),
        *(max_steps, y, Y, clock, counts, outputs.reshape(-1)),
        *(-1 if record is None else record.chunk, room.shape[1], room.reshape(-1)),
        np.empty(work_size(assembly, lu)),
    )
    if record is not None:
        record.chunks.append(room[: counts[RECORDED]])
    passed = int(counts[0]) - state.edge
    state.y = y
    state.time, state.size, state.before = clock.tolist()
    state.edge, state.steps, state.rejected, state.residuals, state.jacobians, _ = counts.tolist()
    return MarchStatus(status), outputs[:passed]


def work_size(assembly: Assembly, lu: SparseLU) -> int:
    """Numbers that a march works with."""
    drives = assembly.drives + len(assembly.drive_rows)
    kernels = 2 * assembly.width
    return 12 * assembly.unknowns + 1 + 6 * lu.blocks + 2 * lu.count + 2 + drives + kernels


def _check(
    assembly: Assembly,
    lu: SparseLU,
    mass: np.ndarray,
    state: MarchState,
    edges: np.ndarray,
    settings: MarchSettings,
    Y: np.ndarray,
) -> None:
    """Raise `ValueError` where sizes do not fit: native code would not notice."""
    n = assembly.unknowns
    fits = (lu.size, lu.entries, len(mass), len(state.y)) == (n, assembly.entries, n, n)
    if not fits or len(settings.powers) > n or len(Y) < assembly.reach:
        raise ValueError("assembly, LU, masses, unknowns and inputs do not belong together")
    if not 0 <= state.edge < len(edges):
        raise ValueError("all edges were passed before")
