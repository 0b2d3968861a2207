"""Which servos give all the torque that they are allowed, and since when.

A servo that does so for long shuts itself off: it sets its torque limit to 0, and whoever
writes that register gives it its torque back, without a word. Between reading a servo and
writing to it some milliseconds pass. So nothing is written to one that has strained for long
enough to be about to shut itself off.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from viscodesign.pump.play.servo_state import ServoState
from viscodesign.pump.play.torque_limit import FULL

LONGEST = 0.2
"""Of strain, after which a torque limit is left alone [s]. After how long a servo shuts itself
off no manual says; that it is no sooner is an assumption."""
NEAR = 2
"""An output this close to its limit is at it [1/1023 of stall]."""


@dataclass
class Strain:
    """Of all servos, as they were last read."""

    limits: dict[int, int] = field(default_factory=dict)
    """Torque limits of servos that are well [1/1023 of stall]."""
    since: dict[int, float] = field(default_factory=dict)
    """When those that strain were first seen to [s of the clock]."""

    def note(self, states: Mapping[int, ServoState], moment: float) -> None:
        """What was read at a moment [s of the clock]."""
        self.limits = {
            servo: state.torque_limit
            for servo, state in states.items()
            if state.torque and state.torque_limit > 0 and not state.errors
        }
        straining = [servo for servo, state in states.items() if _strains(state)]
        self.since = {servo: self.since.get(servo, moment) for servo in straining}

    def writable(self, now: float) -> dict[int, int]:
        """Torque limits in force of those servos that may be given another one."""
        return {
            servo: limit
            for servo, limit in self.limits.items()
            if now - self.since.get(servo, now) < LONGEST
        }


def _strains(state: ServoState) -> bool:
    return abs(state.load) * FULL >= state.torque_limit - NEAR
