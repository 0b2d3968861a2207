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
from viscodesign.model.system import System, rod_endings


@dataclass(frozen=True)
class Gravity(Effect):
    """Dead weight; `tilt` turns it from +z (hanging) towards +x (90 deg: horizontal)."""

    name: ClassVar[str] = "gravity"
    order: ClassVar[int] = 20
    formula: ClassVar[str] = "m g l^3 / (E I)"
    validity: ClassVar[str] = "Gravity in the plane of motion."
    source: ClassVar[str] = "The paper, equation (4), as a distributed load."
    keys: ClassVar[tuple[str, ...]] = ("loads.gravity",)

    pulls: tuple[tuple[float, float], ...]
    """Acceleration [m/s2] and tilt [rad] of every rod."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        each = (loads.gravity for loads in quantities.scene.loads_of_rods)
        return cls(
            tuple((0.0, 0.0) if own is None else (own.acceleration, own.tilt) for own in each)
        )

    def present(self, quantities: SceneQuantities) -> bool:
        return any(acceleration != 0.0 for acceleration, _ in self.pulls)

    def weight(self, quantities: SceneQuantities) -> float:
        return quantities.weight / quantities.bending_force

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.present(quantities):
            return "loads.gravity is off"
        tilts = " and ".join(dict.fromkeys(f"{math.degrees(t):.3g}" for a, t in self.pulls if a))
        return f"the weight acts at {tilts} deg from the clamped axis"

    def estimate_term(self) -> EstimateTerm:
        acceleration, tilt = self.pulls[0]
        down = (math.sin(tilt), math.cos(tilt))
        return EstimateTerm(acceleration=(acceleration * down[0], acceleration * down[1]))

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
        for rod, own, end in zip(system.rod.rods, self.pulls, rod_endings(system), strict=True):
            acceleration = system.parameter(f"gravity.acceleration{end}", own[0])
            tilt = system.parameter(f"gravity.tilt{end}", own[1])
            down = ca.vertcat(ca.sin(tilt), ca.cos(tilt))
            for point in rod.masses():
                system.load_potential -= point.mass * acceleration * ca.dot(down, point.position)
