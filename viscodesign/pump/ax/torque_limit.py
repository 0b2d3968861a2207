"""How much torque a servo is allowed: the guard that works when everything else is dead."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import field

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.protocol.registers import COUNT_ANGLE, FULL
from viscodesign.pump.ax.servo_drive import ServoDrive
from viscodesign.pump.ax.servo_state import ServoState
from viscodesign.scene.pumps.servo import ServoPumpSpec
from viscodesign.scene.pumps.servo_motor import SERVOS

ABOVE_CAP = 1.2  # so that the cap in software acts first
NOTABLE = 32
"""A limit so much above what is needed is lowered [1/1023 of stall]: 4 kPa of a 100 mL syringe."""
LONGEST_SATURATION = 0.2
"""Time at its limit after which a servo's torque limit is left alone [s]. No manual says when a
servo at its limit shuts itself off; that it is no sooner than this is an assumption."""
SATURATION_MARGIN = 2  # an output this close to its limit is at it [1/1023 of stall]


def torque_limit(pump: ServoPumpSpec, speed: float = 0.0) -> int:
    """Torque limit register [1/1023 of stall] for the pressure cap, friction and a speed.

    It limits the output of the servo's controller, and along the straight line of a motor a
    part of that goes into its ``speed`` [counts/s]: a fast profile takes a looser guard.
    """
    drive = ServoDrive(pump)
    share: float = drive.torque(pump.max_pressure, 1.0) / drive.stall_load
    share += speed / free_speed(pump)
    limit = min(math.ceil(FULL * ABOVE_CAP * share), FULL)
    return limit if limit % 256 else limit + 1  # see `TorqueLimits`: no byte that tells is 0


def free_speed(pump: ServoPumpSpec) -> float:
    """Speed of a servo without load, at the spec's supply voltage [counts/s]."""
    servo = SERVOS[pump.servo]
    return servo.no_load_speed * pump.supply_voltage / servo.rated_voltage / COUNT_ANGLE


def stalling_pressure(pump: ServoPumpSpec, limit: int) -> float:
    """Gauge pressure that a torque limit can hold against without friction [Pa]."""
    return share_of_stall(limit) * ServoDrive(pump).stall_pressure


def share_of_stall(limit: int) -> float:
    """A torque limit as a share of the torque at stall [1]."""
    return limit / FULL


def following_limit(held: int, needed: int) -> int:
    """Torque limit to go on with: the one in force while it is enough, and not notably more.

    Any other differs from ``held`` in one of the register's two bytes, and is the next step
    towards what is needed: see `TorqueLimits`.
    """
    if needed <= held <= needed + NOTABLE:
        return held
    # A little more than needed, so that a speed that rises slowly does not raise it each tick.
    high, low = divmod(min(needed + NOTABLE // 4, FULL), 256)
    low = max(low, 1)
    other_high, other_low = 256 * high + held % 256, held - held % 256 + low
    if held % 256 and needed <= other_high <= needed + NOTABLE:
        return other_high  # its low byte will do
    # The low byte first where that is enough, so that what is reached is exact.
    steps = [other_low] if held >= 256 and other_low != held else []
    steps += [other_high] if other_high != held else []
    enough = [step for step in steps if needed <= step <= FULL]
    # Within the lowest 256 the low byte is written by way of a higher limit, for two ticks.
    return enough[0] if enough else max(steps, default=held + 256)


@dataclass
class TorqueLimits:
    """Torque limits in force, and of which servos they may be changed.

    A servo that gives all the torque it is allowed for long shuts itself off: it sets its torque
    limit to 0, and whoever writes that register gives it its torque back. Between reading a servo
    and writing to it some milliseconds pass. So nothing is written to one that has been saturated
    for long; and where one shuts itself off in just these milliseconds, that is seen: only one
    byte of the register is written at a time, so what is read next lacks the other. (Written
    whole, the register would read the same as that of a healthy servo.)
    """

    in_force: dict[int, int] = field(default_factory=dict)
    """By servo, as last read where it is well [1/1023 of stall]."""
    saturated_since: dict[int, float] = field(default_factory=dict)
    """[s of the clock]"""
    sent: dict[int, tuple[int, int]] = field(default_factory=dict)
    """By servo: the limit before the last change, and the one after it."""

    def update(self, states: Mapping[int, ServoState], moment: float) -> None:
        """Note what was read at a moment [s of the clock]."""
        self.sent = {}
        self.in_force = {
            servo: state.torque_limit
            for servo, state in states.items()
            if state.driven and state.torque_limit > 0 and not state.errors
        }
        self.saturated_since = {
            servo: self.saturated_since.get(servo, moment)
            for servo, state in states.items()
            if abs(state.load) * FULL >= state.torque_limit - SATURATION_MARGIN
        }

    def changes(self, needed: Mapping[int, int], now: float) -> dict[int, int]:
        """Limits to be sent [1/1023 of stall]; none where none changes notably."""
        limits = {
            servo: following_limit(held, needed[servo])
            for servo, held in self.in_force.items()
            if servo in needed and now - self.saturated_since.get(servo, now) < LONGEST_SATURATION
        }
        return limits if any(limits[s] != self.in_force[s] for s in limits) else {}

    def revived(self, states: Mapping[int, ServoState]) -> list[int]:
        """Servos that had shut themselves off when their limit was changed."""
        return [
            servo
            for servo, (before, after) in self.sent.items()
            if servo in states and states[servo].torque_limit == _written_to_0(before, after) > 0
        ]


def _written_to_0(before: int, after: int) -> int:
    """What a torque limit of 0 becomes by the one byte that was written."""
    return after % 256 if after // 256 == before // 256 else after // 256 * 256
