"""Rodas5P, a Rosenbrock method, with a whole step as one compiled formula.

BDF of order three and above is not stable for undamped vibrations; this method is, at
order five. A step has one Jacobian, one factorisation and eight stages, no iteration.
The factorisation is written out as formulas, so that a step is one call without any search.
"""

from __future__ import annotations

import time as clock
from dataclasses import dataclass
from typing import Any, ClassVar

import casadi as ca
import numpy as np

from viscodesign.errors import SolveError
from viscodesign.model.equations import Equations, Formulas
from viscodesign.model.jacobian import jacobian
from viscodesign.native import rodas
from viscodesign.solve.numerics.symbolic_lu import SymbolicLU, has_whole_diagonal
from viscodesign.solve.problem import Bound, Problem
from viscodesign.solve.solvers.base import Columns, Solver, Work, smooth_stretches
from viscodesign.solve.statics import Start, consistent

SX = ca.SX


@dataclass(frozen=True)
class StepControl:
    """Numbers that steer the step size."""

    first_step: float = 1e-3
    """In time scales of the rod."""
    min_step: float = 1e-14
    """In durations of the run; below it, the run ends."""
    safety: float = 0.9
    max_factor: float = 5.0
    min_factor: float = 0.2
    """Largest and smallest ratio of a step to the one before."""
    min_steps_per_stretch: int = 50
    """Steps that a stretch of smooth input takes at least, if its swings are short."""
    memory: float = 0.08
    """Exponent of the last error in the next step (a PI controller)."""
    max_unknowns: int = 1_000
    """Up to which it is offered where another solver failed."""


CONTROL = StepControl()


class Rosenbrock(Solver):
    """Steps of Rodas5P, as long as the embedded error allows."""

    name: ClassVar[str] = "rosenbrock"
    order: ClassVar[int] = 20
    title: ClassVar[str] = "Rodas5P: Rosenbrock of order 5, A-stable, exact Jacobian"
    # The largest over a hundred scenes; typically it is below one.
    tip_error_per_tolerance: ClassVar[float] = 5.0

    def __init__(self, problem: Problem, tolerance: float) -> None:
        super().__init__(problem, tolerance)
        equations = problem.equations
        began = clock.perf_counter()
        self.step = RosenbrockStep(equations)
        self.build_s = clock.perf_counter() - began
        self.size: float | None = None
        self.states = equations.states.count
        self.unknowns = problem.unknowns
        self._powers = _weight_powers(equations)

    @classmethod
    def takes(cls, problem: Problem) -> bool:
        """Its elimination pivots on the diagonal only."""
        return has_whole_diagonal(problem.equations.algebraic_function.sparsity_out(1))

    @classmethod
    def fits(cls, problem: Problem) -> bool:
        """Its formulas are long: generating them for a thousand unknowns takes seconds."""
        return problem.unknowns <= CONTROL.max_unknowns

    def __call__(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve the stretches of smooth input in first..stop one after the other."""
        work.compile_s, self.build_s = work.compile_s + self.build_s, 0.0
        columns: list[np.ndarray] = []
        total = np.zeros(self.problem.equations.quadrature.numel())
        failure: SolveError | None = None
        for begin, end in smooth_stretches(self.problem.schedule.pieces, first, stop):
            try:
                here = consistent(
                    self.problem,
                    here,
                    self.problem.schedule.edges[begin],
                    self.problem.schedule.pieces[begin],
                    self.before(begin),
                )
            except SolveError as error:
                failure = error
                break
            y = np.concatenate([here.states, here.algebraics, total])
            found, failure = self._stretch(y, begin, end, work)
            columns += found
            if failure is not None:
                break
            x, z = found[-1][: self.states], found[-1][self.states : self.unknowns]
            here, total = Start(x, z), found[-1][self.unknowns :]
        if not columns:
            return self.nothing(), failure
        x, z, q = np.split(np.array(columns).T, [self.states, self.unknowns])
        return (x, z, q), failure

    def _stretch(
        self, y: np.ndarray, begin: int, end: int, work: Work
    ) -> tuple[list[np.ndarray], SolveError | None]:
        """Unknowns at edges begin+1..end, or as many as possible."""
        schedule = self.problem.schedule
        edges, whole = schedule.edges, schedule.edges[-1]
        self.step.bind(schedule.pieces[begin], self.problem.numbers())
        time, last = edges[begin], edges[end]
        size = self._first_size(last - time)
        # No step is longer than a swing of the input, however smooth all was before; a swing
        # far shorter than the stretch has corners of its own.
        largest = max(
            self.problem.equations.swing_time, (last - time) / CONTROL.min_steps_per_stretch
        )
        found: list[np.ndarray] = []
        before = 1.0
        for _ in range(max(self.problem.max_steps - work.steps, 1)):
            remaining = last - time
            final = size >= remaining * (1 - 1e-9)
            taken = (
                remaining if final else min(size, remaining / 2) if size > remaining / 2 else size
            )
            after, stages = self.step(y, time, taken)
            work.steps += 1
            work.residual_calls += rodas.STAGES
            work.jacobian_calls += 1
            error = self._error(y, after, stages[-1], taken)
            if not error <= 1.0:
                size = taken * _factor(error, 1.0)
                if size < CONTROL.min_step * whole:
                    return found, self.failure(
                        "step size fell below its minimum", begin + len(found)
                    )
                continue
            until = last if final else time + taken
            found += self._outputs(y, after, stages, time, until, begin + 1 + len(found), end)
            if final:
                self.size = max(size, taken) * min(_factor(error, before), 1.0 / CONTROL.safety)
                return found, None
            size = min(taken * _factor(error, before), largest)
            y, time, before = after, until, max(error, 1e-4)
        return found, self.step_limit_reached(time)

    def _first_size(self, stretch: float) -> float:
        if self.size is not None:
            return min(self.size, stretch)
        return CONTROL.first_step * min(self.problem.equations.motion_time, stretch)

    def _outputs(
        self,
        before: np.ndarray,
        after: np.ndarray,
        stages: np.ndarray,
        time: float,
        until: float,
        edge: int,
        end: int,
    ) -> list[np.ndarray]:
        """Unknowns at the edges inside a step, by its dense output."""
        edges = self.problem.schedule.edges[edge : end + 1]
        count = int(np.searchsorted(edges, until * (1 + 1e-15), side="right"))
        if count == 0:
            return []
        theta = np.minimum((edges[:count, None] - time) / (until - time), 1.0)
        d = rodas.DENSE @ stages
        inner = d[0] + theta * (d[1] + theta * d[2])
        dense = (1 - theta) * before + theta * (after + (1 - theta) * inner)
        dense[theta[:, 0] == 1.0] = after
        return list(dense)

    def _error(self, before: np.ndarray, after: np.ndarray, apart: np.ndarray, h: float) -> float:
        """Largest error estimate of an unknown, over what is allowed; infinite if not finite.

        Not their root mean square: many constant unknowns must not hide one that is wrong.
        Algebraic unknowns count too: nothing else brings them back to their equations.
        """
        count = self.unknowns
        if not (np.isfinite(after).all() and np.isfinite(apart).all()):
            return np.inf
        size = np.maximum(np.abs(before[:count]), np.abs(after[:count]))
        weighted = apart[:count] / (self.tolerance * (1 + size))
        # An error of a rate counts by what it amounts to within the step.
        lead = min(1.0, h / self.problem.equations.motion_time)
        for span, power in self._powers:
            weighted[span] *= lead**power if np.isfinite(power) else 0.0
        # Steps that resolve the unknowns well may still integrate their work badly.
        gained = np.abs(after[count:] - before[count:])
        worked = apart[count:] / (self.tolerance * (1 + gained))
        return float(max(np.max(np.abs(weighted)), np.max(np.abs(worked), initial=0.0)))


def _weight_powers(equations: Equations) -> list[tuple[slice, float]]:
    """Unknowns whose errors count less than their size, and by which power of the step."""
    groups = ((equations.states, 0), (equations.algebraics, equations.states.count))
    return [
        (slice(offset + block.span.start, offset + block.span.stop), block.traits.integrations)
        for group, offset in groups
        for block in group.blocks.values()
        if block.traits.integrations
    ]


def _factor(error: float, before: float) -> float:
    """Ratio of the next step to the one with this error."""
    if not np.isfinite(error):
        return CONTROL.min_factor
    memory = CONTROL.memory
    wanted = CONTROL.safety * max(error, 1e-10) ** (memory - 1 / rodas.ORDER) * before**-memory
    wanted = CONTROL.safety * max(error, 1e-10) ** (-1 / rodas.ORDER) if before == 1.0 else wanted
    return float(min(CONTROL.max_factor, max(CONTROL.min_factor, wanted)))


class RosenbrockStep:
    """One step as a compiled function, with arguments that stay in place between calls."""

    def __init__(self, equations: Equations) -> None:
        function = equations.compiled(step_function)
        self._arguments = [np.zeros(function.nnz_in(k)) for k in range(function.n_in())]
        self._after = np.zeros(function.nnz_out(0))
        self._stages = np.zeros(function.nnz_out(1))
        self._run = Bound(function, self._arguments, (self._after, self._stages))

    def bind(self, piece: np.ndarray, numbers: np.ndarray) -> None:
        """Set the inputs' coefficients and all parameters."""
        self._arguments[3][:] = piece
        self._arguments[4][:] = numbers

    def __call__(self, y: np.ndarray, time: float, size: float) -> tuple[np.ndarray, np.ndarray]:
        """Unknowns and integrals after a step, and the stages (STAGES, n)."""
        self._arguments[0][:] = y
        self._arguments[1][0] = time
        self._arguments[2][0] = size
        self._run()
        return self._after.copy(), self._stages.reshape(rodas.STAGES, -1).copy()


def step_function(equations: Formulas) -> ca.Function:
    """A whole step: (y, t, h, pieces, parameters) -> (y after it, stages).

    y (n,): states, algebraic unknowns, integrals of the rates; stages (STAGES n,).
    """
    integrals = SX.sym("integrals", equations.quadrature.numel())
    y = ca.vertcat(equations.states.vector, equations.algebraics.vector, integrals)
    rates = ca.vertcat(equations.ode, equations.alg, equations.quadrature)
    t, h, tail = equations.time, SX.sym("step"), [equations.pieces, equations.parameters]
    balances = ca.Function("balances", [y, t, *tail], [rates])
    mass = ca.DM.ones(y.numel())
    states, algebraics = equations.states.count, equations.algebraics.count
    mass[states : states + algebraics] = 0
    slopes, drift = jacobian(rates, y), ca.jacobian(rates, t)
    matrix = ca.sparsify(ca.diag(mass)) / (h * rodas.GAMMA) - slopes
    elimination = SymbolicLU(matrix.sparsity())
    factors = elimination.factors(matrix)
    stages: list[SX] = []
    for i in range(rodas.STAGES):
        place = y + _combined(rodas.A[i], stages)
        pull = balances(place, t + rodas.NODES[i] * h, *tail)
        pull += mass * _combined(rodas.C[i], stages) / h + h * rodas.SLOPES[i] * drift
        stages.append(elimination.solution(factors, pull))
    after = place + stages[-1]
    return ca.Function(
        "step", [y, t, h, *tail], [ca.densify(after), ca.densify(ca.vertcat(*stages))]
    )


def _combined(weights: tuple[float, ...], stages: list[SX]) -> Any:
    return sum((w * s for w, s in zip(weights, stages, strict=True)), SX(0))
