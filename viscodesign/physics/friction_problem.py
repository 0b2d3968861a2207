"""Contacts in a plane: who is open, sticks or slides, and the forces that go with it.

For contact forces f the linearised motion is r = W f + r_free: gaps g, then slips s. The forces are
sought that satisfy

    0 <= g, 0 <= n, g n = 0;   |t| <= mu n;   s > 0 => t = -mu n,   s < 0 => t = +mu n,

where n and t are the normal and tangential parts of f. With as many contacts as a robot has feet
the states of all contacts are few: given them, forces follow from one linear system, and whether
they satisfy every condition is plain. The states are sought by pivoting from a guess, then
near it, then by Gauss-Seidel sweeps over the contacts, and at last by trying all of them: the
answer is exact.

Source: the conditions are those of Signorini and Coulomb, as in J. J. Moreau, Unilateral contact
and dry friction in finite freedom dynamics, 1988.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from enum import IntEnum

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.storage.cached_property import cached_property


class ContactState(IntEnum):
    """What a contact does."""

    OPEN = 0
    STICK = 1
    FORWARD = 2
    """Slides towards positive slip."""
    BACKWARD = 3


OPEN, STICK, FORWARD, BACKWARD = map(int, ContactState)
EVERY = (OPEN, STICK, FORWARD, BACKWARD)
DIRECTION = (0.0, 0.0, 1.0, -1.0)
"""Sign of the slip in each state; 0 where there is none to speak of."""
MAX_PIVOTS = 30
MAX_SWEEPS = 40
MAX_CONTACTS_TRIED = 7
"""Contacts of which all states are tried: 4 states each."""
VIOLATION_REL_TOL = 1e-10
"""Violation of a condition, relative to the largest number of its kind."""

States = tuple[int, ...]


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
    friction: Sequence[float]
    tries_all: bool = True
    """Whether all states are tried where no others are found."""

    @property
    def count(self) -> int:
        """Number of contacts."""
        return len(self.friction)

    def solve(self, guess: Sequence[int] | None = None) -> tuple[np.ndarray, States]:
        """Forces (2c,), normal then tangential, and states (c,).

        ``guess``: states from which to begin. Raises `ContactError`.
        """
        for states in self._candidates(guess):
            forces, better = self._judged(states)
            if forces is not None and better == states:
                return forces, states
        raise ContactError("no contact states satisfy Signorini's and Coulomb's conditions")

    def _candidates(self, guess: Sequence[int] | None) -> Iterator[States]:
        """States that may be the solution, the likeliest first."""
        start = (OPEN,) * self.count if guess is None else tuple(map(int, guess))
        yield from self._pivoted(start, one_by_one=False)
        yield from self._pivoted(start, one_by_one=True)
        yield from _neighbours(start)
        swept = self._swept()
        yield swept
        yield from self._pivoted(swept, one_by_one=True)
        if self.tries_all and self.count <= MAX_CONTACTS_TRIED:
            yield from itertools.product(EVERY, repeat=self.count)

    def forces(self, states: States) -> np.ndarray | None:
        """Forces (2c,) for given states; None where they are not determined.

        A row each: the gap of a closed contact is zero, or its normal force; the slip of one that
        sticks, or what friction leaves of Coulomb's law.
        """
        c, matrix, right = self.count, np.eye(2 * self.count), np.zeros(2 * self.count)
        rows = [k for k in range(c) if states[k] != OPEN]
        rows += [c + k for k in range(c) if states[k] == STICK]
        matrix[rows], right[rows] = self._scaled[rows], self._scaled_free[rows]
        for k in range(c):
            if states[k] > STICK:
                matrix[c + k, k] = DIRECTION[states[k]] * self.friction[k]
        try:
            return np.linalg.solve(matrix, right)
        except np.linalg.LinAlgError:
            return None

    @cached_property
    def _size(self) -> float:
        """Size of the compliance."""
        return float(np.mean(np.abs(np.diag(self.compliance)))) or 1.0

    @cached_property
    def _scaled(self) -> np.ndarray:
        return self.compliance / self._size

    @cached_property
    def _scaled_free(self) -> np.ndarray:
        return -self.free / self._size

    @cached_property
    def _shortest(self) -> float:
        """Motion that counts as none."""
        return VIOLATION_REL_TOL * (float(np.max(np.abs(self.free))) or 1.0)

    def _pivoted(self, states: States, *, one_by_one: bool) -> Iterator[States]:
        """States that are corrected until they hold, or come round again."""
        seen: set[States] = set()
        while states not in seen and len(seen) < MAX_PIVOTS:
            seen.add(states)
            yield states
            forces, better = self._judged(states)
            if forces is None:
                return
            states = _first_change(states, better) if one_by_one else better

    def _judged(self, states: States) -> tuple[np.ndarray | None, States]:
        """Forces for given states, and the states that they call for."""
        if states not in self._known:
            forces = self.forces(states)
            self._known[states] = forces, () if forces is None else self._better(states, forces)
        return self._known[states]

    @cached_property
    def _known(self) -> dict[States, tuple[np.ndarray | None, States]]:
        """States that were judged before."""
        return {}

    def _better(self, states: States, forces: np.ndarray) -> States:
        """The states that forces call for; the same where they are as they should be."""
        c, motion = self.count, (self.compliance @ forces + self.free).tolist()
        along = forces.tolist()
        least = VIOLATION_REL_TOL * (max(map(abs, along)) or 1.0)
        return tuple(
            self._better_one(k, states[k], along[k], along[c + k], motion[k], motion[c + k], least)
            for k in range(c)
        )

    def _better_one(
        self,
        k: int,
        state: int,
        normal: float,
        along: float,
        gap: float,
        slip: float,
        least: float,
    ) -> int:
        if state == OPEN:
            return STICK if gap < -self._shortest else OPEN
        if normal < -least:
            return OPEN
        if state == STICK:
            if abs(along) - self.friction[k] * normal <= least:
                return STICK
            return BACKWARD if along > 0 else FORWARD
        return STICK if DIRECTION[state] * slip < -self._shortest else state

    def _swept(self) -> States:
        """States after Gauss-Seidel sweeps over the contacts, each solved exactly by itself."""
        forces, states, own = np.zeros(2 * self.count), [OPEN] * self.count, self._single
        for _ in range(MAX_SWEEPS):
            before = forces.copy()
            for k, (places, block) in enumerate(own):
                rest = self.compliance[places] @ forces - block @ forces[places] + self.free[places]
                single = FrictionProblem(block, rest, (self.friction[k],))
                for state in EVERY:
                    found, better = single._judged((state,))
                    if found is not None and better == (state,):
                        forces[places], states[k] = found, state
                        break
            if np.max(np.abs(forces - before)) <= VIOLATION_REL_TOL * np.max(np.abs(forces)):
                break
        return tuple(states)

    @cached_property
    def _single(self) -> list[tuple[list[int], np.ndarray]]:
        """Places of every contact, and its part of the compliance (2, 2)."""
        places = [[k, self.count + k] for k in range(self.count)]
        return [(own, self.compliance[np.ix_(own, own)]) for own in places]


def _neighbours(states: States) -> Iterator[States]:
    """States in which one contact differs, then two."""
    for changed in (1, 2):
        for places in itertools.combinations(range(len(states)), changed):
            for others in itertools.product(EVERY, repeat=changed):
                made = list(states)
                for place, other in zip(places, others, strict=True):
                    made[place] = other
                yield tuple(made)


def _first_change(states: States, better: States) -> States:
    """The states with the first of the changes alone."""
    for k, (own, other) in enumerate(zip(states, better, strict=True)):
        if own != other:
            return (*states[:k], other, *states[k + 1 :])
    return states
