"""A rule that stops the pump, and what comes of several."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import field

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.play.axis import Sample

Fault = Callable[[Sample], str | None]
"""Receives a sample; what is wrong in it, in words."""


@dataclass(frozen=True)
class Stop:
    """Why the pump has to stop."""

    rule: str
    reason: str
    may_retreat: bool = False
    """Whether the pump may be drawn back."""

    def __str__(self) -> str:
        return f"{self.rule.replace('_', ' ')}: {self.reason}"


@dataclass
class Guard:
    """One rule: broken where several samples in succession have its fault."""

    rule: str
    """Its name, as records and messages have it."""
    fault: Fault
    samples: int = 1
    may_retreat: bool = False
    """Whether the pump may be drawn back after this."""
    count: int = field(default=0, init=False)

    def check(self, sample: Sample) -> Stop | None:
        """Why the pump has to stop now; None where it may go on."""
        reason = self.fault(sample)
        self.count = self.count + 1 if reason else 0
        if reason is None or self.count < self.samples:
            return None
        return Stop(self.rule, reason, self.may_retreat)


def first_broken(guards: Sequence[Guard], sample: Sample) -> Stop | None:
    """The stop of the first rule that is broken; all are asked every time, since they count."""
    stops = [guard.check(sample) for guard in guards]
    return next(filter(None, stops), None)
