"""What the bus sees of a computed servo: instructions in, status packets out."""

from __future__ import annotations

from viscodesign.pump.bus import registers as table
from viscodesign.pump.bus.packets import BROADCAST, ErrorBits, Instruction, Packet
from viscodesign.pump.simulated.servo import HIGHEST, WRITABLE, SimulatedServo

NEEDED_LEVEL: dict[int, int] = {Instruction.PING: 0, Instruction.READ: 1}
"""Status return level from which an instruction is answered; others from 2."""


class Access:
    """One servo's share in the protocol."""

    def __init__(self, servo: SimulatedServo) -> None:
        self.servo = servo
        self._registered: bytes | None = None

    @property
    def return_delay(self) -> float:
        """Between request and reply [s]."""
        return 2e-6 * self.servo.get(table.RETURN_DELAY)

    def answer(self, packet: Packet) -> Packet | None:
        """Do what a packet says; the reply, where the servo gives one."""
        servo = self.servo
        own = servo.get(table.ID)
        if not servo.awake or packet.id not in (own, BROADCAST):
            return None
        servo.refresh()
        level = servo.get(table.STATUS_LEVEL)
        errors, data = self._do(packet)
        if packet.id == BROADCAST or level < NEEDED_LEVEL.get(packet.code, 2):
            return None
        return Packet(own, errors | servo.errors, data)

    def _do(self, packet: Packet) -> tuple[int, bytes]:
        """Error bits and data."""
        match packet.code:
            case Instruction.PING:
                return 0, b""
            case Instruction.READ if len(packet.parameters) == 2:
                return self._read(*packet.parameters)
            case Instruction.WRITE if len(packet.parameters) > 1:
                return self.write(packet.parameters[0], packet.parameters[1:]), b""
            case Instruction.REG_WRITE if len(packet.parameters) > 1:
                self._register(packet.parameters)
            case Instruction.ACTION if self._registered:
                todo = self._registered
                self._register(None)
                return self.write(todo[0], todo[1:]), b""
            case Instruction.RESET:
                self.servo.factory_reset()
            case Instruction.SYNC_WRITE:
                self._sync_write(packet.parameters)
            case _:
                return ErrorBits.INSTRUCTION, b""
        return 0, b""

    def _register(self, todo: bytes | None) -> None:
        self._registered = todo
        self.servo.set(table.REGISTERED, int(todo is not None))

    def _read(self, start: int, count: int) -> tuple[int, bytes]:
        if start + count > table.END:
            return ErrorBits.RANGE, b""
        return 0, bytes(self.servo.memory[start : start + count])

    def write(self, start: int, data: bytes) -> ErrorBits:
        """Set registers, all of them or none; the error bits of that."""
        servo = self.servo
        addresses = range(start, start + len(data))
        locked = start < table.RAM and servo.get(table.LOCK)
        if locked or not WRITABLE.issuperset(addresses):
            return ErrorBits.RANGE
        memory = bytearray(servo.memory)
        memory[start : addresses.stop] = data
        new = {register: register.within(bytes(memory), 0) for register in table.TABLE}
        touched = {r for r in new if {r.address, r.address + r.size - 1} & set(addresses)}
        if any(new[register] > HIGHEST.get(register, 255) for register in touched):
            return ErrorBits.RANGE
        low, high = servo.get(table.CW_LIMIT), servo.get(table.CCW_LIMIT)
        goal = table.GOAL_POSITION in touched and not servo.wheel
        if goal and not low <= new[table.GOAL_POSITION] <= high:
            return ErrorBits.ANGLE_LIMIT
        servo.memory[:] = memory
        if goal:
            servo.set(table.TORQUE_ENABLE, 1)
        if table.TORQUE_LIMIT in touched and new[table.TORQUE_LIMIT]:
            servo.alarms = ErrorBits(0)
        return ErrorBits(0)

    def _sync_write(self, parameters: bytes) -> None:
        """Start, length, then id and data of each servo; malformed packets change nothing."""
        if len(parameters) < 2:
            return
        start, length, each = parameters[0], parameters[1], parameters[2:]
        if length == 0 or len(each) % (length + 1):
            return
        for place in range(0, len(each), length + 1):
            if each[place] == self.servo.get(table.ID):
                self.write(start, each[place + 1 : place + 1 + length])
