"""Steps of Rodas5P in native code: small kernels for each kind of term, loops around them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from viscodesign.model.local_equations import LocalEquations
from viscodesign.native.machine import this_machine
from viscodesign.native.march import MarchSettings, MarchState, MarchStatus, StepRecord, march
from viscodesign.native.source.steps import RECORD_HEAD
from viscodesign.native.unavailable import NativeUnavailable
from viscodesign.solve.events import Crossing, EventWatch
from viscodesign.solve.problem import Problem, Schedule
from viscodesign.solve.solvers.base import Work
from viscodesign.solve.solvers.rodas_stretch import CONTROL, Reached, StretchSteps, largest_step
from viscodesign.solve.statics import Start


def has_native_code(problem: Problem) -> bool:
    """Whether `NativeSteps` can take a problem."""
    try:
        _local_equations(problem)
    except NativeUnavailable:
        return False
    return True


def _local_equations(problem: Problem) -> LocalEquations:
    """The equations that native code steps. Raises `NativeUnavailable` where there are none."""
    this_machine()  # code that was made before may have been switched off
    local = problem.equations.local
    if local is None:
        raise NativeUnavailable("the equations are not sums of local terms")
    return local


class NativeSteps(StretchSteps):
    """Steps of the equations as sums of local terms.

    Raises `NativeUnavailable` where there is no native code, or no such form of the equations.
    """

    def __init__(self, problem: Problem, tolerance: float) -> None:
        super().__init__(problem, tolerance)
        local = self._local = _local_equations(problem)
        self._compiled = local.compiled
        self.assembly = self._compiled.bound(problem.numbers())
        sums = local.sums
        self._powers = np.concatenate([self.powers(), np.full(sums, np.inf)])
        after = problem.unknowns + sums
        kept = np.ones(local.form.size, dtype=bool)
        kept[problem.unknowns : after] = False
        self._kept = np.flatnonzero(kept)

    def __call__(
        self,
        schedule: Schedule,
        y: np.ndarray,
        begin: int,
        end: int,
        size: float | None,
        work: Work,
    ) -> Reached:
        edges, piece = schedule.edges[begin : end + 1], schedule.pieces[begin]
        stretch = edges[-1] - edges[0]
        state = MarchState(
            y=self._with_sums(y, float(edges[0]), piece),
            time=float(edges[0]),
            size=self.first_size(size, stretch),
        )
        allowed = max(self.problem.max_steps - work.steps, 1)
        rest, first = np.append(piece, 1.0), float(edges[0])
        columns, crossing, progress = [], None, self.progress_watch(first)
        while True:
            record, tried = StepRecord(self.steps_at_once), 2 * self.steps_at_once
            tried = max(min(tried, allowed - state.steps), 1)
            status, found = self.march(state, rest, first, edges[1:], tried, record)
            columns.append(found[:, self._kept])
            crossing = self._crossing(record, state, piece)
            is_over = status is not MarchStatus.STEP_LIMIT or state.steps >= allowed
            crawl = progress.crawl(state.steps, state.time)
            if crossing is not None or is_over or crawl is not None or work.is_stopped():
                break
        work.native = True
        work.steps += state.steps
        work.residual_calls += state.residuals
        work.jacobian_calls += state.jacobians
        reached = Reached(np.concatenate(columns), None, "", state.time, crossing, crawl)
        if status is MarchStatus.STEP_TOO_SMALL:
            vanishing = EventWatch(self.problem).vanishing(state.time, piece, self._own(state.y))
            failure = "step size fell below its minimum"
            return replace(reached, failure=failure, cause=vanishing)
        if status is MarchStatus.FINISHED:
            return replace(reached, size=state.size, failure=None, cause=None)
        return reached

    def _crossing(
        self, record: StepRecord, state: MarchState, piece: np.ndarray
    ) -> Crossing | None:
        """The first event in the steps of a record and at their end."""
        if self.watch is None:
            return None
        rows = record.rows
        time = np.append(rows[:, 0], state.time)
        unknowns = np.vstack([rows[:, RECORD_HEAD:], state.y])
        return self.watch.crossing(time, piece, self._own(unknowns))

    def _own(self, y: np.ndarray) -> np.ndarray:
        """States and algebraic unknowns (..., nx + nz), integrals behind them."""
        return np.asarray(y[..., self._kept])

    def corrected(self, here: Start, time: float, piece: np.ndarray) -> Start | None:
        assembly, problem = self.assembly, self.problem
        y = self.unknowns_at(here, time, piece)
        Y = np.concatenate([y, np.zeros(assembly.drives), [time], piece, [1.0]])
        assembly.drive(Y)
        found = self._compiled.algebraic.corrected(assembly, Y)
        if found is None:
            return None
        return Start(here.states, found[problem.equations.states.count : problem.unknowns])

    def march(
        self,
        state: MarchState,
        rest: np.ndarray,
        begin: float,
        edges: np.ndarray,
        max_steps: int,
        record: StepRecord | None = None,
    ) -> tuple[MarchStatus, np.ndarray]:
        """Steps over the stretch from ``begin`` to the last of its edges; see `native.march`."""
        equations, stretch = self.problem.equations, float(edges[-1]) - begin
        scales = equations.motion_time, equations.swing_time
        settings = self.settings(*scales, stretch, float(self.problem.schedule.edges[-1]))
        mass = self._local.form.balances.mass
        given = (self.assembly, self._compiled.lu, mass, rest, state, edges, settings)
        return march(*given, max_steps, record)

    def settings(
        self, motion_time: float, swing_time: float, stretch: float, end: float
    ) -> MarchSettings:
        """What steers the steps over a stretch of a length in a run up to ``end`` [s]."""
        return MarchSettings(
            tolerance=self.tolerance,
            motion_time=motion_time,
            powers=self._powers,
            largest=largest_step(swing_time, stretch, is_line=self.problem.has_straight_inputs),
            smallest=CONTROL.min_step * end,
            safety=CONTROL.safety,
            max_factor=CONTROL.max_factor,
            min_factor=CONTROL.min_factor,
            memory=CONTROL.memory,
        )

    def unknowns_at(self, start: Start, time: float, piece: np.ndarray) -> np.ndarray:
        """Unknowns of the native equations (n,), integrals zero."""
        integrals = np.zeros(self.problem.equations.integrals)
        y = np.concatenate([start.states, start.algebraics, integrals])
        return self._with_sums(y, time, piece)

    def _with_sums(self, y: np.ndarray, time: float, piece: np.ndarray) -> np.ndarray:
        """Unknowns and integrals with the sums in between."""
        numbers = self.problem.numbers()
        return self.with_sums(y[None], np.array([time]), piece[None], numbers[None]).ravel()

    def with_sums(
        self, y: np.ndarray, times: np.ndarray, pieces: np.ndarray, numbers: np.ndarray
    ) -> np.ndarray:
        """Unknowns of the native equations (m, n), for unknowns and integrals (m, ...) each.

        ``times`` (m,), ``pieces`` (m, c), and the numbers (m, p) of `Problem.numbers`.
        """
        states, unknowns = self.problem.equations.states.count, self.problem.unknowns
        x, z, integrals = y[:, :states], y[:, states:unknowns], y[:, unknowns:]
        given = [x, z, times[:, None], pieces, numbers]
        (sums,) = self._local.start_by_tape.rows(given, len(y))
        return np.concatenate([x, z, sums, integrals], axis=1)
