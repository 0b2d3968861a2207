"""The ground that an actuator may touch, as a line to draw."""

from __future__ import annotations

import math

import numpy as np

from viscodesign.scene.ground import Ground

CIRCLE_POINTS = 181


def ground_outline(ground: Ground, reach: float) -> np.ndarray:
    """Points of its surface (n, 2) [m]: a whole circle, or a line so far to either side of the
    clamp as ``reach`` [m].
    """
    if ground.kind == "circle":
        assert ground.centre is not None
        assert ground.radius is not None
        turn = np.linspace(0, 2 * np.pi, CIRCLE_POINTS)
        ring = ground.radius * np.column_stack([np.cos(turn), np.sin(turn)])
        return np.asarray(ring + np.array([ground.centre.x, ground.centre.z]))
    assert ground.point is not None
    assert ground.normal is not None
    away = np.array([math.sin(ground.normal), math.cos(ground.normal)])
    nearest = away * (away @ [ground.point.x, ground.point.z])
    along = np.array([away[1], -away[0]])
    return np.array([nearest - reach * along, nearest + reach * along])


def ground_words(ground: Ground) -> str:
    """What touches the line that is drawn: a body drawn about its axis may lie across it."""
    if ground.touches == "sections":
        return "ground, as the axis touches it"
    if ground.foot_radius:
        return f"ground, as a foot of {1e3 * ground.foot_radius:.3g} mm about the tip touches it"
    return "ground, as the tip touches it"
