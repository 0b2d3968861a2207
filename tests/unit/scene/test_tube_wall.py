"""`network.tube_wall`, `network.feed_line` and losses at the ends of tubes."""

from __future__ import annotations

import pytest

from tests.scenes import leg
from tests.unit.scene.round_trip import comes_back
from viscodesign.errors import SpecError

LINE = "network.feed_line={length: 1 m, radius: 2 mm}"
WALL = "network.tube_wall={youngs_modulus: 2 MPa, thickness: 0.5 mm}"
TWO = "inputs={a: {kind: constant, value: 1}, b: {kind: constant, value: 2}}"


def custom(tubes: str, *more: str) -> str:
    rest = "".join(f", {words}" for words in more)
    return (
        f"network={{layout: custom, tube_radius: 1 mm, tube_length: 3 cm, tubes: [{tubes}]{rest}}}"
    )


def test_a_feed_line_joins_the_inlet_and_the_network() -> None:
    graph = leg("bellows.count=4", LINE).graph
    assert [t.name for t in graph.tubes] == ["inlet-feed", "inlet-R1", "R1-R2", "R2-L2", "L2-L1"]
    line, first = graph.tubes[:2]
    assert (line.start, line.end, line.length, line.radius) == ("inlet", "feed", 1.0, 2e-3)
    assert (first.start, first.end, first.length) == ("feed", "R1", 0.0375)
    assert graph.junctions == ("feed",)
    assert graph.bellows == leg("bellows.count=4").graph.bellows


def test_a_feed_line_leaves_parts_without_inlet_unchanged() -> None:
    plain, fed = (leg("bellows.count=4", *more).graph for more in ((), (LINE,)))
    assert fed.tubes[2:] == plain.tubes[1:]
    assert len(fed.components()) == 1
    assert fed.components()[0].fed


def test_every_inlet_has_its_own_feed_line() -> None:
    tubes = "{from: a, to: R1}, {from: R1, to: L1}, {from: L1, to: b}, {from: a, to: T}, {from: T, to: L1}"
    graph = leg(
        "bellows.count=2", "input=null", TWO,
        custom(tubes, "feed_line: {length: 1 m, radius: 2 mm}"),
    ).graph  # fmt: skip
    assert graph.junctions == ("feed_a", "feed_b", "T")
    assert [(t.name, t.start, t.end) for t in graph.tubes] == [
        ("a-feed_a", "a", "feed_a"), ("b-feed_b", "b", "feed_b"),
        ("a-R1", "feed_a", "R1"), ("R1-L1", "R1", "L1"), ("L1-b", "L1", "feed_b"),
        ("a-T", "feed_a", "T"), ("T-L1", "T", "L1"),
    ]  # fmt: skip


@pytest.mark.parametrize("clash", ["feed_a", "feed_b"])
def test_a_node_with_the_name_of_a_feed_line_is_refused(clash: str) -> None:
    tubes = f"{{from: a, to: {clash}}}, {{from: {clash}, to: R1}}, {{from: b, to: L1}}"
    with pytest.raises(SpecError) as caught:
        leg("bellows.count=2", "input=null", TWO,
            custom(tubes, "feed_line: {length: 1 m, radius: 2 mm}"))  # fmt: skip
    (fault,) = caught.value.faults
    assert fault.key == "network.feed_line"
    assert fault.message == f"the network already has a node named '{clash}'; rename it"


def test_a_single_feed_line_has_a_shorter_name() -> None:
    tubes = "{from: inlet, to: feed_inlet}, {from: feed_inlet, to: R1}, {from: feed_inlet, to: L1}"
    graph = leg("bellows.count=2", custom(tubes, "feed_line: {length: 1 m, radius: 2 mm}")).graph
    assert graph.junctions == ("feed", "feed_inlet")
    with pytest.raises(SpecError, match="already has a node named 'feed'"):
        leg("bellows.count=2", custom(tubes.replace("feed_inlet", "feed"),
                                      "feed_line: {length: 1 m, radius: 2 mm}"))  # fmt: skip


def test_changes_still_name_the_tubes_of_the_chain() -> None:
    graph = leg("bellows.count=4", LINE, "network.changes={inlet-R1: {length: 2 m}}").graph
    assert {t.name: t.length for t in graph.tubes}["inlet-R1"] == 2.0


def test_defaults() -> None:
    network = leg(WALL).network
    assert network.tube_wall is not None
    assert network.tube_wall.poissons_ratio == 0.5
    assert (network.entrance_loss, network.exit_loss) == (0.5, 1.0)
    assert leg().network.tube_wall is None
    assert leg().network.feed_line is None


@pytest.mark.parametrize(
    ("override", "words"),
    [
        ("network.tube_wall={youngs_modulus: 2 MPa}", "network.tube_wall.thickness: missing"),
        ("network.tube_wall={youngs_modulus: 0, thickness: 1 mm}", "network.tube_wall.youngs_modulus"),
        ("network.tube_wall={youngs_modulus: 2 MPa, thickness: 0}", "network.tube_wall.thickness"),
        ("network.tube_wall={youngs_modulus: 2 MPa, thickness: 1 mm, poissons_ratio: 0.6}", "network.tube_wall.poissons_ratio"),
        ("network.tube_wall={youngs_modulus: 2 MPa, thicknes: 1 mm}", "did you mean 'thickness'"),
        ("network.feed_line={length: 1 m}", "network.feed_line.radius: missing"),
        ("network.feed_line={length: -1 m, radius: 1 mm}", "network.feed_line.length"),
        ("network.entrance_loss=-0.1", "network.entrance_loss"),
        ("network.exit_loss=11", "network.exit_loss"),
    ],
)  # fmt: skip
def test_faults(override: str, words: str) -> None:
    with pytest.raises(SpecError) as caught:
        leg(override)
    assert words in str(caught.value)


@pytest.mark.parametrize(
    "overrides",
    [
        (LINE,),
        (WALL, "network.tube_wall.poissons_ratio=0.3"),
        (LINE, WALL, "network.entrance_loss=0", "network.exit_loss=2.5"),
    ],
)
def test_feed_line_and_tube_wall_survive_a_round_trip(overrides: tuple[str, ...]) -> None:
    text = comes_back(leg(*overrides))
    assert ("feed_line:" in text) == (LINE in overrides)
    assert ("tube_wall:" in text) == (WALL in overrides)
