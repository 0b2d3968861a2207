"""SUNDIALS IDAS through CasADi: BDF of variable order for any of the equations.

IDAS chooses its steps inside an interval of smooth input and restarts at every corner,
where the coefficients of the input change. Where that fails, every smooth stretch gets a
call of its own, from consistent unknowns; a stretch that fails is halved until the last
output before the failure is found.
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
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.formulas import Formulas
from viscodesign.references import LiteratureReference
from viscodesign.solve.numerics.newton import integrator_linear_solver
from viscodesign.solve.problem import Problem
from viscodesign.solve.solvers.base import Columns, Solver, Work, smooth_stretches
from viscodesign.solve.solvers.quiet_stderr import quiet_stderr
from viscodesign.solve.statics import Start, consistent


@dataclass(frozen=True)
class StepLimits:
    """How many steps IDAS may take between two outputs, and from where it restarts."""

    max_steps: int = 500_000
    """Before anything has failed."""
    max_steps_after_failure: int = 5_000
    share_after_failure: int = 20
    """The part of all steps allowed that each attempt to locate a failure may take."""
    shares_per_interval: int = 4
    """Even shares of the remaining steps that one interval of many may take."""
    min_share: int = 256
    """Steps that any interval may take if enough remain: a restart needs some."""
    first_step: float = 1e-12
    """First step after a failure, in durations of the run."""


LIMITS = StepLimits()
TOO_MUCH_WORK = "IDA_TOO_MUCH_WORK"
REASONS = {
    TOO_MUCH_WORK: "too many steps between two outputs",
    "IDA_TOO_MUCH_ACC": "the tolerance is below machine precision",
    "IDA_ERR_FAIL": "step size fell below its minimum, as the error estimate stayed too large",
    "IDA_CONV_FAIL": "step size fell below its minimum, as Newton's iteration did not converge",
    "IDA_LSETUP_FAIL": "the linear system of a step is singular",
    "IDA_LSOLVE_FAIL": "the linear system of a step cannot be solved",
    "IDA_REP_RES_ERR": "the residual is not finite there",
    "IDA_RES_FAIL": "the residual is not finite there",
}
"""Meaning of its return codes."""
SOURCE_LINE = re.compile(r"^\S*\.[ch]pp:\d+: ")


class Idas(Solver):
    """Variable-order BDF of SUNDIALS on the whole system of equations."""

    name: ClassVar[str] = "idas"
    references: ClassVar[tuple[LiteratureReference, ...]] = (
        LiteratureReference(
            "hindmarsh2005",
            "article",
            {
                "author": "Hindmarsh, A. C. and Brown, P. N. and Grant, K. E. and "
                "Lee, S. L. and Serban, R. and Shumaker, D. E. and "
                "Woodward, C. S.",
                "title": "{SUNDIALS}: Suite of nonlinear and "
                "differential/algebraic equation solvers",
                "journal": "ACM Transactions on Mathematical Software",
                "volume": "31",
                "number": "3",
                "pages": "363--396",
                "year": "2005",
                "doi": "10.1145/1089014.1089020",
            },
        ),
    )
    order: ClassVar[int] = 20
    title: ClassVar[str] = "SUNDIALS IDAS: BDF of order 1 to 5, exact Jacobian"
    # Nine configs at their first tolerances: 6 in the median, 14 at most but for a payload that
    # swings on hardly damped (54), whose run measures that and takes a smaller tolerance.
    tip_error_per_tolerance: ClassVar[float] = 20.0

    def __init__(self, problem: Problem, tolerance: float, **changes: Any) -> None:
        super().__init__(problem, tolerance)
        equations = problem.equations
        self._stops_at_corners = False
        """Whether every smooth stretch of the input gets a call of its own."""
        self.options: dict[str, Any] = {
            "abstol": tolerance,
            "reltol": tolerance,
            "newton_scheme": "direct",
            "linear_solver": integrator_linear_solver(problem.unknowns),
            "max_num_steps": min(LIMITS.max_steps, problem.max_steps),
            "show_eval_warnings": False,
            "disable_internal_warnings": True,
            # Steps that resolve the pressures well may still integrate their work badly.
            "quad_err_con": equations.integrals > 0,
            "suppress_algebraic": any(
                block.traits.is_noisy for block in equations.algebraics.blocks.values()
            ),
        } | changes

    def __call__(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve intervals first..stop, or as many as possible; columns exclude the start."""
        stretches = smooth_stretches(self.problem.schedule.pieces, first, stop)
        if self._stops_at_corners and len(stretches) > 1:
            return self._in_turn(here, stretches, work)
        most = self._max_steps(stop - first, work)
        if most <= 0:
            return self.nothing(), self.step_limit_reached(self.problem.schedule.edges[first])
        try:
            options = self.options | {"max_num_steps": most}
            return self._solve(here, first, stop, work, options), None
        except SolveError as error:
            return self.nothing(), error
        except RuntimeError as error:
            is_share_spent = TOO_MUCH_WORK in str(error)
            work.steps += most if is_share_spent else 0
            if stop - first == 1:
                return self.nothing(), self._interval_failure(error, first, work)
        if not is_share_spent or most >= self.options["max_num_steps"]:
            # A failure is located with few steps: what is stuck is not slow.
            self.options["max_num_steps"] = self._steps_after_failure()
        if len(stretches) > 1 and not is_share_spent:
            # It may not find the values to which algebraic unknowns jump at a corner.
            self._stops_at_corners = True
            return self._in_turn(here, stretches, work)
        middle = (first + stop) // 2
        return self._in_turn(here, [(first, middle), (middle, stop)], work)

    def _in_turn(
        self, here: Start, parts: Sequence[tuple[int, int]], work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve one part after the other, each from where the one before it ended."""
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

    def _max_steps(self, intervals: int, work: Work) -> int:
        """Steps that each of so many intervals may take, so that all keep to the run's limit.

        Several times their even share, rounded to a power of two, so that few integrators
        have to be built. An interval that needs more is solved alone, with all that remain.
        """
        left = self.problem.max_steps - work.steps
        if intervals > 1 and left > 0:
            share = LIMITS.shares_per_interval * left // intervals
            share = max(share, min(LIMITS.min_share, left // 64), 1)
            left = 1 << share.bit_length() - 1
        return min(left, int(self.options["max_num_steps"]))

    def _interval_failure(self, error: RuntimeError, edge: int, work: Work) -> SolveError:
        """The failure of one interval, which may be that of the run's step limit."""
        if work.steps >= self.problem.max_steps:
            return self.step_limit_reached(self.problem.schedule.edges[edge])
        return self.failure(reason_of(error), float(self.problem.schedule.edges[edge]))

    def _steps_after_failure(self) -> int:
        """Steps between two outputs, once a part of the run has failed."""
        allowed = max(self.problem.max_steps // LIMITS.share_after_failure, 1)
        return min(LIMITS.max_steps_after_failure, allowed, int(self.options["max_num_steps"]))

    def remedies(self) -> Iterator[tuple[str, Solver]]:
        """A careful restart, then order 2, then a smaller tolerance."""
        changes: dict[str, Any] = {"max_num_steps": self._steps_after_failure()}
        for tried, change in (
            # The first step is estimated from rates that may be about to jump.
            (
                "restart with a tiny first step",
                {"step0": LIMITS.first_step * self.problem.schedule.edges[-1]},
            ),
            ("error control of algebraic unknowns as well", {"suppress_algebraic": False}),
            ("maximum order 2", {"max_multistep_order": 2}),
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
            with quiet_stderr():
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


def reason_of(error: RuntimeError) -> str:
    """The integrator's reason in one line, without its own file names."""
    text = str(error)
    for code, reason in REASONS.items():
        if code in text:
            return f"{reason} ({code})"
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return SOURCE_LINE.sub("", lines[-1])[:200] if lines else "no reason given"
