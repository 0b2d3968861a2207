"""What goes wrong on the way: each fault strikes at a request by its number, or at a moment."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from viscodesign.pump.simulated.device import Device, Outbox, UnpluggedError


@dataclass
class Fault:
    """Strikes at the first request that is due, and at ``times`` requests in all."""

    request: int = 0
    """Number of the request, from 0 on."""
    moment: float = -math.inf
    """Before which it does not strike [s]."""
    times: float = 1
    struck: int = field(default=0, init=False)

    def due(self, number: int, now: float) -> bool:
        return number >= self.request and now >= self.moment and self.struck < self.times

    def strike(self, request: bytes) -> bytes:
        """The request comes by; what of it arrives."""
        self.struck += 1
        return request

    def spoil(self, reply: bytes) -> tuple[float, bytes]:
        """How much later what comes back comes back [s], and as what."""
        return 0.0, reply


@dataclass
class LostRequest(Fault):
    """It never arrives."""

    def strike(self, request: bytes) -> bytes:
        super().strike(request)
        return b""


@dataclass
class LostReply(Fault):
    """It is done, and nobody hears of it."""

    def spoil(self, reply: bytes) -> tuple[float, bytes]:
        return 0.0, b""


@dataclass
class LateReply(Fault):
    """It comes, but later."""

    delay: float = 0.15

    def spoil(self, reply: bytes) -> tuple[float, bytes]:
        return self.delay, reply


@dataclass
class CorruptRequest(Fault):
    """One bit of it is turned over."""

    bit: int = 40

    def strike(self, request: bytes) -> bytes:
        super().strike(request)
        return _turned(request, self.bit)


@dataclass
class CorruptReply(Fault):
    """One bit of it is turned over."""

    bit: int = 40

    def spoil(self, reply: bytes) -> tuple[float, bytes]:
        return 0.0, _turned(reply, self.bit)


@dataclass
class ForeignBytes(Fault):
    """Something else comes before it: noise, text, or somebody else's reply."""

    data: bytes = b""

    def spoil(self, reply: bytes) -> tuple[float, bytes]:
        return 0.0, self.data + reply


@dataclass
class Unplugged(Fault):
    """From then on the port is gone."""

    def strike(self, request: bytes) -> bytes:
        raise UnpluggedError


@dataclass
class Mishap(Fault):
    """Something happens to the pump itself just before the request arrives."""

    happen: Callable[[], None] = lambda: None

    def strike(self, request: bytes) -> bytes:
        self.happen()
        return super().strike(request)


class Faulty(Device):
    """A device with faults between it and the host."""

    def __init__(self, device: Device, faults: Sequence[Fault]) -> None:
        self.device = device
        self.faults = list(faults)
        self.requests = 0
        """How many came by."""
        self._striking: list[Fault] = []
        self._outbox = Outbox()
        self._gone = False

    def feed(self, data: bytes, now: float) -> None:
        self._collect(now)
        self._striking = [fault for fault in self.faults if fault.due(self.requests, now)]
        self.requests += 1
        for fault in self._striking:
            try:
                data = fault.strike(data)
            except UnpluggedError:
                self._gone = True
                raise
        self.device.feed(data, now)

    def take(self, now: float) -> bytes:
        self._collect(now)
        return self._outbox.take(now)

    def due(self) -> float:
        return min(self.device.due(), self._outbox.due())

    def _collect(self, now: float) -> None:
        if self._gone:
            raise UnpluggedError
        if not (data := self.device.take(now)):
            return
        delay = 0.0
        for fault in self._striking:
            later, data = fault.spoil(data)
            delay += later
        self._outbox.put(data, now + delay)


def _turned(data: bytes, bit: int) -> bytes:
    if not data:
        return data
    turned = bytearray(data)
    place = bit % (8 * len(data))
    turned[place // 8] ^= 1 << place % 8
    return bytes(turned)
