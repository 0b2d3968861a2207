"""One step with contact, in parts of several lengths, and its error.

Where every contact goes on as it is, implicit Euler steps of several lengths are extrapolated, to
as high an order as the tolerance needs: all of them satisfy the same linear conditions of contact,
and so does what is extrapolated. Where a contact closes, opens, sticks or slips, two Euler steps
of half the length are taken as they are.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.unknowns import Block
from viscodesign.physics.friction_problem import ContactState
from viscodesign.solve.contact_euler import ContactEuler, ContactPose
from viscodesign.solve.problem import Problem
from viscodesign.solve.statics import Instant


@dataclass(frozen=True)
class ExtrapolationControl:
    """Numbers that steer the extrapolation."""

    substeps: tuple[int, ...] = (1, 2, 3, 4)
    """Parts into which a smooth step is cut, once for each order."""
    early_share: float = 0.1
    """Error, in tolerances, below which no higher order is tried."""
    penetration_m: float = 1e-7
    """Distance from the surface, to either side, of an extrapolated point that touches it."""
    penetration_share: float = 0.01
    """The same, relative to the tip error that the tolerance allows."""


EXTRAPOLATION = ExtrapolationControl()


@dataclass(frozen=True)
class Way:
    """A way along which instants are known."""

    at: Callable[[float], Instant]
    """The instant at a place on it."""
    begin: float
    end: float
    seconds: float
    """Duration per length of the way: 1 in time, 0 where the inlets change at once."""


class StepNorm:
    """How far two solutions of a step are apart."""

    def __init__(self, problem: Problem, tolerance: float) -> None:
        equations = problem.equations
        states = [*equations.states.blocks.values()][:-1]  # the last are the forces of contact
        blocks = itertools.chain(states, equations.algebraics.blocks.values())
        self._integrations = np.concatenate([_integrations(block) for block in blocks])
        self._time = equations.motion_time
        self.tolerance = tolerance
        self.penetration_m = min(
            EXTRAPOLATION.penetration_m,
            EXTRAPOLATION.penetration_share * tolerance * problem.body.length,
        )
        """Beside the tolerance it must not count that the next step takes out what is inside."""

    def distance(self, one: np.ndarray, other: np.ndarray, duration: float) -> float:
        """Largest difference of unknowns (n,) after a step [s], in their sizes.

        What is integrated counts as far as the step integrates it.
        """
        share = min(1.0, duration / self._time)
        weights = np.where(self._integrations == 0, 1.0, 0.0)
        if share > 0:
            finite = np.isfinite(self._integrations)
            weights[finite] = share ** self._integrations[finite]
        return float(np.max(weights * np.abs(one - other) / (1 + np.abs(other)), initial=0.0))


class StepAttempt:
    """A step from a place on a way."""

    def __init__(
        self,
        euler: ContactEuler,
        norm: StepNorm,
        pose: ContactPose,
        way: Way,
        begin: float,
        step: float,
    ) -> None:
        self.euler, self.norm, self.pose, self.way = euler, norm, pose, way
        self.begin, self.step = begin, step
        self._end = pose.unknowns
        """The best known of the unknowns at the end of the step."""

    def extrapolated(self) -> tuple[ContactPose, float, int] | None:
        """The pose, its error, and the order by which that falls.

        None where a contact changes within the step. Raises `StepError`.
        """
        rows: list[list[np.ndarray]] = []
        count = len(self.pose.unknowns)
        error = np.inf
        for parts in EXTRAPOLATION.substeps:
            poses = self._in_parts(parts)
            if any(np.any(p.touching != self.pose.touching) for p in poses):
                return None
            row = [np.concatenate([poses[-1].unknowns, poses[-1].integrals])]
            for k, before in enumerate(rows[-1] if rows else [], start=1):
                ratio = parts / EXTRAPOLATION.substeps[len(rows) - k]
                row.append(row[-1] + (row[-1] - before) / (ratio - 1))
            rows.append(row)
            if len(row) > 1:
                error = self._apart(row[-2][:count], row[-1][:count])
            if error <= EXTRAPOLATION.early_share * self.norm.tolerance:
                break
        best = rows[-1][-1]
        found = replace(self.pose, unknowns=best[:count], integrals=best[count:])
        found = self.euler.located(found, self.way.at(self.begin + self.step))
        if not self._holds(found):
            return None
        return found, error, len(rows)

    def halved(self) -> tuple[ContactPose, float, int]:
        """The same by two Euler steps. Raises `StepError`."""
        whole, half = self._in_parts(1)[-1], self._in_parts(2)[-1]
        return half, self._apart(whole.unknowns, half.unknowns), 2

    def _in_parts(self, parts: int) -> list[ContactPose]:
        """Poses after each of some equal Euler steps."""
        poses, way = [self.pose], self.way
        origin = self.pose.unknowns
        for k in range(1, parts + 1):
            at = way.at(self.begin + self.step * k / parts)
            guess = origin + (self._end - origin) * k / parts
            duration = way.seconds * self.step / parts
            poses.append(self.euler(poses[-1], at, duration, guess))
        self._end = poses[-1].unknowns
        return poses[1:]

    def _holds(self, pose: ContactPose) -> bool:
        """Whether an extrapolated pose satisfies the conditions of contact."""
        is_open = pose.touching == ContactState.OPEN
        forces = pose.unknowns[self.euler.count :]
        normal = forces[: len(is_open)]
        depth = np.where(is_open, -pose.gaps, np.abs(pose.gaps) - self.norm.penetration_m)
        slack = self.euler.slack(forces)
        return bool(np.all(depth <= 0) and np.all(normal >= 0) and np.all(slack >= 0))

    def _apart(self, one: np.ndarray, other: np.ndarray) -> float:
        own = slice(0, self.euler.count)
        duration = self.way.seconds * self.step
        return self.norm.distance(one[own], other[own], duration)


def _integrations(block: Block) -> np.ndarray:
    """How many times every unknown of a block is integrated; infinite where it is not tested."""
    traits = block.traits
    untested = traits.is_noisy or traits.is_integral
    return np.full(block.count, np.inf if untested else traits.integrations)
