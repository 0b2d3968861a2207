"""Reading servos: what is known of each at one moment."""

from __future__ import annotations

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.protocol.packets import ErrorBits, meaning
from viscodesign.pump.ax.protocol.registers import Register
from viscodesign.pump.boards.base import Board
from viscodesign.pump.play.axis import AxisState

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


def position_of(board: Board, servo: int) -> int:
    """Where a servo is [counts], whatever its error bits say."""
    return board.get(servo, registers.PRESENT_POSITION)
