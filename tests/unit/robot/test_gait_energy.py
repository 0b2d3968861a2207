"""The energy of a robot whose motion is known."""

from __future__ import annotations

import numpy as np
import pytest

from tests.robots import hexapod, recorded


def test_a_robot_that_slides_down_a_slope_keeps_the_books_of_a_block() -> None:
    """Its legs settle within the first two seconds; then it accelerates as any body does."""
    slope, friction, cycle, step = np.radians(20), 0.1, 2.5, 2.5 / 40
    scene = hexapod(
        "robot.hip_height=137 mm",
        "robot.ground.slope=20 deg",
        f"robot.foot.friction={friction}",
        "inputs.A.amplitude=1e-3 Pa",
    )
    found = recorded(scene, 40, 2)
    mass, motion = scene.robot.mass, found.motion
    way = motion.body[motion.last_cycle, 0]
    distance, speeds = way[-1] - way[0], found.velocities[motion.last_cycle, 0][[0, -1]]
    normal, pull = mass * 9.80665 * np.cos(slope), mass * 9.80665 * np.sin(slope)
    assert speeds[1] == pytest.approx(speeds[0] + cycle * (friction * normal - pull) / mass)
    work = friction * normal * distance  # it slides backward
    assert found.energy.cycle_work_j["friction"] == pytest.approx(work, rel=1e-6)
    stored = mass * (speeds[1] ** 2 - speeds[0] ** 2) / 2 + pull * distance
    settled = found.energy.cycle_work_j["pump"]  # what the legs' gas still gives back
    assert found.energy.cycle_stored_j == pytest.approx(stored + settled, rel=1e-5)
    steps = mass * ((speeds[1] - speeds[0]) / cycle) ** 2 * step * cycle / 2
    assert found.energy.cycle_loss_j["steps"] == pytest.approx(steps, rel=1e-4)
