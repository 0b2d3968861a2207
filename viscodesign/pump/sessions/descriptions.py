"""What a user reads, and a program gets, before a pump moves and after it came to rest."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from viscodesign.pump.planning.result import PumpPlan
from viscodesign.pump.play.path import top_speed
from viscodesign.pump.play.preflight import FoundServo
from viscodesign.pump.play.stream import StreamResult
from viscodesign.pump.play.torque_limit import stalling_pressure, torque_limit
from viscodesign.scene.pump import PumpSpec

STATUS_WORDS = {
    "complete": "played to its end",
    "interrupted": "interrupted",
    "stopped": "STOPPED",
}


def aligned(rows: Sequence[Sequence[str]]) -> list[str]:
    """Rows as indented lines with aligned columns."""
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    return [
        "  " + "  ".join(f"{cell:<{w}}" for cell, w in zip(row, widths, strict=True)).rstrip()
        for row in rows
    ]


def plan_rows(plan: PumpPlan, pump: PumpSpec, rate: float, on_stop: str) -> list[tuple[str, str]]:
    """What is about to be streamed, each number with its unit."""
    course = plan.achievable
    slow, fast = (torque_limit(pump, speed) for speed in (0.0, top_speed(plan.profile(course))))
    counts, volume, pressure = course.count, 1e6 * course.volume, course.pressure / 1e3
    low, high = pump.travel
    at_rest, moving = (stalling_pressure(pump, limit) / 1e3 for limit in (slow, fast))
    return [
        (
            "plays",
            f"{plan.name}, {float(course.time[-1]) - course.lead_s:.4g} s at {rate:g} Hz, "
            f"after a lead-in of {course.lead_s:.3g} s",
        ),
        (
            "plunger",
            f"{counts.min():.0f} to {counts.max():.0f} counts (travel {low} to {high}), "
            f"{volume.min():.3g} to {volume.max():.3g} mL from home",
        ),
        (
            "pressure",
            f"{pressure.min():.2f} to {pressure.max():.2f} kPa gauge; "
            f"stops above {pump.max_pressure / 1e3:g} kPa",
        ),
        (
            "torque",
            f"up to {course.stall_share.max():.0%} of stall; limited to {slow / 1023:.0%} at rest "
            f"(holds at most {at_rest:.0f} kPa) and {fast / 1023:.0%} at top speed "
            f"({moving:.0f} kPa)",
        ),
        ("speed", f"up to {course.speed_share.max():.0%} of the speed left at that torque"),
        ("on stop", on_stop),
    ]


def servo_documents(servos: Sequence[FoundServo]) -> list[dict[str, Any]]:
    """Servos as they were found, under names with units."""
    return [
        {
            "id": servo.id,
            "model": servo.name,
            "firmware": servo.firmware,
            "position_counts": servo.state.position,
            "limits_counts": list(servo.limits),
            "torque": servo.state.torque,
            "goal_counts": servo.state.goal,
            "load_rel": servo.state.load,
            "voltage_v": servo.state.voltage,
            "temperature_degc": servo.state.temperature,
            "complaint": servo.state.complaint,
        }
        for servo in servos
    ]


def servo_rows(servos: Sequence[dict[str, Any]]) -> list[tuple[str, ...]]:
    """The same as a table, its heading first."""
    heading = ("id", "model", "position", "limits", "torque", "load", "voltage", "heat", "state")
    return [heading, *(_servo_row(servo) for servo in servos)]


def _servo_row(servo: dict[str, Any]) -> tuple[str, ...]:
    low, high = servo["limits_counts"]
    return (
        str(servo["id"]),
        servo["model"],
        f"{servo['position_counts']}",
        f"{low} to {high}" if (low, high) != (0, 0) else "wheel mode",
        "on" if servo["torque"] else "off",
        f"{servo['load_rel']:+.0%}",
        f"{servo['voltage_v']:.1f} V",
        f"{servo['temperature_degc']:.0f} degC",
        servo["complaint"] or "ok",
    )


def found_lines(identity: str, servos: Sequence[FoundServo]) -> list[str]:
    """What answered on the bus."""
    return [f"found {identity}", *aligned(servo_rows(servo_documents(servos)))]


def result_lines(result: StreamResult) -> list[str]:
    """How it ended, and how each servo was left."""
    first = STATUS_WORDS[result.status]
    if result.status != "complete":
        first += f": {result.reason}"
    lines = [first, *(f"  {state}" for state in result.standing)]
    if result.retreat:
        lines.append(f"  not fully retracted: {result.retreat}")
    if not result.sure:
        lines.append("  NOT VERIFIED: look at the pump, and switch its power off if in doubt")
    return lines


def result_document(result: StreamResult) -> dict[str, Any]:
    """The same for a program."""
    return {
        "status": result.status,
        "reason": result.reason,
        "rule": result.rule,
        "hold_verified": result.sure,
        "servos": [
            {"id": one.servo, "verified": one.sure, "state": one.words} for one in result.standing
        ],
        "retreat": result.retreat,
    }
