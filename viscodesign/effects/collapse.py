"""Collapse: the walls of an emptied bellow meet."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

import numpy as np

from viscodesign.effects.base import Effect
from viscodesign.estimate.estimate import Sketch
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.bellow_wall import CollapsingWall
from viscodesign.model.system import System
from viscodesign.physics import bellow


@dataclass(frozen=True, eq=False)
class Collapse(Effect):
    """A floor below which no bellow empties.

    Its compliance, angle and extension per pressure fade smoothly towards the floor;
    away from it the linear laws hold to the last digit.
    """

    name: ClassVar[str] = "collapse"
    order: ClassVar[int] = 13
    formula: ClassVar[str] = "volume below the start of fading at the lowest inlet pressure / V_0"
    validity: ClassVar[str] = (
        "How the walls meet is an assumption of this model; a measured curve is better."
    )
    source: ClassVar[str] = "An assumption of this model: the paper has no floor."
    keys: ClassVar[tuple[str, ...]] = ("bellows.collapse_fraction",)

    floor: float
    fade: float
    give: float
    linear: tuple[float, float, float]
    """Volume, curvature and stretch per pressure."""
    measured: bool

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        law, bellows = quantities.bellow, quantities.scene.bellows
        ambient = quantities.scene.ambient_pressure
        own = (law.rest_volume, law.compliance, bellows.collapse_fraction, ambient)
        floor, fade = bellow.collapse_pressures(*own)
        give = bellow.residual_compliance(*own)
        linear = (law.compliance, law.curvature_per_pressure, law.stretch_per_pressure)
        measured = (
            bellows.curve is not None and quantities.scene.effects.mode("material_curve") != "off"
        )
        return cls(floor, fade, give, linear, measured)

    def present(self, quantities: SceneQuantities) -> bool:
        return not self.measured

    def weight(self, quantities: SceneQuantities) -> float:
        below = self.floor + self.fade - quantities.lowest_pressure
        law = quantities.bellow
        return max(0.0, below * law.compliance / law.rest_volume)

    def reason(self, quantities: SceneQuantities) -> str:
        if self.measured:
            return "the measured curve (bellows.curve) shows what an emptied bellow does"
        return (
            f"the walls begin to meet at {(self.floor + self.fade) / 1e3:.3g} kPa gauge, "
            f"the inlet goes down to {quantities.lowest_pressure / 1e3:.3g} kPa"
        )

    def wall(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Volume beyond rest, curvature and stretch at gauge pressures, any shape."""
        effective = bellow.effective_pressure(pressure, self.floor, self.fade, np, self.give)
        volume, curvature, stretch = (slope * effective for slope in self.linear)
        return volume, curvature, stretch

    def sketch(self, sketch: Sketch) -> Sketch:
        return sketch.with_(wall=self.wall)

    def join(self, system: System) -> None:
        floor = system.parameter("collapse.floor", self.floor)
        fade = system.parameter("collapse.fade", self.fade)
        give = system.parameter("collapse.give", self.give)
        system.wall = CollapsingWall(system.linear_wall(), floor, fade, give)
