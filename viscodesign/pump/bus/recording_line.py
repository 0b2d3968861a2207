"""A line that remembers what was sent through it."""

from __future__ import annotations

from viscodesign.pump.bus.line import Line


class RecordingLine(Line):
    """Keeps all that is sent."""

    def __init__(self, line: Line) -> None:
        self.line = line
        self.clock = line.clock
        self.sent: list[bytes] = []

    def write(self, data: bytes) -> None:
        self.sent.append(data)
        self.line.write(data)

    def read(self, most: int, deadline: float) -> bytes:
        return self.line.read(most, deadline)

    def drain(self) -> bytes:
        return self.line.drain()

    def close(self) -> None:
        self.line.close()
