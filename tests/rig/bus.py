"""An adapter straight on the servos' bus."""

from __future__ import annotations

import math

from viscodesign.pump.ax.protocol.packets import OVERHEAD, Parser
from viscodesign.pump.simulated.bench import SimulatedBench
from viscodesign.pump.simulated.device import BITS_PER_BYTE, Device

LONGEST_GAP = 0.1
"""Between bytes of a packet [s]: servos drop what comes later (e-manual, Protocol 1.0)."""


class BusAdapter(Device):
    """What a USB adapter passes through both ways, ``latency`` seconds late back."""

    def __init__(self, bench: SimulatedBench, baud: int = 1_000_000, latency: float = 1e-3) -> None:
        super().__init__()
        self.bench = bench
        self.latency = latency
        self._byte = BITS_PER_BYTE / baud
        self._parser = Parser()
        self._heard = -math.inf

    def feed(self, data: bytes, now: float) -> None:
        if now - self._heard > LONGEST_GAP:
            self._parser = Parser()
        moment = self._heard = now + len(data) * self._byte
        for packet in self._parser.feed(data):
            answered = self.bench.answer(packet, now)
            if answered is not None:
                reply, delay = answered
                moment += delay + (OVERHEAD + len(reply.parameters)) * self._byte
                self.outbox.put(reply.encode(), moment + self.latency)

    def take(self, now: float) -> bytes:
        self.bench.advance(now)
        return super().take(now)
