"""A pump on the bench with everything that can happen to it, and all that went over its wire."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from tests.pumps import HOME, Weights, bench, pump
from tests.rig.bus import BusAdapter
from viscodesign.interrupt import StopRequest
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.protocol.packets import Instruction, Packet, Parser
from viscodesign.pump.ax.servo_pump import ServoPump
from viscodesign.pump.boards.dynamixel import Dynamixel
from viscodesign.pump.bus.clock import SteppedClock
from viscodesign.pump.bus.line import Line
from viscodesign.pump.play.stream import Stream
from viscodesign.pump.play.stream_result import OnStop, StreamResult, TickReport
from viscodesign.pump.profile import Profile
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.pump.simulated.bench import SimulatedBench
from viscodesign.pump.simulated.device import DirectLine

AMBIENT = 101_325.0
RATE = 30.0
TRAVEL = (100, 1000)


class Tap(Line):
    """Counts requests, keeps them with what the servos were doing, and lets things happen."""

    def __init__(self, line: Line, rig: Rig) -> None:
        self.line = line
        self.clock = line.clock
        self.rig = rig
        self.sent: list[Sent] = []
        self.coming: Sent | None = None
        """What is about to be sent, while something happens."""
        self.happen: Callable[[int], None] = lambda number: None
        """Called before each request with its number, from 1 on."""
        self.change: Callable[[bytes], bytes] = lambda data: data
        """What becomes of bytes that come."""

    def write(self, data: bytes) -> None:
        (packet,) = Parser().feed(data)
        self.coming = self._noted(packet)
        self.happen(len(self.sent) + 1)
        self.sent.append(self._noted(packet))
        self.line.write(data)

    def _noted(self, packet: Packet) -> Sent:
        positions = {s.get(registers.ID): s.position for s in self.rig.bench.servos}
        return Sent(packet, positions, self.clock.now())

    def read(self, most: int, deadline: float) -> bytes:
        return self.change(self.line.read(most, deadline))

    def drain(self) -> bytes:
        return self.line.drain()

    def close(self) -> None:
        self.line.close()


@dataclass(frozen=True)
class Sent:
    """One request, and where the servos were when it was sent."""

    packet: Packet
    positions: dict[int, float]
    time: float

    def writes(self) -> Iterator[tuple[int, int, bytes]]:
        """(servo, address, data) of everything that it sets."""
        given = self.packet.parameters
        if self.packet.code in (Instruction.WRITE, Instruction.REG_WRITE):
            yield self.packet.id, given[0], given[1:]
        if self.packet.code == Instruction.SYNC_WRITE:
            start, length = given[0], given[1]
            for place in range(2, len(given), length + 1):
                yield given[place], start, given[place + 1 : place + 1 + length]

    def sets_limit_of(self) -> set[int]:
        """Servos of whose torque limit it writes one byte or both."""
        limit = registers.TORQUE_LIMIT
        both = {limit.address, limit.address + 1}
        return {
            servo
            for servo, start, data in self.writes()
            if both & {*range(start, start + len(data))}
        }

    def register(self, register: registers.Register) -> dict[int, int]:
        """By servo, what it writes into a register."""
        return {
            servo: register.within(data, start)
            for servo, start, data in self.writes()
            if start <= register.address < start + len(data)
        }


@dataclass
class Rig:
    """Two plungers or one; the profile swings by 40 counts for a second and a half."""

    ids: Sequence[int] = (1,)
    on_stop: OnStop = "hold"
    settings: dict[str, Any] = field(default_factory=dict)
    pressure: float = 2e3
    """Gauge, at all inlets [Pa]."""
    reading: Callable[[float], float] = lambda pressure: pressure
    """What the sensors make of it."""
    pins: dict[str, bool] = field(default_factory=dict)
    """Levels of digital pins."""
    duration: float = 1.5
    max_lag: float = 3.0

    def __post_init__(self) -> None:
        self.clock = SteppedClock()
        self.plant = Weights(np.full(len(self.ids), self.pressure))
        self.bench: SimulatedBench = bench(*self.ids, plant=self.plant, **self.settings)
        for servo in self.bench.servos:
            servo.supply(11.1)
            servo.set(registers.CW_LIMIT, TRAVEL[0])
            servo.set(registers.CCW_LIMIT, TRAVEL[1])
        self.adapter = BusAdapter(self.bench)
        self.tap = Tap(DirectLine(self.adapter, self.clock), self)
        self.board = PinBoard(self.tap, self.ids)
        self.board.pins = self.pins
        self.spec = pump(travel=TRAVEL, **self.settings)
        self.pump = ServoPump(
            self.board,
            self.spec,
            self.ids,
            PressureReadings(
                [lambda k=k: self._absolute(k) for k in range(len(self.ids))], AMBIENT
            ),
            self.clock,
        )
        self.request = StopRequest()
        self.rows: list[TickReport] = []
        self.see: Callable[[TickReport], None] = self.rows.append
        self.stream: Stream | None = None

    def _absolute(self, inlet: int) -> float:
        return AMBIENT + self.reading(float(self.plant.pressures[inlet]))

    def press(self, pressure: float, inlet: int | None = None) -> None:
        """Another gauge pressure at an inlet or at all, felt by the plungers too [Pa]."""
        pressures = self.plant.pressures.copy()
        pressures[slice(None) if inlet is None else inlet] = pressure
        self.plant.pressures = pressures

    def profile(self) -> Profile:
        time = np.linspace(0.0, self.duration, 61)
        swing = HOME + 40 + 40 * np.sin(2 * np.pi * time / 1.5)
        counts = np.repeat(swing[:, None], len(self.ids), axis=1)
        names = tuple("inlet" if len(self.ids) == 1 else f"inlet{k}" for k in self.ids)
        return Profile(names, tuple(self.ids), time, counts, np.full(counts.shape, 2e3))

    def begin(self) -> None:
        """Connected and armed, as a command does it."""
        self.pump.connect()
        self.pump.arm()

    def play(self) -> StreamResult:
        """All of it: connect, arm, stream."""
        self.pump.connect()
        return self.play_armed()

    def play_armed(self) -> StreamResult:
        self.stream = Stream(
            self.pump,
            self.profile(),
            self.request,
            lambda shown: self.see(shown),
            rate=RATE,
            on_stop=self.on_stop,
            max_lag=self.max_lag,
        )
        return self.stream.play()

    def wait(self, seconds: float) -> None:
        """Let time pass, the host silent."""
        self.clock.sleep(seconds)
        self.bench.advance(self.clock.now())

    def positions(self) -> list[float]:
        return [servo.position for servo in self.bench.servos]


class PinBoard(Dynamixel):
    """An adapter that also reads pins."""

    has_pins = True
    pins: dict[str, bool]

    def digital(self, pin: str) -> bool | None:
        return self.pins[pin]
