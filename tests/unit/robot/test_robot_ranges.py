"""Numbers of a robot a thousand times off are told once each."""

from __future__ import annotations

import re

import pytest

from tests.scenes import CONFIGS, ROOT
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
    "inputs.B.delay=1250": "did you mean 1.25 s?",
    "inputs.B.delay=0.4 ms": "far below",
}


@pytest.mark.parametrize("change", SLIPS)
def test_a_number_that_is_hardly_meant_is_told_once(change: str) -> None:
    (found,) = robot_notices(load_robot(CONFIGS / "hexapod.yaml", [change]))
    assert found.where == change.partition("=")[0].replace("pump", "pump.volume")
    assert SLIPS[change] in found.message


def test_the_bundled_robot_is_not_warned_about() -> None:
    assert not list(robot_notices(load_robot(CONFIGS / "hexapod.yaml")))
    assert all(found.source and found.low < found.high for found in RANGES)


@pytest.mark.parametrize(("damping", "count"), [("0 s", 1), ("0.9 ms", 1), ("1 ms", 0)])
def test_damping_without_a_speed_is_told(damping: str, count: int) -> None:
    """Steps of 1/4000 of a cycle of 2.5 s damp like 0.3125 ms, a third of what is needed."""
    change = f"robot.damping_time={damping}"
    found = list(robot_notices(load_robot(CONFIGS / "hexapod.yaml", [change])))
    assert [notice.where for notice in found] == ["robot.damping_time"] * count
    assert all("will state no speed" in notice.message for notice in found)


def test_every_key_of_a_robot_with_a_unit_has_a_range() -> None:
    page = (ROOT / "docs" / "keys.md").read_text()
    keys = set(re.findall(r"^\| `(robot\.[^`]+)` \| [^|]* \| `[^`]+` \|", page, re.M))
    refused = {f"robot.{name}" for name in ("ground.slope", "legs.LF.lean", "legs.LF.splay")}
    assert refused < keys  # beyond 45 degrees
    assert {key.replace(".LF.", ".*.") for key in keys - refused} <= {one.key for one in RANGES}
