"""Solid-to-fluid feedback: force and moment of a section change its bellows' volumes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar, Self

from viscodesign.effects.base import Effect, Trait
from viscodesign.effects.catalogue import traits_of
from viscodesign.errors import Fault
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.bellow_law import places
from viscodesign.model.system import System
from viscodesign.physics import bellow
from viscodesign.postprocess.stability import growth_notices
from viscodesign.references import PAPER, LiteratureReference
from viscodesign.results.findings import Notice
from viscodesign.solve.problem import Problem
from viscodesign.solve.statics import Start

RECIPROCITY_REL_TOL = 0.05
"""Ratio of the two coefficients of a coupling, less one, up to which they count as equal."""


@dataclass(frozen=True)
class Feedback(Effect):
    """Volume stored by the section's normal force and moment; equation (1), last term."""

    name: ClassVar[str] = "feedback"
    order: ClassVar[int] = 45
    formula: ClassVar[str] = "(da/dN N + da/dM M) / (da/dp p)"
    validity: ClassVar[str] = "Small changes of a bellow's volume by the loads of its section."
    source: ClassVar[str] = "The paper, equation (1)."
    references: ClassVar[tuple[LiteratureReference, ...]] = (PAPER,)
    keys: ClassVar[tuple[str, ...]] = ("bellows.area_per_force", "bellows.area_per_moment")

    area_per_force: float
    area_per_moment: float
    length: float
    """Length of a bellow along the stream [m]."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        bellows = quantities.scene.bellows
        return cls(bellows.area_per_force, bellows.area_per_moment, bellows.length)

    def present(self, quantities: SceneQuantities) -> bool:
        return (self.area_per_force, self.area_per_moment) != (0.0, 0.0)

    def weight(self, quantities: SceneQuantities) -> float:
        force = quantities.load_force
        area = (
            abs(self.area_per_force) + abs(self.area_per_moment) * quantities.body.length
        ) * force
        return area / (quantities.scene.bellows.area_per_pressure * quantities.swing)

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.present(quantities):
            return "bellows.area_per_force and area_per_moment are zero"
        if quantities.load_force == 0.0:
            return "the rod carries no load"
        return f"forces up to about {quantities.load_force:.2g} N act on the sections"

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(
            volume_per_force=self.length * self.area_per_force,
            volume_per_moment=self.length * self.area_per_moment,
        )

    def refusals(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Fault]:
        """Negative compliance: with its strain held, a section must still resist filling."""
        if self.name not in active:
            return
        law, body = quantities.bellow, quantities.body
        for strain, key, area, per_pressure, stiffness in (
            (
                "extension",
                "bellows.area_per_force",
                self.area_per_force,
                law.stretch_per_pressure,
                body.extension_stiffness,
            ),
            (
                "bending",
                "bellows.area_per_moment",
                self.area_per_moment,
                law.curvature_per_pressure,
                body.bending_stiffness,
            ),
        ):
            blocked = bellow.blocked_compliance(
                law.compliance, law.length * area, per_pressure, stiffness
            )
            if blocked <= 0.0:
                yield Fault(
                    f"at fixed strain, a section's bellows have a negative compliance in {strain} "
                    f"({blocked:.4g} m3/Pa, free: {law.compliance:.4g} m3/Pa): pressures would "
                    f"diverge, and the model is ill-posed. Lower {key}, or set "
                    f"effects.{self.name}: off.",
                    key,
                )

    def warnings(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Notice]:
        """Volume per resultant against strain per pressure: equal in a reciprocal coupling."""
        if quantities.scene.effects.mode(self.name) == "off":
            return
        law, section = quantities.bellow, quantities.body.section_length
        for strain, resultant, found in (
            (law.curvature_per_pressure * section, "moment", law.length * self.area_per_moment),
            (law.stretch_per_pressure * section, "force", law.length * self.area_per_force),
        ):
            if found * strain < 0.0:
                yield Notice(
                    "not_passive",
                    f"volume per {resultant} and strain per pressure have opposite signs "
                    f"({found:.3g} and {strain:.3g}): the coupling creates energy",
                    "bellows",
                )
            elif found and not _is_reciprocal(strain / found):
                yield Notice(
                    "not_reciprocal",
                    f"volume per {resultant} is {found:.3g}, strain per pressure {strain:.3g}, a "
                    f"factor of {strain / found:.3g}: in an elastic body they are equal, so this "
                    "coupling does net work",
                    "bellows",
                )

    def start_warnings(
        self, quantities: SceneQuantities, active: frozenset[str], problem: Problem, start: Start
    ) -> Iterator[Notice]:
        """Linear instability, which a damped rod without loads does not have."""
        is_free = quantities.tip_force + quantities.weight == 0.0
        if self.name in active and not (is_free and Trait.ROD_DAMPING in traits_of(active)):
            yield from growth_notices(problem, start)

    def join(self, system: System) -> None:
        length = system.parameter("bellow_length", self.length)
        per_force = system.parameter("area_per_force", self.area_per_force)
        per_moment = system.parameter("area_per_moment", self.area_per_moment)
        for name, place in places(system.graph).items():
            force, moment = system.normal_force[place.section], system.moment[place.section]
            area = per_force * force + place.side * per_moment * moment
            system.extra_volume[name] += length * area


def _is_reciprocal(ratio: float) -> bool:
    return 1 / (1 + RECIPROCITY_REL_TOL) < ratio < 1 + RECIPROCITY_REL_TOL
