"""Contacts in a plane: who is open, sticks or slides, and the forces that go with it.

For contact forces f the linearised motion is r = W f + r_free: gaps g, then slips s. The forces are
sought that satisfy

    0 <= g, 0 <= n, g n = 0;   |t| <= mu n;   s > 0 => t = -mu n,   s < 0 => t = +mu n,

where n and t are the normal and tangential parts of f. With as many contacts as a robot has feet
the states of all contacts are few: given them, forces follow from one linear system, and whether
they satisfy every condition is plain. The states are sought by pivoting from a guess, then by
Gauss-Seidel sweeps over the contacts, and at last by trying all of them: the answer is exact.

Source: the conditions are those of Signorini and Coulomb, as in J. J. Moreau, Unilateral contact
and dry friction in finite freedom dynamics, 1988.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from enum import IntEnum

import numpy as np

from viscodesign.lazy_dataclass import dataclass


class ContactState(IntEnum):
    """What a contact does."""

    OPEN = 0
    STICK = 1
    FORWARD = 2
    """Slides towards positive slip."""
    BACKWARD = 3


OPEN, STICK, FORWARD, BACKWARD = ContactState
DIRECTION = np.array([0.0, 0.0, 1.0, -1.0])
"""Sign of the slip in each state; 0 where there is none to speak of."""
MAX_PIVOTS = 30
MAX_SWEEPS = 300
MAX_CONTACTS_TRIED = 7
"""Contacts of which all states are tried: 4 states each."""
VIOLATION_REL_TOL = 1e-10
"""Of a condition, relative to the largest number of its kind."""


class ContactError(ArithmeticError):
    """No states of the contacts satisfy all conditions."""


@dataclass(frozen=True, eq=False)
class FrictionProblem:
    """Contacts whose motion is linear in their forces: r = W f + r_free.

    ``compliance`` W (2c, 2c) and ``free`` (2c,): c gaps, then c slips, as lengths or speeds;
    ``friction`` mu (c,) [1].
    """

    compliance: np.ndarray
    free: np.ndarray
    friction: np.ndarray

    @property
    def count(self) -> int:
        """Number of contacts."""
        return len(self.friction)

    def solve(self, guess: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
        """Forces (2c,), normal then tangential, and states (c,).

        ``guess``: states from which to begin. Raises `ContactError`.
        """
        for states in self._candidates(guess):
            forces = self.forces(states)
            if forces is not None and not self.violated(states, forces).any():
                return forces, states
        raise ContactError("no contact states satisfy Signorini's and Coulomb's conditions")

    def _candidates(self, guess: np.ndarray | None) -> Iterator[np.ndarray]:
        """States that may be the solution, the likeliest first."""
        start = np.full(self.count, OPEN) if guess is None else np.asarray(guess)
        yield from self._pivoted(start)
        swept = self._swept()
        yield swept
        yield from self._pivoted(swept)
        if self.count <= MAX_CONTACTS_TRIED:
            for states in itertools.product(ContactState, repeat=self.count):
                yield np.array(states)

    def forces(self, states: np.ndarray) -> np.ndarray | None:
        """Forces for given states; None where they are not determined."""
        c, closed = self.count, np.flatnonzero(states != OPEN)
        stuck = np.flatnonzero(states == STICK)
        found = np.zeros(2 * c)
        rows = np.concatenate([closed, c + stuck])
        if not len(rows):
            return found
        ratio = -DIRECTION[states] * self.friction
        columns = self.compliance[:, closed] + self.compliance[:, c + closed] * ratio[closed]
        matrix = np.concatenate([columns[rows], self.compliance[np.ix_(rows, c + stuck)]], axis=1)
        try:
            values = np.linalg.solve(matrix, -self.free[rows])
        except np.linalg.LinAlgError:
            return None
        found[closed] = values[: len(closed)]
        found[c:] = ratio * found[:c]
        found[c + stuck] = values[len(closed) :]
        return found

    def violated(self, states: np.ndarray, forces: np.ndarray) -> np.ndarray:
        """Contacts (c,) whose state the forces contradict."""
        return np.asarray(self._better(states, forces) != states)

    def _pivoted(self, states: np.ndarray) -> Iterator[np.ndarray]:
        """States that are corrected until they hold, or come round again."""
        seen = set()
        for _ in range(MAX_PIVOTS):
            if states.tobytes() in seen:
                return
            seen.add(states.tobytes())
            yield states
            forces = self.forces(states)
            if forces is None:
                return
            states = self._better(states, forces)

    def _better(self, states: np.ndarray, forces: np.ndarray) -> np.ndarray:
        """The states that forces call for; the same where they are as they should be."""
        c = self.count
        motion = self.compliance @ forces + self.free
        normal, along, gap, slip = forces[:c], forces[c:], motion[:c], motion[c:]
        least = VIOLATION_REL_TOL * (np.max(np.abs(forces)) or 1.0)
        shortest = VIOLATION_REL_TOL * (np.max(np.abs(self.free)) or 1.0)
        found = states.copy()
        found[(states == OPEN) & (gap < -shortest)] = STICK
        excess = np.abs(along) - self.friction * normal > least
        slides = (states == STICK) & excess
        found[slides] = np.where(along > 0, BACKWARD, FORWARD)[slides]
        found[(DIRECTION[states] * slip < -shortest) & (states > STICK)] = STICK
        found[(states != OPEN) & (normal < -least)] = OPEN
        return found

    def _swept(self) -> np.ndarray:
        """States after Gauss-Seidel sweeps over the contacts, each solved exactly by itself."""
        forces, states = np.zeros(2 * self.count), np.zeros(self.count, dtype=int)
        for _ in range(MAX_SWEEPS):
            before = forces.copy()
            for k in range(self.count):
                self._sweep_one(k, forces, states)
            if np.max(np.abs(forces - before)) <= VIOLATION_REL_TOL * np.max(np.abs(forces)):
                break
        return states

    def _sweep_one(self, k: int, forces: np.ndarray, states: np.ndarray) -> None:
        """Solve one contact with the forces of the others as they are."""
        own = [k, self.count + k]
        block = self.compliance[np.ix_(own, own)]
        rest = self.compliance[own] @ forces - block @ forces[own] + self.free[own]
        single = FrictionProblem(block, rest, self.friction[[k]])
        for state in ContactState:
            found = single.forces(np.array([state]))
            if found is not None and not single.violated(np.array([state]), found).any():
                forces[own], states[k] = found, state
                return
