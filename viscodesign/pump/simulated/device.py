"""Simulated devices: bytes in and out, each at its moment, and a line straight into one."""

from __future__ import annotations

import math
import sys
from abc import ABC, abstractmethod
from collections.abc import Iterator
from contextlib import contextmanager

from viscodesign.errors import PumpError
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.bus.line import Line

BITS_PER_BYTE = 10  # 8N1: a start and a stop bit around each byte


class UnpluggedError(Exception):
    """The cable is out."""


class Outbox:
    """Bytes on their way; none overtakes another."""

    def __init__(self) -> None:
        self._coming: list[tuple[float, bytes]] = []

    @property
    def last(self) -> float:
        """When the last of them arrive; minus infinity where none are on their way."""
        return self._coming[-1][0] if self._coming else -math.inf

    def put(self, data: bytes, moment: float) -> None:
        if data:
            self._coming.append((max(self.last, moment), data))

    def take(self, now: float) -> bytes:
        arrived = [data for moment, data in self._coming if moment <= now]
        del self._coming[: len(arrived)]
        return b"".join(arrived)

    def due(self) -> float:
        return self._coming[0][0] if self._coming else math.inf


class Device(ABC):
    """Knows neither ports nor clocks; moments never run backwards [s].

    Raises `UnpluggedError` where its cable is out.
    """

    def __init__(self) -> None:
        self.outbox = Outbox()

    @abstractmethod
    def feed(self, data: bytes, now: float) -> None:
        """Take bytes that the host begins to send at this moment."""

    def take(self, now: float) -> bytes:
        """Bytes that have reached the host since the last call."""
        return self.outbox.take(now)

    def due(self) -> float:
        """The earliest moment at which more can come; infinite while nothing will."""
        return self.outbox.due()


class DirectLine(Line):
    """A line into a device without a port; time passes only while a reply is awaited."""

    def __init__(self, device: Device, clock: Clock) -> None:
        self.device = device
        self.clock = clock
        self._arrived = bytearray()
        self._closed = False

    def write(self, data: bytes) -> None:
        with self._plugged():
            self.device.feed(data, self.clock.now())

    def read(self, most: int, deadline: float) -> bytes:
        self._collect()
        while not self._arrived and self.clock.now() < deadline:
            self.clock.sleep_until(min(self.device.due(), deadline))
            self._collect()
        data = bytes(self._arrived[:most])
        del self._arrived[:most]
        return data

    def drain(self) -> bytes:
        return self.read(sys.maxsize, self.clock.now())

    def close(self) -> None:
        self._closed = True

    def _collect(self) -> None:
        with self._plugged():
            self._arrived += self.device.take(self.clock.now())

    @contextmanager
    def _plugged(self) -> Iterator[None]:
        if self._closed:
            raise PumpError("the line to the simulated pump is closed")
        try:
            yield
        except UnpluggedError:
            raise PumpError("the simulated port is gone: its cable was pulled") from None
