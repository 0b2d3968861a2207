"""`actuators:` without a robot: what feeds each, inputs that are later, and what is refused."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest
import yaml

from tests.scenes import CONFIGS, SEVERAL_SPECS
from viscodesign import SeveralScene, load, load_several
from viscodesign.errors import SpecError
from viscodesign.scene.input import INPUT_KINDS
from viscodesign.scene.later_input import later_input
from viscodesign.scene.reading.write import part_yaml


def spec(**changes: Any) -> dict[str, Any]:
    """The bundled spec of three legs with some of its keys replaced."""
    found = yaml.safe_load(SEVERAL_SPECS[0].read_text())
    return {**found, **changes}


def legs(*actuators: str, **changes: Any) -> SeveralScene:
    """Three legs, the second and third of which are given as text."""
    own = spec(**changes)
    names = ("right", "middle")
    given = dict(zip(names, map(yaml.safe_load, actuators), strict=False))
    own["actuators"] = {"left": own["actuators"]["left"], **given}
    return load_several(own)


def test_one_that_is_like_another_has_its_parts_source_and_loads() -> None:
    scene = legs("{like: left}", "{like: right, source: B, loads: {payload: 5 g}}")
    assert [scene.sources_of(name) for name in scene.actuators] == [
        {"inlet": "A"},
        {"inlet": "A"},
        {"inlet": "B"},
    ]
    assert scene.scenes["middle"].bellows == scene.scenes["left"].bellows
    payloads = [own.loads.payload for own in scene.scenes.values()]
    assert payloads == [0.0, 0.0, 0.005]
    assert scene.fed_by("A") == ["left", "right"]


def test_an_actuator_of_several_is_the_scene_of_one() -> None:
    own = spec()
    single = {key: own[key] for key in own if key not in ("actuators", "inputs")}
    parts = {key: own["actuators"]["left"][key] for key in ("actuator", "bellows", "network")}
    alone = load({**single, **parts, "name": "three_legs.left", "input": own["inputs"]["A"]})
    assert load_several(own).scenes["left"].digest == alone.digest


def test_sections_of_one_of_several_may_differ() -> None:
    own = spec()
    own["actuators"]["left"]["sections"] = {"1-2": {"blocked": True}}
    scene = load_several(own)
    assert all(one.sections.blocked.sum() == 2 for one in scene.scenes.values())
    own["actuators"]["left"]["sections"] = {"9": {"blocked": True}}
    with pytest.raises(SpecError, match=r"actuators\.left\.sections\.9: no such section"):
        load_several(own)


def test_a_resolved_spec_is_the_same_again() -> None:
    scene = load_several(SEVERAL_SPECS[0])
    again = load_several(part_yaml(scene))
    digests = [{n: s.digest for n, s in own.scenes.items()} for own in (scene, again)]
    assert digests[0] == digests[1]


@pytest.mark.parametrize(
    ("actuators", "changes", "message"),
    [
        (["{source: B}"], {}, "actuators.right.actuator: missing; or give 'like'"),
        (["{like: lefd}"], {}, "actuators.right.like: no such actuator; did you mean 'left'"),
        (["{like: middle}", "{like: right}"], {}, "is like itself"),
        (["{like: left, source: C}"], {}, "actuators.right.source: no such input: 'C'"),
        (["{like: left, network: {layout: straight, tube_radius: 1 mm, tube_length: 1 cm}}"], {},
         "'like' and network are both given"),
        ([], {"tubes": [{"from": "left.R1", "to": "lefd.R1", "length": 1, "radius": 1}]},
         "no such actuator: 'lefd'; did you mean 'left'"),
        ([], {"inputs": {"A": {"as": "B"}}}, "inputs.A.as: no input 'B'"),
        ([], {"inputs": {}}, "inputs"),
        ([], {"run": {"duration": 1, "start": "periodic"},
              "inputs": {"A": {"kind": "constant", "value": 1}}}, "'periodic' needs inputs"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_said_at_its_key(
    actuators: list[str], changes: dict[str, Any], message: str
) -> None:
    with pytest.raises(SpecError, match=re.escape(message)):
        legs(*actuators, **changes)


def test_an_actuator_without_a_source() -> None:
    own = spec()
    del own["actuators"]["left"]["source"]
    message = "actuators.left.source: missing; name the input that feeds it: A, B"
    with pytest.raises(SpecError, match=re.escape(message)):
        load_several(own)
    own["inputs"] = {"A": own["inputs"]["A"]}
    del own["actuators"]["middle"]["source"]
    assert load_several(own).fed_by("A") == ["left", "right", "middle"]


def test_an_actuator_named_twice() -> None:
    text = SEVERAL_SPECS[0].read_text().replace("right: {", "left: {")
    with pytest.raises(SpecError, match=r"actuators\.left: duplicate key"):
        load_several(text)


SYRINGE = {"kind": "syringe", "diameter": "20 mm", "start": "50 mm", "rows": [[0, 0], [2, 5e-3]]}


def test_a_syringe_that_unequal_ones_share_joins_them_and_one_of_a_single_one_does_not() -> None:
    heavy = "{like: left, loads: {payload: 1 g}}"
    assert [own.names for own in legs(heavy, inputs={"A": SYRINGE}).groups] == [("left", "right")]
    scene = legs("{like: left, source: B}", inputs={"A": SYRINGE, "B": spec()["inputs"]["A"]})
    assert not scene.groups
    assert not scene.scenes["left"].input.gives_pressure  # type: ignore[union-attr]
    with pytest.raises(SpecError, match=r"inputs\.B\.delay: 'A' is of the kind syringe"):
        legs("{like: left, source: B}", inputs={"A": SYRINGE, "B": {"as": "A", "delay": 1}})


def test_equal_ones_have_an_even_part_of_a_syringe() -> None:
    whole = INPUT_KINDS["syringe"].model_validate({**SYRINGE, "dead_volume": 1e-6, "cushion": 1e-7})
    part = whole.shared_by(3)
    assert part is not None
    time = np.linspace(0, 2, 5)
    assert 3 * part.values(time) == pytest.approx(whole.values(time), rel=1e-12)
    volumes = [own.full_volume for own in (part, whole)]  # type: ignore[attr-defined]
    assert 3 * volumes[0] == pytest.approx(volumes[1], rel=1e-12)
    scene = legs("{like: left}", "{like: left}", inputs={"A": SYRINGE})
    assert scene.scenes["middle"].input == INPUT_KINDS["syringe"].model_validate(SYRINGE).shared_by(
        3
    )


def test_a_syringe_that_feeds_two_inlets_joins_them() -> None:
    own = spec(inputs={"A": SYRINGE})
    left = own["actuators"]["left"]
    ends = (("a", "R1"), ("b", "L1"), ("R1", "R2"), ("L1", "L2"))
    tubes = [{"from": a, "to": b, "length": 0.04, "radius": 3e-4} for a, b in ends]
    left |= {"network": {"layout": "custom", "tubes": tubes}, "source": {"a": "A", "b": "A"}}
    left["bellows"]["count"] = 4
    own["actuators"] = {"left": left}
    (joined,) = load_several(own).joined
    assert joined.graph.inlets == ("A",)
    assert [(t.start, t.end) for t in joined.graph.tubes[:2]] == [
        ("A", "left.R1"),
        ("A", "left.L1"),
    ]
    own["inputs"] = spec()["inputs"]
    left["source"] = {"a": "A", "b": "B"}
    assert list(load_several(own).scenes["left"].inputs) == ["a", "b"]


SNAP = {"rows": [[-20e3, -5e-5, -0.1, -5e-4], [0, 0, 0, 0], [6e3, 4e-5, 0.1, 4e-4],
                 [4e3, 8e-5, 0.2, 8e-4], [30e3, 2e-4, 0.4, 2e-3]]}  # fmt: skip


def test_a_syringe_joins_equal_ones_whose_bellows_snap_one_before_the_other() -> None:
    own = spec(inputs={"A": SYRINGE})
    own["actuators"] = {"left": own["actuators"]["left"], "right": {"like": "left"}}
    own["actuators"]["left"]["bellows"]["curve"] = SNAP
    assert [group.names for group in load_several(own).groups] == [("left", "right")]


def test_single_specs_and_others_are_told_apart() -> None:
    with pytest.raises(SpecError, match=r"several actuators.*load_several"):
        load(SEVERAL_SPECS[0])
    with pytest.raises(SpecError, match="actuators: "):
        load_several(CONFIGS / "leg.yaml")


LATER = [
    {"kind": "constant", "value": 3e3},
    {"kind": "step", "value": 5e3, "time": 0.3},
    {"kind": "sine", "amplitude": 5e3, "frequency": 0.7, "phase": 0.2, "mean": 1e3},
    {"kind": "square", "high": 5e3, "low": -1e3, "frequency": 0.7, "duty": 0.3},
    {"kind": "trapezoid", "high": 5e3, "low": -1e3, "rise": 0.2, "hold": 0.3, "fall": 0.2,
     "rest": 0.4},
    {"kind": "harmonics", "period": 1.3, "mean": 1e3, "cosine": [5e3, 1e3], "sine": [2e3]},
    {"kind": "double_sigmoid", "start": 4e3, "drop": 9e3, "fall_time": 0.5, "rise_time": 1.5,
     "transition": 0.4},
    {"kind": "table", "rows": [[0, 0], [0.4, 5e3], [0.4, 2e3], [1, 1e3]]},
    {"kind": "table", "rows": [[0, 0], [0.4, 5e3], [0.4, 2e3], [1, 0]], "repeat": True},
]  # fmt: skip


@pytest.mark.parametrize("keys", LATER, ids=lambda keys: keys["kind"])
def test_a_later_input_has_the_values_of_its_source_later(keys: dict[str, Any]) -> None:
    source, delay = INPUT_KINDS[keys["kind"]].model_validate(keys), 0.37
    later = later_input(source, delay, 3.0)
    assert later is not None
    time = np.linspace(0.013, 3.0, 401)
    before = time - delay
    if source.period is not None:
        before = before % source.period
    expected = source.values(np.maximum(before, 0.0))
    if source.period is None and keys["kind"] != "double_sigmoid":
        initial = float(source.expression(0.0, source.initial_piece(), np))
        expected = np.where(time < delay, initial, expected)
    if keys["kind"] == "double_sigmoid":
        expected = source.values(before)
    assert later.values(time) == pytest.approx(expected, abs=1e-6 * 5e3)
    assert np.ptp(later.values(time)) == pytest.approx(np.ptp(expected), rel=1e-9)


def test_every_kind_is_tried() -> None:
    assert {keys["kind"] for keys in LATER} == {*INPUT_KINDS} - {"syringe"}


def leading_to(node: str) -> dict[str, Any]:
    """The bundled spec with one tube of its first actuator to a node by name."""
    own = spec()
    tubes = [{"from": "inlet", "to": "R1"}, {"from": "R8", "to": node}]
    sizes = {"tube_length": 0.04, "tube_radius": 3e-4}
    own["actuators"]["left"]["network"] = {"layout": "custom", "tubes": tubes, **sizes}
    return own


@pytest.mark.parametrize(
    ("node", "message"),
    [
        ("right.R1", "'right.R1': a tube that leads to another actuator stands"),
        ("right.inlet", "'right.inlet': a tube that leads to another actuator stands"),
        ("nix.R1", "no such actuator: 'nix'; there are left"),
        ("rigth.tee", "no such actuator: 'rigth'; did you mean 'right'?"),
        ("left.R1", "nodes of its own network have no prefix; use 'R1'"),
    ],
)
def test_a_tube_of_one_actuator_leads_to_no_other(node: str, message: str) -> None:
    with pytest.raises(SpecError, match=re.escape(message)) as raised:
        load_several(leading_to(node))
    assert "actuators.left.network.tubes.1" in str(raised.value)


def test_a_junction_of_its_own_may_have_a_dot() -> None:
    graph = load_several(leading_to("tee.a")).scenes["left"].graph
    assert graph.junctions == ("tee.a",)


@pytest.mark.parametrize("key", ["actuators", "inputs"])
def test_an_empty_mapping_is_called_empty(key: str) -> None:
    with pytest.raises(SpecError, match=f"{key}: empty; at least one is needed"):
        load_several(spec(**{key: {}}))


def test_an_input_that_feeds_nothing_is_told() -> None:
    """Also where a tube was to lead from it, but names another node."""
    spec = yaml.safe_load((CONFIGS / "two_legs.yaml").read_text())
    spec["tubes"][0]["from"] = "Q"
    with pytest.raises(SpecError, match=r"inputs\.A: feeds nothing; name it as the source"):
        load_several(spec)
