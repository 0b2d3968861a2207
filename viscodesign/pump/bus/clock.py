"""Time as a pump's commands see it: real, or simulated at any pace."""

from __future__ import annotations

import time
from abc import ABC, abstractmethod

SHORTEST_SLEEP = 2e-3  # shorter sleeps of the wall's time are added to the next one [s]
MADE_UP = 0.25  # lateness, of computing, that is made up for by running faster later, at most [s]


class Clock(ABC):
    """Seconds since some moment, never running backwards."""

    @abstractmethod
    def now(self) -> float:
        """Seconds [s]."""

    @abstractmethod
    def sleep(self, seconds: float) -> None:
        """Let this much time pass; at once where it is not positive."""

    def sleep_until(self, moment: float) -> None:
        self.sleep(moment - self.now())


class WallClock(Clock):
    """The machine's monotonic clock."""

    def now(self) -> float:
        return time.monotonic()

    def sleep(self, seconds: float) -> None:
        if seconds > 0.0:
            time.sleep(seconds)


class SteppedClock(Clock):
    """Simulated time: it advances only in waits, as fast as these are computed."""

    def __init__(self) -> None:
        self._now = 0.0

    def now(self) -> float:
        return self._now

    def sleep(self, seconds: float) -> None:
        self._now += max(seconds, 0.0)


class PacedClock(SteppedClock):
    """Simulated time that advances only in waits, and no faster than ``pace`` times wall time.

    Computing between two waits takes none of it: a simulated pump is not late because the machine
    is busy.
    """

    def __init__(self, pace: float = 1.0) -> None:
        super().__init__()
        self.pace = pace
        self._due = time.monotonic()  # when the wall's time has come that far [s]

    def sleep(self, seconds: float) -> None:
        super().sleep(seconds)
        now = time.monotonic()
        self._due = max(self._due + max(seconds, 0.0) / self.pace, now - MADE_UP)
        if self._due - now > SHORTEST_SLEEP:
            time.sleep(self._due - now)
