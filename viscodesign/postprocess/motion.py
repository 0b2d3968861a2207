"""A solution as a motion in SI units, with its balances."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.postprocess.conservation import Ledger
from viscodesign.postprocess.inlet_supply import DeliveredVolume, contents
from viscodesign.postprocess.outputs import Outputs, read_outputs
from viscodesign.postprocess.solved_edges import SolvedEdges
from viscodesign.postprocess.terminations import first_termination
from viscodesign.results.motion_arrays import MotionArrays
from viscodesign.results.trajectory import Invariants
from viscodesign.solve.problem import Problem
from viscodesign.solve.transient import Solution
from viscodesign.storage.cached_property import cached_property
from viscodesign.storage.deferred_arrays import DeferredArrays
from viscodesign.storage.disk_arrays import ArrayStore, GrowingArray, NoRoomError, blocks

MAX_WAITING = 500_000
"""Numbers of outputs that wait in memory until shapes or balances are asked for."""
KEPT_OUTPUTS = ("inlet_pressure", "pressure", "volume", "junction_pressure")
"""Outputs that become part of a motion unchanged."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Motion(MotionArrays):
    """A solution as arrays, with its balances and the failure that ended it, if any."""

    balances: Callable[[], Invariants]
    """Sums them; of a coarser solution nobody asks for them."""
    failure: SolveError | None
    between: Mapping[str, np.ndarray]
    """All but shapes at all times that were solved for: outputs, corners, samples between them.
    None where these are the outputs."""

    def at_solved_times(self) -> Motion:
        """The motion as just these quantities, at these times."""
        return replace(self, arrays=self.between) if self.between else self

    @cached_property
    def invariants(self) -> Invariants:
        """Errors of the balances."""
        return self.balances()

    def largest_displacement(self, lengths: Sequence[float]) -> float:
        """Largest distance of a tip from that of the straight rod of its length [m]."""
        each = (self.tips(rows) for rows in blocks(len(self.tip), self.tip))
        return max(float(np.max(np.hypot(t[..., 0], t[..., 1] - lengths))) for t in each)


def read_motion(
    problem: Problem, solution: Solution, store: ArrayStore | None = None, shape_every: int = 1
) -> Motion:
    """Evaluate every output and balance of a solution, block by block.

    A section compressed to zero length ends the motion just before, with its name; so does a
    full disk. ``store``: storage for the arrays; ``shape_every``: outputs from one whole
    shape to the next.
    """
    reader = _MotionReader(problem, solution, store or ArrayStore(), shape_every)
    for outputs in read_outputs(problem, solution):
        reader.take(outputs)
        if reader.is_over:
            break
    if not reader.end and reader.failure is not None:
        raise reader.failure
    return reader.motion()


class _MotionReader:
    """Tables of a motion that grow block by block, until something ends it."""

    def __init__(
        self, problem: Problem, solution: Solution, store: ArrayStore, shape_every: int
    ) -> None:
        self.failure: SolveError | None = None
        self.is_over = False
        self.end = 0
        """Number of edges of the schedule that have a meaning."""
        self.count = 0
        """Outputs among them."""
        self._problem, self._solution = problem, solution
        self._store, self._every = store, shape_every
        self._ledger = Ledger(problem)
        self._delivered = DeliveredVolume(problem)
        self._tables: dict[str, GrowingArray] = {}
        self._between: dict[str, GrowingArray] = {}
        self._last_shape: np.ndarray | None = None
        self._arc = np.zeros(0)
        """Arc length of the points of a shape (K,) [m]."""
        self._rest: Callable[[], None] | None = None
        """What waits until it is asked for."""

    def take(self, outputs: Outputs) -> None:
        """Add a block, up to the end of the motion."""
        stretch, turn = outputs.section_strains()
        is_last = outputs.end == self._solution.reached
        end, failure = first_termination(
            self._problem,
            outputs.time,
            outputs.values,
            stretch,
            self._solution.failure if is_last else None,
        )
        end = min(outputs.first + end, outputs.end)
        # What ends the motion in the margin is found again by the block that owns those edges.
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
        every = {
            **_quantities(outputs),
            **_contacts(outputs),
            "inflow": self._delivered.along(outputs, self._solution),
            "section_stretch": stretch,
            "section_turn": turn,
        }
        if self._problem.body.members:
            every["content"] = contents(outputs)
        self._append_rows(self._tables, outputs, every, keep)
        if len(schedule.edges) > len(schedule.outputs):
            solved = np.arange(*outputs.rows_to(end).indices(len(outputs.time)))
            self._append_rows(self._between, outputs, every, solved)
        self._arc = outputs.arc()
        due = (np.arange(self.count, stop) % self._every) == 0
        self.count = stop
        if self._is_whole(outputs):
            self._rest = lambda: self._add_rest(outputs, end, keep, due)
        else:
            self._add_rest(outputs, end, keep, due)

    def _add_rest(self, outputs: Outputs, end: int, keep: np.ndarray, due: np.ndarray) -> None:
        """Shapes and balances, which take longest and of a coarser solution are not looked at."""
        shape = outputs.shapes(keep)
        self._append(self._tables, "shape", shape[due])
        if end > outputs.begin:
            self._ledger.add(self._block(outputs, end))
        if len(keep):
            self._last_shape = None if due[-1] else shape[-1:]

    def _append_rows(
        self,
        tables: dict[str, GrowingArray],
        outputs: Outputs,
        every: Mapping[str, np.ndarray],
        rows: np.ndarray,
    ) -> None:
        """Add some rows (T,) of quantities at every edge of a block, and the tips there."""
        for name, values in every.items():
            self._append(tables, name, values[rows])
        self._append(tables, "tip", outputs.tips(rows))

    def _append(self, tables: dict[str, GrowingArray], name: str, values: np.ndarray) -> None:
        if name not in tables:
            tables[name] = self._store.growing_array(*values.shape[1:])
        tables[name].append(values)

    def _is_whole(self, outputs: Outputs) -> bool:
        """Whether a block is all of a short run, and can wait in memory."""
        is_all = outputs.begin == 0 and outputs.end == self._solution.reached
        return is_all and sum(v.size for v in outputs.values.values()) <= MAX_WAITING

    def _block(self, outputs: Outputs, end: int) -> SolvedEdges:
        """A block's own edges up to ``end``, for the balances."""
        own, edges, found = outputs.rows_to(end), slice(outputs.begin, end), self._solution
        return SolvedEdges(
            outputs.begin,
            found.states[:, edges],
            found.algebraics[:, edges],
            found.integrals[:, edges],
            {name: values[own] for name, values in outputs.values.items()},
        )

    def _cut(self) -> int:
        """Cut back to the last row with a whole shape, before a block that found no room.

        Returns the number of edges up to that block.
        """
        shapes = -(-self.count // self._every)
        self.count = (shapes - 1) * self._every + 1
        for name, table in self._tables.items():
            table.cut(shapes if name == "shape" else self.count)
        for table in self._between.values():
            table.cut(self.end)
        self._last_shape = None
        return self.end

    def motion(self) -> Motion:
        """The motion as read so far."""
        arrays = {name: table.array() for name, table in self._tables.items() if name != "shape"}
        found = Motion(
            arrays=DeferredArrays(arrays, "shape", self._shapes),
            arc=self._arc,
            shape_every=self._every,
            balances=self._invariants,
            failure=self.failure,
            between={name: table.array() for name, table in self._between.items()},
        )
        if self._rest is None:  # nothing of the solution is to stay in memory
            invariants = found.invariants
            found = replace(found, arrays=dict(found.arrays), balances=lambda: invariants)
        return found

    def _finish(self) -> None:
        """Do what has waited."""
        rest, self._rest = self._rest, None
        if rest is not None:
            rest()

    def _shapes(self) -> np.ndarray:
        self._finish()
        if self._last_shape is not None:
            self._tables["shape"].append(self._last_shape)
            self._last_shape = None
        return self._tables["shape"].array()

    def _invariants(self) -> Invariants:
        self._finish()
        return self._ledger.invariants(self._solution.work.steps)


def _contacts(outputs: Outputs) -> dict[str, np.ndarray]:
    """Forces [N] and gaps [m] of the points that may touch something (n, c)."""
    normal, tangential = np.split(outputs["contact_force"], 2, axis=1)
    gap, _ = np.split(outputs["contact_path"], 2, axis=1)
    return {"contact_normal": normal, "contact_tangential": tangential, "contact_gap": gap}


def _quantities(outputs: Outputs) -> dict[str, np.ndarray]:
    """Quantities of the motion at every edge (n,) of the outputs."""
    kept = {name: outputs[name] for name in KEPT_OUTPUTS}
    return {"time": outputs.time, "flow": outputs.flows(), **kept}
