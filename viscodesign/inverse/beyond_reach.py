"""Paths that no pressure within limits can reach: the rod is not long enough."""

from __future__ import annotations

import numpy as np

from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.inverse.arc_rod import ArcRod
from viscodesign.inverse.free_choice import FreeChoice
from viscodesign.inverse.wanted_path import WantedPath
from viscodesign.scene.far_places import far_words
from viscodesign.scene.scene import Scene

ADDED_STRETCH = 0.02
"""Part of the length that loads and feedback may add to the rod's own stretch."""


def beyond_reach(
    wanted: WantedPath, choice: FreeChoice, scene: Scene, tolerance: float
) -> tuple[str, str] | None:
    """Why a path is out of reach, a point farther from the clamp than the rod may be long, and what
    would help; None where it may be in reach.

    The highest pressure is that of the limits, or of the input where its numbers are not free;
    with other numbers of the body free, or a measured curve of it, nothing is said.
    """
    has_free_body = any(key.startswith(("actuator", "bellows", "loads")) for key in choice.keys)
    if not has_free_body and (words := far_words(wanted.points, scene.actuator.length)):
        return (
            f"out of reach: {words}",
            "Write the unit of each column, such as x_mm; rows are in m",
        )
    has_free_pressure = any(key.startswith(("input", "gauge")) for key in choice.keys)
    if has_free_body or (has_free_pressure and choice.harmonics is None):
        return None
    if scene.bellows.curves:
        return None  # it may stretch by more than its slope at rest says
    if choice.harmonics is not None:
        high = choice.harmonics.limits[1]
    else:
        high = max(source.extremes(scene.run.duration)[1] for source in scene.inputs.values())
        if not all(source.gives_pressure for source in scene.inputs.values()):
            return None
    length, level = scene.actuator.length, max(scene.gauge_pressure + high, 0.0)
    longest = ArcRod.of(SceneQuantities(scene)).longest(level, scene.bellows.count)
    far = np.linalg.norm(wanted.points, axis=1)
    beyond = float(far.max()) - longest
    if beyond <= max(tolerance, ADDED_STRETCH * length):
        return None
    x, z = np.round(1e3 * wanted.points[int(far.argmax())], 6) + 0.0
    return (
        f"out of reach: ({x:.4g}, {z:.4g}) mm is {1e3 * far.max():.4g} mm from the clamp, and at "
        f"{1e-3 * level:.3g} kPa the actuator is {1e3 * longest:.4g} mm long; it is "
        f"{1e3 * beyond:.3g} mm too far",
        "Move the path, or allow higher pressures",
    )
