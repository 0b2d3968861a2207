"""A plunger in its barrel and what moves it: the contract of a drive, in physical units."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from typing import Any, ClassVar, NamedTuple

from viscodesign.lazy_dataclass import dataclass


class Load(NamedTuple):
    """How a drive's load is stated: the force on its plunger, or a torque proportional to it."""

    name: str = "force"
    unit: str = "N"
    suffix: str = "n"  # of names with units
    per_newton: float = 1.0  # load per force on the plunger [unit/N]


@dataclass(frozen=True)
class PlungerDrive(ABC):
    """One plunger; a family adds its step, its stall and the speed that it has left.

    Positions are pushed in from home, positive towards the outlet. Pressures are gauge: the
    ambient pushes on the plunger's other side. Forces are positive where the drive pushes in.
    """

    step_name: ClassVar[str] = "step"
    """What a step is called in messages and names."""
    gear_key: ClassVar[str]
    """Key of the section that makes a step shorter as it gets smaller."""

    pump: Any
    """The section of its kind. It has, in SI, `syringe_diameter`, `syringe_stroke`, `filled_length`
    (None: the withdrawn end of travel is full), `dead_volume` and `plunger_friction`; in steps
    `home` and `travel`; and `push`: the direction of steps as the plunger goes in, up or down."""

    @property
    @abstractmethod
    def step(self) -> float:
        """Travel of the plunger per step [m]; positive whichever way steps push."""

    @property
    @abstractmethod
    def stall_load(self) -> float:
        """Load at which the drive stalls, in the unit of `load`."""

    @abstractmethod
    def speed_left(self, force: Any) -> Any:
        """Plunger speed that the drive still has against a force [m/s]; zero beyond its stall."""

    @property
    def load(self) -> Load:
        """How its load is stated."""
        return Load()

    @property
    def play(self) -> float:
        """Backlash between drive and plunger [steps]."""
        return 0.0

    @property
    def stall_words(self) -> str:
        """What its stall is called in messages, with the conditions that it depends on."""
        return f"stall {self.load.name}"

    @property
    def area(self) -> float:
        """Cross section of the barrel [m2]."""
        diameter: float = self.pump.syringe_diameter
        return math.pi * diameter**2 / 4

    @property
    def volume_per_step(self) -> float:
        """Volume swept per step, the finest that can be set [m3]."""
        return self.area * self.step

    def position(self, steps: float) -> float:
        """Plunger position [m] at a step of the drive."""
        pushed: float = steps - self.pump.home if self.pump.push == "up" else self.pump.home - steps
        return pushed * self.step

    @property
    def range(self) -> tuple[float, float]:
        """Plunger positions at the ends of travel, withdrawn first [m]."""
        low, high = sorted(self.position(end) for end in self.pump.travel)
        return low, high

    @property
    def filled_at_home(self) -> float:
        """Length of barrel in front of the plunger at home [m]."""
        stated: float | None = self.pump.filled_length
        return float(self.pump.syringe_stroke) + self.range[0] if stated is None else stated

    def force(self, pressure: Any, direction: Any = 0.0) -> Any:
        r"""Force of the drive that balances the plunger [N].

        .. math:: p A + F d

        ``pressure`` p gauge [Pa]; ``direction`` d is 1 where the plunger moves in against its
        friction F, -1 where it moves out, 0 at rest.
        """
        return pressure * self.area + self.pump.plunger_friction * direction

    @property
    def stall_pressure(self) -> float:
        r"""Gauge pressure at which the pump stalls, without friction [Pa]: :math:`F_s / A`."""
        return self.stall_load / (self.load.per_newton * self.area)
