"""A rule that stops the pump, and the watch over all rules."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import field
from typing import ClassVar

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.play.axis import Sample

NOISE_SAMPLES = 2  # samples in succession that must agree where one alone may be noise


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
class Guard(ABC):
    """One rule: broken where several samples in succession have its fault."""

    rule: ClassVar[str]
    samples: ClassVar[int] = 1
    may_retreat: ClassVar[bool] = False
    """Whether the pump may be drawn back after this."""
    count: int = field(default=0, init=False)

    def check(self, sample: Sample) -> str | None:
        """Why the pump has to stop now; None where it may go on."""
        reason = self._fault(sample)
        self.count = self.count + 1 if reason else 0
        return reason if self.count >= self.samples else None

    def name(self, sample: Sample) -> str:
        """The rule, as records and messages have it."""
        return self.rule

    @abstractmethod
    def _fault(self, sample: Sample) -> str | None:
        """What is wrong in this sample."""


class Watch:
    """All rules; the first that is broken is kept, whatever the others say later."""

    def __init__(self, guards: Sequence[Guard]) -> None:
        self.guards = guards
        self.stop: Stop | None = None

    def check(self, sample: Sample) -> Stop | None:
        """The alarm, once there is one: it stays."""
        # Every rule is asked every time, since they count.
        reasons = [(guard, guard.check(sample)) for guard in self.guards]
        broken = [Stop(g.name(sample), reason, g.may_retreat) for g, reason in reasons if reason]
        self.stop = self.stop or next(iter(broken), None)
        return self.stop
