"""95 % intervals by profile likelihood: how far a number may go while all others follow.

The ends are where the sum of squares, least over all other numbers, is 3.84 above that of the best
fit (chi-squared with one degree of freedom). Where the model is linear nearby, these are the ends
of the Gaussian interval. Source: D. J. Venzon and S. H. Moolgavkar, A method for computing
profile-likelihood-based confidence intervals, Applied Statistics 37 (1988).
"""

from __future__ import annotations

import math

import numpy as np

from viscodesign.calibration.misfit import Misfit
from viscodesign.calibration.spread import Spread
from viscodesign.errors import ViscodesignError
from viscodesign.interrupt import StopRequest
from viscodesign.lazy_dataclass import dataclass
from viscodesign.studies.least_squares import NumberRanges

NORMAL_95 = 1.959964
"""Standard deviations of a normal distribution that hold 95 %."""


@dataclass(frozen=True)
class ProfileRules:
    """How far and how closely a profile is followed."""

    close: float = 0.02
    """Error of an end, relative to its distance."""
    largest_move: float = 1.0
    """Step that is taken at once, beyond which the others are fitted again before it goes on."""
    most_profile_points: int = 12
    """Points of a profile on one side."""
    following_steps: int = 3
    """Gauss-Newton steps in which the others follow, at most."""
    most_derivatives: int = 10
    """Points at which all profiles together have derivatives of their own; elsewhere those at the
    best fit have to do."""
    followed_fall: float = 0.02
    """Fall of the squares by such a step, over 3.84, at which they have followed."""


RULES = ProfileRules()


@dataclass(frozen=True)
class IntervalEnd:
    """One end of an interval."""

    value: float
    is_open: bool
    """Whether the data set no end there: the number is then the last one that was tried."""


@dataclass(frozen=True)
class ProfilePoint:
    """Values on a profile."""

    values: np.ndarray
    rise: float
    """Sum of squares above that of the best fit."""


class Profiles:
    """Profiles of a misfit about its best fit.

    The other numbers are pulled to the spec's values as in the fit, the number itself is not: its
    interval is what the data say.
    """

    def __init__(
        self, misfit: Misfit, spread: Spread, ranges: NumberRanges, stop: StopRequest
    ) -> None:
        self._comparison, self._spread, self._stop = misfit, spread, stop
        self._low, self._high = ranges.low, ranges.high
        self._is_log = np.array([own.is_log for own in misfit.unknowns])
        self._derived: list[int] = []
        self.lowest = ProfilePoint(spread.values, 0.0)
        """The point of all profiles with the least squares: below 0, the best fit was none."""

    def ends(self, number: int) -> tuple[IntervalEnd, IntervalEnd]:
        """Both ends of the interval of a number; see `IntervalEnd`."""
        profile = _Profile(
            self._comparison,
            self._spread,
            number,
            self._spread.of_others_pulled(number),
            self._is_log,
            (self._low, self._high),
            self._derived,
        )
        low, high = (self._end(profile, sign) for sign in (-1.0, 1.0))
        return low, high

    def _end(self, profile: _Profile, sign: float) -> IntervalEnd:
        """Where the root of the rise is 1.96, by secants from the Gaussian end.

        The root is what is nearly linear in the step.
        """
        inside, done, outside = ProfilePoint(self._spread.values, 0.0), 0.0, math.inf
        step = min(NORMAL_95 * profile.deviation, RULES.largest_move)
        for _ in range(RULES.most_profile_points):
            if self._stop.asked:
                raise KeyboardInterrupt
            found = profile.at(inside.values, sign * (step - done))
            if found is not None and found.rise < self.lowest.rise:
                self.lowest = found
            root = math.inf if found is None else math.sqrt(max(found.rise, 0.0))
            if abs(root / NORMAL_95 - 1) < RULES.close:
                return IntervalEnd(profile.value_at(sign * step * NORMAL_95 / root), False)
            if found is None or root > NORMAL_95:
                outside = step
                before = math.sqrt(max(inside.rise, 0.0))
                share = 0.5 if found is None else (NORMAL_95 - before) / (root - before)
                step = done + float(np.clip(share, 0.1, 0.98)) * (step - done)
                if outside - done < RULES.close * outside:
                    return IntervalEnd(profile.value_at(sign * step), False)
                continue
            inside, done = found, step
            if profile.is_at_bound(found.values):
                return IntervalEnd(profile.value_at(sign * step), True)
            ahead = step * min(NORMAL_95 / max(root, 1e-3), 3.0)
            limit = step + max(RULES.largest_move, 0.5 * step)
            step = min(ahead, limit, (done + outside) / 2)
        return IntervalEnd(profile.value_at(sign * done), outside == math.inf)


class _Profile:
    """The least sum of squares over all other numbers, as a function of one."""

    def __init__(
        self,
        misfit: Misfit,
        spread: Spread,
        number: int,
        covariance: np.ndarray,
        is_log: np.ndarray,
        bounds: tuple[np.ndarray, np.ndarray],
        derived: list[int],
    ) -> None:
        self._comparison, self._spread, self._number = misfit, spread, number
        self._is_log, self._bounds = is_log, bounds
        self._derived = derived
        """Numbers whose profiles have had derivatives of their own, once for each."""
        self._others = [k for k in range(len(is_log)) if k != number]
        self._along = covariance[:, number] / covariance[number, number]
        self.deviation = float(np.sqrt(covariance[number, number]))
        """Standard deviation of its step, where the model is linear."""
        self._best = self._residual(spread.values)

    def value_at(self, step: float) -> float:
        """The number a step from the best fit."""
        return self._number_at(self._spread.values, step)

    def is_at_bound(self, values: np.ndarray) -> bool:
        """Whether the number has gone as far as it may."""
        own = values[self._number]
        return own in (self._bounds[0][self._number], self._bounds[1][self._number])

    def at(self, near: np.ndarray, step: float) -> ProfilePoint | None:
        """The profile a step from a point on it; None where the scene has no solution there."""
        moved = self._stepped(near, self._along * step)
        moved[self._number] = self._number_at(near, step)
        try:
            return self._followed(moved)
        except ViscodesignError:
            return None

    def _number_at(self, near: np.ndarray, step: float) -> float:
        k, value = self._number, float(near[self._number])
        size = float(self._spread.sizes[k])
        moved = value * math.exp(step) if self._is_log[k] else value + step * size
        return float(np.clip(moved, self._bounds[0][k], self._bounds[1][k]))

    def _followed(self, values: np.ndarray) -> ProfilePoint:
        """The point after Gauss-Newton steps of the other numbers."""
        jacobian = self._without_own(self._spread.jacobian)
        point, residual = self._point(values)
        for k in range(RULES.following_steps):
            if k and len(self._derived) < RULES.most_derivatives:
                # The derivatives at the best fit did not do.
                self._derived.append(self._number)
                sizes = self._comparison.sizes(point.values)
                jacobian = self._without_own(self._comparison.jacobian(point.values) * sizes)
            information = jacobian.T @ jacobian
            steps = np.zeros(len(values))
            steps[self._others] = -np.linalg.solve(information, jacobian.T @ residual)
            expected = -float(residual @ (jacobian @ steps[self._others]))
            if expected < RULES.followed_fall * NORMAL_95**2:
                break
            try:
                new, new_residual = self._point(self._stepped(point.values, steps))
            except ViscodesignError:
                continue
            if new.rise < point.rise:
                point, residual = new, new_residual
        return point

    def _without_own(self, jacobian: np.ndarray) -> np.ndarray:
        """Derivatives with respect to the other numbers, without the pull of this one."""
        found = jacobian[:, self._others]
        found[self._own_pull(len(found))] = 0.0
        return found

    def _own_pull(self, rows: int) -> slice:
        pulled = self._comparison.pulled
        if self._number not in pulled:
            return slice(0, 0)
        row = rows - len(pulled) + pulled.index(self._number)
        return slice(row, row + 1)

    def _residual(self, values: np.ndarray) -> np.ndarray:
        found = self._comparison(values)
        found[self._own_pull(len(found))] = 0.0
        return found

    def _point(self, values: np.ndarray) -> tuple[ProfilePoint, np.ndarray]:
        residual = self._residual(values)
        return ProfilePoint(values, float(residual @ residual - self._best @ self._best)), residual

    def _stepped(self, values: np.ndarray, steps: np.ndarray) -> np.ndarray:
        return np.asarray(np.clip(self._comparison.stepped(values, steps), *self._bounds))
