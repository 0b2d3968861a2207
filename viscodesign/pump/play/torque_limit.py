"""How much torque a servo is allowed: the guard that works when everything else is dead."""

from __future__ import annotations

import math

from viscodesign.pump.servo_motor import COUNT_ANGLE, SERVOS
from viscodesign.pump.syringe import shaft_torque, stall_pressure, stall_torque
from viscodesign.scene.pump import Pump

ABOVE_CAP = 1.2
"""So that the cap in software acts first."""
FULL = 1023
NOTABLE = 32
"""A limit so much above what is needed is lowered [1/1023 of stall]: 4 kPa of a 100 mL syringe."""


def torque_limit(pump: Pump, speed: float = 0.0) -> int:
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


def free_speed(pump: Pump) -> float:
    """Of a servo without load, at the spec's supply voltage [counts/s]."""
    servo = SERVOS[pump.servo]
    return servo.no_load_speed * pump.supply_voltage / servo.rated_voltage / COUNT_ANGLE


def stalling_pressure(pump: Pump, limit: int) -> float:
    """Gauge pressure that a torque limit can hold against without friction [Pa]."""
    servo, shape = SERVOS[pump.servo], (pump.syringe_diameter, pump.pinion_diameter)
    return limit / FULL * stall_pressure(servo, pump.supply_voltage, *shape)
