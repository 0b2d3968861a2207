"""A steady grid of moments."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.bus.clock import Clock

SLICE = 0.02  # waiting is cut into pieces this long, to obey a request to stop at any rate [s]


@dataclass
class Ticks:
    """Moments ``start + k period``; those that went by unused are counted, not made up for."""

    clock: Clock
    period: float
    """[s]"""
    start: float = 0.0
    """Time on the clock [s]."""
    index: int = 0
    done: int = 0
    skipped: int = 0
    worst: float = 0.0
    """Longest time by which a tick came late [s]."""
    total: float = 0.0
    """Sum of those times [s]."""

    def begin(self) -> None:
        """Start counting time now; the counters continue."""
        self.start, self.index = self.clock.now(), 0

    @property
    def elapsed(self) -> float:
        """The present moment of the grid, from its start [s]."""
        return self.index * self.period

    @property
    def now(self) -> float:
        """Time from the start [s]."""
        return self.clock.now() - self.start

    def wait(self, going_on: Callable[[], bool] = lambda: True) -> None:
        """Let time pass up to the next moment, or while it is ``going_on``."""
        self.index += 1
        behind = max(int(self.now / self.period) - self.index, 0)
        self.skipped += behind
        self.index += behind
        moment = self.start + self.index * self.period
        while going_on() and (left := moment - self.clock.now()) > 0.0:
            self.clock.sleep(min(left, SLICE))
        late = self.clock.now() - moment
        self.done += 1
        self.worst = max(self.worst, late)
        self.total += max(late, 0.0)

    def document(self) -> dict[str, Any]:
        """Counts and jitter, under names with units."""
        return {
            "rate_hz": 1.0 / self.period,
            "ticks": self.done,
            "skipped_ticks": self.skipped,
            "worst_lateness_s": self.worst,
            "mean_lateness_s": self.total / max(self.done, 1),
        }
