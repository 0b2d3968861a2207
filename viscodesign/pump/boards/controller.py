"""What is at the other end of a line, whatever the principle of the pump behind it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import ClassVar

from viscodesign.pump.bus.line import Line


class Controller(ABC):
    """One kind of board, or a device with a port of its own.

    Everything raises `PumpError` with what was asked and what came.
    """

    name: ClassVar[str]
    """Word after `--board`."""
    baud: ClassVar[int]
    """Bits a second, where `--baud` says nothing else."""
    streams: ClassVar[bool] = True
    """Whether it takes set-points in real time (`pump stream`)."""
    plays_poses: ClassVar[bool] = False
    """Whether it plays a whole profile by itself (`pump upload`)."""
    has_pins: ClassVar[bool] = False
    """Whether it reads analog and digital pins."""
    simulated: ClassVar[bool] = False
    """Whether nothing real moves; everything it says is labelled so."""
    boot: ClassVar[float] = 0.0
    """How long a real one takes to start, where opening its port resets it [s]."""

    def __init__(self, line: Line, axes: Sequence[int] = ()) -> None:
        self.line = line
        self.axes = tuple(axes)  # ids of those that should be there, as far as known

    def identify(self) -> str:
        """Name and version of what answers, without moving anything.

        Raises `PumpError` where nothing answers, or something else than this board, saying what
        it seems to be and which `--board` would fit.
        """
        return "simulated, nothing real moves: " * self.simulated + self._identity()

    @abstractmethod
    def _identity(self) -> str:
        """What `identify` says of a real board, and raises."""

    @staticmethod
    @abstractmethod
    def sets(request: bytes) -> bool:
        """Whether a request sets something, rather than asks."""

    @staticmethod
    @abstractmethod
    def shown(request: bytes) -> str:
        """A request for people."""

    def analog(self, channel: int) -> float | None:
        """An analog input over its supply, 0 to 1; None on boards without such pins."""
        return None

    def digital(self, pin: str) -> bool | None:
        """Level of a digital pin like 'D1'; None on boards without such pins."""
        return None
