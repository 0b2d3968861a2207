"""What a user reads before a pump moves, and after it stood still."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from viscodesign.pumpplan import PumpPlan
    from viscodesign.pumps.found import Servo
    from viscodesign.pumps.stream import Ending
    from viscodesign.scene.pump import Pump


def plan_rows(plan: PumpPlan, pump: Pump, rate: float, on_stop: str) -> list[tuple[str, str]]:
    """What is going to be played, each number with its unit."""
    from viscodesign.pumps.limits import stalling_pressure, torque_limit

    course, limit = plan.achievable, torque_limit(pump)
    counts, volume, pressure = course.count, 1e6 * course.volume, course.pressure / 1e3
    play = float(course.time[-1]) - course.lead_s
    low, high = pump.travel
    held = stalling_pressure(pump, limit) / 1e3
    return [
        ("plays", f"{plan.name}, {play:.4g} s at {rate:g} Hz; {course.lead_s:.3g} s before it"),
        (
            "plunger",
            f"{counts.min():.0f} to {counts.max():.0f} counts of {low} to {high}, "
            f"{volume.min():.3g} to {volume.max():.3g} mL from home",
        ),
        (
            "pressure",
            f"{pressure.min():.2f} to {pressure.max():.2f} kPa gauge; "
            f"stops above {pump.max_pressure / 1e3:g} kPa",
        ),
        (
            "torque",
            f"up to {course.stall_share.max():.0%} of stall, limited to {limit / 1023:.0%}: "
            f"it cannot hold more than {held:.0f} kPa",
        ),
        ("speed", f"up to {course.speed_share.max():.0%} of what the servo has left"),
        ("on stop", on_stop),
    ]


def servo_rows(servos: Sequence[Servo]) -> list[tuple[str, ...]]:
    """A table of servos as they were found, its heading first."""
    heading = ("id", "model", "position", "limits", "torque", "voltage", "temperature", "state")
    return [heading, *(_servo_row(servo) for servo in servos)]


def _servo_row(servo: Servo) -> tuple[str, ...]:
    state = servo.state
    limits = "wheel mode" if servo.turns_endlessly else f"{servo.limits[0]} to {servo.limits[1]}"
    return (
        str(servo.id),
        servo.name,
        f"{state.position}",
        limits,
        "on" if state.torque else "off",
        f"{state.voltage:.1f} V",
        f"{state.temperature:.0f} degC",
        state.complaint or "ok",
    )


def ending_lines(ending: Ending) -> list[str]:
    """How it ended, and how the pump stands now."""
    words = {"complete": "played to its end", "interrupted": "interrupted", "stopped": "STOPPED"}
    first = words[ending.status]
    if ending.status != "complete":
        first += f": {ending.reason}"
    lines = [first, *(f"  {standing}" for standing in ending.standing)]
    if ending.retreat:
        lines.append(f"  not drawn back all the way: {ending.retreat}")
    if not ending.sure:
        lines.append("  NOT VERIFIED: look at the pump, and switch its power off where in doubt")
    return lines


def ending_document(ending: Ending) -> dict[str, Any]:
    """The same for a program."""
    return {
        "status": ending.status,
        "reason": ending.reason,
        "rule": ending.rule,
        "hold_verified": ending.sure,
        "servos": [
            {"id": one.servo, "verified": one.sure, "state": one.words} for one in ending.standing
        ],
        "retreat": ending.retreat,
    }
