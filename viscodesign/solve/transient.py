"""Motion through time: SUNDIALS IDAS on the scaled equations.

IDAS steps freely inside an interval of smooth input and starts afresh at every
corner, because there the coefficients of the input change: no step ever passes
over one. Long runs are cut into chunks, so that progress can be told and an
interrupt keeps what was computed; a chunk that fails is halved until the output
before the failure is found.
"""

from __future__ import annotations

import time as clock
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np

from viscodesign.errors import SolveError
from viscodesign.solve.interrupt import gentle_interrupt
from viscodesign.solve.problem import Problem
from viscodesign.solve.silence import silence
from viscodesign.solve.statics import Start, consistent

MAX_STEPS = 500_000
"""Steps between two outputs after which a run is given up."""
CAUTIOUS_STEP = 1e-12
"""First step after a failure, in parts of the run."""
MAX_STEPS_AFTER_FAILURE = 5_000
"""The same, once a part of the run has failed."""
CHUNK_SECONDS = 0.4
"""Wall time that one uninterrupted call of the integrator should take."""
CHUNK_PER_COMPILE = 10.0
"""The same, at least, in times that making an integrator takes."""
FIRST_CHUNK = 0.1
"""Part of a long run that is solved first, to learn how fast it goes."""


@dataclass
class Work:
    """Counts of work done, which no clock disturbs."""

    steps: int = 0
    residual_calls: int = 0
    jacobian_calls: int = 0
    chunks: int = 0
    compile_s: float = 0.0
    """Wall time spent on making integrators, which is building, not solving [s]."""

    def add(self, stats: dict[str, object]) -> None:
        """Add one call of the integrator."""
        self.steps += int(stats["nsteps"])  # type: ignore[call-overload]
        self.residual_calls += int(stats["n_call_daeF"])  # type: ignore[call-overload]
        self.jacobian_calls += int(stats["n_call_jacF"])  # type: ignore[call-overload]


@dataclass
class Solution:
    """Scaled unknowns and balance integrals at the edges that were reached."""

    states: np.ndarray
    """(nx, m)"""
    algebraics: np.ndarray
    """(nz, m)"""
    integrals: np.ndarray
    """(nq, m) running integrals of the equations' rates, in SI."""
    reached: int
    """Number of edges solved, counted from the first."""
    work: Work
    failure: SolveError | None = None
    interrupted: bool = False


@dataclass
class _Record:
    """Columns gathered chunk by chunk."""

    states: list[np.ndarray] = field(default_factory=list)
    algebraics: list[np.ndarray] = field(default_factory=list)
    integrals: list[np.ndarray] = field(default_factory=list)


def integrate(
    problem: Problem,
    start: Start,
    tolerance: float,
    progress: Callable[[float], None] | None = None,
) -> Solution:
    """Follow the motion over all edges of the schedule.

    ``start``: states at t = 0; ``tolerance``: relative and absolute, on scaled
    unknowns. Never raises for a failure on the way: what was reached is returned,
    with the failure.
    """
    march = (
        _Algebraic(problem) if problem.equations.states.count == 0 else _Idas(problem, tolerance)
    )
    edges = problem.schedule.edges
    record, work = _Record(), Work()
    here = consistent(problem, start, edges[0], problem.schedule.pieces[0])
    total = np.zeros(len(problem.equations.rates))
    _append(record, here.states[:, None], here.algebraics[:, None], total[:, None])
    done, failure = 0, None
    length = _first_length(problem)
    with gentle_interrupt() as interrupt:
        while done < len(edges) - 1 and failure is None and not interrupt.asked:
            stop = min(done + length, len(edges) - 1)
            began = clock.perf_counter()
            columns, failure = march(here, done, stop, work)
            count = columns[0].shape[1]
            if count:
                _append(record, columns[0], columns[1], total[:, None] + columns[2])
                total = total + columns[2][:, -1]
                here = Start(columns[0][:, -1], columns[1][:, -1])
                done += count
            length = _next_length(count, clock.perf_counter() - began, work)
            if progress is not None:
                progress(edges[done] / edges[-1])
    return Solution(
        np.concatenate(record.states, axis=1),
        np.concatenate(record.algebraics, axis=1),
        np.concatenate(record.integrals, axis=1),
        done + 1,
        work,
        failure,
        interrupt.asked and done < len(edges) - 1,
    )


def _append(record: _Record, x: np.ndarray, z: np.ndarray, q: np.ndarray) -> None:
    record.states.append(x)
    record.algebraics.append(z)
    record.integrals.append(q)


def _first_length(problem: Problem) -> int:
    """Intervals of the first chunk: all of a run that is surely short, else a part."""
    equations = problem.equations
    intervals = len(problem.schedule.edges) - 1
    unknowns = equations.states.count + equations.algebraics.count
    if intervals * max(unknowns, 20) <= SHORT_RUN:
        return intervals
    return max(1, int(FIRST_CHUNK * intervals))


SHORT_RUN = 200_000
"""Intervals times unknowns up to which a run takes well under a second."""


def _next_length(count: int, seconds: float, work: Work) -> int:
    """Intervals that take a moment; where an integrator is slow to make, a longer one."""
    work.chunks += 1
    making = work.compile_s / work.chunks
    wanted = max(CHUNK_SECONDS, CHUNK_PER_COMPILE * making)
    return max(1, int(count * wanted / max(seconds - making, 1e-6)))


Columns = tuple[np.ndarray, np.ndarray, np.ndarray]


class _Idas:
    """One march with SUNDIALS IDAS."""

    def __init__(self, problem: Problem, tolerance: float) -> None:
        self.problem = problem
        equations = problem.equations
        self.dae = {
            "t": equations.time,
            "x": equations.states.vector,
            "z": equations.algebraics.vector,
            "p": equations.parameters,
            "u": equations.pieces,
            "ode": equations.ode,
            "alg": equations.alg,
            "quad": ca.vertcat(*equations.rates.values()),
        }
        self.options: dict[str, Any] = {
            "abstol": tolerance,
            "reltol": tolerance,
            "newton_scheme": "direct",
            # LU by CSparse: the pivots do not mind a mirrored sign, Householder's QR does.
            "linear_solver": "csparse",
            "max_num_steps": MAX_STEPS,
            "show_eval_warnings": False,
            "disable_internal_warnings": True,
            "quad_err_con": False,
            # Accelerations are noisy, and nothing is integrated from them but through the
            # velocities, whose error is controlled.
            "suppress_algebraic": "acceleration" in equations.algebraics.blocks,
        }
        self.remedies: tuple[dict[str, Any], ...] = (
            # The first step is guessed from rates that may be about to jump: take less.
            {"step0": CAUTIOUS_STEP * problem.schedule.edges[-1]},
            {"suppress_algebraic": False},
            {"max_multistep_order": 2},
        )

    def __call__(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve intervals first..stop, or as many as can be; columns exclude the start."""
        try:
            return self._solve(here, first, stop, work, self.options), None
        except SolveError as error:
            return self._nothing(), error
        except RuntimeError as error:
            if stop - first == 1:
                return self._insist(here, first, work, error)
        # What failed once is sought with little patience: a stuck step is not a slow one.
        self.options["max_num_steps"] = MAX_STEPS_AFTER_FAILURE
        middle = (first + stop) // 2
        before, failure = self(here, first, middle, work)
        if failure is not None or not before[0].shape[1]:
            return before, failure
        there = Start(before[0][:, -1], before[1][:, -1])
        after, failure = self(there, middle, stop, work)
        joined = tuple(
            np.concatenate(pair, axis=1) for pair in zip(before[:2], after[:2], strict=True)
        )
        integrals = np.concatenate([before[2], before[2][:, -1:] + after[2]], axis=1)
        return (joined[0], joined[1], integrals), failure

    def _insist(
        self, here: Start, first: int, work: Work, error: RuntimeError
    ) -> tuple[Columns, SolveError | None]:
        """Try one interval again, each time with one more remedy."""
        options = dict(self.options)
        for remedy in self.remedies:
            options |= remedy
            try:
                return self._solve(here, first, first + 1, work, options), None
            except RuntimeError as again:
                error = again
        return self._nothing(), self._failure(error, first)

    def _solve(
        self, here: Start, first: int, stop: int, work: Work, options: dict[str, Any]
    ) -> Columns:
        schedule = self.problem.schedule
        edges, pieces = schedule.edges, schedule.pieces
        there = consistent(self.problem, here, edges[first], pieces[first])
        began = clock.perf_counter()
        integrator = ca.integrator(
            "motion", "idas", self.dae, edges[first], edges[first + 1 : stop + 1], options
        )
        work.compile_s += clock.perf_counter() - began
        with silence():
            result = integrator(
                x0=there.states,
                z0=there.algebraics,
                p=self.problem.numbers(),
                u=pieces[first:stop].T,
            )
        work.add(integrator.stats())
        return np.array(result["xf"]), np.array(result["zf"]), np.array(result["qf"])

    def _nothing(self) -> Columns:
        equations = self.problem.equations
        return (
            np.zeros((equations.states.count, 0)),
            np.zeros((equations.algebraics.count, 0)),
            np.zeros((len(equations.rates), 0)),
        )

    def _failure(self, error: RuntimeError, first: int) -> SolveError:
        time = float(self.problem.schedule.edges[first])
        return SolveError(
            f"the motion cannot be followed past t = {time:.6g} s: {_last_words(error)}",
            quantity="motion",
            where="integrator",
            time_s=time,
            remedy="Look at the last shapes; lower the pressure or the loads, or take inertia in.",
        )


def _last_words(error: RuntimeError) -> str:
    """The integrator's own reason, one line."""
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    return lines[-1][:200] if lines else "no reason given"


class _Algebraic:
    """A march without states: every output is a solution of its own."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem

    def __call__(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve the constraints at edges first+1..stop, each from the one before."""
        schedule = self.problem.schedule
        found: list[np.ndarray] = []
        failure: SolveError | None = None
        for k in range(first, stop):
            try:
                here = consistent(self.problem, here, schedule.edges[k + 1], schedule.pieces[k])
            except SolveError as error:
                failure = error
                break
            found.append(here.algebraics)
            work.steps += 1
        columns = np.array(found).T.reshape(self.problem.equations.algebraics.count, len(found))
        return (np.zeros((0, len(found))), columns, np.zeros((0, len(found)))), failure
