"""Goals for the next tick: where the path is then, and what the servos need to get there.

A servo of this kind gives an output in proportion to the distance from its goal: it stays behind
by what its load asks for, and by more the faster it goes. Both are compensated, the speed's share
in advance and the load's as it is seen, so that the plunger is where the path says.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from viscodesign.pump.play.axis import AxisLimits
from viscodesign.pump.play.path import TargetPath

LEARNING_RATE = 0.25
"""Part of the following error that is added to the goals in each tick."""
LARGEST_LEAD = 40.0
"""Of what is added for the load [counts]: beyond the slope nothing more is given anyway."""
DEAD_BAND = 1.0
"""Following error that is none [counts]: counts are whole, and gears have play."""
SPEED_MARGIN = 1.25
"""Of the speed register: a servo that is behind needs more than the path's speed."""
SETTLED = 0.5
"""The same at the end of a path [counts]."""
SETTLE_SPEED = 45.0
"""At the end of a path [counts/s]."""
CATCH_UP = 1.5
"""A late stream goes along its path this many times as fast as planned, until it is in time."""


@dataclass
class PathProgress:
    """How far along its path a stream is: behind where ticks came late, then catching up."""

    period: float
    """Of the ticks [s]."""
    place: float = 0.0
    """Reached on the path [s]."""
    moment: float = 0.0
    """When, since the first tick [s]."""
    pace: float = 1.0
    """Of the last step: 1 is the planned speed."""

    def advance(self, elapsed: float) -> float:
        """The place for the tick at this time since the first one [s]."""
        since = min(elapsed - self.moment, self.period)
        step = min(elapsed - self.place, CATCH_UP * since)
        self.pace = max(step / since, 1.0) if since > 0.0 else 1.0
        self.place += step
        self.moment = elapsed
        return self.place

    def commanded(self, elapsed: float) -> float:
        """The place on the path to which the axes were sent by this time [s]."""
        return self.place + min(max(elapsed - self.moment, 0.0), self.period)

    @property
    def lag(self) -> float:
        """How far behind the plan the stream is [ticks]."""
        return (self.moment - self.place) / self.period


@dataclass
class SetPoints:
    """Goals along one path; keeps what it has learnt of each servo's load."""

    path: TargetPath
    period: float
    """Of the ticks [s]."""
    limits: AxisLimits
    behind: dict[int, float] = field(default_factory=dict)
    """By servo: what its load needs [counts]."""

    def learn(
        self, place: float, positions: Mapping[int, int], dead_band: float = DEAD_BAND
    ) -> None:
        """Add part of each plunger's following error, unless that is within a dead band [counts].

        ``positions`` [counts] as read when the plungers should have been at a place [s].
        """
        wanted = self.path.goals(place)
        for k, servo in enumerate(self.path.profile.servos):
            error = float(wanted[k]) - positions[servo]
            before = self.behind.setdefault(servo, 0.0)
            if abs(error) > dead_band:
                lead = before + LEARNING_RATE * error
                self.behind[servo] = min(max(lead, -LARGEST_LEAD), LARGEST_LEAD)

    def next(
        self, place: float, goals: Mapping[int, int], reach: int
    ) -> tuple[dict[int, int], dict[int, float]]:
        """Goals [counts], within reach of those in force, and speeds [counts/s] to get there."""
        now, then = self.path.goals(place), self.path.goals(place + self.period)
        aims: dict[int, int] = {}
        speeds: dict[int, float] = {}
        for k, servo in enumerate(self.path.profile.servos):
            speed = float(then[k] - now[k]) / self.period
            aim = (
                float(then[k])
                + self.behind.get(servo, 0.0)
                + self.limits.lead_distance * speed / self.limits.top_speed
            )
            step = min(max(round(aim) - goals[servo], -reach), reach)
            aims[servo] = goals[servo] + step
            # Slow ramps go smoothly at their own speed, not in jerks of one count.
            speeds[servo] = SPEED_MARGIN * max(abs(speed), (abs(step) - 1.0) / self.period)
            speeds[servo] += self.limits.slowest_speed
        return aims, speeds
