"""`kind: syringe`: a plunger, whose fluid then finds its own pressure."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from typing import Any, ClassVar, Literal

import numpy as np
from pydantic import Field, ValidationInfo, model_validator

from viscodesign.scene.inputs.base import PiecewiseLinear
from viscodesign.scene.section import Complaint, refuse_any
from viscodesign.scene.table_file import disorder, refuse_rows, with_rows
from viscodesign.units import Length, Speed, Time, Volume

COLUMNS = ("time_s", "position_m")


class Syringe(PiecewiseLinear):
    """The plunger is pushed in from its start, by position or by speed.

    Barrel, tubes and bellows are one closed vessel, filled at the baseline pressure with
    the plunger at its start; the fluid's stiffness then makes the pressure.
    """

    name: ClassVar[str] = "syringe"
    gives_pressure: ClassVar[bool] = False
    kind: Literal["syringe"]
    diameter: Length = Field(gt=0, description="Inner diameter of the barrel")
    start: Length = Field(gt=0, description="Length of the filled barrel at the start")
    dead_volume: Volume = Field(0.0, ge=0, description="What the plunger cannot push out")
    cushion: Volume = Field(
        0.0,
        ge=0,
        description="Gas in front of the plunger beside a liquid, at the baseline pressure",
    )
    file: str | None = Field(
        None, description="CSV with the columns time_s, position_m; relative to the spec"
    )
    rows: tuple[tuple[Time, Length], ...] | None = Field(
        None, description="Instead of a file: [time, position pushed in from the start] pairs"
    )
    speeds: tuple[tuple[Time, Speed], ...] | None = Field(
        None, description="Instead of positions: [time, speed from then on] pairs"
    )

    @model_validator(mode="before")
    @classmethod
    def _read(cls, given: Any, info: ValidationInfo) -> Any:
        return with_rows(given, info, COLUMNS, disorder, "a syringe", ["speeds"])

    @model_validator(mode="after")
    def _in_order(self) -> Syringe:
        if self.speeds is None:
            refuse_rows(self.rows or (), disorder)
        refuse_any(self._faults())
        return self

    def _faults(self) -> Iterator[Complaint]:
        key = "rows" if self.speeds is None else "speeds"
        times = [t for t, _ in self.speeds or ()]
        if any(b <= a for a, b in itertools.pairwise([-1.0, *times])):
            yield Complaint(("speeds",), "times must rise, from 0 s on")
        for t, x in self._positions():
            if x >= self.start:
                message = f"pushed in by {1e3 * x:g} mm at {t:g} s, but only {1e3 * self.start:g} "
                yield Complaint((key,), message + "mm of the barrel are filled")
                return

    @property
    def area(self) -> float:
        """Cross section of the barrel [m2]."""
        return math.pi * self.diameter**2 / 4

    @property
    def full_volume(self) -> float:
        """Volume in front of the plunger at its start, a cushion included [m3]."""
        return self.area * self.start + self.dead_volume + self.cushion

    def _positions(self) -> list[tuple[float, float]]:
        """(time, position) where the speed changes; the last speed of a list is kept."""
        if self.speeds is None:
            return [(float(t), float(x)) for t, x in self.rows or ()]
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
