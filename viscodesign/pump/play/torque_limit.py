"""How much torque a servo is allowed: the guard that works when everything else is dead."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from viscodesign.pump.play.servo_state import ServoState
from viscodesign.pump.servo_motor import COUNT_ANGLE, SERVOS
from viscodesign.pump.syringe import shaft_torque, stall_pressure, stall_torque
from viscodesign.scene.pump import PumpSpec

ABOVE_CAP = 1.2
"""So that the cap in software acts first."""
FULL = 1023
NOTABLE = 32
"""A limit so much above what is needed is lowered [1/1023 of stall]: 4 kPa of a 100 mL syringe."""
LONGEST_SATURATION = 0.2
"""Of strain, after which a torque limit is left alone [s]. After how long a servo shuts itself
off no manual says; that it is no sooner is an assumption."""
SATURATION_MARGIN = 2
"""An output this close to its limit is at it [1/1023 of stall]."""


def torque_limit(pump: PumpSpec, speed: float = 0.0) -> int:
    """Torque limit register [1/1023 of stall] for the pressure cap, friction and a speed.

    It limits the output of the servo's controller, and along the straight line of a motor a
    part of that goes into its ``speed`` [counts/s]: a fast profile takes a looser guard.
    """
    servo = SERVOS[pump.servo]
    torque: float = shaft_torque(
        pump.max_pressure, pump.syringe_diameter, pump.pinion_diameter, pump.plunger_friction
    )
    share = torque / stall_torque(servo, pump.supply_voltage)
    share += speed / free_speed(pump)
    return min(math.ceil(FULL * ABOVE_CAP * share), FULL)


def following_limit(held: int, needed: int) -> int:
    """Torque limit to go on with: the one in force while it is enough, and not notably more."""
    if needed <= held <= needed + NOTABLE:
        return held
    # A little more than needed, so that a speed that rises slowly does not raise it each tick.
    return min(needed + NOTABLE // 4, FULL)


def free_speed(pump: PumpSpec) -> float:
    """Of a servo without load, at the spec's supply voltage [counts/s]."""
    servo = SERVOS[pump.servo]
    return servo.no_load_speed * pump.supply_voltage / servo.rated_voltage / COUNT_ANGLE


def stalling_pressure(pump: PumpSpec, limit: int) -> float:
    """Gauge pressure that a torque limit can hold against without friction [Pa]."""
    servo, shape = SERVOS[pump.servo], (pump.syringe_diameter, pump.pinion_diameter)
    return limit / FULL * stall_pressure(servo, pump.supply_voltage, *shape)


@dataclass
class TorqueSaturation:
    """Which servos give all the torque that they are allowed, and since when.

    A servo that does so for long shuts itself off: it sets its torque limit to 0, and whoever
    writes that register gives it its torque back silently. Between reading a servo and writing
    to it some milliseconds pass, so no limit is written to one that has been saturated for long.
    """

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
        saturated = [servo for servo, state in states.items() if _saturated(state)]
        self.since = {servo: self.since.get(servo, moment) for servo in saturated}

    def writable(self, now: float) -> dict[int, int]:
        """Torque limits in force of those servos that may be given another one."""
        return {
            servo: limit
            for servo, limit in self.limits.items()
            if now - self.since.get(servo, now) < LONGEST_SATURATION
        }


def _saturated(state: ServoState) -> bool:
    return abs(state.load) * FULL >= state.torque_limit - SATURATION_MARGIN
