"""Inertia: the solid's mass resists acceleration."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, ClassVar, Self

import casadi as ca

from viscodesign.effects.base import Effect, Missed, Trait
from viscodesign.errors import Fault
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.model.rod_equations import RodForm
from viscodesign.model.system import System
from viscodesign.physics.timescales import LARGEST_TIME_RATIO
from viscodesign.references import PAPER, LiteratureReference
from viscodesign.solve.obstacles import Obstacle

if TYPE_CHECKING:
    from viscodesign.postprocess.motion import Motion
    from viscodesign.solve.problem import Problem

FOLD_FAILURES = ("equilibrium", "motion")
"""What fails at a fold: the equilibrium itself, or an integrator that follows its fluid."""


class Inertia(Effect):
    """Mass times acceleration of the rod and of what hangs on it; off: quasi-static rod."""

    name: ClassVar[str] = "inertia"
    order: ClassVar[int] = 30
    formula: ClassVar[str] = "(t_s / t_i)^2"
    # Without it a rod would ring for ever.
    companion: ClassVar[str] = "damping"
    traits: ClassVar[frozenset[Trait]] = frozenset({Trait.ROD_INERTIA})
    remedies: ClassVar[Mapping[Obstacle, str]] = {
        Obstacle.NO_EQUILIBRIUM: f"include inertia ('effects.{name}: on', 'run.start: rest') to "
        "follow the motion past the end of the static branch",
        Obstacle.LIMIT_POINT: f"set effects.{name} and effects.{companion} to auto or on to follow "
        "the snap-through",
    }
    validity: ClassVar[str] = "A slender rod, its mass lumped at points of the axis."
    source: ClassVar[str] = "The paper, equation (4)."
    references: ClassVar[tuple[LiteratureReference, ...]] = (PAPER,)
    keys: ClassVar[tuple[str, ...]] = ("actuator.density", "actuator.solid_fraction")

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        return cls()

    def indispensable(self, quantities: SceneQuantities) -> bool:
        return quantities.suddenly_loaded

    def weight(self, quantities: SceneQuantities) -> float:
        ratio = quantities.scales.ratios["ts_over_ti"]
        return ratio * ratio  # infinite for a jump, and for what is as good as one

    def reason(self, quantities: SceneQuantities) -> str:
        scales = quantities.scales
        if quantities.suddenly_loaded:
            return "the loads act at once on a straight rod at rest (run.start: rest)"
        return f"the solid swings in {scales.t_s:.3g} s, the input in {scales.t_i:.3g} s"

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(resists_acceleration=True)

    def numeric_faults(self, quantities: SceneQuantities) -> Iterator[Fault]:
        t_s = quantities.scales.t_s
        share = t_s / quantities.scene.run.duration
        if not 1 / LARGEST_TIME_RATIO < share < LARGEST_TIME_RATIO:
            yield Fault(
                f"the rod swings in {t_s:.3g} s, {share:.2g} times run.duration: too far apart for "
                f"double precision; use effects.{self.name}: off",
                "actuator.density",
            )

    def missed_in(
        self, quantities: SceneQuantities, problem: Problem, motion: Motion
    ) -> Missed | None:
        """A static rod at the end of its branch of equilibria: only inertia carries it on."""
        failure, is_static = motion.failure, problem.equations.rod_form is RodForm.STATIC
        if not (is_static and failure and failure.quantity in FOLD_FAILURES):
            return None
        return Missed(failure.short, math.inf, failure.time_s or 0.0)

    def join(self, system: System) -> None:
        for point in system.rod.masses():
            system.kinetic_energy += point.mass * ca.sumsqr(point.velocity) / 2
