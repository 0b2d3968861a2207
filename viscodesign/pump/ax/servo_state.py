"""What each servo is, how it is at one moment, and whether it may be moved."""

from __future__ import annotations

from collections.abc import Iterator

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.protocol.packets import ErrorBits, meaning
from viscodesign.pump.ax.protocol.registers import Register
from viscodesign.pump.boards.base import Board
from viscodesign.pump.play.axis import AxisState, FoundAxis
from viscodesign.scene.pumps.servo import ServoPumpSpec
from viscodesign.scene.pumps.servo_motor import SERVOS, model_title

LOWEST_VOLTAGE = 10.0
"""Below it a battery of three lithium cells is ruined; its servo would go on to 6 V [V]."""
HIGHEST_TEMPERATURE = 70.0
"""AX servos switch themselves off at 70 (AX-12A) or 75 degC (AX-18A) [degC]."""

IDENTITY = registers.STATUS_LEVEL.address + 1  # bytes from address 0 on that tell what a servo is
ANSWERS_ALL = 2  # status return level with which writes are answered too
STATE_ADDRESS = registers.TORQUE_ENABLE.address
STATE_LENGTH = registers.PRESENT_TEMPERATURE.address + 1 - STATE_ADDRESS
NO_ERRORS = ErrorBits(0)


@dataclass(frozen=True)
class ServoState(AxisState):
    """Registers 24 to 43 of a servo, read at once; a step is a count."""

    load: float
    voltage: float
    temperature: float
    moving_speed: int
    """The register; 0 would be full speed."""
    torque_limit: int
    """[1/1023 of stall]"""
    errors: ErrorBits = NO_ERRORS

    @property
    def alarm(self) -> str:
        if self.errors:
            return f"reports: {self.complaint}"
        return "shut itself off: its torque limit is 0" if self.torque_limit == 0 else ""

    @property
    def complaint(self) -> str:
        """What its error bits say, in words."""
        return meaning(self.errors)


def read_servo(board: Board, servo: int) -> ServoState:
    """A servo's state; raises where no registers came, whatever its error bits say."""
    data, errors = board.read_anyway(servo, STATE_ADDRESS, STATE_LENGTH)

    def value(register: Register) -> int:
        return register.within(data, STATE_ADDRESS)

    return ServoState(
        driven=bool(value(registers.TORQUE_ENABLE)),
        goal=value(registers.GOAL_POSITION),
        moving_speed=value(registers.MOVING_SPEED),
        torque_limit=value(registers.TORQUE_LIMIT),
        position=value(registers.PRESENT_POSITION),
        load=value(registers.PRESENT_LOAD) / registers.FULL,
        voltage=value(registers.PRESENT_VOLTAGE) / 10,
        temperature=float(value(registers.PRESENT_TEMPERATURE)),
        errors=errors,
    )


@dataclass(frozen=True)
class FoundServo:
    """One servo as it was found."""

    id: int
    model: int
    firmware: int
    limits: tuple[int, int]
    """Its own angle limits [counts], kept without power; both 0 is wheel mode."""
    status_level: int
    state: ServoState

    @property
    def name(self) -> str:
        return model_title(self.model)

    @property
    def turns_endlessly(self) -> bool:
        return self.limits == (0, 0)

    def axis(self, pump: ServoPumpSpec | None) -> FoundAxis:
        """It for people and programs; with a spec, whether it may be moved."""
        state, (low, high) = self.state, self.limits
        cells = {
            "id": f"{self.id}",
            "model": self.name,
            "position": f"{state.position}",
            "limits": "wheel mode" if self.turns_endlessly else f"{low} to {high}",
            "torque": "on" if state.driven else "off",
            "load": f"{state.load:+.0%}",
            "voltage": f"{state.voltage:.1f} V",
            "heat": f"{state.temperature:.0f} degC",
            "state": state.complaint or "ok",
        }
        document = {
            "id": self.id,
            "model": self.name,
            "firmware": self.firmware,
            "position_counts": state.position,
            "limits_counts": list(self.limits),
            "torque": state.driven,
            "goal_counts": state.goal,
            "load_rel": state.load,
            "voltage_v": state.voltage,
            "temperature_degc": state.temperature,
            "complaint": state.complaint,
        }
        faults = () if pump is None else _faults(self, pump)
        return FoundAxis(self.id, cells, document, [f"servo {self.id}: {f}" for f in faults])


def identify(board: Board, servo: int) -> FoundServo:
    """Read what a servo is and its state; changes nothing."""
    data, _ = board.read_anyway(servo, 0, IDENTITY)
    return FoundServo(
        id=servo,
        model=registers.MODEL.within(data, 0),
        firmware=registers.FIRMWARE.within(data, 0),
        limits=(registers.CW_LIMIT.within(data, 0), registers.CCW_LIMIT.within(data, 0)),
        status_level=registers.STATUS_LEVEL.within(data, 0),
        state=read_servo(board, servo),
    )


def _faults(servo: FoundServo, pump: ServoPumpSpec) -> Iterator[str]:
    state, (low, high) = servo.state, pump.travel
    if servo.model != SERVOS[pump.servo].model:
        title = SERVOS[pump.servo].title
        yield f"is an {servo.name}, but the spec says {title}; correct pump.servo"
    if state.errors:
        yield f"reports: {state.complaint}; see `pump status`, then switch it off and on"
    if state.voltage < LOWEST_VOLTAGE:
        yield f"has {state.voltage:g} V; charge the battery (at least {LOWEST_VOLTAGE:g} V)"
    if state.temperature >= HIGHEST_TEMPERATURE:
        yield f"is at {state.temperature:g} degC; let it cool down (below {HIGHEST_TEMPERATURE:g})"
    if servo.status_level != ANSWERS_ALL:
        yield f"answers at status level {servo.status_level} only; `pump calibrate` sets it to 2"
    if servo.turns_endlessly:
        yield "is in wheel mode (both angle limits 0), where it never stops; run `pump calibrate`"
    elif not low <= servo.limits[0] <= servo.limits[1] <= high:
        yield (
            f"its own angle limits {list(servo.limits)} exceed pump.travel "
            f"[{low}, {high}]: not calibrated for this spec; run `pump calibrate`"
        )
    if not low <= state.position <= high:
        yield (
            f"is at {state.position} counts, outside of pump.travel [{low}, {high}]; "
            "move the plunger by hand with its torque off, or run `pump calibrate`"
        )


@dataclass(frozen=True)
class EepromChange:
    """A register of the EEPROM that is to hold another value: id, angle limits, status level."""

    servo: int
    register: Register
    before: int
    after: int

    def __str__(self) -> str:
        return f"servo {self.servo}: {self.register.name} {self.before} -> {self.after}"

    def write(self, board: Board) -> None:
        """Write it and read it back; only `pump calibrate` does so."""
        data = self.register.encode(self.after)
        board.write_permanent(self.servo, self.register.address, data)


def id_change(old: int, new: int) -> EepromChange:
    """The change that renames a servo."""
    return EepromChange(old, registers.ID, old, new)


def changes(servo: FoundServo, travel: tuple[int, int]) -> list[EepromChange]:
    """What differs from a calibrated servo."""
    calibrated = [
        (registers.CW_LIMIT, servo.limits[0], travel[0]),
        (registers.CCW_LIMIT, servo.limits[1], travel[1]),
        (registers.STATUS_LEVEL, servo.status_level, ANSWERS_ALL),
    ]
    return [EepromChange(servo.id, *change) for change in calibrated if change[1] != change[2]]
