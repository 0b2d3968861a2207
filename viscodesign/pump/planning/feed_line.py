"""What the tubes hold at the inlet of a network."""

from __future__ import annotations

from viscodesign.effects.base import Trait
from viscodesign.effects.catalogue import every_effect, traits_of
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.scene import Scene


@dataclass(frozen=True)
class FeedLine:
    """What the tubes hold at an inlet."""

    volume: float = 0.0  # [m3]
    compliance: float = 0.0  # [m3/Pa]
    compressible: bool = False  # whether its fluid has a density of its own, like the network's


def feed_line_at(scene: Scene, inlet: str, active: frozenset[str]) -> FeedLine:
    """The lines of an inlet in a model with these effects, to all actuators that it feeds."""
    compressible = Trait.COMPRESSIBLE_FLUID in traits_of(active)
    effects = every_effect(SceneQuantities(scene))
    stored = [effects[name].node_storage(inlet, compressible) for name in sorted(active)]
    volume, compliance = sum(v for v, _ in stored), sum(c for _, c in stored)
    return FeedLine(fed_by_each(scene) * volume, fed_by_each(scene) * compliance, compressible)


def fed_by_each(scene: Scene) -> int:
    """Equal actuators that each inlet of the scene's pump feeds."""
    return 1 if scene.pump is None else scene.pump.feeds
