"""The spec of a robot: what it means, and one clear message for each fault."""

from __future__ import annotations

import numpy as np
import pytest

from tests.robots import TEXT, hexapod
from tests.scenes import CONFIGS
from viscodesign import SpecError, load, load_robot
from viscodesign.loading import load_any
from viscodesign.robot.build_robot import build_robot


def test_the_bundled_robot_is_that_of_the_paper() -> None:
    scene = hexapod()
    assert scene.robot.mass == pytest.approx(0.734)
    assert scene.robot.body_length == pytest.approx(0.254)
    assert scene.gauge_pressure + scene.ambient_pressure == pytest.approx(140e3, abs=50)
    fed = {name: leg.source for name, leg in scene.robot.legs.items()}
    assert sorted(name for name, source in fed.items() if source == "A") == ["LF", "LR", "RM"]


def test_an_input_that_is_another_one_is_later() -> None:
    sources = hexapod().sources
    times = np.linspace(0.0, 7.0, 50)
    own = sources["A"].values(times)
    np.testing.assert_allclose(sources["B"].values(times + 1.25), own, atol=1e-9)
    assert sources["B"].values(np.zeros(1))[0] == pytest.approx(
        sources["A"].values(np.array([1.25]))[0], abs=1e-9
    )


def test_an_actuator_may_be_like_another_one() -> None:
    scene = hexapod("actuators.rear={like: leg}", "robot.legs.LR.actuator=rear")
    assert scene.leg_scene("rear") == scene.leg_scene("leg")
    assert [len(group.legs) for group in build_robot(scene).groups] == [5, 1]


def test_robots_is_a_slip_of_robot() -> None:
    text = TEXT.replace("\nrobot:\n", "\nrobots:\n")
    with pytest.raises(SpecError, match="robots: no such key; did you mean 'robot'"):
        load_any(text)
    with pytest.raises(SpecError, match=r"no key 'robot' \('robots' is none\)"):
        load_robot(text)


FAULTS = [
    ("\nactuators:\n", "\nactuators: {}\nx-actuators:\n", "actuators: empty; at least one is needed"),
    (", source: A}", "}", "robot.legs.LF.source: missing"),
    ("source: A}", "source: C}", "robot.legs.LF.source: no such input; there are A, B"),
    ("LM: {actuator: leg", "LM: {actuator: lag", "robot.legs.LM.actuator: no such actuator; did you mean 'leg'?"),
    ("  damping_time", "  # damping_time", "robot.damping_time: missing"),
    ("friction: 0.6", "friction: -0.6", "robot.foot.friction: must be at least 0"),
    ("\nrobot:\n", "\nrobot:\n - {}\n - {}\nx-robot:\n", "robot: a list of 2 bodies"),
    ("\nactuators:\n", "\nactuators:\n  leg: {like: leg}\n", "actuators.leg: duplicate key"),
    ("  leg:\n", "  leg: {like: lag}\nx-leg:\n  leg:\n", "actuators.leg.like: no such actuator"),
    ("as: A", "as: Q", "inputs.B.as: no input 'Q'"),
    ("delay: 1.25 s", "delay: 1.25 m", "inputs.B.delay: '1.25 m' is a length"),
    ("amplitude: 10", "amplitud: 10", "inputs.A.amplitud: no such key; did you mean 'amplitude'?"),
    ("[1, 2]", "[1, 9]", "robot.stiff_sections: actuator 'leg' has sections 1 to 8"),
    ("[1, 2]", "[0]", "robot.stiff_sections: sections count from 1"),
    ("mass: 7 g", "mass: 700 g", "robot.mass: 734 g for the whole robot"),
    ("count: 16", "count: 15", "actuators.leg.bellows.count: 15 is odd"),
    ("layout: straight", "layout: crossd", "actuators.leg.network.layout: must be one of"),
    ("tube_radius", "changes: {R1-R7: {length: 1 mm}}\n      tube_radius", "actuators.leg.network.changes.R1-R7: the straight layout has no such tube"),
    ("x: 0 mm, y: -60 mm, splay", "x: 0 mm, y: 0 mm, splay", "robot.legs.LM.splay: a hip in the middle"),
    ("      entrance_loss", "      tube_wall: {youngs_modulus: 10 MPa, thickness: 1 mm}\n      entrance_loss", "actuators.leg.network.tube_wall: a robot's legs have equal sections"),
    ("    network:\n", "    sections: {1-2: {}}\n    network:\n", "actuators.leg.sections: a robot's legs have equal sections"),
    ("      count: 16", "      curve: {rows: [[-1, -1e-6, 0, 0], [1, 1e-6, 0, 0]]}\n      count: 16", "actuators.leg.bellows.curve: a robot's legs have equal sections"),
    ("layout: straight", "layout: custom\n      tubes: [{from: inlet, to: lag.R1}]", "actuators.leg.network.tubes.0: no such actuator: 'lag'; did you mean 'leg'?"),
    ("output_interval: 20 ms", "start: rest", "run.start: 'rest', but a robot stands at the start"),
    ("output_interval: 20 ms", "output_times: [0, 1]", "run.output_times: a gait is written by steps"),
    ("accuracy: 1 %", "effects: off", "effects: the equations of a robot's legs are fixed"),
]  # fmt: skip


@pytest.mark.parametrize(("old", "new", "message"), FAULTS, ids=[case[2][:40] for case in FAULTS])
def test_each_fault_is_told_at_its_line(old: str, new: str, message: str) -> None:
    assert old in TEXT
    with pytest.raises(SpecError) as caught:
        load_robot(TEXT.replace(old, new))
    told = str(caught.value).splitlines()
    assert any(message in line for line in told), told
    assert all(fault.line is not None for fault in caught.value.faults)


def test_feet_inside_the_ground_are_told_with_the_height_that_they_need() -> None:
    with pytest.raises(SpecError, match=r"robot.hip_height: 100 mm puts the feet 35.6 mm into"):
        build_robot(hexapod("robot.hip_height=100 mm"))
    build_robot(hexapod("robot.hip_height=140 mm"))


def test_a_command_for_one_actuator_names_those_for_a_robot() -> None:
    with pytest.raises(SpecError, match=r"this is the spec of a robot; `viscodesign stand`"):
        load(TEXT)


def test_a_spec_without_a_robot_is_told_in_one_line() -> None:
    with pytest.raises(SpecError) as caught:
        load_robot(CONFIGS / "leg_16_straight_air.yaml")
    assert [fault.message.partition(";")[0] for fault in caught.value.faults] == [
        "not a robot: no key 'robot'"
    ]


def test_pillars_are_blocked_sections_of_every_leg() -> None:
    scene = hexapod()
    blocked = scene.single_scene("leg", "A").sections.blocked
    assert blocked is not None
    assert blocked.tolist() == [True, True] + 6 * [False]
    assert hexapod("robot.stiff_sections=[]").leg_scene("leg").section_changes is None
