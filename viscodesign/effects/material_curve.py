"""Material curve: measured laws of a bellow in the place of the linear ones."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

import numpy as np

from viscodesign.effects.base import Effect
from viscodesign.estimate.estimate import Sketch
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.bellow_wall import MeasuredWall, SnappingWall
from viscodesign.model.system import System
from viscodesign.physics.curves import PiecewiseCubic
from viscodesign.physics.snapping import SnapCurves
from viscodesign.scene.bellows import falls


@dataclass(frozen=True, eq=False)
class MaterialCurve(Effect):
    """Area, angle and extension of one bellow against its pressure, as measured.

    Monotone cubics through the rows, straight beyond them; zero at zero gauge. The angle
    and the extension are those of a section when one of its bellows, the left one, has
    the pressure and the other none; the two bellows of a section add. Where the pressure
    falls from row to row the cubics are functions of the area, and the bellow snaps.
    """

    name: ClassVar[str] = "material_curve"
    order: ClassVar[int] = 12
    formula: ClassVar[str] = "largest departure from the linear law over the range / its swing"
    validity: ClassVar[str] = "Inside of the measured range; beyond it a warning is given."
    source: ClassVar[str] = "Interpolation by Fritsch and Butland (1984)."
    keys: ClassVar[tuple[str, ...]] = ("bellows.curve",)

    curves: tuple[PiecewiseCubic, ...]
    """Volume beyond rest, curvature and stretch against gauge pressure; none without a curve."""
    snap: SnapCurves | None = None
    """In their place where the pressure falls."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        curve = quantities.scene.bellows.curve
        if curve is None:
            return cls(())
        rows = np.array(curve.rows, dtype=float)
        section = quantities.body.section_length
        if falls(curve.rows or ()):
            baseline = quantities.scene.gauge_pressure
            return cls((), SnapCurves.through(rows, quantities.bellow.length, section, baseline))
        factors = (quantities.bellow.length, 1 / section, 1 / section)
        found = tuple(
            PiecewiseCubic.monotone(rows[:, 0], rows[:, k + 1]).zeroed().scaled(factor)
            for k, factor in enumerate(factors)
        )
        return cls(found)

    def present(self, quantities: SceneQuantities) -> bool:
        return bool(self.curves) or self.snap is not None

    def weight(self, quantities: SceneQuantities) -> float:
        low, high = quantities.lowest_pressure, quantities.highest_pressure
        pressure = np.linspace(min(low, 0.0), max(high, 0.0), 101)
        law = quantities.bellow
        linear = (law.compliance, law.curvature_per_pressure, law.stretch_per_pressure)
        found = []
        for slope, measured in zip(linear, self.wall(pressure), strict=True):
            straight = slope * pressure
            size = float(np.ptp(straight)) or 1.0
            found.append(float(np.max(np.abs(measured - straight))) / size)
        return max(found)

    def reason(self, quantities: SceneQuantities) -> str:
        if self.snap is not None:
            return "measured rows stand in the place of the linear coefficients; by them it snaps"
        if not self.curves:
            return "no curve is given (bellows.curve)"
        return "measured rows stand in the place of the linear coefficients"

    def wall(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Volume beyond rest, curvature and stretch at gauge pressures, any shape."""
        if self.snap is not None:
            return self.snap.loaded(pressure)
        volume, curvature, stretch = (curve(pressure) for curve in self.curves)
        return volume, curvature, stretch

    def sketch(self, sketch: Sketch) -> Sketch:
        return sketch.with_(wall=self.wall)

    def join(self, system: System) -> None:
        rest = system.parameter("rest_volume", system.bellow.rest_volume)
        if self.snap is not None:
            wall = SnappingWall(rest, self.snap.pressure, self.snap.curvature, self.snap.stretch)
            system.use_snapping_wall(wall, self.snap.filled)
            return
        system.wall = MeasuredWall(rest, *self.curves)
