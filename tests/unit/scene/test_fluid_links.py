"""Which actuators share fluid, what their system consists of, and each of them by itself."""

from __future__ import annotations

import copy
import re
from typing import Any

import numpy as np
import pytest

from tests.coupled_specs import BELLOWS, LEFT, RIGHT, SYRINGE, TREE, coupled_spec, on_one_syringe
from viscodesign import load_several
from viscodesign.errors import SpecError
from viscodesign.scene.reading.write import part_yaml


def test_a_tee_joins_both_in_one_network() -> None:
    (joined,) = load_several(coupled_spec()).joined
    graph = joined.graph
    assert graph.inlets == ("A",)
    assert graph.bellows == (
        *("left.R1", "left.R2", "right.R1"),
        *("left.L1", "left.L2", "right.L1"),
    )
    assert set(graph.junctions) == {"T", "left.inlet", "right.inlet"}
    assert [t.name for t in graph.tubes if t.start == "T"] == ["T-left.inlet", "T-right.inlet"]
    assert len(graph.components()) == 1
    assert joined.section_name(3) == "section 1 of right"


def test_what_differs_stands_at_the_bellows_and_sections_of_each() -> None:
    spec = coupled_spec()
    spec["actuators"]["right"] = {
        **RIGHT,
        "bellows": {**RIGHT["bellows"], "changes": {"L1": {"area_per_pressure": 4e-9}}},
        "loads": {"gravity": "off", "payload": "3 g"},
    }
    (joined,) = load_several(spec).joined
    length, area = (joined.bellows.each(key) for key in ("length", "area_per_pressure"))
    assert length == pytest.approx([0.018, 0.018, 0.015] * 2)
    assert area == pytest.approx([3.413e-9] * 5 + [4e-9])
    assert joined.sections.each("youngs_modulus") == pytest.approx([1.8e6, 1.8e6, 1.5e6])
    assert [own.payload for own in joined.loads_of_rods] == [0.0, 0.003]
    assert [own.gravity is None for own in joined.loads_of_rods] == [False, True]


def test_only_what_shares_fluid_is_joined() -> None:
    spec = coupled_spec(inputs={"A": SYRINGE, "B": {"kind": "constant", "value": 0}})
    spec["actuators"]["apart"] = {**LEFT, "source": "B"}
    scene = load_several(spec)
    assert [group.names for group in scene.groups] == [("left", "right")]
    assert list(scene.scenes) == ["apart"]
    assert scene.sources_of("left") == {}


def test_one_source_of_given_pressure_joins_nothing() -> None:
    spec = on_one_syringe()
    spec["inputs"] = {"A": {"kind": "constant", "value": 0}}
    assert load_several(spec).groups == ()


def test_unequal_ones_on_one_syringe_are_one_system_and_equal_ones_are_not() -> None:
    (joined,) = load_several(on_one_syringe()).joined
    assert [t.start for t in joined.graph.tubes if "inlet" in t.name] == ["A", "A"]
    spec = on_one_syringe()
    spec["actuators"]["right"] = {"like": "left"}
    assert load_several(spec).groups == ()
    spec["actuators"]["right"] = {"like": "left", "loads": {"payload": "1 g"}}
    assert len(load_several(spec).groups) == 1


def test_each_by_itself_has_the_far_ends_of_its_tubes_as_inlets() -> None:
    spec = coupled_spec(
        tubes=[*TREE, {"from": "left.L1", "to": "right.L1", "length": "1 m", "radius": "1 mm"}]
    )
    scene = load_several(spec)
    own = scene.alone["right"]
    assert own.inlets == {"T": "T", "left_L1": "left.L1"}
    alone = scene.alone_driven_by(
        "right", {n: {"kind": "constant", "value": 0} for n in own.inlets}
    )
    assert alone.graph.bellows == ("R1", "L1")
    assert [t.name for t in alone.graph.tubes] == ["joint-R1", "R1-L1", "T-joint", "left_L1-L1"]
    same = load_several(on_one_syringe())
    assert same.alone["left"].network.layout == "straight"
    assert same.alone["left"].inlets == {"inlet": "A"}


def test_a_chain_that_is_fed_at_a_bellow_alone_has_no_inlet() -> None:
    tubes = [{"from": "left.L1", "to": "right.L1", "length": "1 m", "radius": "1 mm"}]
    spec = coupled_spec(tubes=tubes)
    spec["actuators"]["left"] = {**LEFT, "source": "A"}
    (joined,) = load_several(spec).joined
    assert [t.name for t in joined.graph.tubes if t.name.startswith("right")] == ["right.R1-L1"]


def test_a_resolved_spec_is_the_same_again() -> None:
    scene = load_several(coupled_spec())
    again = load_several(part_yaml(scene))
    assert [own.digest for own in scene.joined] == [own.digest for own in again.joined]


CURVE = {"rows": [[-30e3, -5e-5, -0.1, -5e-4], [0, 0, 0, 0], [60e3, 2e-4, 0.4, 2e-3]]}


def tube(start: str, end: str, **sizes: Any) -> dict[str, Any]:
    return {"from": start, "to": end, **({"length": 0.1, "radius": 1e-3} | sizes)}


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"tubes": [tube("A", "left")]}, "'left' is an actuator; name a node of it"),
        ({"tubes": [tube("A", "R1")]}, "'R1' is a bellow of which actuator? Write it as 'left.R1'"),
        ({"tubes": [tube("A", "left.R9")]}, "left has no node 'R9' for a tube"),
        ({"tubes": [tube("A", "lefd.R1")]}, "no such actuator: 'lefd'; did you mean 'left'"),
        ({"tubes": [tube("left.R1", "left.R1")]}, "joins left.R1 to itself"),
        ({"tubes": [tube("A", "A2"), *TREE[1:]]}, "tubes: no actuator is connected to A2"),
        ({"tubes": TREE[1:]}, "inputs.A: feeds nothing; name it as the source of an actuator, lead a tube"),
        ({"tubes": [*TREE, tube("A", "left.R1", radius=None)]}, "tubes.3.radius: missing; tubes"),
        ({"tubes": [*TREE, tube("J", "K")]}, "no actuator is connected to J, K"),
        ({"uncertainty": "typical"}, "uncertainty: bands of actuators that share fluid"),
        ({"loads": {"ground": {"kind": "line", "point": {"x": 0.1, "z": 0}, "normal": "270 deg", "friction": 0, "foot_radius": 1e-3}}},
         "loads.ground.foot_radius: a round tip of actuators that share fluid"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_said_at_its_key(changes: dict[str, Any], message: str) -> None:
    with pytest.raises(SpecError, match=re.escape(message)):
        load_several(coupled_spec(**copy.deepcopy(changes)))


@pytest.mark.parametrize(
    ("right", "message"),
    [
        ({"bellows": {**BELLOWS, "curve": CURVE}}, "actuators.left.bellows.curve: missing"),
        ({"network": {**RIGHT["network"], "exit_loss": 0.7}},
         "actuators.right.network.exit_loss: differs from that of left"),
    ],
)  # fmt: skip
def test_what_all_must_have_alike(right: dict[str, Any], message: str) -> None:
    spec = coupled_spec()
    spec["actuators"]["right"] = {**RIGHT, **right}
    with pytest.raises(SpecError, match=re.escape(message)):
        load_several(spec)


def test_a_tube_that_leads_elsewhere_stands_beside_the_actuators() -> None:
    own = [
        {"from": "inlet", "to": "R1", "length": 0.1, "radius": 1e-3},
        {"from": "R1", "to": "right.R1", "length": 0.1, "radius": 1e-3},
    ]
    spec = on_one_syringe()
    spec["actuators"]["left"]["network"] = {"layout": "custom", "tubes": own}
    with pytest.raises(SpecError, match="stands under the 'tubes' of the whole spec"):
        load_several(spec)


def test_numbers_of_a_joined_scene_are_the_largest_of_any() -> None:
    from viscodesign.estimate.joined_quantities import quantities_of

    spec = coupled_spec()
    spec["actuators"]["right"] = {**RIGHT, "loads": {"payload": "30 g"}}
    (joined,) = load_several(spec).joined
    found = quantities_of(joined)
    each = [quantities_of(own) for own in joined.members.values()]
    assert found.weight == max(own.weight for own in each)
    assert found.bending_force == min(own.bending_force for own in each)
    assert found.requested_m == pytest.approx(0.005 * 0.022)
    turns = found.bellows.curvature_per_pressure * np.array([0.02, 0.02, 0.022] * 2)
    assert found.largest_turn == pytest.approx(found.pressure_range * np.abs(turns).max())
