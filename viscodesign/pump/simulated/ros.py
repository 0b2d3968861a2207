"""The ArbotiX' firmware for ROS: registers of the board itself, and the bus behind it.

Read from `ros.ino` of vanadiumlabs' arbotix_ros repository. Its hobby servos and its wheels
are left out, and so are its controllers (CONTROL_*), which are acknowledged and do nothing.
"""

from __future__ import annotations

from viscodesign.pump.bus.packets import BROADCAST, ErrorBits, Instruction, Packet, Parser
from viscodesign.pump.bus.transactions import ARBOTIX
from viscodesign.pump.simulated.bench import SimulatedBench
from viscodesign.pump.simulated.firmware import Firmware, Work
from viscodesign.pump.simulated.pins import Pins
from viscodesign.pump.simulated.pose_engine import PoseEngine
from viscodesign.pump.simulated.pypose import LOAD_POSE, LOAD_SEQ, LOOP, PLAY, SIZE_POSE

MODEL, VERSION, BAUD = 300, 0, 34
DIGITAL_IN, RESCAN, RETURN_LEVEL, ALARM_LED, ANALOG, SERVOS = 5, 15, 16, 17, 18, 26
MOVING, DIGITAL_OUT, USER = 46, 47, 79
SYNC_READ = 0x84
CONTROL_SETUP, CONTROL_WRITE = 26, 27
CONVERSION = 450e-6
"""Four analog conversions [s]."""


class Ros(Firmware):
    """115200 baud; model 300."""

    baud = 115_200
    checksum_error = ErrorBits.CHECKSUM

    def __init__(
        self, bench: SimulatedBench, pins: Pins | None = None, latency: float = 1e-3
    ) -> None:
        self.pins = pins or Pins(bench)
        super().__init__(bench, latency)

    def start(self) -> None:
        self.engine = PoseEngine(self)
        self._outputs = bytearray(32)
        self._bus = Parser()
        self._return_level = 1

    def obey(self, packet: Packet) -> Work:
        if packet.id == ARBOTIX:
            yield from self._own(packet)
        elif packet.id == BROADCAST and packet.code == SYNC_READ:
            yield from self._sync_read(packet)
        elif packet.id == BROADCAST:
            self._to_bus(packet)
        elif packet.code == Instruction.READ:
            yield from self.pass_read(packet)
        elif packet.code == Instruction.WRITE:
            yield from self.pass_write(packet)

    def _to_bus(self, packet: Packet) -> None:
        """As it came, and one byte of what lay in the buffer before."""
        stale = self._parameters[len(packet.parameters) + 1 :][:1]
        for heard in self._bus.feed(packet.encode() + stale):
            self.bench.answer(heard, self.now)

    def _sync_read(self, packet: Packet) -> Work:
        start, count = packet.parameters[:2]
        data = b""
        for servo in packet.parameters[2:]:
            value = yield from self.ask_servo(servo, start, count)
            data += self._received[5 : 5 + count] if value >= 0 else b"\xff" * count
        self.reply(BROADCAST, 0, data)

    def _own(self, packet: Packet) -> Work:
        match packet.code:
            case Instruction.READ:
                start, count = self._parameters[0], self._parameters[1]
                channels = sum(ANALOG <= a < SERVOS for a in range(start, start + count))
                yield self.now + channels * CONVERSION
                data = bytes(self._register(start + i) for i in range(count))
                self.reply(ARBOTIX, 0, data)
            case Instruction.WRITE:
                self.reply(ARBOTIX, self._write(packet.parameters))
            case code if code in (CONTROL_SETUP, CONTROL_WRITE):
                self.reply(ARBOTIX, 0)
            case _:
                yield from self._play(packet)

    def _play(self, packet: Packet) -> Work:
        if packet.code in (SIZE_POSE, LOAD_POSE, LOAD_SEQ, PLAY, LOOP):
            self.reply(ARBOTIX, 0)
        match packet.code:
            case code if code == SIZE_POSE:
                yield from self.engine.set_size(self._parameters[0])
            case code if code == LOAD_POSE:
                self.engine.load_pose(bytes(self._parameters))
            case code if code == LOAD_SEQ:
                self.engine.load_sequence(bytes(self._parameters), len(packet.parameters) + 2)
            case code if code == PLAY:
                yield from self.engine.play()
            case code if code == LOOP:  # its condition is the wrong way round
                yield from self.engine.play()
                while self.engine.halted:
                    yield from self.engine.play()

    def _register(self, address: int) -> int:
        """One byte of the board's own registers."""
        known = {0: MODEL & 255, 1: MODEL >> 8, 2: VERSION, 3: ARBOTIX, 4: BAUD}
        if address in known:
            return known[address]
        if DIGITAL_IN <= address < DIGITAL_IN + 4:
            return self._port(address - DIGITAL_IN)
        if address == RETURN_LEVEL:
            return self._return_level
        if ANALOG <= address < SERVOS:
            return min(int(self.pins.analog(address - ANALOG) * 1024), 1023) >> 2
        return 0

    def _port(self, port: int) -> int:
        """Levels of eight pins."""
        return sum(self._level(8 * port + bit) << bit for bit in range(8))

    def _level(self, pin: int) -> bool:
        """Of an output its own; of an input the pin's, pulled up where its output is high."""
        high, output = bool(self._outputs[pin] & 2), bool(self._outputs[pin] & 1)
        return high if output else self.pins.high(pin, pulled_up=high)

    def _write(self, parameters: bytes) -> int:
        """Byte by byte until one is refused; the error of that."""
        for address, value in enumerate(parameters[1:], parameters[0]):
            if DIGITAL_OUT <= address < USER:
                self._outputs[address - DIGITAL_OUT] = value
            elif address == RETURN_LEVEL:
                self._return_level = value
            elif address not in (BAUD, RESCAN, ALARM_LED):
                return ErrorBits.INSTRUCTION
        return 0
