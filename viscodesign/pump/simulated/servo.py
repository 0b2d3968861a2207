"""A simulated AX servo: registers, alarms and the law of its motion.

Source of the registers: ROBOTIS e-manual, AX-12A and AX-18A. What the manual leaves open is
assumed: a goal outside of the limits is reported and not followed; a motor that is held back
at its highest torque for a second is overloaded.
"""

from __future__ import annotations

import math

from viscodesign.pump.bus import registers as table
from viscodesign.pump.bus.packets import ErrorBits
from viscodesign.pump.bus.registers import Register
from viscodesign.pump.drive import COUNTS_PER_TURN
from viscodesign.pump.servo_motor import SERVOS_BY_MODEL
from viscodesign.pump.simulated.motor import MOTORS

AMBIENT_TEMPERATURE = 25.0
OVERLOAD_TIME = 1.0
"""[s]; assumed."""
STILL = 1.0
"""Counts a second."""
BROWN_OUT = 5.0
"""Supply below which the servo's processor stops [V]; assumed."""
FULL = 1023

FACTORY: dict[Register, int] = {
    table.FIRMWARE: 24,
    table.ID: 1,
    table.BAUD: 1,
    table.RETURN_DELAY: 250,
    table.CCW_LIMIT: FULL,
    table.LOWEST_VOLTAGE: 60,
    table.HIGHEST_VOLTAGE: 140,
    table.STATUS_LEVEL: 2,
    table.ALARM_LED: 36,
    table.SHUTDOWN: 36,
}
AWAKE: dict[Register, int] = {
    table.CW_MARGIN: 1,
    table.CCW_MARGIN: 1,
    table.CW_SLOPE: 32,
    table.CCW_SLOPE: 32,
    table.PUNCH: 32,
}
"""What registers without memory hold after power came."""
HIGHEST: dict[Register, int] = {
    table.ID: 253,
    table.RETURN_DELAY: 254,
    table.CW_LIMIT: FULL,
    table.CCW_LIMIT: FULL,
    table.MAX_TORQUE: FULL,
    table.STATUS_LEVEL: 2,
    table.TORQUE_ENABLE: 1,
    table.GOAL_POSITION: FULL,
    table.MOVING_SPEED: 2047,
    table.TORQUE_LIMIT: FULL,
    table.PUNCH: FULL,
}
WRITABLE = {
    register.address + byte
    for register in table.TABLE
    if register.writable
    for byte in range(register.size)
}


class SimulatedServo:
    """One servo; `access.py` is what the bus sees of it."""

    def __init__(self, id: int = 1, model: int = 18, position: float = 512.0) -> None:
        self.memory = bytearray(table.END)
        self.position = position
        """Counts, not rounded."""
        self.speed = 0.0
        """Counts a second."""
        self.output = 0.0
        """Of the motor, -1 to 1 of what the supply gives."""
        self.voltage = 12.0
        self.temperature = AMBIENT_TEMPERATURE
        self.alarms = ErrorBits(0)
        """Overload and overheat since the last time that somebody gave torque again."""
        self._model = model
        self._held_back = 0.0
        self.factory_reset()
        self.set(table.ID, id)

    def get(self, register: Register) -> int:
        return register.within(bytes(self.memory), 0)

    def set(self, register: Register, value: int) -> None:
        end = register.address + register.size
        self.memory[register.address : end] = register.encode(value)

    def factory_reset(self) -> None:
        self.memory[: table.RAM] = bytes(table.RAM)
        kind = SERVOS_BY_MODEL[self._model]
        own = {
            table.MODEL: kind.model,
            table.TEMPERATURE_LIMIT: kind.temperature_limit,
            table.MAX_TORQUE: kind.max_torque,
        }
        for register, value in (FACTORY | own).items():
            self.set(register, value)
        self.power_cycle()

    def power_cycle(self) -> None:
        """Power went and came: what is no EEPROM begins anew."""
        self.memory[table.RAM :] = bytes(table.END - table.RAM)
        for register, value in AWAKE.items():
            self.set(register, value)
        self.set(table.TORQUE_LIMIT, self.get(table.MAX_TORQUE))
        self.set(table.GOAL_POSITION, round(self.position))
        self.alarms = ErrorBits(0)
        self._held_back = 0.0
        self.output = self.speed = 0.0

    @property
    def awake(self) -> bool:
        return self.voltage >= BROWN_OUT

    @property
    def errors(self) -> ErrorBits:
        """Of every status packet now."""
        low, high = self.get(table.LOWEST_VOLTAGE), self.get(table.HIGHEST_VOLTAGE)
        strange = not low <= 10 * self.voltage <= high
        return self.alarms | (ErrorBits.VOLTAGE if strange else ErrorBits(0))

    def supply(self, voltage: float) -> None:
        """Another supply voltage; from below the brown-out the servo starts anew."""
        was_awake, self.voltage = self.awake, voltage
        if self.awake and not was_awake:
            self.power_cycle()

    def advance(self, seconds: float, load: float) -> None:
        """Move for a short while; ``load`` pushes towards higher counts [N m]."""
        self.output = self._commanded() if self.awake else 0.0
        motor = MOTORS[self._model]
        free = motor.speed(self.output, self.voltage if self.awake else 0.0, load)
        self.speed = self._limited(free, seconds)
        if 0.0 < abs(self.speed) < abs(free):
            self.output = motor.output(self.speed, self.voltage, load)
        self.position = min(max(self.position + self.speed * seconds, 0.0), float(FULL))
        rise = motor.heating * self.output**2
        fall = (self.temperature - AMBIENT_TEMPERATURE) / motor.cooling_time
        self.temperature += seconds * (rise - fall)
        self._watch(seconds)

    def refresh(self) -> None:
        """Bring the registers of the present up to date."""
        self.set(table.PRESENT_POSITION, 0 if self.wheel else round(self.position))
        self.set(table.PRESENT_SPEED, _directed(self.speed / _counts_per_second(1)))
        self.set(table.PRESENT_LOAD, _directed(FULL * self.output))
        self.set(table.PRESENT_VOLTAGE, round(10 * self.voltage))
        self.set(table.PRESENT_TEMPERATURE, round(self.temperature))
        self.set(table.MOVING, int(abs(self.speed) > STILL and self.output != 0.0))

    @property
    def wheel(self) -> bool:
        """Both angle limits 0: turns for ever, and its position means nothing."""
        return self.get(table.CW_LIMIT) == self.get(table.CCW_LIMIT) == 0

    def _commanded(self) -> float:
        """Output of the motor: full far from the goal, less within the compliance slope."""
        if not self.get(table.TORQUE_ENABLE):
            return 0.0
        limit = min(self.get(table.TORQUE_LIMIT), self.get(table.MAX_TORQUE)) / FULL
        if self.wheel:
            given = self.get(table.MOVING_SPEED)
            return max(min((given & FULL) / FULL, limit), 0.0) * (-1 if given & 0x400 else 1)
        error = self.get(table.GOAL_POSITION) - self.position
        clockwise = error < 0
        beyond = abs(error) - self.get(table.CW_MARGIN if clockwise else table.CCW_MARGIN)
        if beyond <= 0.0:
            return 0.0
        slope = max(self.get(table.CW_SLOPE if clockwise else table.CCW_SLOPE), 1)
        punch = self.get(table.PUNCH) / FULL
        return math.copysign(min(punch + (1.0 - punch) * beyond / slope, limit, 1.0), error)

    def _limited(self, speed: float, seconds: float) -> float:
        """No faster towards the goal than the register says, and not past it."""
        if self.wheel or speed * self.output <= 0.0:
            return speed
        register = self.get(table.MOVING_SPEED) & FULL
        most = _counts_per_second(register) if register else math.inf
        left = abs(self.get(table.GOAL_POSITION) - self.position) / seconds
        return math.copysign(min(abs(speed), most, left), speed)

    def _watch(self, seconds: float) -> None:
        limit = min(self.get(table.TORQUE_LIMIT), self.get(table.MAX_TORQUE)) / FULL
        towards_goal = math.copysign(self.speed, self.speed * self.output)
        stuck = 0.0 < limit <= abs(self.output) and towards_goal < STILL
        self._held_back = self._held_back + seconds if stuck else 0.0
        if self._held_back >= OVERLOAD_TIME:
            self.alarm(ErrorBits.OVERLOAD)
        if self.temperature > self.get(table.TEMPERATURE_LIMIT):
            self.alarm(ErrorBits.OVERHEAT)

    def alarm(self, bit: ErrorBits) -> None:
        """Report it, and let go where the shutdown register says so."""
        self.alarms |= bit
        if self.get(table.SHUTDOWN) & bit:
            self.set(table.TORQUE_LIMIT, 0)
            self._held_back = 0.0


def _counts_per_second(register: int) -> float:
    return register * table.SPEED_UNIT * COUNTS_PER_TURN


def _directed(value: float) -> int:
    return min(round(abs(value)), FULL) | (0x400 if value < 0 else 0)
