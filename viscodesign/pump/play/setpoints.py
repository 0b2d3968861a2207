"""Goals for the next tick: where the course is then, and what the servos need to get there.

A servo of this kind gives an output in proportion to the distance from its goal: it stays behind
by what its load asks for, and by more the faster it goes. Both are made up for, the speed's share
beforehand and the load's as it is seen, so that the plunger is where the course says.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from viscodesign.pump.play.path import Course
from viscodesign.pump.play.pump import SPEED

SLOPE = 32.0
"""Distance from its goal at which a servo gives its full output [counts]: the initial value of
its compliance slopes (ROBOTIS e-manual)."""
GAIN = 0.25
"""Part of what a plunger is behind that is added a tick."""
LARGEST = 40.0
"""Of what is added for the load [counts]: beyond the slope nothing more is given anyway."""
UNSEEN = 1.0
"""Distance that is none: counts are whole, and gears have play."""
SPARE = 1.25
"""Of the speed register: a servo that is behind needs more than the course's speed."""


@dataclass
class SetPoints:
    """Of one course; keeps what it has learnt of each servo's load."""

    course: Course
    period: float
    """Of the ticks [s]."""
    free_speed: float
    """Of a servo without load [counts/s]."""
    behind: dict[int, float] = field(default_factory=dict)
    """By servo: what its load needs [counts]."""

    def learn(self, elapsed: float, positions: Mapping[int, int]) -> None:
        """Add part of what each plunger is behind the course.

        ``positions`` [counts] read at a time since the course began, ``elapsed`` [s].
        """
        wanted = self.course.goals(elapsed)
        for k, servo in enumerate(self.course.profile.servos):
            error = float(wanted[k]) - positions[servo]
            before = self.behind.setdefault(servo, 0.0)
            if abs(error) > UNSEEN:
                self.behind[servo] = min(max(before + GAIN * error, -LARGEST), LARGEST)

    def next(
        self, elapsed: float, goals: Mapping[int, int], reach: int
    ) -> tuple[dict[int, int], dict[int, float]]:
        """Goals [counts], within reach of those in force, and speeds [counts/s] to get there."""
        now, then = self.course.goals(elapsed), self.course.goals(elapsed + self.period)
        aims: dict[int, int] = {}
        speeds: dict[int, float] = {}
        for k, servo in enumerate(self.course.profile.servos):
            speed = float(then[k] - now[k]) / self.period
            aim = float(then[k]) + self.behind.get(servo, 0.0) + SLOPE * speed / self.free_speed
            step = min(max(round(aim) - goals[servo], -reach), reach)
            aims[servo] = goals[servo] + step
            # Slow ramps go smoothly at their own speed, not in jerks of one count.
            speeds[servo] = SPARE * max(abs(speed), (abs(step) - 1.0) / self.period) + SPEED
        return aims, speeds
