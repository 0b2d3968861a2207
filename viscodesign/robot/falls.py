"""Why a robot falls whatever its legs bear: its feet slide, or its weight acts beside them."""

from __future__ import annotations

import numpy as np
from scipy.optimize import nnls

from viscodesign.results.stand_study import Fall
from viscodesign.robot.leg_pose import BODY, FOOT
from viscodesign.robot.robot_model import RobotModel
from viscodesign.robot.stance import set_down

OUTSIDE = 1e-6
"""Part of the weight and its moments that no feet carry, from which on a robot tips over."""


def slide(model: RobotModel) -> Fall | None:
    """Sliding: on a slope beyond the angle of friction, and on any ground without friction."""
    along, across = model.gravity
    friction, needed = model.feet.friction, abs(along) / across
    if friction >= needed and friction > 0.0:
        return None
    slope = np.degrees(np.arctan(needed))
    why = (
        f"on a slope of {slope:.3g} deg its feet need a friction of at least tan(slope) = "
        f"{needed:.3g}; robot.foot.friction is {friction:.3g}"
        if needed
        else "without friction nothing holds its feet; give robot.foot.friction more than 0"
    )
    return Fall("slides", why)


def tip_over(model: RobotModel, pressures: np.ndarray) -> Fall | None:
    """Tipping over: no forces with which the ground pushes on the feet balance the weight.

    ``pressures``: gauge, of every source [Pa]; the feet are where the robot is set down.
    """
    feet, weight = _feet(model, pressures)
    balance = np.vstack([feet.T / _size(feet), np.ones(len(feet))])
    _, left = nnls(balance, np.append(weight / _size(feet), 1.0))
    if left < OUTSIDE:
        return None
    (x, y), low, high = 1e3 * weight, 1e3 * feet.min(axis=0), 1e3 * feet.max(axis=0)
    why = (
        f"its weight acts at x = {x:.3g} mm, y = {y:.3g} mm from the body's centre of mass, beside "
        f"its feet (x from {low[0]:.3g} to {high[0]:.3g} mm, y from {low[1]:.3g} to "
        f"{high[1]:.3g} mm); move its legs or robot.centre_of_mass"
    )
    return Fall("tips over", why)


def _feet(model: RobotModel, pressures: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Places of the feet (c, 2) and of the weight (2,) on the ground: x and y [m]."""
    place, _ = set_down(model, pressures)
    x, z, y = place[BODY::FOOT], place[BODY + 1 :: FOOT], np.zeros(model.count)
    for group in model.groups:
        _, hip, below, tilt, _ = group.mounts.T
        y[group.legs] = hip + (z[group.legs] - place[1] - below) * np.tan(tilt)
    share = model.feet.mass / model.mass
    height = -(share * z.sum() + (1 - share * model.count) * place[1])
    along, across = model.gravity
    body = (1 - share * model.count) * place[0]
    weight = np.array([body + share * x.sum() + height * along / across, share * y.sum()])
    return np.column_stack([x, y]), weight


def _size(feet: np.ndarray) -> float:
    return float(np.max(np.abs(feet)))
