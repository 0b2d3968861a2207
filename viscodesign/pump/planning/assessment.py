"""One limit of a pump held against what a motion asks, and the margins of all limits."""

from __future__ import annotations

from dataclasses import dataclass

from viscodesign.pump.planning.result import Severity


@dataclass(frozen=True)
class Assessment:
    """What a limit says of a demand."""

    severity: Severity
    """Where ``ratio`` is above 1."""
    wanted: float
    """At the worst time, in ``unit``."""
    allowed: float
    unit: str
    ratio: float
    """How much of what is allowed is wanted."""
    when: int
    """Index of the worst time."""
    message: str


@dataclass(frozen=True)
class LimitMargins:
    """Where limits are drawn that no data sheet draws."""

    stall_share: float = 0.8
    """Of the stall torque, above which a plan is refused: near it a servo creeps, heats and
    switches off."""
    sensor_floor: float = 20e3
    """Absolute [Pa]; the Phidgets 1140 reads no lower."""
    sensor_accuracy: float = 6e3
    """Swing below which the sensor's 1.5 % of full scale, 5.7 kPa, hides the profile [Pa]."""
    sensor_step: float = 1.61e3
    """One count of the sensor at 8 bit, as the firmware for ROS reads it [Pa]."""
    fewest_counts: float = 5.0
    """Smallest motion, beside what the gear loses [counts]."""
    fine_steps: float = 20.0
    """Counts that a swing of pressure should have, taken at once; with fewer it is coarse."""
    short_life: float = 360.0
    """Battery life that is worth a word [s]."""
    coarse_speed: float = 5.0
    """Units of the speed register below which even the fastest move goes in steps."""


MARGINS = LimitMargins()
EPS_COUNTS = 1e-9
"""Keeps a share of no motion finite."""
FLAT_PA = 1.0
"""Swing of pressure below which nothing is asked."""
