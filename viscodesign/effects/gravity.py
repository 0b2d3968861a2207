"""Gravity: the weight of the body and of what hangs on it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import ClassVar, Self

import casadi as ca

from viscodesign.effects.base import Effect
from viscodesign.effects.load_limit import load_faults
from viscodesign.errors import Fault
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.system import System


@dataclass(frozen=True)
class Gravity(Effect):
    """Dead weight; `tilt` turns it from +z (hanging) towards +x (90 deg: horizontal)."""

    name: ClassVar[str] = "gravity"
    order: ClassVar[int] = 20
    formula: ClassVar[str] = "m g l^3 / (E I)"
    validity: ClassVar[str] = "Gravity in the plane of motion."
    source: ClassVar[str] = "The paper, equation (4), as a distributed load."
    keys: ClassVar[tuple[str, ...]] = ("loads.gravity",)

    acceleration: float
    tilt: float

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        gravity = quantities.scene.loads.gravity
        return cls(0.0, 0.0) if gravity is None else cls(gravity.acceleration, gravity.tilt)

    def present(self, quantities: SceneQuantities) -> bool:
        return self.acceleration != 0.0

    def weight(self, quantities: SceneQuantities) -> float:
        return quantities.weight / quantities.bending_force

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.present(quantities):
            return "loads.gravity is off"
        return f"the weight acts at {math.degrees(self.tilt):.3g} deg from the clamped axis"

    def estimate_term(self) -> EstimateTerm:
        down = (math.sin(self.tilt), math.cos(self.tilt))
        return EstimateTerm(acceleration=(self.acceleration * down[0], self.acceleration * down[1]))

    def numeric_faults(self, quantities: SceneQuantities) -> Iterator[Fault]:
        return load_faults(quantities, quantities.weight, "loads.gravity")

    def changed_default(self, quantities: SceneQuantities) -> str:
        if "gravity" in quantities.scene.loads.model_fields_set:
            return ""
        return (
            "`loads.gravity` is not stated, which up to version 0.9 meant weightless and now "
            "means Earth's gravity along the hanging actuator. State `on` or `off`"
        )

    def join(self, system: System) -> None:
        acceleration = system.parameter("gravity.acceleration", self.acceleration)
        tilt = system.parameter("gravity.tilt", self.tilt)
        down = ca.vertcat(ca.sin(tilt), ca.cos(tilt))
        for point in system.rod.masses():
            system.load_potential -= point.mass * acceleration * ca.dot(down, point.position)
