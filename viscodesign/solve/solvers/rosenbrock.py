"""Rodas5P, a Rosenbrock method.

BDF of order three and above is not stable for undamped vibrations; this method is, at
order five. A step has one Jacobian, one factorisation and eight stages, no iteration.
"""

from __future__ import annotations

import time as clock
from typing import ClassVar

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.model.rod_equations import RodForm
from viscodesign.native.unavailable import NativeUnavailable
from viscodesign.references import LiteratureReference
from viscodesign.solve.event_location import located
from viscodesign.solve.numerics.symbolic_lu import has_whole_diagonal
from viscodesign.solve.problem import Problem
from viscodesign.solve.solvers.base import Columns, Solver, Work, smooth_stretches
from viscodesign.solve.solvers.rodas_formulas import FormulaSteps
from viscodesign.solve.solvers.rodas_native import NativeSteps, has_native_code
from viscodesign.solve.solvers.rodas_stretch import CONTROL, Reached, StretchSteps
from viscodesign.solve.statics import Instant, Start


class Rosenbrock(Solver):
    """Steps of Rodas5P, as long as the embedded error allows."""

    name: ClassVar[str] = "rosenbrock"
    references: ClassVar[tuple[LiteratureReference, ...]] = (
        LiteratureReference(
            "steinebach2023",
            "article",
            {
                "author": "Steinebach, G.",
                "title": "Construction of {Rosenbrock--Wanner} method {Rodas5P} "
                "and numerical benchmarks within the {Julia Differential "
                "Equations} package",
                "journal": "BIT Numerical Mathematics",
                "volume": "63",
                "number": "2",
                "pages": "27",
                "year": "2023",
                "doi": "10.1007/s10543-023-00967-x",
            },
        ),
    )
    order: ClassVar[int] = 10
    title: ClassVar[str] = "Rodas5P: Rosenbrock of order 5, A-stable, exact Jacobian"
    # The largest over a hundred scenes; typically it is below one.
    tip_error_per_tolerance: ClassVar[float] = 5.0

    def __init__(self, problem: Problem, tolerance: float) -> None:
        super().__init__(problem, tolerance)
        began = clock.perf_counter()
        self.steps = _steps(problem, tolerance)
        self.build_s = clock.perf_counter() - began
        self.size: float | None = None
        self._consistent: tuple[Start | None, float] = None, 0.0
        """The latest unknowns that were made so, and their time [s]."""
        self.states = problem.equations.states.count
        self.unknowns = problem.unknowns

    def unwatched(self, problem: Problem) -> Solver:
        """Its steps look for no events."""
        solver = Rosenbrock(problem, self.tolerance)
        solver.steps.watch = None
        return solver

    @classmethod
    def takes(cls, problem: Problem) -> bool:
        """Its elimination pivots on the diagonal only."""
        return has_whole_diagonal(problem.equations.constraints_by_tape.sparsities[1])

    @classmethod
    def fits(cls, problem: Problem) -> bool:
        """Without native code, generating formulas for a thousand unknowns takes seconds."""
        return problem.unknowns <= CONTROL.max_unknowns or has_native_code(problem)

    def consistent(
        self, here: Start, time: float, piece: np.ndarray, before: Instant | None = None
    ) -> Start:
        """In native code, where these have one solution and Newton's full steps lead there."""
        if here is self._consistent[0] and time == self._consistent[1]:
            return here  # as a run has begun
        equations = self.problem.equations
        is_static = equations.rod_form is RodForm.STATIC
        may_branch = is_static or bool(equations.algebraics.multivalued)
        found = None if may_branch else self.steps.corrected(here, time, piece)
        if found is None:
            found = super().consistent(here, time, piece, before)
        self._consistent = found, time
        return found

    def __call__(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve the stretches of smooth input in first..stop one after the other."""
        work.compile_s, self.build_s = work.compile_s + self.build_s, 0.0
        columns: list[np.ndarray] = []
        total = np.zeros(self.problem.equations.integrals)
        failure: SolveError | None = None
        for begin, end in smooth_stretches(self.problem.schedule.pieces, first, stop):
            try:
                here = self.consistent(
                    here,
                    float(self.problem.schedule.edges[begin]),
                    self.problem.schedule.pieces[begin],
                    self.before(begin),
                )
            except SolveError as error:
                failure = error
                break
            y = np.concatenate([here.states, here.algebraics, total])
            reached = self.steps(self.problem.schedule, y, begin, end, self.size, work)
            columns.append(reached.columns)
            if reached.crossing is not None:
                failure = located(self, reached.crossing, work)
                edges = self.problem.schedule.edges[begin + 1 : end + 1]
                valid = int(np.searchsorted(edges, failure.time_s))
                columns[-1] = reached.columns[:valid]
                break
            if reached.failure is not None:
                failure = self._failure(reached)
                break
            self.size, last = reached.size, reached.columns[-1]
            x, z, total = np.split(last, [self.states, self.unknowns])
            here = Start(x, z)
        if not columns:
            return self.nothing(), failure
        x, z, q = np.split(np.concatenate(columns).T, [self.states, self.unknowns])
        return (x, z, q), failure

    def _failure(self, reached: Reached) -> SolveError:
        if reached.cause is not None:
            return reached.cause
        if not reached.failure:
            return self.step_limit_reached(reached.time)
        return self.failure(reached.failure, reached.time)


def _steps(problem: Problem, tolerance: float) -> StretchSteps:
    """Native code where it can be had."""
    try:
        return NativeSteps(problem, tolerance)
    except NativeUnavailable:
        return FormulaSteps(problem, tolerance)
