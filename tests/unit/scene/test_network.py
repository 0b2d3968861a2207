"""Layouts, and what a custom list of tubes makes."""

from __future__ import annotations

import pytest

from tests.scenes import leg
from viscodesign.errors import SpecError
from viscodesign.model.graph import Graph


def chain(*overrides: str) -> list[str]:
    return [tube.name for tube in leg(*overrides).graph.tubes]


def custom(tubes: str, *overrides: str) -> Graph:
    network = f"{{layout: custom, tube_radius: 1 mm, tube_length: 3 cm, tubes: [{tubes}]}}"
    return leg(f"network={network}", *overrides).graph


def test_straight_layout_runs_down_the_right_and_up_the_left() -> None:
    assert chain("bellows.count=4") == ["inlet-R1", "R1-R2", "R2-L2", "L2-L1"]


def test_crossed_layout_swaps_the_columns_at_mid_length() -> None:
    assert chain("bellows.count=8", "network.layout=crossed") == [
        "inlet-R1", "R1-R2", "R2-L3", "L3-L4", "L4-R4", "R4-R3", "R3-L2", "L2-L1",
    ]  # fmt: skip


def test_bellows_are_listed_right_then_left() -> None:
    graph = leg("bellows.count=4").graph
    assert graph.bellows == ("R1", "R2", "L1", "L2")
    assert graph.nodes == ("inlet", "R1", "R2", "L1", "L2")
    assert graph.bellows_along_tubes() == ("R1", "R2", "L2", "L1")


def test_changes_name_their_tube_in_either_direction() -> None:
    tubes = leg("network.changes={R2-R1: {length: 1 m}, L2-L1: {radius: 1 mm}}").graph.tubes
    by_name = {tube.name: tube for tube in tubes}
    assert (by_name["R1-R2"].length, by_name["R1-R2"].radius) == (1.0, 0.000325)
    assert (by_name["L2-L1"].length, by_name["L2-L1"].radius) == (0.0375, 0.001)
    assert by_name["R2-R3"].length == 0.0375


def test_the_inlet_of_a_chain_has_the_name_of_its_input() -> None:
    assert chain("input=null", "inputs={left: {kind: constant, value: 1}}")[0] == "left-R1"


def test_components_distinguish_fed_from_sealed() -> None:
    tubes = "{from: inlet, to: T}, {from: T, to: R1}, {from: R2, to: L2}, {from: T, to: end}"
    parts = custom(tubes, "bellows.count=4").components()
    fed = {part.bellows: part.fed for part in parts}
    assert fed == {("R1",): True, ("R2", "L2"): False, ("L1",): False}
    assert parts[0].junctions == ("T", "end")
    assert [tube.name for tube in parts[0].tubes] == ["inlet-T", "T-R1", "T-end"]


def test_remarks_report_unusual_networks() -> None:
    tubes = "{from: inlet, to: R1}, {from: inlet, to: R1}, {from: R1, to: inlet}, {from: R1, to: T}"
    graph = custom(tubes, "bellows.count=2")
    assert [tube.name for tube in graph.tubes] == ["inlet-R1", "inlet-R1#2", "R1-inlet", "R1-T"]
    remarks = " ".join(graph.remarks())
    assert "3 parallel tubes join R1 and inlet" in remarks
    assert "junction T joins only one tube" in remarks
    assert "L1 has no tube" in remarks


def test_loops_and_several_inlets_are_legal() -> None:
    tubes = "{from: a, to: R1}, {from: R1, to: L1}, {from: L1, to: a}, {from: b, to: L1}"
    graph = custom(
        tubes,
        "bellows.count=2",
        "input=null",
        "inputs={a: {kind: constant, value: 1}, b: {kind: constant, value: 2}}",
    )
    assert graph.inlets == ("a", "b")
    assert len(graph.components()) == 1


def test_a_tree_of_4096_bellows_is_built() -> None:
    names = [f"{side}{j}" for side in "RL" for j in range(1, 2049)]
    parts = custom(
        ", ".join(f"{{from: inlet, to: {name}}}" for name in names), "bellows.count=4096"
    ).components()
    assert len(parts) == 1
    assert len(parts[0].tubes) == 4096


def test_a_bellow_of_another_actuator_is_no_junction() -> None:
    with pytest.raises(SpecError, match=r"'right\.R1' is a bellow of another actuator.*'R1'\?"):
        custom("{from: inlet, to: right.R1}")
    assert custom("{from: inlet, to: tee.a}, {from: tee.a, to: R1}").junctions == ("tee.a",)
