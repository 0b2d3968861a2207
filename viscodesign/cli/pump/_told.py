"""What a user reads before a pump moves, and after it stood still."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from viscodesign.pump.planning.result import PumpPlan
    from viscodesign.pump.play.preflight import FoundServo
    from viscodesign.pump.play.stream import StreamResult
    from viscodesign.scene.pump import Pump


def plan_rows(plan: PumpPlan, pump: Pump, rate: float, on_stop: str) -> list[tuple[str, str]]:
    """What is going to be played, each number with its unit."""
    from viscodesign.pump.play.path import top_speed
    from viscodesign.pump.play.torque_limit import stalling_pressure, torque_limit

    course = plan.achievable
    slow, fast = (torque_limit(pump, speed) for speed in (0.0, top_speed(plan.profile(course))))
    counts, volume, pressure = course.count, 1e6 * course.volume, course.pressure / 1e3
    play = float(course.time[-1]) - course.lead_s
    low, high = pump.travel
    held, most = (stalling_pressure(pump, limit) / 1e3 for limit in (slow, fast))
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
            f"up to {course.stall_share.max():.0%} of stall, limited to {slow / 1023:.0%} at rest "
            f"and {fast / 1023:.0%} at its fastest: it cannot hold more than {held:.0f} kPa, there "
            f"{most:.0f} kPa",
        ),
        ("speed", f"up to {course.speed_share.max():.0%} of what the servo has left"),
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


def document_rows(servos: Sequence[dict[str, Any]]) -> list[tuple[str, ...]]:
    """The same as a table, its heading first."""
    heading = ("id", "model", "position", "limits", "torque", "load", "voltage", "heat", "state")
    return [heading, *(_row(servo) for servo in servos)]


def _row(servo: dict[str, Any]) -> tuple[str, ...]:
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


def ending_lines(ending: StreamResult) -> list[str]:
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


def ending_document(ending: StreamResult) -> dict[str, Any]:
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
