"""Numbers of a robot a thousand times off are told once each."""

from __future__ import annotations

import pytest

from tests.scenes import CONFIGS
from viscodesign import load_robot
from viscodesign.robot.robot_ranges import RANGES, robot_notices

SLIPS = {
    "robot.mass=734 kg": "734 kg is far above what such robots have",
    "robot.body_length=254": "did you mean 254 mm?",
    "robot.hip_height=105": "did you mean 105 mm?",
    "robot.hip_height=105 um": "did you mean 105 mm?",
    "robot.foot.radius=15": "did you mean 15 mm?",
    "robot.foot.friction=60": "did you mean 0.6?",
    "robot.legs.LF.x=90": "did you mean 90 mm?",
    "robot.damping_time=30 s": "did you mean 30 ms?",
    "robot.payload=500 kg": "did you mean 0.5 kg?",
    "robot.pump={volume: 100}": "did you mean",
}


@pytest.mark.parametrize("change", SLIPS)
def test_a_number_that_is_hardly_meant_is_told_once(change: str) -> None:
    (found,) = robot_notices(load_robot(CONFIGS / "hexapod.yaml", [change]))
    assert found.where == change.partition("=")[0].replace("pump", "pump.volume")
    assert SLIPS[change] in found.message


def test_the_bundled_robot_is_not_warned_about() -> None:
    assert not list(robot_notices(load_robot(CONFIGS / "hexapod.yaml")))
    assert all(found.source and found.low < found.high for found in RANGES)
