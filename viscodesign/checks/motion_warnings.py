"""Where a run leaves the assumptions of its model."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from viscodesign.effects.catalogue import every_effect
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.postprocess.motion_limits import MotionBlock, limit_notices
from viscodesign.postprocess.validity_in_motion import model_limits
from viscodesign.results.findings import Notice


def motion_notices(
    quantities: SceneQuantities,
    active: frozenset[str],
    outputs: Iterable[MotionBlock],
    solved: Iterable[MotionBlock] = (),
) -> Iterator[Notice]:
    """Every limit that a run with these effects exceeds, once, at its worst place and time.

    ``outputs``: the run at its outputs, in order; ``solved``: at all times that were solved for.
    """
    limits = [*model_limits(quantities)]
    for effect in every_effect(quantities).values():
        limits += effect.limits(quantities, active)
    yield from limit_notices(limits, outputs, solved)
