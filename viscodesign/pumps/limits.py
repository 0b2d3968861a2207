"""How much torque a servo is allowed: the guard that works when everything else is dead."""

from __future__ import annotations

import math

from viscodesign.pumps.drive import Drive
from viscodesign.scene.pump import Pump

STALL_TORQUE = {"ax12a": 1.5, "ax18a": 1.8}
"""At 12 V [N m]; source: ROBOTIS e-manual, AX-12A and AX-18A, Specifications."""
STALL_VOLTAGE = 12.0
"""[V]; torque is taken as proportional to voltage."""
ABOVE_CAP = 1.2
"""So that the cap in software acts first."""
FRICTION = 0.05
"""Of the stall torque, for plunger and rack; without it a low cap would never let them move."""
FULL = 1023


def stall_torque(pump: Pump) -> float:
    """Of one servo at the spec's supply voltage [N m]."""
    return STALL_TORQUE[pump.servo] * pump.supply_voltage / STALL_VOLTAGE


def torque_limit(pump: Pump) -> int:
    """Torque limit register [1/1023 of stall] that a spec's pressure cap needs."""
    needed = ABOVE_CAP * pump.max_pressure * _torque_per_pressure(pump) / stall_torque(pump)
    return min(math.ceil(FULL * (needed + FRICTION)), FULL)


def stalling_pressure(pump: Pump, limit: int) -> float:
    """Gauge pressure that a torque limit can hold against without friction [Pa]."""
    return limit / FULL * stall_torque(pump) / _torque_per_pressure(pump)


def _torque_per_pressure(pump: Pump) -> float:
    """Barrel's area times the pinion's radius [m3]."""
    return Drive(pump).area * pump.pinion_diameter / 2
