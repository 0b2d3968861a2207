"""Where bytes go out and come in: a serial port, or a simulated device."""

from __future__ import annotations

from abc import ABC, abstractmethod

from viscodesign.pump.bus.clock import Clock


class Line(ABC):
    """A byte stream both ways; one owner, opened once and closed once.

    Every failure of the port below, a pulled cable too, is a `PumpError`.
    """

    clock: Clock
    """The clock that deadlines refer to."""

    @abstractmethod
    def write(self, data: bytes) -> None:
        """Send all of it; raises `PumpError` where the port is gone or takes too long."""

    @abstractmethod
    def read(self, most: int, deadline: float) -> bytes:
        """What is there, up to ``most`` bytes; waits for the first byte until the deadline.

        ``deadline``: a moment of the clock. Empty when nothing came. Raises `PumpError`
        where the port is gone.
        """

    @abstractmethod
    def drain(self) -> bytes:
        """Take away, unread, what has come so far."""

    @abstractmethod
    def close(self) -> None:
        """Let go of the port; a second time does nothing."""
