"""Time as a pump's commands see it: the real one, or one that runs at another pace."""

from __future__ import annotations

import time
from abc import ABC, abstractmethod

SHORTEST_SLEEP = 2e-3
"""Sleeps of the wall's time shorter than this wait for the next one [s]."""

MADE_UP = 0.25
"""What computing may take on top and is made up for by running faster later [s]."""


class Clock(ABC):
    """Seconds since some moment, never running backwards."""

    @abstractmethod
    def now(self) -> float:
        """Seconds [s]."""

    @abstractmethod
    def sleep(self, seconds: float) -> None:
        """Let this much time pass; at once where it is not positive."""

    def sleep_until(self, moment: float) -> None:
        """Let time pass up to a moment; at once where it is over."""
        self.sleep(moment - self.now())


class WallClock(Clock):
    """The machine's monotonic clock, or ``pace`` of its seconds in each of them."""

    def __init__(self, pace: float = 1.0) -> None:
        self.pace = pace

    def now(self) -> float:
        return time.monotonic() * self.pace

    def sleep(self, seconds: float) -> None:
        if seconds > 0.0:
            time.sleep(seconds / self.pace)


class SteppedClock(Clock):
    """Time that passes only where somebody waits: as fast as it is computed."""

    def __init__(self) -> None:
        self._now = 0.0

    def now(self) -> float:
        return self._now

    def sleep(self, seconds: float) -> None:
        self._now += max(seconds, 0.0)


class PacedClock(SteppedClock):
    """Time that passes only where somebody waits, and no faster than the wall's times ``pace``.

    What is computed between two waits takes none of it: a simulated pump is not late because
    the machine is busy.
    """

    def __init__(self, pace: float = 1.0) -> None:
        super().__init__()
        self.pace = pace
        self._due = time.monotonic()
        """When the wall's time has come that far [s]."""

    def sleep(self, seconds: float) -> None:
        super().sleep(seconds)
        here = time.monotonic()
        self._due = max(self._due + max(seconds, 0.0) / self.pace, here - MADE_UP)
        if self._due - here > SHORTEST_SLEEP:
            time.sleep(self._due - here)
