"""Equilibria at many times, each from the two before it, in native code."""

from __future__ import annotations

import numpy as np

from viscodesign.native.equilibria import FollowState, follow_equilibria
from viscodesign.native.machine import this_machine
from viscodesign.native.unavailable import NativeUnavailable
from viscodesign.solve.branch_following import (
    MAX_EXTRAPOLATION,
    SAME_BRANCH_DISTANCE,
    PreviousSolution,
)
from viscodesign.solve.problem import Problem


class EquilibriaInTurn:
    """The equilibria of a problem without states, as far as full steps of Newton's lead.

    Raises `NativeUnavailable` where there is no native code, or no such form of the equations.
    """

    def __init__(self, problem: Problem) -> None:
        this_machine()  # code that was made before may have been switched off
        local = problem.equations.local
        if local is None:
            raise NativeUnavailable("the equations are not sums of local terms")
        self._problem, self._local, self._compiled = problem, local, local.compiled
        self._assembly = self._compiled.bound(problem.numbers())

    def after(
        self,
        here: np.ndarray,
        time: float,
        previous: PreviousSolution | None,
        piece: np.ndarray,
        times: np.ndarray,
    ) -> np.ndarray:
        """Algebraic unknowns (m, nz) at the first m of ``times`` on one smooth piece of the inputs.

        ``here`` (nz,): those at ``time``; ``previous``: the solution before. They stay on the
        branch of stable equilibria, or end before the first that may not be on it: then m may be 0.
        """
        unknowns = self._problem.equations.algebraics
        before, time_before = previous or (here, time)
        state = FollowState(
            now=self._whole(here, time, piece),
            time=time,
            before=self._whole(before, time_before, piece),
            time_before=time_before,
        )
        with np.errstate(over="ignore", invalid="ignore"):
            found = follow_equilibria(
                self._assembly,
                self._compiled.lu,
                self._local.form.balances.mass,
                np.append(piece, 1.0),
                state,
                times,
                unknowns.branch_span or slice(0, 0),
                most_ahead=MAX_EXTRAPOLATION,
                near=SAME_BRANCH_DISTANCE,
            )[:, : unknowns.count]
        return found[: self._stable(found, times[: len(found)], piece)]

    def _whole(self, algebraics: np.ndarray, time: float, piece: np.ndarray) -> np.ndarray:
        """All unknowns of the native equations (n,), integrals zero."""
        given = [np.zeros(0), algebraics, np.array([time]), piece, self._problem.numbers()]
        (sums,) = self._local.start_by_tape.rows(given, 1)
        integrals = np.zeros(self._problem.equations.integrals)
        return np.concatenate([algebraics, sums[0], integrals])

    def _stable(self, found: np.ndarray, times: np.ndarray, piece: np.ndarray) -> int:
        """How many of the equilibria (m, nz) come before the first unstable one."""
        stability = self._problem.stability
        if stability is None or not len(found):
            return len(found)
        _, *rest = self._problem.tail(0.0, piece)
        shared = [np.atleast_1d(np.asarray(values, dtype=float)) for values in rest]
        given = [np.zeros(0), found, times[:, None], *shared]
        _, entries = self._problem.equations.constraints_by_tape.rows(given, len(found))
        unstable = np.flatnonzero(~stability.are_stable(entries))
        return int(unstable[0]) if len(unstable) else len(found)
