"""Inputs that hardly move the actuator: pressures or volumes a thousand times too small."""

from __future__ import annotations

import math
from collections.abc import Iterator

from viscodesign.results.findings import Notice
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.scene import Scene

MIN_MOTION = 0.01
"""Motion of the tip, in lengths of the actuator, that inputs are made for."""


def slight_inputs(scene: Scene) -> Iterator[Notice]:
    """One warning, where all inputs together hardly move the tip, at the largest of them."""
    sizes = {name: _pressure(scene, source) for name, source in scene.inputs.items()}
    if not sizes:
        return
    name = max(sizes, key=sizes.__getitem__)
    pressure = sizes[name]
    motion = _motion(scene, pressure)
    if not 0.0 < motion < MIN_MOTION:
        return
    larger = _motion(scene, 1e3 * pressure)
    meant = "; are its numbers in another unit?" if larger > MIN_MOTION else ""
    yield Notice(
        "slight_input",
        f"{pressure:.4g} Pa in the bellows move the tip by about {100 * motion:.2g} % of the "
        f"actuator's length{meant}",
        "input" if scene.several_inputs is None else f"inputs.{name}",
    )


def _pressure(scene: Scene, source: Input) -> float:
    """Change of pressure that an input brings about, its level where it rests, by the bellows'
    linear law [Pa].
    """
    low, high = source.extremes(scene.run.duration)
    is_moved, bellows = source.moves_within(scene.run.duration), scene.bellows
    size = high - low if is_moved and high > low else max(abs(low), abs(high))
    if source.gives_pressure:
        return size
    return size / (bellows.count * bellows.length * bellows.area_per_pressure)


def _motion(scene: Scene, pressure: float) -> float:
    """Displacement of the tip in lengths of the rod: half of its turn, and its stretch [1]."""
    body, bellows = scene.actuator, scene.bellows
    strain = pressure / body.youngs_modulus
    sections = bellows.count // 2
    turn = strain * abs(bellows.angle_per_pressure) * sections
    stretch = strain * abs(bellows.extension_per_pressure) * sections / body.length
    return math.hypot(turn / 2, stretch)
