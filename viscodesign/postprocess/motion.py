"""From scaled unknowns back to a motion in SI, with its balances."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.postprocess.conservation import Ledger, SolvedEdges
from viscodesign.postprocess.inlet_supply import Given
from viscodesign.postprocess.outputs import Outputs, read_outputs
from viscodesign.postprocess.terminations import first_ending
from viscodesign.results.motion_arrays import MotionArrays
from viscodesign.results.trajectory import Invariants
from viscodesign.solve.problem import Problem
from viscodesign.solve.transient import Solution
from viscodesign.storage.disk_arrays import ArrayStore, GrowingArray, NoRoomError

TOLD = ("inlet_pressure", "pressure", "volume", "junction_pressure")
"""Outputs that a motion keeps as they are."""


@dataclass(frozen=True, kw_only=True)
class Motion(MotionArrays):
    """What was solved, as arrays, with its balances and what ended it early."""

    invariants: Invariants
    failure: SolveError | None


def read_motion(
    problem: Problem, solution: Solution, store: ArrayStore | None = None, shape_every: int = 1
) -> Motion:
    """Evaluate every output and balance over what was solved, stretch by stretch.

    A section pressed to nothing ends the motion just before, with its name; so does a
    disk that has no more room. ``store``: for the arrays; ``shape_every``: outputs from
    one whole shape to the next.
    """
    reader = _Reader(problem, solution, store or ArrayStore(), shape_every)
    for outputs in read_outputs(problem, solution):
        reader.take(outputs)
        if reader.is_over:
            break
    if not reader.end and reader.failure is not None:
        raise reader.failure
    return reader.motion()


class _Reader:
    """Tables of a motion that grow stretch by stretch, until something ends it."""

    def __init__(
        self, problem: Problem, solution: Solution, store: ArrayStore, shape_every: int
    ) -> None:
        self.failure: SolveError | None = None
        self.is_over = False
        self.end = 0
        """Edges that have a meaning, from the first on."""
        self.count = 0
        """Outputs among them."""
        self._problem, self._solution = problem, solution
        self._store, self._every = store, shape_every
        self._ledger = Ledger(problem)
        self._given = Given(problem)
        self._tables: dict[str, GrowingArray] = {}
        self._last_shape: np.ndarray | None = None

    def take(self, outputs: Outputs) -> None:
        """Add what a stretch has up to the motion's end."""
        stretch, turn = outputs.section_strains()
        is_last = outputs.end == self._solution.reached
        end, failure = first_ending(
            self._problem,
            outputs.time,
            outputs.values,
            stretch,
            self._solution.failure if is_last else None,
        )
        end = min(outputs.first + end, outputs.end)
        # What ends the motion in the margin behind is found again by the stretch that owns it.
        self.is_over = is_last or end < outputs.end
        try:
            self._add(outputs, end, stretch, turn)
        except NoRoomError as error:
            end, failure = self._cut(), SolveError(str(error), quantity="room", where="disk")
            self.is_over = True
        self.end = end
        if self.is_over:
            self.failure = failure

    def _add(self, outputs: Outputs, end: int, stretch: np.ndarray, turn: np.ndarray) -> None:
        schedule = self._problem.schedule
        stop = int(np.searchsorted(schedule.outputs, end))
        keep = schedule.outputs[self.count : stop] - outputs.first
        due = (np.arange(self.count, stop) % self._every) == 0
        shape, angle = outputs.shapes(keep)
        rows = {
            **_quantities(outputs, keep),
            "tip": np.column_stack((shape[:, -1], angle)),
            "inflow": self._given.along(outputs, self._solution)[keep],
            "section_stretch": stretch[keep],
            "section_turn": turn[keep],
            "shape": shape[due],
        }
        for name, values in rows.items():
            if name not in self._tables:
                self._tables[name] = self._store.growing_array(*values.shape[1:])
            self._tables[name].append(values)
        if end > outputs.begin:
            self._ledger.add(self._block(outputs, end))
        if len(keep):
            self._last_shape = None if due[-1] else shape[-1:]
        self.count = stop

    def _block(self, outputs: Outputs, end: int) -> SolvedEdges:
        """A stretch's own edges up to ``end``, for the balances."""
        own, edges, found = outputs.rows_to(end), slice(outputs.begin, end), self._solution
        return SolvedEdges(
            outputs.begin,
            found.states[:, edges],
            found.algebraics[:, edges],
            found.integrals[:, edges],
            {name: values[own] for name, values in outputs.values.items()},
        )

    def _cut(self) -> int:
        """Back to the last row with a whole shape before a stretch that found no room.

        Returns the edges up to that stretch.
        """
        shapes = -(-self.count // self._every)
        self.count = (shapes - 1) * self._every + 1
        for name, table in self._tables.items():
            table.cut(shapes if name == "shape" else self.count)
        self._last_shape = None
        return self.end

    def motion(self) -> Motion:
        """All that was read."""
        if self._last_shape is not None:
            self._tables["shape"].append(self._last_shape)
        arrays = {name: table.array() for name, table in self._tables.items()}
        points = arrays["shape"].shape[1]
        return Motion(
            arrays=arrays,
            arc=np.linspace(0.0, self._problem.body.length, points),
            shape_every=self._every,
            invariants=self._ledger.invariants(self._solution.work.steps),
            failure=self.failure,
        )


def _quantities(outputs: Outputs, rows: np.ndarray) -> dict[str, np.ndarray]:
    """What the outputs hold of the motion at some of their rows (T,), by quantity."""
    return {
        "time": outputs.time[rows],
        "flow": outputs.flows()[rows],
        **{name: outputs[name][rows] for name in TOLD},
    }
