"""The servos that drive a syringe pump, in the numbers of their maker."""

from __future__ import annotations

import math
from dataclasses import dataclass

STEADY_SHARE = 1 / 5
"""Part of the stall torque up to which the maker promises steady motion.

Source: ROBOTIS e-manual, AX-12A and AX-18A, note to the specifications: "Stall torque is the
maximum instantaneous and static torque. Stable motions are possible with robots designed
for loads with 1/5 or less of the stall torque."
"""
SPEED_UNIT = 0.111 * 2 * math.pi / 60
"""Speed of one unit of the register Moving Speed [rad/s]: about 0.111 rpm (e-manual)."""
LARGEST_SPEED = 1023
COUNT_ANGLE = math.radians(300.0) / 1024
"""Angle of one count [rad]: 1024 counts span 300 degrees (e-manual, Goal Position)."""


@dataclass(frozen=True)
class Servo:
    """A servo at its rated voltage, in SI."""

    title: str
    stall_torque: float
    """[N m]"""
    stall_current: float
    """[A]"""
    no_load_speed: float
    """[rad/s]"""
    rated_voltage: float
    """Of the three above, and the highest that is allowed [V]."""
    lowest_voltage: float
    """[V]"""


def _rpm(value: float) -> float:
    return value * 2 * math.pi / 60


SERVOS = {
    "ax12a": Servo("AX-12A", 1.5, 1.5, _rpm(59.0), 12.0, 9.0),
    "ax18a": Servo("AX-18A", 1.8, 2.2, _rpm(97.0), 12.0, 9.0),
}
"""Source: ROBOTIS e-manual, specifications of AX-12A and AX-18A."""
