"""One implicit step in time with contact: positions and forces at its end agree with each other.

The equations of the step are linearised; what is left of them in the gaps and slips at the end of
the step is a problem of complementarity in the forces of contact alone, solved exactly. Newton's
iteration repeats both. Gaps are those of positions, so nothing sinks in; slips are counted from
the start of the step, so friction opposes what has slid. A massless rod takes the same step: its
positions follow at once.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.rod_equations import CONTACT_FORCES, RodForm
from viscodesign.physics.friction_problem import ContactError, ContactState, FrictionProblem, States
from viscodesign.solve.contact_formulas import (
    filled,
    friction_coefficients,
    implicit_residual,
    implicit_step,
    placed,
    powers_and_paths,
)
from viscodesign.solve.numerics.dense_or_sparse import Matrix, Solve, dense, solver_of
from viscodesign.solve.problem import Problem
from viscodesign.solve.statics import Instant, Start
from viscodesign.storage.cached_property import cached_property

CONE_TOL = 1e-12
"""Part of a force of friction by which it may exceed the most that there can be."""


@dataclass(frozen=True)
class ContactNewton:
    """Numbers that steer Newton's iteration."""

    correction_tol: float = 1e-9
    """Correction, in sizes of the unknowns, that need not be made any more."""
    round_off_tol: float = 1e-6
    """Correction below which stagnation is round-off of a stiff problem."""
    max_iterations: int = 15
    reuse_ratio: float = 0.1
    """Of a correction to the one before, above which derivatives are made anew."""
    max_move: float = 0.1
    """Move of a massless rod within a step, in lengths of the rod, beyond which it may have
    jumped to another equilibrium."""


NEWTON = ContactNewton()


class StepError(ArithmeticError):
    """A step has no solution that is found; a shorter one may have."""


@dataclass(frozen=True, eq=False)
class ContactPose:
    """Everything at one instant of a motion with contact."""

    unknowns: np.ndarray
    """Scaled: states but for the forces of contact, algebraic unknowns, these forces (n + 2c,)."""
    touching: np.ndarray
    """`ContactState` of every contact (c,)."""
    slips: np.ndarray
    """Paths of the contacts (c,) [m]."""
    gaps: np.ndarray
    """Distances from the surface (c,) [m]."""
    integrals: np.ndarray
    """Integrals of powers so far, over the size of an energy (nq,)."""


@dataclass(eq=False)
class _Slopes:
    """Derivatives of a step, its equations solved for the unknowns besides the forces."""

    duration: float
    solve: Solve
    """The inverse of the equations by these unknowns."""
    follow: np.ndarray
    """How the unknowns go with the forces (n, 2c)."""
    pull: np.ndarray
    """How gaps and slips go with the unknowns (2c, n)."""
    compliance: np.ndarray
    """How gaps and slips go with the forces, the unknowns following (2c, 2c)."""
    is_old: bool = False
    """Whether an iteration was done with them before."""

    @classmethod
    def of(cls, matrix: Matrix, count: int, duration: float) -> _Slopes:
        """From all derivatives. Raises `LinAlgError`."""
        solve = solver_of(matrix[:count, :count])
        follow = solve(dense(matrix[:count, count:]))
        pull = dense(matrix[count:, :count])
        return cls(duration, solve, follow, pull, dense(matrix[count:, count:]) - pull @ follow)


def _finite(rows: np.ndarray) -> np.ndarray:
    if not np.all(np.isfinite(rows)):
        raise np.linalg.LinAlgError("the residual is not finite there")
    return rows


class ContactEuler:
    """Implicit Euler steps of one problem."""

    def __init__(self, problem: Problem) -> None:
        equations = problem.equations
        self.problem = problem
        self.states = equations.states.blocks[CONTACT_FORCES].start
        """Number of states before the forces of contact, which are the last."""
        self.contacts = len(equations.contacts)
        self.count = self.states + equations.algebraics.count
        """Number of unknowns besides the forces of contact."""
        self._step = equations.taped(implicit_step)
        self._residual = equations.taped(implicit_residual)
        self._slopes: _Slopes | None = None
        """Derivatives that the next iteration may use."""
        self._powers = equations.taped(powers_and_paths)
        self._pattern = self._step.sparsities[1]
        self.calls = 0
        """Linearised systems since they were last counted."""

    # -- unknowns -------------------------------------------------------------

    def pose(self, here: Start, at: Instant) -> ContactPose:
        """A start as a pose that nothing is known of; contacts that carry a force stick."""
        x, forces = np.split(here.states, [self.states])
        unknowns = np.concatenate([x, here.algebraics, forces])
        closed = forces[: self.contacts] > 0
        states = np.where(closed, ContactState.STICK, ContactState.OPEN)
        _, paths = self._evaluate_powers([unknowns], at)
        gaps, slips = np.split(paths[0], 2)
        none = np.zeros(self.problem.equations.integrals)
        return ContactPose(unknowns, states, slips, gaps, none)

    def start(self, pose: ContactPose) -> Start:
        """A pose as states and algebraic unknowns."""
        x, z, forces = np.split(pose.unknowns, [self.states, self.count])
        return Start(np.concatenate([x, forces]), z)

    def located(self, pose: ContactPose, at: Instant) -> ContactPose:
        """The same with the gaps and slips of its unknowns."""
        _, paths = self._evaluate_powers([pose.unknowns], at)
        gaps, slips = np.split(paths[0], 2)
        return replace(pose, gaps=gaps, slips=slips)

    def _evaluate_powers(
        self, rows: list[np.ndarray], at: Instant
    ) -> tuple[np.ndarray, np.ndarray]:
        """Powers (m, nq), and gaps and slips (m, 2c) [m], at unknowns (m, n + 2c)."""
        x, z, forces = np.split(np.array(rows), [self.states, self.count], axis=1)
        given = [np.hstack([x, forces]), z, *self._tail(at)]
        found = self._powers.rows(given, len(rows))
        return tuple(map(filled, found, self._powers.sparsities))  # type: ignore[return-value]

    def _tail(self, at: Instant) -> list[np.ndarray]:
        return [np.atleast_1d(part).astype(float) for part in self.problem.tail(*at)]

    # -- the step -------------------------------------------------------------

    def __call__(
        self, here: ContactPose, at: Instant, duration: float, guess: np.ndarray
    ) -> ContactPose:
        """The pose at the end of a step, at the instant ``at``.

        ``duration``: of the step [s]; zero where the inlets change at once; ``guess``: unknowns
        from which the iteration begins (n + 2c,). Raises `StepError`.
        """
        y, touching = self._solved(here, at, duration, guess)
        self._check_move(here.unknowns, y)
        # Impulses do their work along the mean of the velocities before and after.
        before = np.concatenate([here.unknowns[: self.count], y[self.count :]])
        powers, paths = self._evaluate_powers([before, y], at)
        gaps, slips = np.split(paths[1], 2)
        work = duration * powers.sum(axis=0) / 2
        return ContactPose(y, touching, slips, gaps, here.integrals + work)

    def _solved(
        self, here: ContactPose, at: Instant, duration: float, guess: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Unknowns and states of the contacts at the end of a step, by Newton's iteration.

        Derivatives are those of an earlier step of the same length, as long as the corrections
        shrink fast with them.
        """
        known = np.zeros(self.count + 2 * self.contacts)
        known[: self.states] = here.unknowns[: self.states]
        known[self.count + self.contacts :] = here.slips
        y, states, size, tail = guess, tuple(here.touching.tolist()), np.inf, self._tail(at)
        if self._slopes is not None and self._slopes.duration != duration:
            self._slopes = None
        for _ in range(NEWTON.max_iterations):
            try:
                rows, slopes = self._around(y, tail, duration)
                step, states = self._correction(y, rows - known, slopes, states)
            except (np.linalg.LinAlgError, ContactError):
                break
            y = y + step
            before, size = size, float(np.max(np.abs(step[: self.count]), initial=0.0))
            is_stagnant = size <= NEWTON.round_off_tol and size > before / 2
            # The next correction of a converging iteration is smaller by at least this ratio.
            following = size * min(1.0, size / before) if np.isfinite(before) else size
            if following <= NEWTON.correction_tol or is_stagnant:
                return y, np.array(states)
            if slopes.is_old and size > NEWTON.reuse_ratio * before:
                self._slopes = None
            slopes.is_old = True
        self._slopes = None
        raise StepError(f"no solution of a step to t = {at[0]:.6g} s was found")

    def _around(
        self, y: np.ndarray, tail: list[np.ndarray], duration: float
    ) -> tuple[np.ndarray, _Slopes]:
        """Residuals, then gaps and slips (n + 2c,), and their derivatives, which may be older.

        Raises `LinAlgError` where there are none.
        """
        x, z, forces = np.split(y, [self.states, self.count])
        given = [np.concatenate([x, forces]), z, *tail, np.array([duration])]
        if self._slopes is not None:
            (rows,) = self._residual.rows(given, 1)
            return _finite(filled(rows, self._residual.sparsities[0])[0]), self._slopes
        self.calls += 1
        rows, entries = self._step.rows(given, 1)
        found = _finite(filled(rows, self._step.sparsities[0])[0])
        self._slopes = _Slopes.of(placed(entries[0], self._pattern), self.count, duration)
        return found, self._slopes

    def _correction(
        self, y: np.ndarray, rows: np.ndarray, slopes: _Slopes, states: States
    ) -> tuple[np.ndarray, States]:
        """The step (n + 2c,) by which the linearised equations and the laws of contact hold."""
        n = self.count
        back = slopes.solve(rows[:n, None])[:, 0]
        free = rows[n:] - slopes.pull @ back - slopes.compliance @ y[n:]
        forces, states = FrictionProblem(slopes.compliance, free, self._friction).solve(states)
        change = forces - y[n:]
        return np.concatenate([-back - slopes.follow @ change, change]), states

    @cached_property
    def _friction(self) -> list[float]:
        function = self.problem.equations.compiled(friction_coefficients)
        values = np.array(function(self.problem.equations.parameter_values)).ravel()
        return [float(value) for value in values]

    def slack(self, forces: np.ndarray) -> np.ndarray:
        """Friction that is left until every contact slides (c,), of scaled forces (2c,).

        Round-off counts as zero.
        """
        normal, along = np.split(forces, 2)
        slack = np.array(self._friction) * normal - np.abs(along)
        return np.where(np.abs(slack) <= CONE_TOL * np.abs(along), 0.0, slack)

    def _check_move(self, before: np.ndarray, after: np.ndarray) -> None:
        """Whether a rod without inertia has gone farther than its branch leads in one step."""
        equations = self.problem.equations
        span = equations.algebraics.branch_span
        if equations.rod_form is not RodForm.STATIC or span is None:
            return
        places = slice(self.states + span.start, self.states + span.stop)
        if np.max(np.abs(after[places] - before[places])) > NEWTON.max_move:
            raise StepError("the rod moved too far in one step")
