"""Collapse: the walls of an emptied bellow meet."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, ClassVar, Self

import numpy as np

from viscodesign.effects.base import Effect, Trait
from viscodesign.effects.catalogue import traits_of
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.bellow_wall import CollapsingWall
from viscodesign.model.scene_number import Numbers
from viscodesign.model.system import System
from viscodesign.physics import bellow
from viscodesign.postprocess.motion_limits import Limit, Peak
from viscodesign.results.findings import Notice
from viscodesign.solve.obstacles import FLOOR_REL_TOL, Obstacle


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

    floor: Numbers
    fade: Numbers
    give: Numbers
    linear: tuple[Numbers, Numbers, Numbers]
    """Volume, curvature and stretch per pressure; all of them one for all bellows, or (B,)."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        law, bellows = quantities.bellows, quantities.scene.bellows
        ambient, fraction = quantities.scene.ambient_pressure, bellows.each("collapse_fraction")
        own = (law.rest_volume, law.compliance, fraction, ambient)
        floor, fade, give = _contact(*own)
        linear = (law.compliance, law.curvature_per_pressure, law.stretch_per_pressure)
        return cls(floor, fade, give, linear)

    def weight(self, quantities: SceneQuantities) -> float:
        below = self.floor + self.fade - quantities.lowest_pressure
        law = quantities.bellows
        return max(0.0, np.max(below * law.compliance / law.rest_volume))

    def reason(self, quantities: SceneQuantities) -> str:
        return (
            f"the walls start to touch at {np.max(self.floor + self.fade) / 1e3:.3g} kPa gauge; "
            f"the lowest inlet pressure is {quantities.lowest_inlet_pressure / 1e3:.3g} kPa"
        )

    def wall(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Volume beyond rest, curvature and stretch at gauge pressures, any shape."""
        effective = pressure
        if np.any(pressure < self.floor + self.fade):  # else the law is the linear one
            own = (self.floor, self.fade, np, self.give)
            effective = bellow.effective_pressure(pressure, *own)
        volume, curvature, stretch = (slope * effective for slope in self.linear)
        return volume, curvature, stretch

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(wall=self.wall)

    def warnings(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Notice]:
        # Where the effect was weighed and neglected, no bellow comes near its floor.
        is_forbidden = quantities.scene.effects.mode(self.name) == "off"
        if not is_forbidden or Trait.LIMITED_EMPTYING in traits_of(active):
            return
        law, low = quantities.bellows, quantities.lowest_pressure
        share = np.atleast_1d(1 + law.compliance * low / law.rest_volume)
        floor = law.floor_volume / law.rest_volume * np.ones(len(share))
        softest = int(np.argmin(share - floor))
        if share[softest] < floor[softest]:
            empty = low / (1 - share[softest])
            yield Notice(
                "negative_volume" if share[softest] <= 0.0 else self.name,
                f"at {low / 1e3:.4g} kPa gauge the linear law leaves a bellow "
                f"{share[softest]:.3g} of its rest volume (nothing below "
                f"{empty / 1e3:.4g} kPa gauge); a real bellow collapses at about "
                f"{floor[softest]:.3g}",
                "bellows",
            )

    def limits(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Limit]:
        """The minimum volume, whatever the law of the bellows."""
        law, names = quantities.bellows, quantities.graph.bellows
        every = np.ones(len(names))
        floor, rest = law.floor_volume * every, law.rest_volume * every
        kept = floor * (1 - FLOOR_REL_TOL)

        def below_floor(peak: Peak) -> Notice:
            k = peak.column
            name, least = names[k], kept[k] / rest[k] - peak.value
            count = int(np.sum(peak.columns > 0.0))
            return Notice(
                "negative_volume" if least <= 0.0 else self.name,
                f"{count} of {len(names)} bellows fall below their minimum of "
                f"{floor[k] / rest[k]:.3g} of the rest volume; {name} reaches {least:.3g}",
                name,
                peak.time_s,
            )

        # By how much of its rest volume a bellow is below its minimum.
        yield Limit(lambda block: (kept - block.volume) / rest, 0.0, below_floor)

    def join(self, system: System) -> None:
        floor = system.of_bellows("collapse.floor", self.floor)
        fade = system.of_bellows("collapse.fade", self.fade)
        give = system.of_bellows("collapse.give", self.give)
        system.wall = CollapsingWall(system.linear_wall(), floor, fade, give)


def _contact(*numbers: Any) -> tuple[Numbers, Numbers, Numbers]:
    """Floor, fade and give by rest volume, compliance, minimum and ambient, bellow by bellow."""
    count = max(np.size(own) for own in numbers)
    if not any(isinstance(own, np.ndarray) for own in numbers):
        return (*bellow.collapse_pressures(*numbers), bellow.residual_compliance(*numbers))
    each = zip(*((own * np.ones(count)).tolist() for own in numbers), strict=True)
    found = [(*bellow.collapse_pressures(*own), bellow.residual_compliance(*own)) for own in each]
    floor, fade, give = (np.array(column) for column in zip(*found, strict=True))
    return floor, fade, give
