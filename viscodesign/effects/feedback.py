"""Solid-to-fluid feedback: force and moment of a section change its bellows' volumes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar, Self

import casadi as ca
import numpy as np

from viscodesign.effects.base import Effect, Trait
from viscodesign.effects.catalogue import traits_of
from viscodesign.errors import Fault
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.bellow_law import places
from viscodesign.model.scene_number import Numbers, mean_of
from viscodesign.model.system import System
from viscodesign.physics import bellow
from viscodesign.references import PAPER, LiteratureReference
from viscodesign.results.findings import Notice
from viscodesign.scene.bellow_numbers import moving_bellows
from viscodesign.scene.body_numbers import section_stiffnesses

if TYPE_CHECKING:
    from viscodesign.solve.problem import Problem
    from viscodesign.solve.statics import Start

RECIPROCITY_REL_TOL = 0.05
"""Ratio of the two coefficients of a coupling, less one, up to which they count as equal."""


SX = ca.SX


@dataclass(frozen=True, eq=False)
class Feedback(Effect):
    """Volume stored by the section's normal force and moment; equation (1), last term."""

    name: ClassVar[str] = "feedback"
    order: ClassVar[int] = 45
    formula: ClassVar[str] = "(da/dN N + da/dM M) / (da/dp p)"
    validity: ClassVar[str] = "Small changes of a bellow's volume by the loads of its section."
    source: ClassVar[str] = "The paper, equation (1)."
    references: ClassVar[tuple[LiteratureReference, ...]] = (PAPER,)
    keys: ClassVar[tuple[str, ...]] = ("bellows.area_per_force", "bellows.area_per_moment")

    areas_per_force: Numbers
    areas_per_moment: Numbers
    lengths: Numbers
    """Length of a bellow along the stream [m]; all of them one for all bellows, or of each (B,)."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        # What blocks a section carries its load.
        bellows, moved = quantities.scene.bellows, moving_bellows(quantities.scene)
        per_force, per_moment = (bellows.each(f"area_per_{n}") for n in ("force", "moment"))
        return cls(moved * per_force, moved * per_moment, bellows.each("length"))

    @property
    def area_per_force(self) -> float:
        """Where bellows differ, the mean [m2/N]."""
        found: float = mean_of(self.areas_per_force)
        return found

    @property
    def area_per_moment(self) -> float:
        """Where bellows differ, the mean [m2/(N m)]."""
        found: float = mean_of(self.areas_per_moment)
        return found

    def present(self, quantities: SceneQuantities) -> bool:
        return bool(np.any(self.areas_per_force) or np.any(self.areas_per_moment))

    def weight(self, quantities: SceneQuantities) -> float:
        force = quantities.load_force
        area = (
            abs(self.area_per_force) + abs(self.area_per_moment) * quantities.body.length
        ) * force
        per_pressure = mean_of(quantities.scene.bellows.each("area_per_pressure"))
        return float(area / (per_pressure * quantities.swing))

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.present(quantities):
            return "bellows.area_per_force and area_per_moment are zero"
        if quantities.load_force == 0.0:
            return "the rod carries no load"
        return f"forces up to about {quantities.load_force:.2g} N act on the sections"

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(
            volume_per_force=self.lengths * self.areas_per_force,
            volume_per_moment=self.lengths * self.areas_per_moment,
        )

    def refusals(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Fault]:
        if self.name in active:
            yield from self._negative_compliances(quantities)

    def _negative_compliances(self, quantities: SceneQuantities) -> Iterator[Fault]:
        """With its strain held, a section must still resist filling."""
        law: Any = quantities.bellows
        own = quantities.scene.sections
        bending, extension = section_stiffnesses(quantities.body)
        for strain, key, area, per_pressure, stiffness in (
            (
                "extension",
                "bellows.area_per_force",
                self.areas_per_force,
                law.stretch_per_pressure,
                extension,
            ),
            (
                "bending",
                "bellows.area_per_moment",
                self.areas_per_moment,
                law.curvature_per_pressure,
                bending,
            ),
        ):
            held = bellow.blocked_compliance(
                law.compliance, law.length * area, per_pressure, own.of_bellows(stiffness)
            )
            worst = np.argmin(held)
            if np.min(held) <= 0.0:
                free = np.broadcast_to(law.compliance, np.shape(held)).flat[worst]
                yield Fault(
                    f"at fixed strain, a section's bellows have a negative compliance in {strain} "
                    f"({np.min(held):.4g} m3/Pa, free: {free:.4g} m3/Pa): pressures would "
                    f"diverge, and the model is ill-posed. Lower {key}, or set "
                    f"effects.{self.name}: off.",
                    key,
                )

    def warnings(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Notice]:
        """Volume per resultant against strain per pressure: equal in a reciprocal coupling."""
        if quantities.scene.effects.mode(self.name) == "off":
            return
        if self.name not in active:
            for fault in self._negative_compliances(quantities):
                message = f"no run with {self.name} can judge what it does: {fault.message}"
                yield Notice("not_passive", message, fault.key)
        law = quantities.bellows
        section = quantities.scene.sections.of_bellows(quantities.body.section_lengths)
        for strain, resultant, found in (
            (law.curvature_per_pressure * section, "moment", law.length * self.areas_per_moment),
            (law.stretch_per_pressure * section, "force", law.length * self.areas_per_force),
        ):
            yield from self._coupling(strain, resultant, found)

    def _coupling(self, strains: Numbers, resultant: str, volumes: Numbers) -> Iterator[Notice]:
        """What is odd about the couplings of bellows; of several alike, the first is named."""
        told: set[str] = set()
        every = max(np.size(strains), np.size(volumes))
        for strain, found in zip(strains * np.ones(every), volumes * np.ones(every), strict=True):
            if found * strain < 0.0 and "not_passive" not in told:
                told.add("not_passive")
                yield Notice(
                    "not_passive",
                    f"volume per {resultant} and strain per pressure have opposite signs "
                    f"({found:.3g} and {strain:.3g}): the coupling creates energy",
                    "bellows",
                )
            elif found and not _is_reciprocal(strain / found) and not told:
                told.add("not_reciprocal")
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
            # Its matrices take time to import, and only a solved scene needs them.
            from viscodesign.postprocess.stability import growth_notices

            yield from growth_notices(problem, start)

    def join(self, system: System) -> None:
        length = self._of_each(system, "bellow_length", self.lengths)
        per_force = self._of_each(system, "area_per_force", self.areas_per_force)
        per_moment = self._of_each(system, "area_per_moment", self.areas_per_moment)
        for name, place in places(system.graph).items():
            force, moment = system.normal_force[place.section], system.moment[place.section]
            area = per_force[name] * force + place.side * per_moment[name] * moment
            system.extra_volume[name] += length[name] * area

    def _of_each(self, system: System, name: str, values: Numbers) -> dict[str, SX]:
        """A number of every bellow by its name, as symbols."""
        along, symbols = system.pressure, ca.vertsplit(system.of_bellows(name, values))
        return dict(zip(along, symbols * (len(along) // len(symbols)), strict=True))


def _is_reciprocal(ratio: float) -> bool:
    return 1 / (1 + RECIPROCITY_REL_TOL) < ratio < 1 + RECIPROCITY_REL_TOL
