"""How much torque a servo is allowed: the guard that works when everything else is dead."""

from __future__ import annotations

import math

from viscodesign.physics.servo import SERVOS
from viscodesign.physics.syringe_pump import shaft_torque, stall_pressure, stall_torque
from viscodesign.scene.pump import Pump

ABOVE_CAP = 1.2
"""So that the cap in software acts first."""
FULL = 1023


def torque_limit(pump: Pump) -> int:
    """Torque limit register [1/1023 of stall] that the pressure cap and the friction need."""
    torque: float = shaft_torque(
        pump.max_pressure, pump.syringe_diameter, pump.pinion_diameter, pump.plunger_friction
    )
    share = ABOVE_CAP * torque / stall_torque(SERVOS[pump.servo], pump.supply_voltage)
    return min(math.ceil(FULL * share), FULL)


def stalling_pressure(pump: Pump, limit: int) -> float:
    """Gauge pressure that a torque limit can hold against without friction [Pa]."""
    return (
        limit
        / FULL
        * stall_pressure(
            SERVOS[pump.servo], pump.supply_voltage, pump.syringe_diameter, pump.pinion_diameter
        )
    )
