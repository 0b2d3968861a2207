"""The way from where the axes are to the profile, and the set-points along it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import field, replace

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.play.axis import AxisLimits
from viscodesign.pump.profile import Profile

SHORTEST = 0.1  # of such a way [s]
LEARNING_RATE = 0.25  # part of the following error that is added to the goals in each tick
ROUNDING = 1.0  # beyond which a target lies outside of a range: targets are whole [steps]
SPEED_MARGIN = 1.25
"""Factor on the speeds that are sent: an axis that is behind needs more than the path's speed."""


def led_in(profile: Profile, present: Mapping[int, int], speed: float) -> Profile:
    """A profile behind a slow way to its first targets.

    ``present``: position of each axis [steps]; ``speed``: of that way [steps/s].
    """
    here = np.array([[float(present[axis]) for axis in profile.axes]])
    way = float(np.max(np.abs(profile.steps[0] - here), initial=0.0)) / speed
    # Not at once even where it is there already: times have to rise.
    begins = max(way, SHORTEST)
    return replace(
        profile,
        time=np.concatenate(([0.0], profile.time + begins)),
        steps=np.concatenate((here, profile.steps)),
        pressure=np.concatenate((profile.pressure[:1], profile.pressure)),
        begins=begins,
    )


def way_back(profile: Profile, goals: Mapping[int, int], home: int, speed: float) -> Profile:
    """From the goals in force to home at a speed [steps/s]; no pressure is expected on the way."""
    here = np.array([float(goals[axis]) for axis in profile.axes])
    steps = np.stack((here, np.full_like(here, home)))
    time = np.array([0.0, max(float(np.abs(here - home).max()) / speed, SHORTEST)])
    return Profile(profile.inlets, profile.axes, time, steps, np.zeros_like(steps), math.inf)


@dataclass
class SetPoints:
    """Goals for the next tick: where the path is then, and what the axes need to get there.

    An axis whose output is proportional to the distance from its goal lags by what its load needs,
    and by more the faster it goes. Both lags are compensated: that of the speed in advance, that of
    the load as it is observed.
    """

    path: Profile
    period: float
    """Time between two ticks [s]."""
    limits: AxisLimits
    behind: dict[int, float] = field(default_factory=dict)
    """By axis: what its load needs [steps]."""

    def learn(
        self, place: float, positions: Mapping[int, int], dead_band: float | None = None
    ) -> None:
        """Add part of each axis' following error, unless that is within a dead band [steps].

        ``positions`` [steps] as read when the axes should have been at a place [s].
        """
        for axis, goal in zip(self.path.axes, self.path.at(place), strict=True):
            error = float(goal) - positions[axis]
            dead_band = self.limits.dead_band if dead_band is None else dead_band
            lead = self.behind.setdefault(axis, 0.0)
            if abs(error) > dead_band:
                lead += LEARNING_RATE * error
                most = self.limits.largest_lead
                self.behind[axis] = min(max(lead, -most), most)

    def next(
        self, place: float, goals: Mapping[int, int], reach: int
    ) -> tuple[dict[int, int], dict[int, float]]:
        """Goals [steps], within reach of those in force, and speeds [steps/s] to get there."""
        now, then = self.path.at(place), self.path.at(place + self.period)
        aims: dict[int, int] = {}
        speeds: dict[int, float] = {}
        for k, axis in enumerate(self.path.axes):
            speed = float(then[k] - now[k]) / self.period
            lead = self.limits.lead_distance * speed / self.limits.top_speed
            aim = float(then[k]) + self.behind.get(axis, 0.0) + lead
            step = min(max(round(aim) - goals[axis], -reach), reach)
            aims[axis] = goals[axis] + step
            # Slow ramps go smoothly at their own speed, not in jerks of one step.
            speeds[axis] = SPEED_MARGIN * max(abs(speed), (abs(step) - 1.0) / self.period)
            speeds[axis] += self.limits.slowest_speed
        return aims, speeds
