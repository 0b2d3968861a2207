"""Designs that are better in something than every other: fit, fluid, pressure, sensitivity."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from viscodesign.inverse.number_search import NumberDesign
from viscodesign.results.path_design import DesignAlternative
from viscodesign.scene.effects_choice import EffectsChoice
from viscodesign.scene.reading.write import resolved_yaml
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import copied

MAX_ALTERNATIVES = 8
WORSE_FIT = 10.0
"""Multiple of the best distance beyond which a design is not an alternative."""


def alternatives(
    designs: Sequence[NumberDesign], effects: EffectsChoice
) -> tuple[DesignAlternative, ...]:
    """The Pareto set of designs, the best fit first; ``effects``: those of the task's spec."""
    near = WORSE_FIT * designs[0].distance.total_m
    found = [
        _measured(own, effects)
        for own in designs
        if own.distance.total_m <= near and own.distance.strays <= designs[0].distance.strays
    ]
    best = [own for own in found if not any(_beats(other, own) for other in found)]
    return tuple(sorted(best, key=lambda own: own.rms_m)[:MAX_ALTERNATIVES])


def with_modes_of(effects: EffectsChoice, scene: Scene) -> Scene:
    """A found scene with the modes of a spec's effects; options may have been free."""
    choice = scene.effects.with_modes(effects.modes, effects.others)
    return copied(scene, {"effects": choice})


def _beats(one: DesignAlternative, other: DesignAlternative) -> bool:
    """Whether one is at least as good in everything and better in something."""
    pairs = list(zip(one.measures, other.measures, strict=True))
    return all(a <= b for a, b in pairs) and any(a < b for a, b in pairs)


def _measured(own: NumberDesign, effects: EffectsChoice) -> DesignAlternative:
    scene = with_modes_of(effects, own.scene)
    ends = [source.extremes(scene.run.duration) for source in scene.inputs.values()]
    squares = (own.band**2).sum(axis=1)
    return DesignAlternative(
        own.distance.rms_m,
        sum(math.pi * tube.radius**2 * tube.length for tube in scene.graph.tubes),
        max(high for _, high in ends) - min(low for low, _ in ends),
        float(np.sqrt(squares.mean())) if len(squares) else 0.0,
        own.parameters,
        resolved_yaml(scene),
    )
