"""`kind: syringe`: a plunger imposes volume, and the pressure follows."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from typing import Any, ClassVar, Literal, get_args

import numpy as np
from pydantic import Field, ValidationInfo, model_validator

from viscodesign.scene.inputs.base import PiecewiseLinear
from viscodesign.scene.spec_part import KeyFault, copied, raise_faults
from viscodesign.scene.table_file import FromFile, check_rows, time_faults, with_rows
from viscodesign.scene.tables.columns import WantedColumn
from viscodesign.units import Length, Speed, Time, Volume

POSITION_COLUMNS = (
    WantedColumn("time", get_args(Time)[1], ("t",)),
    WantedColumn("position", get_args(Length)[1], ("x", "stroke")),
)


class SyringeInput(PiecewiseLinear, FromFile):
    """A plunger that is pushed in from its start by given positions or speeds.

    Barrel, tubes and bellows form a closed volume, filled at the baseline pressure with the
    plunger at its start; the compressibility of the fluid determines the pressure.
    """

    name: ClassVar[str] = "syringe"
    gives_pressure: ClassVar[bool] = False
    kind: Literal["syringe"]
    diameter: Length = Field(gt=0, description="Inner diameter of the barrel")
    start: Length = Field(gt=0, description="Filled length of the barrel at the start")
    dead_volume: Volume = Field(0.0, ge=0, description="Volume that the plunger cannot displace")
    cushion: Volume = Field(
        0.0,
        ge=0,
        description="Gas volume in a liquid-filled barrel, at the baseline pressure",
    )
    rows: tuple[tuple[Time, Length], ...] | None = Field(
        None,
        description="Instead of a file: pairs of [time, position from the start, positive inwards]",
    )
    speeds: tuple[tuple[Time, Speed], ...] | None = Field(
        None, description="Instead of positions: pairs of [time, speed from then on]"
    )

    @model_validator(mode="before")
    @classmethod
    def _read(cls, given: Any, info: ValidationInfo) -> Any:
        return with_rows(given, info, POSITION_COLUMNS, time_faults, "a syringe", ["speeds"])

    @model_validator(mode="after")
    def _check_motion(self) -> SyringeInput:
        if self.speeds is None:
            check_rows(self.rows or (), time_faults)
        raise_faults(self._faults())
        return self

    def _faults(self) -> Iterator[KeyFault]:
        key = "rows" if self.speeds is None else "speeds"
        times = [t for t, _ in self.speeds or ()]
        if any(b <= a for a, b in itertools.pairwise([-1.0, *times])):
            yield KeyFault(("speeds",), "times must increase, starting at 0 s or later")
        for t, x in self._positions():
            if x >= self.start:
                message = f"position {1e3 * x:g} mm at {t:g} s exceeds the filled length of "
                yield KeyFault((key,), message + f"{1e3 * self.start:g} mm")
                return

    def shared_by(self, count: int) -> SyringeInput:
        """A barrel of an even part of its section, dead volume and cushion, pushed as far."""
        part = {"dead_volume": self.dead_volume / count, "cushion": self.cushion / count}
        return copied(self, {"diameter": self.diameter / math.sqrt(count), **part})

    @property
    def area(self) -> float:
        """Cross-sectional area of the barrel [m2]."""
        return math.pi * self.diameter**2 / 4

    @property
    def full_volume(self) -> float:
        """Volume in front of the plunger at its start, including the gas cushion [m3]."""
        return self.area * self.start + self.dead_volume + self.cushion

    @property
    def covered(self) -> tuple[float, float] | None:
        """First and last time [s] of the positions; None where speeds go on for ever."""
        return (self.rows[0][0], self.rows[-1][0]) if self.rows else None

    def _positions(self) -> list[tuple[float, float]]:
        """(time, position) where the speed changes; the last speed continues."""
        if self.speeds is None:
            return list(self.rows or ())
        points, place = [(0.0, 0.0)], 0.0
        for (t, speed), (later, _) in itertools.pairwise(self.speeds):
            if t > points[-1][0]:
                points.append((t, place))
            place += speed * (later - t)
            points.append((later, place))
        return points

    def vertices(self, duration: float) -> np.ndarray:
        points = self._positions()
        last, place = points[-1]
        end = max(duration, last) + 1.0
        if self.speeds is not None:
            place += self.speeds[-1][1] * (end - last)
        first = [(0.0, points[0][1])] if points[0][0] > 0 else []
        return np.array([(t, self.area * x) for t, x in [*first, *points, (end, place)]])

    def initial(self) -> float:
        return self.area * self._positions()[0][1]

    def profile(self) -> list[tuple[float, float]]:
        return [(t, self.area * x) for t, x in self._positions()]
