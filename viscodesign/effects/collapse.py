"""Collapse: the walls of an emptied bellow meet."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import ClassVar, Self

import numpy as np

from viscodesign.effects.base import Effect, Trait
from viscodesign.effects.catalogue import traits_of
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.bellow_wall import CollapsingWall
from viscodesign.model.system import System
from viscodesign.physics import bellow
from viscodesign.postprocess.motion_limits import Limit, Peak
from viscodesign.results.findings import Notice
from viscodesign.solve.events import FLOOR_REL_TOL
from viscodesign.solve.obstacles import Obstacle


@dataclass(frozen=True, eq=False)
class Collapse(Effect):
    """A floor below which no bellow empties.

    Its compliance, angle and extension per pressure fade smoothly towards the floor;
    away from it the linear laws hold to the last digit.
    """

    name: ClassVar[str] = "collapse"
    order: ClassVar[int] = 13
    formula: ClassVar[str] = "volume below the onset of collapse at the lowest inlet pressure / V_0"
    replaced_by: ClassVar[str] = "material_curve"
    traits: ClassVar[frozenset[Trait]] = frozenset({Trait.LIMITED_EMPTYING})
    remedies: ClassVar[Mapping[Obstacle, str]] = {
        Obstacle.EMPTY_BELLOW: f"set effects.{name} to auto"
    }
    validity: ClassVar[str] = "The contact law of the walls is assumed; a measured curve is better."
    source: ClassVar[str] = (
        "An assumption of this model; the paper's bellows have no minimum volume."
    )
    keys: ClassVar[tuple[str, ...]] = ("bellows.collapse_fraction",)

    floor: float
    fade: float
    give: float
    linear: tuple[float, float, float]
    """Volume, curvature and stretch per pressure."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        law, bellows = quantities.bellow, quantities.scene.bellows
        ambient = quantities.scene.ambient_pressure
        own = (law.rest_volume, law.compliance, bellows.collapse_fraction, ambient)
        floor, fade = bellow.collapse_pressures(*own)
        give = bellow.residual_compliance(*own)
        linear = (law.compliance, law.curvature_per_pressure, law.stretch_per_pressure)
        return cls(floor, fade, give, linear)

    def weight(self, quantities: SceneQuantities) -> float:
        below = self.floor + self.fade - quantities.lowest_pressure
        law = quantities.bellow
        return max(0.0, below * law.compliance / law.rest_volume)

    def reason(self, quantities: SceneQuantities) -> str:
        return (
            f"the walls start to touch at {(self.floor + self.fade) / 1e3:.3g} kPa gauge; "
            f"the lowest inlet pressure is {quantities.lowest_inlet_pressure / 1e3:.3g} kPa"
        )

    def wall(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Volume beyond rest, curvature and stretch at gauge pressures, any shape."""
        effective = bellow.effective_pressure(pressure, self.floor, self.fade, np, self.give)
        volume, curvature, stretch = (slope * effective for slope in self.linear)
        return volume, curvature, stretch

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(wall=self.wall)

    def warnings(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Notice]:
        # Where the effect was weighed and neglected, no bellow comes near its floor.
        is_forbidden = quantities.scene.effects.mode(self.name) == "off"
        if not is_forbidden or Trait.LIMITED_EMPTYING in traits_of(active):
            return
        law, low = quantities.bellow, quantities.lowest_pressure
        lowest = law.rest_volume + law.compliance * low
        if lowest < law.floor_volume:
            empty = -law.rest_volume / law.compliance
            yield Notice(
                "negative_volume" if lowest <= 0.0 else self.name,
                f"at {low / 1e3:.4g} kPa gauge the linear law leaves a bellow "
                f"{lowest / law.rest_volume:.3g} of its rest volume (nothing below "
                f"{empty / 1e3:.4g} kPa gauge); a real bellow collapses at about "
                f"{law.floor_volume / law.rest_volume:.3g}",
                "bellows",
            )

    def limits(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Limit]:
        """The minimum volume, whatever the law of the bellows."""
        law, names = quantities.bellow, quantities.graph.bellows
        bound = -law.floor_volume * (1 - FLOOR_REL_TOL)

        def below_floor(peak: Peak) -> Notice:
            name, least = names[peak.column], -peak.value
            count = int(np.sum(peak.columns > bound))
            return Notice(
                "negative_volume" if least <= 0.0 else self.name,
                f"{count} of {len(names)} bellows fall below their minimum of "
                f"{law.floor_volume / law.rest_volume:.3g} of the rest volume; {name} "
                f"reaches {least / law.rest_volume:.3g}",
                name,
                peak.time_s,
            )

        yield Limit(lambda block: -block.volume, bound, below_floor)

    def join(self, system: System) -> None:
        floor = system.parameter("collapse.floor", self.floor)
        fade = system.parameter("collapse.fade", self.fade)
        give = system.parameter("collapse.give", self.give)
        system.wall = CollapsingWall(system.linear_wall(), floor, fade, give)
