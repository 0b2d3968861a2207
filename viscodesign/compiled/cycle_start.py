"""The limit cycle that a run starts on, as a function of a scene's numbers with derivatives.

States x0 that come back after a period, phi(x0, p) = x0, move with the numbers p by the implicit
function theorem, (I - dphi/dx0) dx0 = dphi/dp dp. What every period keeps, such as an amount that
is sealed in, makes that matrix singular and is what it is in the equilibrium from which the cycle
is sought; so are integrals, which do not come back.
"""

from __future__ import annotations

import numpy as np

from viscodesign.compiled.problem_at import cycle_at
from viscodesign.compiled.scene_numbers import ProblemNumbers
from viscodesign.compiled.start import FoundEquilibrium, StartFunction
from viscodesign.compiled.stretch_slopes import StretchDots, StretchSlopes
from viscodesign.compiled.stretches import SolvedStretches, Stretches
from viscodesign.lazy_dataclass import dataclass
from viscodesign.solve.limit_cycle import CYCLE, limit_cycle
from viscodesign.solve.problem import Problem
from viscodesign.solve.solvers.rodas_native import NativeSteps
from viscodesign.solve.solvers.rosenbrock import Rosenbrock
from viscodesign.solve.statics import Start

KEPT = 1e-9
"""Singular value of I - dphi/dx0, relative to the largest, below which a period keeps something."""
NO_TIMES = np.zeros(0)


@dataclass(frozen=True)
class ReturnMap:
    """A period from the states of a cycle, and how these depend on where it ends."""

    period: SolvedStretches
    slopes: np.ndarray
    """(nx, nx): identity less the derivatives of the states after a period; rows of the identity
    for integrals."""
    bordered: np.ndarray
    """The same with a row and a column for everything that a period keeps."""

    def moved(self, ends: np.ndarray, kept: np.ndarray) -> np.ndarray:
        """Rates (d, nx) of the cycle's states, for those of the ends of a period from states at
        rest (d, nx), and of states (d, nx) that keep the same.
        """
        right = ends - kept @ self.slopes.T
        return np.asarray(kept + self._solved(self.bordered, right))

    def pulled(self, weights: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The opposite: weights (nx,) of both, for those of the cycle's states."""
        (ends,) = self._solved(self.bordered.T, weights[None])
        return ends, weights - self.slopes.T @ ends

    @staticmethod
    def _solved(matrix: np.ndarray, right: np.ndarray) -> np.ndarray:
        count, size = right.shape
        padded = np.concatenate([right, np.zeros((count, len(matrix) - size))], axis=1)
        return np.asarray(np.linalg.solve(matrix, padded.T).T[:, :size])


@dataclass
class FoundCycle:
    """Where a run starts on its limit cycle, and what its derivatives need."""

    start: Start
    equilibrium: FoundEquilibrium
    """From which the cycle was sought."""
    returns: ReturnMap | None = None
    """Made when it is first asked for."""


class CycleStart:
    """States and algebraic unknowns (nx + nz,) at the start of a limit cycle."""

    def __init__(
        self,
        steady: StartFunction,
        stretches: Stretches,
        slopes: StretchSlopes,
        tolerance: float,
    ) -> None:
        self._steady, self._tolerance = steady, tolerance
        self._stretches, self._slopes = stretches, slopes

    def __call__(self, problem: Problem, numbers: ProblemNumbers) -> FoundCycle:
        """Raises `SolveError` where no motion repeats, or none that attracts."""
        found = self._steady(problem, numbers)
        one = cycle_at(problem, numbers)
        cycle = limit_cycle(one, found.start, self._tolerance, Rosenbrock.name)
        return FoundCycle(cycle.start, found)

    def pull_back(
        self, problem: Problem, found: FoundCycle, numbers: ProblemNumbers, weights: np.ndarray
    ) -> ProblemNumbers:
        """Slopes of weights (nx + nz,) times the start by all numbers."""
        states, recurs = problem.equations.states.count, _recurs(problem)
        returns = self._returns(problem, found, numbers)
        ends, kept = returns.pulled(weights[:states])
        whole = np.zeros(problem.unknowns)
        whole[:states] = np.where(recurs, ends, 0.0)
        none = np.zeros((0, problem.unknowns))
        bars = self._slopes.pull_back(returns.period, numbers.parameters, none, whole)
        slopes = numbers.zeros()
        slopes.cycle_pieces[:], slopes.cycle_stops[:] = bars.pieces, bars.stops
        slopes.parameters[:] = bars.parameters
        whole[:states] = kept + np.where(recurs, 0.0, ends)
        return slopes.plus(self._steady.pull_back(problem, found.equilibrium, numbers, whole))

    def push_forward(
        self, problem: Problem, found: FoundCycle, numbers: ProblemNumbers, dots: ProblemNumbers
    ) -> np.ndarray:
        """Rates (d, nx + nz) of the start along d directions, the first axis of all ``dots``."""
        states, recurs = problem.equations.states.count, _recurs(problem)
        returns = self._returns(problem, found, numbers)
        moved = self._steady.push_forward(problem, found.equilibrium, numbers, dots)
        own = StretchDots(
            np.zeros_like(moved), dots.cycle_pieces, dots.cycle_stops, dots.parameters
        )
        _, ends = self._slopes.push_forward(returns.period, numbers.parameters, own)
        kept = moved[:, :states]
        rates = np.zeros_like(moved)
        rates[:, :states] = returns.moved(np.where(recurs, ends[:, :states], kept), kept)
        return rates

    def _returns(self, problem: Problem, found: FoundCycle, numbers: ProblemNumbers) -> ReturnMap:
        if found.returns is None:
            found.returns = self._return_map(problem, found.start, numbers)
        return found.returns

    def _return_map(self, problem: Problem, start: Start, numbers: ProblemNumbers) -> ReturnMap:
        """The period as it was solved for the cycle, along every state."""
        states, unknowns = problem.equations.states.count, problem.unknowns
        steps = NativeSteps(cycle_at(problem, numbers), CYCLE.tolerance_share * self._tolerance)
        period = self._stretches.over(
            steps, start, numbers.cycle_stops, numbers.cycle_pieces, NO_TIMES
        )
        still = numbers.zeros()
        along = [
            np.repeat(part[None], states, axis=0)
            for part in (still.cycle_pieces, still.cycle_stops, still.parameters)
        ]
        own = StretchDots(np.eye(states, unknowns), *along)
        _, ends = self._slopes.push_forward(period, numbers.parameters, own)
        returned = np.where(_recurs(problem)[:, None], ends[:, :states].T, 0.0)
        slopes = np.eye(states) - returned
        left, sizes, right = np.linalg.svd(slopes)
        kept = sizes <= KEPT * np.max(sizes, initial=0.0)
        corner = np.zeros((int(np.sum(kept)),) * 2)
        bordered = np.block([[slopes, right[kept].T], [left[:, kept].T, corner]])
        return ReturnMap(period, slopes, bordered)


def _recurs(problem: Problem) -> np.ndarray:
    """(nx,) Which states come back after a period; integrals do not."""
    found = np.ones(problem.equations.states.count, dtype=bool)
    for block in problem.equations.states.blocks.values():
        found[block.span] = not block.traits.is_integral
    return found
