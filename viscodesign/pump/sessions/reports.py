"""Reports on a pump before it moves and after it has come to rest, as text and as data."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from viscodesign.errors import InterruptedRunError, PumpError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.preflight import FoundServo
from viscodesign.pump.planning.result import PumpCourse
from viscodesign.pump.play.stream_result import StreamResult
from viscodesign.scene.pump import PumpSpec

STATUS_WORDS = {
    "complete": "played to its end",
    "interrupted": "interrupted",
    "stopped": "STOPPED",
}


def aligned(rows: Sequence[Sequence[str]]) -> list[str]:
    """Rows as indented lines with aligned columns."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = (zip(row, widths, strict=True) for row in rows)
    return ["  " + "  ".join(f"{cell:<{w}}" for cell, w in line).rstrip() for line in lines]


def motion_rows(course: PumpCourse, pump: PumpSpec, counts: np.ndarray) -> list[tuple[str, str]]:
    """Range of the plungers, in ``counts``, and of the pressures."""
    volume, pressure = 1e6 * course.volume, course.pressure / 1e3
    low, high = pump.travel
    return [
        (
            "plunger",
            f"{counts.min():.0f} to {counts.max():.0f} counts (travel {low} to {high}), "
            f"{volume.min():.3g} to {volume.max():.3g} mL from home",
        ),
        ("pressure", f"{pressure.min():.2f} to {pressure.max():.2f} kPa gauge"),
    ]


def servo_document(servo: FoundServo) -> dict[str, Any]:
    """A servo as it was found, under names with units."""
    return {
        "id": servo.id,
        "model": servo.name,
        "firmware": servo.firmware,
        "position_counts": servo.state.position,
        "limits_counts": list(servo.limits),
        "torque": servo.state.driven,
        "goal_counts": servo.state.goal,
        "load_rel": servo.state.load,
        "voltage_v": servo.state.voltage,
        "temperature_degc": servo.state.temperature,
        "complaint": servo.state.complaint,
    }


def servo_rows(servos: Sequence[FoundServo]) -> list[tuple[str, ...]]:
    """Servos as a table, its heading first."""
    heading = ("id", "model", "position", "limits", "torque", "load", "voltage", "heat", "state")
    return [heading, *(_servo_row(servo) for servo in servos)]


def _servo_row(servo: FoundServo) -> tuple[str, ...]:
    state, (low, high) = servo.state, servo.limits
    return (
        f"{servo.id}",
        servo.name,
        f"{state.position}",
        "wheel mode" if servo.turns_endlessly else f"{low} to {high}",
        "on" if state.driven else "off",
        f"{state.load:+.0%}",
        f"{state.voltage:.1f} V",
        f"{state.temperature:.0f} degC",
        state.complaint or "ok",
    )


def found_lines(identity: str, servos: Sequence[FoundServo]) -> list[str]:
    """What answered on the bus."""
    return [f"found {identity}", *aligned(servo_rows(servos))]


def result_lines(result: StreamResult) -> list[str]:
    """How it ended, and how each servo was left."""
    first = STATUS_WORDS[result.status]
    if result.status != "complete":
        first += f": {result.reason}"
    lines = [first, *(f"  {state}" for state in result.standing)]
    if result.retreat:
        lines.append(f"  not fully retracted: {result.retreat}")
    if not result.verified:
        lines.append("  NOT VERIFIED: look at the pump, and switch its power off if in doubt")
    return lines


@dataclass(frozen=True)
class PlaybackReport:
    """How a stream or an upload ended."""

    name: str
    """Of the scene."""
    result: StreamResult | None
    """How the pump was left; None where poses were loaded and not played."""
    facts: Mapping[str, Any]
    """What else is known, under names with units."""
    kept: str = ""
    """Where the record is, in words."""

    @property
    def status(self) -> str:
        """`complete`, `interrupted` or `stopped`; `loaded` where nothing was played."""
        return "loaded" if self.result is None else self.result.status

    @property
    def lines(self) -> list[str]:
        """How it ended, for people."""
        return [] if self.result is None else result_lines(self.result)

    def document(self) -> dict[str, Any]:
        """All of it for a program."""
        document = {"name": self.name, **self.facts, "status": self.status}
        if (result := self.result) is None:
            return document
        return document | {
            "reason": result.reason,
            "rule": result.rule,
            "hold_verified": result.verified,
            "servos": [
                {"id": one.axis, "verified": one.verified, "state": one.words}
                for one in result.standing
            ],
            "retreat": result.retreat,
        }

    def raise_failure(self) -> None:
        """Raise what did not end well as an error."""
        if self.result is None:
            return
        kept = f"; {self.kept}" if self.kept else ""
        if not self.result.verified or self.status == "stopped":
            raise PumpError(f"stopped ({self.result.rule or 'hold not verified'}){kept}")
        if self.status == "interrupted":
            raise InterruptedRunError(f"interrupted{kept}")
