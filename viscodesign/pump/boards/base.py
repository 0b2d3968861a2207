"""What every board can be asked, byte by byte; what to ask, and when, is `pump.py`'s to know."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar

from viscodesign.errors import PumpError
from viscodesign.pump.bus import registers
from viscodesign.pump.bus.line import Line
from viscodesign.pump.bus.registers import Register
from viscodesign.pump.bus.transactions import NoReplyError, ServoError


@dataclass(frozen=True)
class Goal:
    """Where one servo is to go."""

    count: int
    """Goal position, 0 to 1023."""
    speed: int
    """Speed register, 1 to 1023 (0 would be full speed, and is refused)."""
    torque: int | None = None
    """Torque limit register, 1 to 1023; None leaves it as it is."""
    held: int | None = None
    """Torque limit in force, which ``torque`` differs from in one byte: only that one is sent."""

    def __post_init__(self) -> None:
        if not 0 <= self.count <= 1023:
            raise PumpError(f"a goal of {self.count} counts; a servo turns from 0 to 1023")
        if not 1 <= self.speed <= 1023:
            raise PumpError(f"a speed of {self.speed}; the register takes 1 to 1023")
        if self.torque is not None and not 1 <= self.torque <= 1023:
            raise PumpError(f"a torque limit of {self.torque}; the register takes 1 to 1023")


class Board(ABC):
    """One kind of board between a serial line and the servos' bus; a board is a file.

    Replies are checked for id, length, checksum and error bits. Reads are repeated where
    nothing or nonsense came; a write of an absolute value may be; what starts a motion
    program never is. Everything raises `PumpError` with what was asked and what came.
    """

    name: ClassVar[str]
    """Word after `--board`."""
    baud: ClassVar[int]
    """Bits a second, where `--baud` says nothing else."""
    streams: ClassVar[bool]
    """Whether it takes set-points in real time (`pump stream`)."""
    has_pins: ClassVar[bool]
    """Whether it reads analog and digital pins."""
    limits_torque: ClassVar[bool] = False
    """Whether a move sets torque limits too, in the same transaction."""
    simulated: ClassVar[bool] = False
    """Whether nothing real moves; everything it says is labelled so."""
    boot: ClassVar[float] = 0.0
    """How long it takes to start, where opening its port resets it [s]."""

    def __init__(self, line: Line, servos: Sequence[int] = ()) -> None:
        self.line = line
        self.servos = tuple(servos)
        """Ids of the servos that should be there, as far as known."""

    @abstractmethod
    def identify(self) -> str:
        """Name and version of what answers, without moving anything.

        Raises `PumpError` where nothing answers, or something else than this board, saying what
        it seems to be and which `--board` would fit.
        """

    @abstractmethod
    def read(self, servo: int, address: int, count: int) -> bytes:
        """Registers of one servo."""

    @abstractmethod
    def write(self, servo: int, address: int, data: bytes) -> None:
        """Set registers of one servo, and see that it says so."""

    def write_permanent(self, servo: int, address: int, data: bytes) -> None:
        """Set registers of the EEPROM where they differ: for `pump calibrate` alone."""
        raise PumpError(
            f"servo {servo}: the board {self.name} does not write what servos keep without power"
        )

    def hurry(self) -> None:  # noqa: B027
        """From now on something moves: give up asking before a silence has lasted too long.

        Boards that play by themselves have nothing to do here.
        """

    def answers(self, servo: int) -> bool:
        """Whether a servo answers at all; with error bits too."""
        try:
            self.read(servo, registers.ID.address, registers.ID.size)
        except ServoError:
            return True
        except NoReplyError:
            return False
        return True

    def get(self, servo: int, register: Register) -> int:
        """Value of one register."""
        return register.decode(self.read(servo, register.address, register.size))

    def set(self, servo: int, register: Register, value: int) -> None:
        """Write one register that is forgotten without power."""
        self.write(servo, register.address, register.encode(value))

    @abstractmethod
    def move(self, goals: Mapping[int, Goal]) -> None:
        """Set speed and goal of all named servos, in one transaction where the board can.

        Torque limits only where the board `limits_torque`; others leave them.
        """

    @abstractmethod
    def halt(self) -> None:
        """Stop a program that runs on the board itself; boards without one do nothing."""

    @abstractmethod
    def analog(self, channel: int) -> float | None:
        """An analog input over its supply, 0 to 1; None on boards without such pins."""

    @abstractmethod
    def digital(self, pin: str) -> bool | None:
        """Level of a digital pin like 'D1'; None on boards without such pins."""
