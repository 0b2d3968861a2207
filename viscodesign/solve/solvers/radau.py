"""SciPy's Radau IIA on the states alone, as a check by another author's method.

The algebraic unknowns are solved for inside every evaluation, with the exact Jacobian
of the reduced system. In Python throughout: for comparison, not for production.
"""

from __future__ import annotations

from typing import ClassVar

import casadi as ca
import numpy as np

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.formulas import Formulas
from viscodesign.model.jacobian import jacobian
from viscodesign.references import LiteratureReference
from viscodesign.solve.numerics.newton import NewtonError, newton
from viscodesign.solve.problem import Problem, evaluate
from viscodesign.solve.solvers.base import Columns, Solver, Work, smooth_stretches
from viscodesign.solve.statics import Start, consistent


@dataclass(frozen=True)
class RadauLimits:
    """Limits of SciPy's solver."""

    min_rtol: float = 3e-14
    untested_tolerance: float = 1e30
    """Tolerance of unknowns that no error test is to see."""
    max_states: int = 300
    """States up to which it is offered where another solver failed."""
    max_steps: int = 20_000
    """In one stretch of smooth input."""
    rates_per_step: int = 30
    """Evaluations of the rates that a step may take on average; three for every iteration,
    and fourteen are typical."""


LIMITS = RadauLimits()


class Radau(Solver):
    """SciPy's Radau of order 5, restarted at every corner."""

    name: ClassVar[str] = "radau"
    references: ClassVar[tuple[LiteratureReference, ...]] = (
        LiteratureReference(
            "hairer1996",
            "book",
            {
                "author": "Hairer, Ernst and Wanner, Gerhard",
                "title": "Solving Ordinary Differential Equations {II}: Stiff and "
                "Differential-Algebraic Problems",
                "publisher": "Springer",
                "year": "1996",
                "doi": "10.1007/978-3-642-05221-7",
            },
        ),
    )
    order: ClassVar[int] = 30
    title: ClassVar[str] = "SciPy's Radau IIA: order 5, exact Jacobian, in Python"
    tip_error_per_tolerance: ClassVar[float] = 5.0

    def __init__(self, problem: Problem, tolerance: float) -> None:
        super().__init__(problem, tolerance)
        self.function = problem.equations.compiled(_reduced)
        self.states = problem.equations.states.count

    @classmethod
    def fits(cls, problem: Problem) -> bool:
        """Its matrices are dense."""
        return problem.equations.states.count <= LIMITS.max_states

    def __call__(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve the stretches of smooth input in first..stop one after the other."""
        schedule = self.problem.schedule
        columns: list[np.ndarray] = []
        total = np.zeros(self.problem.equations.integrals)
        failure: SolveError | None = None
        for begin, end in smooth_stretches(schedule.pieces, first, stop):
            try:
                here = consistent(
                    self.problem,
                    here,
                    schedule.edges[begin],
                    schedule.pieces[begin],
                    self.before(begin),
                )
                found = _RadauStretch(self, here, total, schedule.pieces[begin], work).follow(
                    begin, end
                )
            except (SolveError, NewtonError) as error:
                failure = (
                    error
                    if isinstance(error, SolveError)
                    else self.failure(str(error), float(schedule.edges[begin]))
                )
                break
            columns += found
            if len(found) < end - begin:
                reached = float(schedule.edges[begin + len(found)])
                failure = self.failure("step size fell below its minimum", reached)
                break
            x, z, total = np.split(found[-1], [self.states, len(found[-1]) - len(total)])
            here = Start(x, z)
        if not columns:
            return self.nothing(), failure
        x, z, q = np.split(np.array(columns).T, [self.states, len(columns[0]) - len(total)])
        return (x, z, q), failure


class _RadauStretch:
    """One run of SciPy's solver over smooth input."""

    def __init__(
        self, solver: Radau, here: Start, total: np.ndarray, piece: np.ndarray, work: Work
    ) -> None:
        self.solver, self.piece, self.work = solver, piece, work
        self.guess = here.algebraics
        self.steps_left = min(LIMITS.max_steps, solver.problem.max_steps - work.steps)
        self.rates_left = LIMITS.rates_per_step * self.steps_left
        self.start = np.concatenate([here.states, total])
        self.numbers = solver.problem.numbers()

    def _evaluate(self, time: float, x: np.ndarray, z: np.ndarray) -> list[ca.DM]:
        return evaluate(self.solver.function, x, z, time, self.piece, self.numbers)

    def _algebraics(self, time: float, x: np.ndarray) -> np.ndarray:
        """Algebraic unknowns (nz,) of these states, starting from those last found."""
        if not self.guess.size:
            return self.guess

        def constraints(z: np.ndarray) -> tuple[np.ndarray, ca.DM]:
            _, defect, _, slope, *_ = self._evaluate(time, x, z)
            return np.array(defect).ravel(), slope

        self.guess = newton(constraints, self.guess)
        return self.guess

    def _rates(self, time: float, y: np.ndarray) -> np.ndarray:
        self.work.residual_calls += 1
        self.rates_left -= 1
        if self.rates_left < 0:
            raise self.solver.step_limit_reached(time)
        x = y[: self.solver.states]
        return np.array(self._evaluate(time, x, self._algebraics(time, x))[0]).ravel()

    def _jacobian(self, time: float, y: np.ndarray) -> np.ndarray:
        """d rates/d y with the algebraic unknowns following (n, n)."""
        self.work.jacobian_calls += 1
        x = y[: self.solver.states]
        _, _, by_z, slope, by_x, pull = self._evaluate(time, x, self._algebraics(time, x))
        own = np.array(by_x.full())
        if self.guess.size:
            own -= by_z.full() @ np.linalg.solve(slope.full(), pull.full())
        return np.hstack([own, np.zeros((len(y), len(y) - len(x)))])

    def follow(self, begin: int, end: int) -> list[np.ndarray]:
        """States, algebraic unknowns and integrals at edges begin+1..end, or fewer."""
        from scipy.integrate import Radau as ScipyRadau

        edges = self.solver.problem.schedule.edges
        allowed = np.full(len(self.start), LIMITS.untested_tolerance)
        allowed[: self.solver.states] = self.solver.tolerance
        method = ScipyRadau(
            self._rates,
            edges[begin],
            self.start,
            edges[end],
            rtol=max(self.solver.tolerance, LIMITS.min_rtol),
            atol=allowed,  # type: ignore[arg-type]
            jac=self._jacobian,
        )
        found: list[np.ndarray] = []
        while len(found) < end - begin:
            if self.steps_left <= 0:
                raise self.solver.step_limit_reached(method.t)
            self.steps_left -= 1
            if method.step() is not None and method.status == "failed":
                break
            self.work.steps += 1
            if self.work.progress is not None:
                self.work.progress(method.t)
            dense = method.dense_output()
            while len(found) < end - begin and edges[begin + 1 + len(found)] <= method.t:
                time = edges[begin + 1 + len(found)]
                y = dense(time)
                z = self._algebraics(time, y[: self.solver.states])
                found.append(np.insert(y, self.solver.states, z))
        return found


def _reduced(e: Formulas) -> ca.Function:
    """(x, z, t, pieces, parameters) -> rates and defects with their four Jacobians.

    In the order: rates (states, then integrals), defects, d rates/d z, d defects/d z,
    d rates/d x, d defects/d x.
    """
    x, z = e.states.vector, e.algebraics.vector
    rates = ca.vertcat(e.ode, e.quadrature)
    results = [rates, e.alg, *(jacobian(f, v) for v in (z, x) for f in (rates, e.alg))]
    return ca.Function("reduced", [x, z, e.time, e.pieces, e.parameters], results)
