"""A simulated AX servo: registers, instructions, alarms and the law of its motion.

Source of the registers: ROBOTIS e-manual, AX-12A and AX-18A. What the manual leaves open is
assumed: a goal outside of the limits is reported and not followed; a motor that is held back
at its highest torque for a second is overloaded.
"""

from __future__ import annotations

import math

from viscodesign.pump.ax.protocol import registers as table
from viscodesign.pump.ax.protocol.packets import BROADCAST, ErrorBits, Instruction, Packet
from viscodesign.pump.ax.protocol.registers import Register
from viscodesign.pump.simulated.motor import COOLING_TIME, HEATING, motor_output, motor_speed
from viscodesign.scene.pumps.servo_motor import servos_by_model

AMBIENT_TEMPERATURE = 25.0
OVERLOAD_TIME = 1.0  # [s]; assumed
STANDSTILL_SPEED = 1.0  # [counts/s]
BROWN_OUT = 5.0  # supply below which the servo's processor stops [V]; assumed
COUNTS_PER_SECOND = table.SPEED_UNIT * table.COUNTS_PER_TURN  # of one unit of the speed registers
WRITABLE = {a for register in table.TABLE if register.writable for a in register.addresses}
NEEDED_LEVEL: dict[int, int] = {Instruction.PING: 0, Instruction.READ: 1}
"""Status return level from which an instruction is answered; others from 2."""


class SimulatedServo:
    """One servo, its horn on a rack that a load pushes."""

    def __init__(self, id: int = 1, model: int = 18, position: float = 512.0) -> None:
        self.memory = bytearray(table.TABLE_END)
        self.position = position  # counts, not rounded
        self.speed = 0.0  # [counts/s]
        self.output = 0.0  # of the motor, -1 to 1 of what the supply gives
        self.voltage = 12.0
        self.temperature = AMBIENT_TEMPERATURE
        self.alarms = ErrorBits(0)  # overload and overheating since torque was last allowed again
        self._type = servos_by_model()[model]
        self._held_back = 0.0
        self.factory_reset()
        self.set(table.ID, id)

    def get(self, register: Register) -> int:
        # Every step of the motion asks for ten: no copies, and no further calls for most.
        start = register.address
        if register.size == 1:
            return self.memory[start]
        if register.directed:
            return register.within(self.memory, 0)
        return self.memory[start] | self.memory[start + 1] << 8

    def set(self, register: Register, value: int) -> None:
        self.memory[register.address : register.addresses.stop] = register.encode(value)

    def limit_angles(self, low: int, high: int) -> None:
        """Set its own limits [counts], as a calibration does."""
        self.set(table.CW_LIMIT, low)
        self.set(table.CCW_LIMIT, high)

    def factory_reset(self) -> None:
        self._initialise(0)
        self.set(table.MODEL, self._type.model)
        self.set(table.TEMPERATURE_LIMIT, self._type.temperature_limit)
        self.set(table.MAX_TORQUE, self._type.max_torque)
        self.power_cycle()

    def _initialise(self, start: int) -> None:
        for register in table.TABLE:
            if register.address >= start:
                self.set(register, register.initial)

    def power_cycle(self) -> None:
        """Everything but the EEPROM begins anew."""
        self._initialise(table.RAM)
        self.set(table.TORQUE_LIMIT, self.get(table.MAX_TORQUE))
        self.set(table.GOAL_POSITION, round(self.position))
        self.alarms = ErrorBits(0)
        self._held_back = self.output = self.speed = 0.0

    @property
    def awake(self) -> bool:
        return self.voltage >= BROWN_OUT

    def supply(self, voltage: float) -> None:
        """Change the supply voltage; from below the brown-out the servo starts anew."""
        was_awake, self.voltage = self.awake, voltage
        if self.awake and not was_awake:
            self.power_cycle()

    def alarm(self, bit: ErrorBits) -> None:
        """Report an alarm, and let go where the shutdown register says so."""
        self.alarms |= bit
        if self.get(table.SHUTDOWN) & bit:
            self.set(table.TORQUE_LIMIT, 0)
            self._held_back = 0.0

    # -- instructions ---------------------------------------------------------------------------

    @property
    def return_delay(self) -> float:
        """Between request and reply [s]."""
        return 2e-6 * self.get(table.RETURN_DELAY)

    def answer(self, packet: Packet) -> Packet | None:
        """Do what a packet says; the reply, where the servo gives one."""
        own = self.get(table.ID)
        if not self.awake or packet.id not in (own, BROADCAST):
            return None
        self._refresh()
        level = self.get(table.STATUS_LEVEL)
        errors, data = self._do(packet)
        if packet.id == BROADCAST or level < NEEDED_LEVEL.get(packet.code, 2):
            return None
        low, high = self.get(table.LOWEST_VOLTAGE), self.get(table.HIGHEST_VOLTAGE)
        if not low <= 10 * self.voltage <= high:
            errors |= ErrorBits.VOLTAGE
        return Packet(own, errors | self.alarms, data)

    def _refresh(self) -> None:
        """Bring the registers of the present up to date."""
        self.set(table.PRESENT_POSITION, 0 if self.wheel else round(self.position))
        self.set(table.PRESENT_SPEED, _directed(self.speed / COUNTS_PER_SECOND))
        self.set(table.PRESENT_LOAD, _directed(table.FULL * self.output))
        self.set(table.PRESENT_VOLTAGE, round(10 * self.voltage))
        self.set(table.PRESENT_TEMPERATURE, round(self.temperature))
        self.set(table.MOVING, int(abs(self.speed) > STANDSTILL_SPEED and self.output != 0.0))

    def _do(self, packet: Packet) -> tuple[int, bytes]:
        """Error bits and data."""
        given = packet.parameters
        match packet.code:
            case Instruction.PING:
                pass
            case Instruction.READ if len(given) == 2:
                start, stop = given[0], given[0] + given[1]
                return (
                    (ErrorBits.RANGE, b"")
                    if stop > table.TABLE_END
                    else (0, bytes(self.memory[start:stop]))
                )
            case Instruction.WRITE if len(given) > 1:
                return self._write(given[0], given[1:]), b""
            case Instruction.SYNC_WRITE:
                self._sync_write(given)
            case _:
                return ErrorBits.INSTRUCTION, b""
        return 0, b""

    def _write(self, start: int, data: bytes) -> ErrorBits:
        """Set registers, all of them or none; the error bits of that."""
        stop = start + len(data)
        locked = start < table.RAM and self.get(table.LOCK)
        if locked or not WRITABLE.issuperset(range(start, stop)):
            return ErrorBits.RANGE
        memory = self.memory[:start] + data + self.memory[stop:]
        touched = {r for r in table.TABLE if r.address < stop and r.addresses.stop > start}
        if any(r.within(memory, 0) > r.highest for r in touched):
            return ErrorBits.RANGE
        low, high = self.get(table.CW_LIMIT), self.get(table.CCW_LIMIT)
        goal = table.GOAL_POSITION in touched and not self.wheel
        if goal and not low <= table.GOAL_POSITION.within(memory, 0) <= high:
            return ErrorBits.ANGLE_LIMIT
        self.memory[:] = memory
        if goal:
            self.set(table.TORQUE_ENABLE, 1)
        if table.TORQUE_LIMIT in touched and self.get(table.TORQUE_LIMIT):
            self.alarms = ErrorBits(0)
        return ErrorBits(0)

    def _sync_write(self, given: bytes) -> None:
        """Start, length, then id and data of each servo; malformed packets change nothing."""
        if len(given) < 2 or given[1] == 0 or (len(given) - 2) % (given[1] + 1):
            return
        for place in range(2, len(given), given[1] + 1):
            if given[place] == self.get(table.ID):
                self._write(given[0], given[place + 1 : place + 1 + given[1]])

    # -- motion ---------------------------------------------------------------------------------

    def advance(self, seconds: float, load: float) -> None:
        """Move for a short while; ``load`` pushes towards higher counts [N m]."""
        self.output = self._commanded() if self.awake else 0.0
        free = motor_speed(self._type, self.output, self.voltage if self.awake else 0.0, load)
        self.speed = self._limited(free, seconds)
        if 0.0 < abs(self.speed) < abs(free):
            self.output = motor_output(self._type, self.speed, self.voltage, load)
        self.position = min(max(self.position + self.speed * seconds, 0.0), float(table.FULL))
        cooling = (self.temperature - AMBIENT_TEMPERATURE) / COOLING_TIME
        self.temperature += seconds * (HEATING * self.output**2 - cooling)
        self._watch(seconds)

    @property
    def wheel(self) -> bool:
        """Both angle limits 0: it would turn without end, which is not simulated."""
        return self.get(table.CW_LIMIT) == self.get(table.CCW_LIMIT) == 0

    @property
    def _torque_share(self) -> float:
        return min(self.get(table.TORQUE_LIMIT), self.get(table.MAX_TORQUE)) / table.FULL

    def _commanded(self) -> float:
        """Output of the motor: full far from the goal, less within the compliance slope."""
        if self.wheel or not self.get(table.TORQUE_ENABLE):
            return 0.0
        error = self.get(table.GOAL_POSITION) - self.position
        clockwise = error < 0
        beyond = abs(error) - self.get(table.CW_MARGIN if clockwise else table.CCW_MARGIN)
        if beyond <= 0.0:
            return 0.0
        slope = max(self.get(table.CW_SLOPE if clockwise else table.CCW_SLOPE), 1)
        punch = self.get(table.PUNCH) / table.FULL
        output = min(punch + (1.0 - punch) * beyond / slope, self._torque_share, 1.0)
        return math.copysign(output, error)

    def _limited(self, speed: float, seconds: float) -> float:
        """No faster towards the goal than the register says, and not past it."""
        if speed * self.output <= 0.0:
            return speed
        most = (self.get(table.MOVING_SPEED) & table.FULL) * COUNTS_PER_SECOND or math.inf
        left = abs(self.get(table.GOAL_POSITION) - self.position) / seconds
        return math.copysign(min(abs(speed), most, left), speed)

    def _watch(self, seconds: float) -> None:
        towards_goal = math.copysign(self.speed, self.speed * self.output)
        stuck = 0.0 < self._torque_share <= abs(self.output) and towards_goal < STANDSTILL_SPEED
        self._held_back = self._held_back + seconds if stuck else 0.0
        if self._held_back >= OVERLOAD_TIME:
            self.alarm(ErrorBits.OVERLOAD)
        if self.temperature > self.get(table.TEMPERATURE_LIMIT):
            self.alarm(ErrorBits.OVERHEAT)


def _directed(value: float) -> int:
    return min(round(abs(value)), table.FULL) | (0x400 if value < 0 else 0)
