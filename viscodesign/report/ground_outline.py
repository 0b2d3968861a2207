"""The ground that an actuator may touch, as a line to draw."""

from __future__ import annotations

import math

import numpy as np

from viscodesign.scene.ground import Ground

CIRCLE_POINTS = 181
BEYOND = 0.01
"""How far drawn points may lie behind a surface and still count as touching it, of the length."""


def ground_outline(ground: Ground, reach: float) -> np.ndarray:
    """Points of its surface (n, 2) [m]: a whole circle, or a line so far to either side of the
    clamp as ``reach`` [m].
    """
    if ground.kind == "circle":
        assert ground.centre is not None
        assert ground.radius is not None
        return np.asarray(_ring(ground.radius) + np.array([ground.centre.x, ground.centre.z]))
    point, away = _line(ground)
    nearest = away * (away @ point)
    along = np.array([away[1], -away[0]])
    return np.array([nearest - reach * along, nearest + reach * along])


def feet(ground: Ground, tips: np.ndarray) -> np.ndarray:
    """Rings (n, k, 2) [m] of the round foot about tips (n, 2) [m]; none for a tip without one."""
    if not ground.foot_radius:
        return np.zeros((0, CIRCLE_POINTS, 2))
    return np.asarray(tips[:, None] + _ring(ground.foot_radius))


def lies_beyond(ground: Ground, points: np.ndarray, length: float) -> bool:
    """Whether any of the points (..., 2) [m] lies behind the surface, as no body can.

    ``length`` of the actuator [m], by which it is told what lies on the surface.
    """
    if ground.kind == "circle":
        assert ground.centre is not None
        assert ground.radius is not None
        apart = points - np.array([ground.centre.x, ground.centre.z])
        gap = np.hypot(apart[..., 0], apart[..., 1]) - ground.radius
    else:
        point, away = _line(ground)
        gap = (points - point) @ away
    return bool(np.min(gap) < -BEYOND * length)


def _line(ground: Ground) -> tuple[np.ndarray, np.ndarray]:
    """A point [m] of a straight surface, and the unit vector in which it pushes."""
    assert ground.point is not None
    assert ground.normal is not None
    away = np.array([math.sin(ground.normal), math.cos(ground.normal)])
    return np.array([ground.point.x, ground.point.z]), away


def _ring(radius: float) -> np.ndarray:
    turn = np.linspace(0, 2 * np.pi, CIRCLE_POINTS)
    return radius * np.column_stack([np.cos(turn), np.sin(turn)])


def ground_words(ground: Ground) -> str:
    """What touches the line that is drawn: a body drawn about its axis may lie across it."""
    if ground.touches == "sections":
        return "ground, touched by the axis"
    if ground.foot_radius:
        return f"ground, touched by the tip's round foot ({1e3 * ground.foot_radius:.3g} mm)"
    return "ground, touched by the tip"
