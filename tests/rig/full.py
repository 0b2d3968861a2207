"""Servos and firmware with all that they do, also what the program never asks for."""

from __future__ import annotations

from dataclasses import dataclass, field

from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.protocol.packets import BROADCAST, Instruction, Packet
from viscodesign.pump.ax.protocol.transactions import ARBOTIX
from viscodesign.pump.simulated.firmware import Work
from viscodesign.pump.simulated.pypose import LOOP, SIZE_POSE, PoseEngine
from viscodesign.pump.simulated.ros import Pins, Ros
from viscodesign.pump.simulated.servo import SimulatedServo

SYNC_READ = 0x84
CONTROL_SETUP, CONTROL_WRITE = 26, 27


@dataclass
class BrokenPins(Pins):
    """Some pins give one value whatever happens: 'A0' a ratio, 'D1' a level."""

    broken: dict[str, float] = field(default_factory=dict)

    def analog(self, channel: int) -> float:
        return self.broken.get(f"A{channel}", super().analog(channel))

    def high(self, pin: int, pulled_up: bool) -> bool:
        return bool(self.broken.get(f"D{pin}", super().high(pin, pulled_up)))


class FullServo(SimulatedServo):
    """Also registers writes until an ACTION, and goes back to what it was delivered with."""

    later: bytes | None = None

    def _do(self, packet: Packet) -> tuple[int, bytes]:
        match packet.code:
            case Instruction.REG_WRITE if len(packet.parameters) > 1:
                self._register(packet.parameters)
            case Instruction.ACTION if self.later:
                given = self.later
                self._register(None)
                return self._write(given[0], given[1:]), b""
            case Instruction.RESET:
                self.factory_reset()
            case _:
                return super()._do(packet)
        return 0, b""

    def _register(self, later: bytes | None) -> None:
        self.later = later
        self.set(registers.REGISTERED, int(later is not None))


class FullRos(Ros):
    """Also reads several servos at once and plays poses; its controllers are only acknowledged."""

    def start(self) -> None:
        super().start()
        self.engine = PoseEngine(self)

    def obey(self, packet: Packet) -> Work:
        if packet.id == BROADCAST and packet.code == SYNC_READ:
            yield from self._sync_read(packet)
        else:
            yield from super().obey(packet)

    def own(self, packet: Packet) -> Work:
        if packet.code in (CONTROL_SETUP, CONTROL_WRITE):
            self.reply(ARBOTIX, 0)
        elif SIZE_POSE <= packet.code <= LOOP:
            self.reply(ARBOTIX, 0)
            yield from self._play(packet)
        else:
            yield from super().own(packet)

    def _sync_read(self, packet: Packet) -> Work:
        start, count = packet.parameters[:2]
        data = b""
        for servo in packet.parameters[2:]:
            value = yield from self.ask_servo(servo, start, count)
            data += self._received[5 : 5 + count] if value >= 0 else b"\xff" * count
        self.reply(BROADCAST, 0, data)

    def _play(self, packet: Packet) -> Work:
        length = len(packet.parameters)
        yield from self.engine.obey(packet.code, bytes(self._parameters), length)
        if packet.code == LOOP:  # its condition is the wrong way round
            yield from self.engine.play()
            while self.engine.halted:
                yield from self.engine.play()
