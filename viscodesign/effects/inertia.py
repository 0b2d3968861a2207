"""Inertia: the solid's mass resists acceleration."""

from __future__ import annotations

from typing import ClassVar, Self

import casadi as ca

from viscodesign.effects.base import Effect
from viscodesign.estimate.estimate import Sketch
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.system import System


class Inertia(Effect):
    """Mass times acceleration of the rod and of what hangs on it; off: quasi-static rod."""

    name: ClassVar[str] = "inertia"
    order: ClassVar[int] = 30
    formula: ClassVar[str] = "(t_s / t_i)^2"
    # Without it a rod rings on, as none does.
    companion: ClassVar[str] = "damping"
    validity: ClassVar[str] = "A slender rod; points on its axis carry the mass."
    source: ClassVar[str] = "The paper, equation (4)."
    keys: ClassVar[tuple[str, ...]] = ("actuator.density", "actuator.solid_fraction")

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        return cls()

    def indispensable(self, quantities: SceneQuantities) -> bool:
        return quantities.suddenly_loaded

    def weight(self, quantities: SceneQuantities) -> float:
        return quantities.scales.ratios["ts_over_ti"] ** 2

    def reason(self, quantities: SceneQuantities) -> str:
        scales = quantities.scales
        if quantities.suddenly_loaded:
            return "the loads act at once on a straight rod at rest (run.start: rest)"
        return f"the solid swings in {scales.t_s:.3g} s, the input in {scales.t_i:.3g} s"

    def sketch(self, sketch: Sketch) -> Sketch:
        return sketch.with_(moving=True)

    def join(self, system: System) -> None:
        for point in system.rod.masses():
            system.kinetic_energy += point.mass * ca.sumsqr(point.velocity) / 2
