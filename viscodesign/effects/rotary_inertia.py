"""Rotary inertia: a cross section resists being turned."""

from __future__ import annotations

import math
from typing import ClassVar, Self

import numpy as np

from viscodesign.effects.base import Effect
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.scene_number import Numbers
from viscodesign.model.system import System

MODE_SLOPE = 4.648
"""Integral of the first mode's squared slope over that of the mode squared, times l^2."""
UNDAMPED_TURNING = 10.0
"""Factor on the effect of turning where nothing damps the higher modes: it shifts the phase of the
second 43 times as fast as that of the first, which has up to four times its amplitude."""


@dataclass(frozen=True)
class RotaryInertia(Effect):
    """Kinetic energy of turning, m h_s^2/12 per length; off: point masses on the axis."""

    name: ClassVar[str] = "rotary_inertia"
    order: ClassVar[int] = 32
    formula: ClassVar[str] = "(t_s / t_i)^2 h_s^2 / (12 l^2)"
    needs: ClassVar[tuple[str, ...]] = ("inertia",)
    validity: ClassVar[str] = "Homogeneous cross sections that stay plane."
    source: ClassVar[str] = "Rayleigh's beam; with shear Timoshenko's."
    keys: ClassVar[tuple[str, ...]] = ("actuator.height",)

    gyration: float
    """Radius of gyration of the cross section; where sections differ, the largest [m]."""
    inertia: Numbers
    """Moment of inertia per length, one for all sections or of each (S,) [kg m]."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        height = quantities.scene.sections.each("height")
        gyration = height / math.sqrt(12)
        largest = gyration if not isinstance(gyration, np.ndarray) else np.max(gyration)
        return cls(largest, quantities.body.masses_per_length * gyration**2)

    def weight(self, quantities: SceneQuantities) -> float:
        slender = (self.gyration / quantities.body.length) ** 2
        ratio = quantities.scales.ratios["ts_over_ti"]
        return ratio * ratio * slender

    def reason(self, quantities: SceneQuantities) -> str:
        ratio = self.gyration / quantities.body.length
        return f"the cross section's radius of gyration is {ratio:.2g} of the length"

    def modal_mass(self, length: float, is_damped: bool) -> float:
        """Mass that turning adds to the first bending mode, relative [1]; ``length`` [m]."""
        slope = MODE_SLOPE * (1.0 if is_damped else UNDAMPED_TURNING)
        return slope * (self.gyration / length) ** 2

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(modal_mass=self.modal_mass)

    def join(self, system: System) -> None:
        inertia = system.of_sections("rotary_inertia.per_length", self.inertia)
        for energy in system.rod.rotary_energies(inertia):
            system.kinetic_energy += energy
