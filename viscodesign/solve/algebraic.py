"""The march of a problem without states."""

from __future__ import annotations

import casadi as ca
import numpy as np

from viscodesign.errors import SolveError
from viscodesign.model.formulation import Equations
from viscodesign.model.rod_equations import RodForm
from viscodesign.solve.newton import CONVERGED, MAX_ITERATIONS
from viscodesign.solve.problem import Problem
from viscodesign.solve.silence import silence
from viscodesign.solve.solvers.base import Columns, Solver, Work
from viscodesign.solve.statics import Start, consistent


PER_SWING = 32
"""Parts of an input's swing over which rates are integrated, each by itself, at first."""
MOST_PARTS = 20_000
"""Parts of one interval, at most."""
POINTS = 4
"""Points of Gauss in each."""
EXACT = 1e-7
"""Change of an integral, of the largest, at which it is taken as exact."""
MOST_HALVINGS = 7


class Algebraic(Solver):
    """Every output is a solution of its own, found from the one before."""

    # Not named, hence not among those to choose from: without states there is no choice.

    def __call__(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """Solve the constraints at edges first+1..stop."""
        # Pressures have one solution. A loaded rod may have several, and plain Newton would
        # leap from one to another where a fold ends the branch that it was on.
        if self.problem.equations.rod_form is RodForm.ARCS:
            found = self._at_once(here, first, stop)
            if found is not None:
                work.steps += stop - first
                return self._columns(found, first), None
        return self._one_by_one(here, first, stop, work)

    def _at_once(self, here: Start, first: int, stop: int) -> np.ndarray | None:
        """All of them by plain Newton in one call (nz, m); None where it fails for any."""
        problem, count = self.problem, stop - first
        if not problem.equations.algebraics.count:
            return np.zeros((0, count))
        march = problem.equations.compiled.get(("algebraic", count), lambda: _march(problem, count))
        schedule = problem.schedule
        try:
            with silence():
                result = march(
                    here.algebraics,
                    schedule.edges[None, first + 1 : stop + 1],
                    schedule.pieces[first:stop].T,
                    np.tile(problem.numbers()[:, None], count),
                )
        except RuntimeError:
            return None
        found = np.array(result)
        return found if np.isfinite(found).all() else None

    def _one_by_one(
        self, here: Start, first: int, stop: int, work: Work
    ) -> tuple[Columns, SolveError | None]:
        """The same with damped steps and loads raised bit by bit, as far as it goes."""
        schedule = self.problem.schedule
        found: list[np.ndarray] = []
        failure: SolveError | None = None
        for k in range(first, stop):
            try:
                piece = schedule.pieces[k]
                if k and np.any(piece != schedule.pieces[k - 1]):
                    here = consistent(self.problem, here, schedule.edges[k], piece, self.before(k))
                here = consistent(
                    self.problem, here, schedule.edges[k + 1], piece, (schedule.edges[k], piece)
                )
            except SolveError as error:
                failure = error
                break
            found.append(here.algebraics)
            work.steps += 1
        count = self.problem.equations.algebraics.count
        return self._columns(np.array(found).T.reshape(count, len(found)), first), failure

    def _columns(self, found: np.ndarray, first: int) -> Columns:
        count = found.shape[1]
        return np.zeros((0, count)), found, self._integrals(first, first + count)

    def _integrals(self, first: int, stop: int) -> np.ndarray:
        """Integrals of the rates over time from edge ``first`` to those that follow (nq, m).

        Where nothing has a rate of its own, rates are formulas of the time. Parts are halved
        until that changes little.
        """
        if not self.problem.equations.rates:
            return np.zeros((0, stop - first))
        edges = self.problem.schedule.edges[first : stop + 1]
        spacing = (self.problem.equations.swing_time or edges[-1]) / PER_SWING
        before = self._summed(first, edges, spacing)
        for _ in range(MOST_HALVINGS):
            spacing /= 2
            found = self._summed(first, edges, spacing)
            if np.max(np.abs(found - before)) <= EXACT * np.max(np.abs(found)):
                break
            before = found
        return found

    def _summed(self, first: int, edges: np.ndarray, spacing: float) -> np.ndarray:
        """The same by Gauss's rule on parts of every interval that are no longer than that."""
        equations = self.problem.equations
        parts = np.ceil(np.minimum(np.diff(edges) / spacing, MOST_PARTS)).astype(int)
        cuts = [np.linspace(a, b, n + 1) for a, b, n in zip(edges, edges[1:], parts, strict=False)]
        begins, ends = np.concatenate([c[:-1] for c in cuts]), np.concatenate([c[1:] for c in cuts])
        stop = first + len(parts)
        pieces = np.repeat(self.problem.schedule.pieces[first:stop], parts, axis=0)
        told = np.zeros((len(equations.rates), len(begins)))
        rates = equations.compiled.get("rates", lambda: _rates(equations))
        for place, weight in zip(*np.polynomial.legendre.leggauss(POINTS), strict=True):
            at = begins + (place + 1) / 2 * (ends - begins)
            values = np.array(rates(at[None, :], pieces.T, self.problem.numbers()))
            told += weight / 2 * (ends - begins) * values
        return np.asarray(np.cumsum(told, axis=1)[:, np.cumsum(parts) - 1])


def _rates(equations: Equations) -> ca.Function:
    """(time, pieces, numbers) -> rates over the size of an energy (nq,)."""
    arguments = [equations.time, equations.pieces, equations.parameters]
    return ca.Function("rates", arguments, [equations.quadrature])


def _march(problem: Problem, count: int) -> ca.Function:
    """(start, times (1, m), pieces (p, m), numbers (n, m)) -> unknowns (nz, m)."""
    equations = problem.equations
    given = ca.vertcat(equations.time, equations.pieces, equations.parameters)
    system = {"x": equations.algebraics.vector, "p": given, "g": equations.alg}
    options = {"abstol": CONVERGED, "abstolStep": CONVERGED, "max_iter": MAX_ITERATIONS}
    finder = ca.rootfinder("constraints", "newton", system, options | {"error_on_fail": True})
    z, t = ca.MX.sym("z", equations.algebraics.count), ca.MX.sym("t")
    pieces = ca.MX.sym("pieces", equations.pieces.numel())
    numbers = ca.MX.sym("numbers", equations.parameters.numel())
    after = finder(z, ca.vertcat(t, pieces, numbers))
    step = ca.Function("step", [z, t, pieces, numbers], [after])
    return step.mapaccum("march", count)
