"""The smooth stretches of a run, one after the other, by native steps."""

from __future__ import annotations

import itertools

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.rod_equations import RodForm
from viscodesign.native.derivatives import (
    Consistency,
    Stretch,
)
from viscodesign.native.march import MarchState, MarchStatus, StepRecord
from viscodesign.native.tables import Assembly
from viscodesign.solve.problem import SAME_TIME, Problem
from viscodesign.solve.solvers.rodas_native import NativeSteps
from viscodesign.solve.statics import Instant, Start, consistent

CONSISTENT = 1e-12
"""Correction of algebraic unknowns, in their sizes, at which they count as solved."""
ROUND_OFF_CORRECTION = 1e-8
"""Correction that is round-off of stiff equations if it no longer gets smaller."""
MAX_STAGE_CORRECTIONS = 12
MAX_WITH_STAGES = 500
"""Unknowns up to which the stages of all steps are recorded: 36 kB a step."""


@dataclass(frozen=True)
class SolvedStretch:
    """One smooth stretch of a solved run."""

    begin: Consistency
    march: Stretch
    outputs: slice
    """Which of the output times lie behind its beginning and up to its end."""

    @property
    def output_count(self) -> int:
        """How many these are."""
        return int(self.outputs.stop - self.outputs.start)


@dataclass(frozen=True)
class TakenStretch:
    """What going over one smooth stretch gives."""

    begin: Consistency
    march: Stretch
    columns: np.ndarray
    """(edges, n)"""
    end: Start
    size: float
    """First step that suits what follows [s]."""
    steps: int


@dataclass(frozen=True)
class SolvedStretches:
    """All stretches of a run."""

    assembly: Assembly
    stretches: list[SolvedStretch]
    columns: np.ndarray
    """(T, nx + nz): unknowns at the output times."""
    end: Start
    steps: int


class Stretches:
    """Goes over the stretches of a run, and records the steps for derivatives.

    Stateless. Raises `NativeUnavailable` where native code does not take the equations.
    """

    def __init__(self, problem: Problem, tolerance: float) -> None:
        NativeSteps(problem, tolerance)
        local = problem.equations.local
        assert local is not None, "native steps have it"
        self._compiled = local.compiled

    def over(
        self,
        steps: NativeSteps,
        here: Start,
        stops: np.ndarray,
        pieces: np.ndarray,
        times: np.ndarray,
        *,
        recorded: bool = True,
    ) -> SolvedStretches:
        """Go from a start at the first stop to the last one, with outputs at ``times`` (T,).

        ``pieces`` (m, c): coefficients between the stops (m + 1,); ``recorded``: for derivatives.
        Raises `SolveError` where that fails on the way.
        """
        size, taken, unknowns = None, 0, steps.problem.unknowns
        stretches, columns = [], [np.zeros((0, unknowns))]
        for k, outputs in enumerate(outputs_between(stops, times)):
            edges = edges_of(stops, k, times[outputs])
            before = (float(stops[k]), pieces[k - 1]) if k else None
            own = (float(stops[k]), pieces[k])
            part = self.advance(
                steps, here, own, edges, size, before=before, taken=taken, recorded=recorded
            )
            if k == 0 and outputs.start > 0:
                columns.append(part.begin.Y[None, :unknowns])
            stretches.append(SolvedStretch(part.begin, part.march, outputs))
            columns.append(part.columns[: stretches[-1].output_count, :unknowns])
            here, size, taken = part.end, part.size, taken + part.steps
        return SolvedStretches(steps.assembly, stretches, np.concatenate(columns), here, taken)

    def advance(
        self,
        steps: NativeSteps,
        here: Start,
        begins: Instant,
        edges: np.ndarray,
        size: float | None,
        *,
        before: Instant | None = None,
        taken: int = 0,
        recorded: bool = True,
    ) -> TakenStretch:
        """Go over one smooth stretch from a state, to the last of its edges.

        ``begins``: when, and its coefficients; ``size``: of the first step [s]; ``before``: the
        same instant with the coefficients of the stretch before; ``taken``: steps so far.
        """
        (time, piece), problem = begins, steps.problem
        begin = self.begin(steps, here, begins, before)
        state = MarchState(
            y=begin.Y[: steps.assembly.unknowns].copy(),
            time=time,
            size=steps.first_size(size, edges[-1] - time),
        )
        has_stages = steps.assembly.unknowns <= MAX_WITH_STAGES
        record = StepRecord(has_stages=has_stages) if recorded else None
        rest = np.append(piece, 1.0)
        columns = self._march(problem, steps, state, rest, edges, record, taken)
        states, unknowns = problem.equations.states.count, problem.unknowns
        end = Start(state.y[:states], state.y[states:unknowns])
        march = Stretch(rest, edges, np.zeros((0, 0)) if record is None else record.rows)
        return TakenStretch(begin, march, columns, end, state.size, state.steps)

    def begin(
        self, steps: NativeSteps, here: Start, begins: Instant, before: Instant | None = None
    ) -> Consistency:
        """Consistent unknowns at the beginning of a stretch."""
        (time, piece), problem = begins, steps.problem
        if problem.equations.rod_form is RodForm.STATIC and before is not None:
            here = consistent(problem, here, time, piece, before)
        own, rest = self._compiled.differentiable, np.append(piece, 1.0)
        y, before_size = steps.unknowns_at(here, time, piece), np.inf
        for _ in range(MAX_STAGE_CORRECTIONS):
            try:
                begin = Consistency(own, steps.assembly, y, time, rest)
                correction = begin.correction()
            except ZeroDivisionError as error:
                raise _without_unknowns(time) from error
            size = float(np.max(np.abs(correction), initial=0.0))
            is_round_off = size <= ROUND_OFF_CORRECTION and size > before_size / 2
            if size <= CONSISTENT or is_round_off:
                return begin
            if not np.isfinite(size):
                break
            y, before_size = y + correction, size
        raise _without_unknowns(time)

    def _march(
        self,
        problem: Problem,
        steps: NativeSteps,
        state: MarchState,
        rest: np.ndarray,
        edges: np.ndarray,
        record: StepRecord | None,
        taken: int,
    ) -> np.ndarray:
        begin, found = state.time, []
        while True:
            left = problem.max_steps - taken - state.steps
            status, columns = steps.march(state, rest, begin, edges, max(left, 1), record)
            found.append(columns)
            if status is MarchStatus.FINISHED:
                return np.concatenate(found)
            if status is not MarchStatus.STEP_LIMIT or left <= 0:
                raise _stopped(state.time, status is MarchStatus.STEP_LIMIT)


def outputs_between(stops: np.ndarray, times: np.ndarray) -> list[slice]:
    """Which output times each stretch has; that at its start belongs to none."""
    ends = np.searchsorted(times, stops + SAME_TIME * stops[-1], side="right").tolist()
    return [slice(i, j) for i, j in itertools.pairwise(ends)]


def edges_of(stops: np.ndarray, k: int, times: np.ndarray) -> np.ndarray:
    """Output times (T,) of a stretch, and its end where that is none."""
    end = stops[k + 1]
    if len(times) and end - times[-1] <= SAME_TIME * stops[-1]:
        times = times[:-1]
    return np.append(times, end)


def _without_unknowns(time: float) -> SolveError:
    return SolveError(
        f"no pressures and forces are consistent with the state at t = {time:.6g} s",
        quantity="equilibrium",
        where="rod",
        time_s=time,
        remedy="Use `simulate` for these values: it raises the loads step by step.",
    )


def _stopped(time: float, at_limit: bool) -> SolveError:
    """A failure on the way."""
    reason = "the limit of steps was reached" if at_limit else "steps became too small"
    return SolveError(
        f"{reason} at t = {time:.6g} s",
        quantity="work" if at_limit else "step",
        where="run",
        time_s=time,
        remedy="Raise run.max_steps." if at_limit else "Inspect the motion with `simulate`.",
    )
