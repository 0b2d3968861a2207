"""A whole step of Rodas5P as one compiled formula, run by CasADi's virtual machine.

The factorisation is written out as formulas, so that a step is one call without any search.
Serves where native code cannot be had.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import casadi as ca
import numpy as np

from viscodesign.model.equations import Equations
from viscodesign.model.formulas import Formulas
from viscodesign.model.jacobian import jacobian
from viscodesign.model.row_blocks import Bound
from viscodesign.native import rodas
from viscodesign.solve.events import Crossing, EventWatch
from viscodesign.solve.numerics.symbolic_lu import SymbolicLU
from viscodesign.solve.problem import Problem, Schedule
from viscodesign.solve.solvers.base import Work
from viscodesign.solve.solvers.rodas_stretch import CONTROL, Reached, StretchSteps

SX = ca.SX


class FormulaSteps(StretchSteps):
    """Steps as calls of one function."""

    def __init__(self, problem: Problem, tolerance: float) -> None:
        super().__init__(problem, tolerance)
        self._step = RosenbrockStep(problem.equations)
        self._powers = self.powers()

    def __call__(
        self,
        schedule: Schedule,
        y: np.ndarray,
        begin: int,
        end: int,
        size: float | None,
        work: Work,
    ) -> Reached:
        edges, whole = schedule.edges, schedule.edges[-1]
        self._step.bind(schedule.pieces[begin], self.problem.numbers())
        time, last = edges[begin], edges[end]
        size = self.first_size(size, last - time)
        largest = self.largest_size(last - time)
        found: list[np.ndarray] = []
        before = 1.0
        watched, piece = [(time, y)], schedule.pieces[begin]
        progress = self.progress_watch(time)
        for tried in range(max(self.problem.max_steps - work.steps, 1)):
            if work.is_stopped():
                break
            crawl = progress.crawl(tried, time)
            if len(watched) > self.steps_at_once or crawl is not None:
                crossing = self._crossing(watched, piece)
                if crossing is not None or crawl is not None:
                    reached = self._reached(found, None, "", time)
                    return replace(reached, crossing=crossing, cause=crawl)
                del watched[:-1]
            remaining = last - time
            final = size >= remaining * (1 - 1e-9)
            taken = (
                remaining if final else min(size, remaining / 2) if size > remaining / 2 else size
            )
            after, stages = self._step(y, time, taken)
            work.steps += 1
            work.residual_calls += rodas.STAGES
            work.jacobian_calls += 1
            error = self._error(y, after, stages[-1], taken)
            if not error <= 1.0:
                size = taken * _factor(error, 1.0)
                if size < CONTROL.min_step * whole:
                    reached = self._reached(found, None, "step size fell below its minimum", time)
                    vanishing = EventWatch(self.problem).vanishing(time, piece, y)
                    crossing = self._crossing(watched, piece)
                    return replace(reached, crossing=crossing, cause=vanishing)
                continue
            until = last if final else time + taken
            inside = edges[begin + 1 + len(found) : end + 1]
            found += _outputs(y, after, stages, time, until, inside)
            watched.append((until, after))
            if final:
                size = max(size, taken) * min(_factor(error, before), 1.0 / CONTROL.safety)
                reached = self._reached(found, size, None, until)
                return replace(reached, crossing=self._crossing(watched, piece))
            size = min(taken * _factor(error, before), largest)
            y, time, before = after, until, max(error, 1e-4)
        crossing = self._crossing(watched, piece)
        return replace(self._reached(found, None, "", time), crossing=crossing)

    def _crossing(
        self, steps: list[tuple[float, np.ndarray]], piece: np.ndarray
    ) -> Crossing | None:
        """The first event at the ends of steps, the beginning of the first among them."""
        if self.watch is None:
            return None
        times, unknowns = zip(*steps, strict=True)
        return self.watch.crossing(np.array(times), piece, np.array(unknowns))

    def _reached(
        self, found: list[np.ndarray], size: float | None, failure: str | None, time: float
    ) -> Reached:
        width = self.problem.unknowns + self.problem.equations.integrals
        columns = np.array(found) if found else np.zeros((0, width))
        return Reached(columns, size, failure, time)

    def _error(self, before: np.ndarray, after: np.ndarray, apart: np.ndarray, h: float) -> float:
        """Largest error estimate of an unknown, over what is allowed; infinite if not finite.

        Not their root mean square: many constant unknowns must not hide one that is wrong.
        Algebraic unknowns count too: nothing else brings them back to their equations.
        """
        count = self.problem.unknowns
        if not (np.isfinite(after).all() and np.isfinite(apart).all()):
            return np.inf
        size = np.maximum(np.abs(before[:count]), np.abs(after[:count]))
        weighted = apart[:count] / (self.tolerance * (1 + size))
        # An error of a rate counts by what it amounts to within the step.
        lead = min(1.0, h / self.problem.equations.motion_time)
        weighted *= np.where(np.isfinite(self._powers), lead**self._powers, 0.0)
        # Steps that resolve the unknowns well may still integrate their work badly.
        gained = np.abs(after[count:] - before[count:])
        worked = apart[count:] / (self.tolerance * (1 + gained))
        return float(max(np.max(np.abs(weighted)), np.max(np.abs(worked), initial=0.0)))


def _outputs(
    before: np.ndarray,
    after: np.ndarray,
    stages: np.ndarray,
    time: float,
    until: float,
    edges: np.ndarray,
) -> list[np.ndarray]:
    """Unknowns at those of the next ``edges`` that lie inside a step, by its dense output."""
    count = int(np.searchsorted(edges, until * (1 + 1e-15), side="right"))
    if count == 0:
        return []
    theta = np.minimum((edges[:count, None] - time) / (until - time), 1.0)
    d = rodas.DENSE @ stages
    inner = d[0] + theta * (d[1] + theta * d[2])
    dense = (1 - theta) * before + theta * (after + (1 - theta) * inner)
    dense[theta[:, 0] == 1.0] = after
    return list(dense)


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
