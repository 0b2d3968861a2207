"""Rotary inertia: a cross section resists being turned."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar, Self

from viscodesign.effects.base import Effect
from viscodesign.estimate.estimate import Sketch
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.system import System


@dataclass(frozen=True)
class RotaryInertia(Effect):
    """Kinetic energy of turning, m h_s^2/12 per length; off: point masses on the axis."""

    name: ClassVar[str] = "rotary_inertia"
    order: ClassVar[int] = 32
    formula: ClassVar[str] = "(t_s / t_i)^2 h_s^2 / (12 l^2)"
    needs: ClassVar[str] = "inertia"
    validity: ClassVar[str] = "A cross section of even mass that stays plane, without shear."
    source: ClassVar[str] = "Rayleigh's beam."
    keys: ClassVar[tuple[str, ...]] = ("actuator.height",)

    gyration: float
    """Radius of gyration of the cross section [m]."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        return cls(quantities.scene.actuator.height / math.sqrt(12))

    def weight(self, quantities: SceneQuantities) -> float:
        slender = (self.gyration / quantities.body.length) ** 2
        return quantities.scales.ratios["ts_over_ti"] ** 2 * slender

    def reason(self, quantities: SceneQuantities) -> str:
        ratio = self.gyration / quantities.body.length
        return f"the cross section's radius of gyration is {ratio:.2g} of the length"

    def sketch(self, sketch: Sketch) -> Sketch:
        return sketch.with_(gyration=self.gyration)

    def join(self, system: System) -> None:
        per_length = system.parameter("mass_per_length", system.body.mass_per_length)
        radius = system.parameter("gyration", self.gyration)
        for energy in system.rod.rotary_energies(per_length * radius**2):
            system.kinetic_energy += energy
