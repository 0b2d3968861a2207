"""What a simulated device has to do, and the queue of what it sends."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod

BITS_PER_BYTE = 10
"""8N1: a start and a stop bit around each byte."""


class UnpluggedError(Exception):
    """The cable is out."""


class Device(ABC):
    """Bytes in, bytes out, each at its moment; knows neither ports nor clocks.

    Moments never run backwards. Raises `UnpluggedError` where its cable is out.
    """

    @abstractmethod
    def feed(self, data: bytes, now: float) -> None:
        """Bytes that the host began to send at this moment."""

    @abstractmethod
    def take(self, now: float) -> bytes:
        """Bytes that have reached the host since the last time."""

    @abstractmethod
    def due(self) -> float:
        """When to ask again: earlier, nothing can come. Infinite while nothing will."""


class Outbox:
    """Bytes under way to the host; none overtakes another."""

    def __init__(self) -> None:
        self._coming: list[tuple[float, bytes]] = []

    def put(self, data: bytes, moment: float) -> None:
        if data:
            earliest = self._coming[-1][0] if self._coming else moment
            self._coming.append((max(earliest, moment), data))

    def take(self, now: float) -> bytes:
        arrived = [data for moment, data in self._coming if moment <= now]
        del self._coming[: len(arrived)]
        return b"".join(arrived)

    def due(self) -> float:
        return self._coming[0][0] if self._coming else math.inf
