"""What a stream gives while it runs, and how it ends."""

from __future__ import annotations

from dataclasses import field
from typing import Any, Literal

from viscodesign.errors import PumpError
from viscodesign.interrupt import StopRequest
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.play.axis import FinalAxisState, Sample
from viscodesign.pump.play.guard import Stop

OnStop = Literal["hold", "release", "retract"]

Status = Literal["complete", "interrupted", "stopped"]


class RecordingError(PumpError):
    """What observes the ticks cannot keep them: the disk is full, or gone."""

    rule = "record"


@dataclass(frozen=True)
class TickReport:
    """What one tick gives to be recorded and seen."""

    time: float
    """Time of the scene; negative on the way to its start [s]."""
    sample: Sample
    skipped: int
    """Ticks skipped so far."""
    stop: Stop | None
    """The rule that this sample breaks."""


@dataclass
class StreamResult:
    """How a stream ended, and how the pump was left."""

    status: Status = "stopped"
    reason: str = "it did not begin"
    rule: str = ""
    """The broken rule, where one was."""
    may_retreat: bool = True
    """Whether the plunger may be drawn back."""
    standing: list[FinalAxisState] = field(default_factory=list)
    retreat: str = ""
    """Why the plunger was not drawn back as far as intended, where it was not."""

    @classmethod
    def interrupted(cls, request: StopRequest) -> StreamResult:
        """Ended by a request to stop."""
        return cls("interrupted", f"asked to stop ({request.first})")

    @property
    def verified(self) -> bool:
        """Whether every axis was read back as it was left."""
        return bool(self.standing) and all(one.verified for one in self.standing)

    def outcome(self) -> dict[str, Any]:
        """Why it ended, and whether it is at rest, for a program."""
        return {"reason": self.reason, "rule": self.rule, "hold_verified": self.verified}
