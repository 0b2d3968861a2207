"""The ArbotiX' firmware for ROS: registers of the board itself, and the bus behind it.

Read from `ros.ino` of vanadiumlabs' arbotix_ros repository. Left out is what this program does
not ask for: poses, SYNC_READ, controllers, hobby servos and wheels.
"""

from __future__ import annotations

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.protocol.packets import BROADCAST, ErrorBits, Instruction, Packet, Parser
from viscodesign.pump.ax.protocol.transactions import ARBOTIX, ROS_MODEL
from viscodesign.pump.sensors.pressure_sensors import HIGHEST_RATIO, LOWEST_RATIO, ratio_of
from viscodesign.pump.simulated.bench import SimulatedBench
from viscodesign.pump.simulated.firmware import Firmware, Work
from viscodesign.pump.simulated.plant import AMBIENT
from viscodesign.scene.per_inlet import each
from viscodesign.scene.pumps.servo import ServoPumpSpec

IDENTITY = bytes([ROS_MODEL & 255, ROS_MODEL >> 8, 0, ARBOTIX, 34])  # model, version, id, baud
BAUD, INPUT_PINS, RESCAN, RETURN_LEVEL, ALARM_LED = 4, 5, 15, 16, 17
ANALOG_PINS, SERVO_REGISTERS, OUTPUT_PINS, USER = 18, 26, 47, 79
CONVERSION = 450e-6  # four analog conversions [s]
SWITCH_DISTANCE = 10  # of the limit switches behind the ends of travel [counts]


@dataclass
class Pins:
    """Each plunger's sensor and switches, where the spec connects them."""

    bench: SimulatedBench
    ambient: float = AMBIENT
    """Absolute [Pa]."""

    def analog(self, channel: int) -> float:
        """Voltage over supply; channels without a sensor float about zero."""
        sensors = each(self.bench.drives[0].pump.sensor, len(self.bench.servos))
        for sensor, pressure in zip(sensors, self.bench.pressures, strict=True):
            if sensor is not None and sensor.channel == channel:
                ratio = ratio_of(self.ambient + float(pressure))
                return min(max(ratio, LOWEST_RATIO), HIGHEST_RATIO)
        return 0.0

    def high(self, pin: int, pulled_up: bool) -> bool:
        """Level of a digital pin; an open one is high only where it is pulled up."""
        return pulled_up and not self._grounded(f"D{pin}")

    def _grounded(self, name: str) -> bool:
        """Whether a switch connects the pin to ground now."""
        pump: ServoPumpSpec = self.bench.drives[0].pump
        low, high = pump.travel
        servos = self.bench.servos
        for servo, pair in zip(servos, each(pump.limit_switches, len(servos)), strict=True):
            if pair is not None and name in (pair.low, pair.high):
                pressed = (
                    servo.position < low - SWITCH_DISTANCE
                    if name == pair.low
                    else servo.position > high + SWITCH_DISTANCE
                )
                return pressed == (pair.normally == "open")
        return False


class Ros(Firmware):
    """115200 baud; model 300."""

    baud = 115_200
    checksum_error = ErrorBits.CHECKSUM

    def __init__(self, bench: SimulatedBench, pins: Pins | None = None) -> None:
        self.pins = pins or Pins(bench)
        super().__init__(bench)

    def start(self) -> None:
        self._outputs = bytearray(32)
        self._bus = Parser()

    def obey(self, packet: Packet) -> Work:
        if packet.id == BROADCAST:
            # As it came, and one byte of what lay in the buffer before.
            stale = self._parameters[len(packet.parameters) + 1 :][:1]
            for heard in self._bus.feed(packet.encode() + stale):
                self.bench.answer(heard, self.now)
        else:
            yield from super().obey(packet)

    def own(self, packet: Packet) -> Work:
        if packet.code == Instruction.READ:
            addresses = range(self._parameters[0], self._parameters[0] + self._parameters[1])
            yield self.now + sum(ANALOG_PINS <= a < SERVO_REGISTERS for a in addresses) * CONVERSION
            self.reply(ARBOTIX, 0, bytes(self._register(a) for a in addresses))
        elif packet.code == Instruction.WRITE:
            self.reply(ARBOTIX, self._write(packet.parameters))

    def _register(self, address: int) -> int:
        """One byte of the board's own registers."""
        if address < len(IDENTITY):
            return IDENTITY[address]
        if INPUT_PINS <= address < INPUT_PINS + 4:
            first = 8 * (address - INPUT_PINS)
            return sum(self._level(first + bit) << bit for bit in range(8))
        if ANALOG_PINS <= address < SERVO_REGISTERS:
            return min(int(self.pins.analog(address - ANALOG_PINS) * 1024), 1023) >> 2
        return int(address == RETURN_LEVEL)

    def _level(self, pin: int) -> bool:
        """Whether a pin is high: an output as set, an input pulled up where it is set high."""
        high, output = bool(self._outputs[pin] & 2), bool(self._outputs[pin] & 1)
        return high if output else self.pins.high(pin, pulled_up=high)

    def _write(self, parameters: bytes) -> int:
        """Byte by byte until one is refused; the error of that."""
        for address, value in enumerate(parameters[1:], parameters[0]):
            if OUTPUT_PINS <= address < USER:
                self._outputs[address - OUTPUT_PINS] = value
            elif address not in (BAUD, RESCAN, RETURN_LEVEL, ALARM_LED):
                return ErrorBits.INSTRUCTION
        return 0
