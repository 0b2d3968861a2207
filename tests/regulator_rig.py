"""A pressure regulator on its line with everything that can happen to it, and all that was sent."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from viscodesign.interrupt import StopRequest
from viscodesign.pump.boards.line_regulator import LineRegulator
from viscodesign.pump.bus.byte_log import LoggedLine, SentBytes
from viscodesign.pump.bus.clock import SteppedClock
from viscodesign.pump.kinds.connection import Connection
from viscodesign.pump.kinds.regulator import RegulatorKind
from viscodesign.pump.play.stream import Stream
from viscodesign.pump.play.stream_result import OnStop, StreamResult, TickReport
from viscodesign.pump.profile import Profile
from viscodesign.pump.simulated.device import DirectLine
from viscodesign.pump.simulated.regulator import SimulatedRegulator
from viscodesign.scene.pumps.regulator import HIGHEST_SET_POINT, RegulatorSpec

AMBIENT = 101_325.0
RATE = 20.0


class FaultyRegulator(SimulatedRegulator):
    """One whose outlet, replies and cable somebody spoils."""

    extra = 0.0  # what else presses at its outlet [Pa]
    deaf = False  # no command gets through
    mute = False  # no reply gets through
    late = 0.0  # by which replies come later [s]
    stuck = False  # its outlet follows no more

    def feed(self, data: bytes, now: float) -> None:
        if not self.deaf:
            super().feed(data, now)

    def take(self, now: float) -> bytes:
        came = super().take(now - self.late)
        return b"" if self.mute else came

    def due(self) -> float:
        return math.inf if self.mute else super().due() + self.late

    def answer(self, command: str) -> str:
        if command != "MON":
            return super().answer(command)
        pressure = self.pressure + self.extra
        return str(min(max(round(pressure / self.spec.step), 0), HIGHEST_SET_POINT))

    def _step(self, seconds: float) -> None:
        super()._step(0.0 if self.stuck else seconds)


@dataclass
class RegulatorRig:
    """Up and down by 8 kPa in two seconds."""

    on_stop: OnStop = "hold"
    spec: RegulatorSpec = field(default_factory=lambda: RegulatorSpec(full_scale=100e3))

    def __post_init__(self) -> None:
        self.clock = SteppedClock()
        self.device = FaultyRegulator(self.spec)
        self.log = SentBytes()
        self.board = LineRegulator(LoggedLine(DirectLine(self.device, self.clock), self.log))
        kind = RegulatorKind()
        self.link = Connection(
            kind, self.board, self.log, self.clock, self.spec, AMBIENT, ("inlet",)
        )
        self.request = StopRequest()
        self.rows: list[TickReport] = []
        self.happen: Callable[[TickReport], None] = lambda report: None

    def observe(self, report: TickReport) -> None:
        self.rows.append(report)
        self.happen(report)

    def profile(self) -> Profile:
        time = np.linspace(0.0, 2.0, 81)
        pressure = 8e3 * np.sin(np.pi * time / 2)[:, None] ** 2
        return Profile(("inlet",), (1,), time, pressure / self.spec.step, pressure)

    def play(self) -> StreamResult:
        with self.link.gauges() as gauges:
            self.pump = self.link.connected_pump(gauges)
            self.pump.connect()
            self.stream = Stream(
                self.pump, self.profile(), self.request, self.observe, rate=RATE,
                on_stop=self.on_stop,
            )  # fmt: skip
            return self.stream.play()

    @property
    def set_points(self) -> list[int]:
        """Every set-point that was sent, in order."""
        words = [sent.decode().split() for sent in self.log.sent]
        return [int(word[1]) for word in words if word[0] == "SET"]
