"""A line right into a computed device: no port, no thread, each run like the other."""

from __future__ import annotations

from viscodesign.errors import PumpError
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.bus.line import Line
from viscodesign.pump.simulated.device import Device, UnpluggedError


class DirectLine(Line):
    """Time passes only while it is waited for a reply."""

    def __init__(self, device: Device, clock: Clock) -> None:
        self.device = device
        self.clock = clock
        self._arrived = bytearray()
        self._closed = False

    def write(self, data: bytes) -> None:
        self._check()
        try:
            self.device.feed(data, self.clock.now())
        except UnpluggedError:
            raise _gone() from None

    def read(self, most: int, deadline: float) -> bytes:
        self._collect()
        while not self._arrived and self.clock.now() < deadline:
            self.clock.sleep_until(min(self.device.due(), deadline))
            self._collect()
        data = bytes(self._arrived[:most])
        del self._arrived[:most]
        return data

    def drain(self) -> bytes:
        self._collect()
        data = bytes(self._arrived)
        self._arrived.clear()
        return data

    def close(self) -> None:
        self._closed = True

    def _collect(self) -> None:
        self._check()
        try:
            self._arrived += self.device.take(self.clock.now())
        except UnpluggedError:
            raise _gone() from None

    def _check(self) -> None:
        if self._closed:
            raise PumpError("the line to the simulated pump is closed")


def _gone() -> PumpError:
    return PumpError("the simulated port is gone: its cable was pulled")
