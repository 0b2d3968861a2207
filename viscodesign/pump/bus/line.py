"""Where bytes go out and come in: a serial port, or a simulated device."""

from __future__ import annotations

from abc import ABC, abstractmethod

from viscodesign.pump.bus.clock import Clock


class Line(ABC):
    """A byte stream both ways; every failure of the port below is a `PumpError`."""

    clock: Clock
    """The clock that deadlines refer to."""

    @abstractmethod
    def write(self, data: bytes) -> None:
        """Send all of it."""

    @abstractmethod
    def read(self, most: int, deadline: float) -> bytes:
        """What is there, up to ``most`` bytes; waits for the first byte until the deadline.

        ``deadline``: a moment of the clock. Empty when nothing came.
        """

    @abstractmethod
    def drain(self) -> bytes:
        """Take away what has come so far."""

    @abstractmethod
    def close(self) -> None:
        """Release the port; calling it again does nothing."""
