"""SUNDIALS IDAS through CasADi: the default.

IDAS steps freely inside an interval of smooth input and starts afresh at every
corner, because there the coefficients of the input change. Where that fails, every smooth
stretch has a call of its own, from consistent unknowns; a stretch that fails is
halved until the output before the failure is found.
"""

from __future__ import annotations

import re
import time as clock
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager
from typing import Any, ClassVar

import casadi as ca
import numpy as np

from viscodesign.errors import SolveError
from viscodesign.model.formulation import Formulas
from viscodesign.solve.numerics.linear import direct_solver
from viscodesign.solve.problem import Problem
from viscodesign.solve.solvers.base import Columns, Solver, Work, smooth_stretches
from viscodesign.solve.solvers.quiet_stderr import silence
from viscodesign.solve.statics import Start, consistent

MAX_STEPS = 500_000
"""Steps between two outputs after which a run is given up."""
CAUTIOUS_STEP = 1e-12
"""First step after a failure, in parts of the run."""
MAX_STEPS_AFTER_FAILURE = 5_000
"""The same, once a part of the run has failed."""
PART_AFTER_FAILURE = 20
"""The part of all steps allowed that each try to find the place of a failure may take."""
SHARES = 4
"""Even shares of the steps that are left, of which one interval of many may take so many."""
LEAST_SHARE = 256
"""Steps that any interval may take where there are enough: a start afresh needs some."""
TOO_MUCH_WORK = "IDA_TOO_MUCH_WORK"
REASONS = {
    TOO_MUCH_WORK: "too many steps are needed from one output to the next",
    "IDA_TOO_MUCH_ACC": "the tolerance is below what numbers can tell",
    "IDA_ERR_FAIL": "the steps shrink to nothing, since each leaves too large an error",
    "IDA_CONV_FAIL": "the steps shrink to nothing, since the equations of none can be solved",
    "IDA_LSETUP_FAIL": "the linear system of a step is singular",
    "IDA_LSOLVE_FAIL": "the linear system of a step cannot be solved",
    "IDA_REP_RES_ERR": "the equations have no value there",
    "IDA_RES_FAIL": "the equations have no value there",
}
"""What its return codes mean for whoever reads of them."""
SOURCE_LINE = re.compile(r"^\S*\.[ch]pp:\d+: ")


class Idas(Solver):
    """Variable-order BDF of SUNDIALS on the whole system of equations."""

    name: ClassVar[str] = "idas"
    order: ClassVar[int] = 10
    title: ClassVar[str] = "SUNDIALS IDAS: BDF of order 1 to 5, exact Jacobian"
    # Measured on the paper's leg from 1e-3 to 1e-6.
    tip_error_per_tolerance: ClassVar[float] = 20.0

    def __init__(self, problem: Problem, tolerance: float, **changes: Any) -> None:
        super().__init__(problem, tolerance)
        equations = problem.equations
        self._stops_at_corners = False
        """Whether every smooth stretch of the input is solved by a call of its own."""
        self.options: dict[str, Any] = {
            "abstol": tolerance,
            "reltol": tolerance,
            "newton_scheme": "direct",
            "linear_solver": direct_solver(problem.unknowns),
            "max_num_steps": min(MAX_STEPS, problem.most_steps),
            "show_eval_warnings": False,
            "disable_internal_warnings": True,
            # Or steps that follow pressures well enough add up their work badly.
            "quad_err_con": equations.quadrature.numel() > 0,
            # Accelerations are noisy, and nothing is integrated from them but through the
            # velocities, whose error is controlled.
            "suppress_algebraic": "acceleration" in equations.algebraics.blocks,
        } | changes

    def __call__(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve intervals first..stop, or as many as can be; columns exclude the start."""
        stretches = smooth_stretches(self.problem.schedule.pieces, first, stop)
        if self._stops_at_corners and len(stretches) > 1:
            return self._in_turn(here, stretches, work)
        most = self._most_steps(stop - first, work)
        if most <= 0:
            return self.nothing(), self.overworked(self.problem.schedule.edges[first])
        try:
            options = self.options | {"max_num_steps": most}
            return self._solve(here, first, stop, work, options), None
        except SolveError as error:
            return self.nothing(), error
        except RuntimeError as error:
            is_share_spent = TOO_MUCH_WORK in str(error)
            work.steps += most if is_share_spent else 0
            if stop - first == 1:
                return self.nothing(), self._ended(error, first, work)
        if not is_share_spent or most >= self.options["max_num_steps"]:
            # What failed once is sought with little patience: a stuck step is not a slow one.
            self.options["max_num_steps"] = self._patience()
        if len(stretches) > 1 and not is_share_spent:
            # Behind a corner it may not find what the algebraic unknowns have jumped to.
            self._stops_at_corners = True
            return self._in_turn(here, stretches, work)
        middle = (first + stop) // 2
        return self._in_turn(here, [(first, middle), (middle, stop)], work)

    def _in_turn(
        self, here: Start, parts: Sequence[tuple[int, int]], work: Work
    ) -> tuple[Columns, SolveError | None]:
        """One part after the other, each from what the one before it came to."""
        done: list[Columns] = []
        total = np.zeros(self.nothing()[2].shape[0])
        failure: SolveError | None = None
        for first, stop in parts:
            (states, algebraics, integrals), failure = self(here, first, stop, work)
            if states.shape[1]:
                done.append((states, algebraics, total[:, None] + integrals))
                here, total = Start(states[:, -1], algebraics[:, -1]), done[-1][2][:, -1]
            if failure is not None or states.shape[1] < stop - first:
                break
        if not done:
            return self.nothing(), failure
        columns = tuple(np.concatenate(rows, axis=1) for rows in zip(*done, strict=True))
        return (columns[0], columns[1], columns[2]), failure

    def _most_steps(self, intervals: int, work: Work) -> int:
        """Steps that each of so many intervals may take, so that all keep to the run's limit.

        Several times their even share, as a power of two: what has few different options is
        made once. An interval that needs more is tried by itself, with all that is left.
        """
        left = self.problem.most_steps - work.steps
        if intervals > 1 and left > 0:
            share = max(SHARES * left // intervals, min(LEAST_SHARE, left // 64), 1)
            left = 1 << share.bit_length() - 1
        return min(left, int(self.options["max_num_steps"]))

    def _ended(self, error: RuntimeError, edge: int, work: Work) -> SolveError:
        """The failure of one interval; all work that is allowed may be done."""
        if work.steps >= self.problem.most_steps:
            return self.overworked(self.problem.schedule.edges[edge])
        return self.failure(_last_words(error), edge)

    def _patience(self) -> int:
        """Steps from one output to the next, once a part of the run has failed."""
        allowed = max(self.problem.most_steps // PART_AFTER_FAILURE, 1)
        return min(MAX_STEPS_AFTER_FAILURE, allowed, int(self.options["max_num_steps"]))

    def remedies(self) -> Iterator[tuple[str, Solver]]:
        """Care, then order 2, then a smaller tolerance."""
        changes: dict[str, Any] = {"max_num_steps": self._patience()}
        for tried, change in (
            # The first step is guessed from rates that may be about to jump: take less.
            (
                "a restart with a tiny first step",
                {"step0": CAUTIOUS_STEP * self.problem.schedule.edges[-1]},
            ),
            ("errors of accelerations controlled, too", {"suppress_algebraic": False}),
            ("order 2 at most", {"max_multistep_order": 2}),
        ):
            if self.options.items() >= change.items():
                continue
            changes |= change
            yield tried, Idas(self.problem, self.tolerance, **changes)
        yield "a hundredth of the tolerance", Idas(self.problem, self.tolerance / 100, **changes)

    def integrator(
        self, edges: np.ndarray, options: dict[str, Any]
    ) -> AbstractContextManager[ca.Function]:
        """One for these times and options, for no one else inside the context."""
        return self.problem.equations.lent(
            _integrator, edges.tobytes(), tuple(sorted(options.items()))
        )

    def _solve(
        self, here: Start, first: int, stop: int, work: Work, options: dict[str, Any]
    ) -> Columns:
        schedule = self.problem.schedule
        edges, pieces = schedule.edges, schedule.pieces
        there = consistent(self.problem, here, edges[first], pieces[first], self.before(first))
        began = clock.perf_counter()
        with self.integrator(edges[first : stop + 1], options) as integrator:
            work.compile_s += clock.perf_counter() - began
            with silence():
                result = integrator(
                    x0=there.states,
                    z0=there.algebraics,
                    p=self.problem.numbers(),
                    u=pieces[first:stop].T,
                )
            _count(work, integrator.stats())
        return np.array(result["xf"]), np.array(result["zf"]), np.array(result["qf"])


def _integrator(
    equations: Formulas, times: bytes, options: tuple[tuple[str, Any], ...]
) -> ca.Function:
    edges = np.frombuffer(times)
    dae = {
        "t": equations.time,
        "x": equations.states.vector,
        "z": equations.algebraics.vector,
        "p": equations.parameters,
        "u": equations.pieces,
        "ode": equations.ode,
        "alg": equations.alg,
        "quad": equations.quadrature,
    }
    return ca.integrator("motion", "idas", dae, edges[0], edges[1:], dict(options))


def _count(work: Work, stats: dict[str, Any]) -> None:
    """Add one call of the integrator."""
    work.steps += int(stats["nsteps"])
    work.residual_calls += int(stats["n_call_daeF"])
    work.jacobian_calls += int(stats["n_call_jacF"])


def _last_words(error: RuntimeError) -> str:
    """The integrator's reason, in one line without its own file names."""
    text = str(error)
    for code, reason in REASONS.items():
        if code in text:
            return f"{reason} ({code})"
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return SOURCE_LINE.sub("", lines[-1])[:200] if lines else "no reason given"
