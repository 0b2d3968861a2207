"""What stands at the other end before anything moves, and whether it may be moved."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from viscodesign.pump.ax.servo_state import ServoState, read_anyway, read_servo
from viscodesign.pump.boards.base import Board
from viscodesign.pump.bus import registers
from viscodesign.pump.play.safety_rules import HIGHEST_TEMPERATURE, LOWEST_VOLTAGE
from viscodesign.pump.servo_motor import SERVOS, model_title
from viscodesign.scene.pump import PumpSpec

IDENTITY = registers.STATUS_LEVEL.address + 1
"""Bytes from address 0 on that tell what a servo is."""
ANSWERS_ALL = 2
"""Status return level with which writes are answered too."""


@dataclass(frozen=True)
class FoundServo:
    """One servo as it was found."""

    id: int
    model: int
    firmware: int
    limits: tuple[int, int]
    """Its own angle limits [counts], kept without power; both 0 is wheel mode."""
    status_level: int
    state: ServoState

    @property
    def name(self) -> str:
        return model_title(self.model)

    @property
    def turns_endlessly(self) -> bool:
        return self.limits == (0, 0)


def identify(board: Board, servo: int) -> FoundServo:
    """Read who it is and how it does; changes nothing."""
    data, _ = read_anyway(board, servo, 0, IDENTITY)
    return FoundServo(
        id=servo,
        model=registers.MODEL.within(data, 0),
        firmware=registers.FIRMWARE.within(data, 0),
        limits=(registers.CW_LIMIT.within(data, 0), registers.CCW_LIMIT.within(data, 0)),
        status_level=registers.STATUS_LEVEL.within(data, 0),
        state=read_servo(board, servo),
    )


def blocking_faults(servo: FoundServo, pump: PumpSpec) -> list[str]:
    """Why it must not be moved, each with what to do."""
    return [f"servo {servo.id}: {reason}" for reason in _reasons(servo, pump)]


def _reasons(servo: FoundServo, pump: PumpSpec) -> Iterator[str]:
    state, (low, high) = servo.state, pump.travel
    if servo.model != SERVOS[pump.servo].model:
        wanted = SERVOS[pump.servo].title
        yield f"is an {servo.name}, but the spec says {wanted}; correct pump.servo"
    if state.errors:
        yield f"reports: {state.complaint}; see `pump status`, then switch it off and on"
    if state.voltage < LOWEST_VOLTAGE:
        yield f"has {state.voltage:g} V; charge the battery (at least {LOWEST_VOLTAGE:g} V)"
    if state.temperature >= HIGHEST_TEMPERATURE:
        yield f"is at {state.temperature:g} degC; let it cool down (below {HIGHEST_TEMPERATURE:g})"
    if servo.status_level != ANSWERS_ALL:
        yield f"answers at status level {servo.status_level} only; `pump calibrate` sets it to 2"
    yield from _misplaced(servo, low, high)


def _misplaced(servo: FoundServo, low: int, high: int) -> Iterator[str]:
    if servo.turns_endlessly:
        yield "is in wheel mode (both angle limits 0), where it never stops; run `pump calibrate`"
    elif not low <= servo.limits[0] <= servo.limits[1] <= high:
        yield (
            f"its own angle limits {list(servo.limits)} let it out of pump.travel "
            f"[{low}, {high}]: not calibrated for this spec; run `pump calibrate`"
        )
    if not low <= servo.state.position <= high:
        yield (
            f"is at {servo.state.position} counts, outside of pump.travel [{low}, {high}]; "
            "move the plunger by hand with its torque off, or run `pump calibrate`"
        )
