"""Keys of free numbers: what they stand for, and which are refused."""

from __future__ import annotations

import pytest

from tests.scenes import leg
from viscodesign.compiled.free_keys import FreeKeys, candidates
from viscodesign.errors import SpecError

TREE = (
    "network={layout: custom, tube_radius: 0.3 mm, tubes: ["
    "{from: inlet, to: J, length: 10 mm}, {from: J, to: R1, length: 20 mm, radius: 1 mm}, "
    "{from: J, to: R1, length: 30 mm}, {from: R1, to: R2, length: 4 mm}, "
    "{from: R2, to: L2, length: 5 mm}, {from: L2, to: L1, length: 6 mm}]}"
)
CHANGED = "network.changes={R2-R1: {length: 80 mm}}"
TABLE = "input={kind: table, rows: [[0, 1 kPa], [1, 2 kPa], [3, 0]]}"


def keys(*free: str, overrides: tuple[str, ...] = ()) -> FreeKeys:
    return FreeKeys(leg(*overrides, config="leg_4_air"), free)


def test_every_tube_of_a_layout_is_one_number() -> None:
    own = keys("network.tubes[*].length", overrides=(CHANGED,))
    assert own.names == tuple(
        f"network.tubes[{name}].length" for name in ("inlet-R1", "R1-R2", "R2-L2", "L2-L1")
    )
    assert own.values[1] == 0.08
    tubes = own.placed([0.1, 0.2, 0.3, 0.4]).graph.tubes
    assert [tube.length for tube in tubes] == [0.1, 0.2, 0.3, 0.4]
    assert own.scene.graph.tubes[0].length != 0.1  # what was derived is derived anew


@pytest.mark.parametrize(
    "key",
    [
        "network.tubes[R1-R2].length",
        "network.changes.R1-R2.length",
        "network.changes.R2-R1.length",
    ],
)
def test_a_changed_tube_has_one_place_whatever_its_key(key: str) -> None:
    own = keys(key, overrides=(CHANGED,))
    assert own.values.tolist() == [0.08]
    assert own.placed([0.01]).graph.tubes[1].length == 0.01


def test_tubes_of_a_custom_layout_are_known_by_name_or_position() -> None:
    own = keys(
        "network.tubes[J-R1#2].length",
        "network.tubes[J-R1].radius",
        "network.tubes.5.length",
        overrides=(TREE,),
    )
    assert own.values.tolist() == [0.03, 0.001, 0.006]
    tubes = own.placed([1.0, 2.0, 3.0]).graph.tubes
    assert (tubes[2].length, tubes[1].radius, tubes[5].length) == (1.0, 2.0, 3.0)


def test_feed_lines_have_their_own_key() -> None:
    line = "network.feed_line={length: 1 m, radius: 1 mm}"
    own = keys("network.tubes[*].radius", "network.feed_line.radius", overrides=(line,))
    assert len(own.names) == 5
    assert own.placed([1.0, 2.0, 3.0, 4.0, 5.0]).graph.tubes[0].radius == 5.0


def test_rows_of_a_table_are_known_by_number_and_column() -> None:
    own = keys("input.rows[1].pressure", "input.rows[2].time", "input.rows.0.1", overrides=(TABLE,))
    assert own.values.tolist() == [2e3, 3.0, 1e3]
    placed = own.placed([7.0, 8.0, 9.0]).input
    assert placed.rows == ((0.0, 9.0), (1.0, 7.0), (8.0, 0.0))


def test_every_candidate_but_those_without_derivatives_is_a_number() -> None:
    scene = leg(TABLE, TREE, "loads.gravity=on")
    found = candidates(scene)
    for key in ("loads.gravity.tilt", "input.rows[*].pressure", "network.tubes[*].radius"):
        assert key in found
    for key in found:
        assert FreeKeys(scene, [key]).names


@pytest.mark.parametrize(
    ("free", "message"),
    [
        (["network.tube_lenght"], "no such number.*did you mean 'network.tube_length'"),
        (["network.tubes[*]"], "no such number.*did you mean 'network.tubes"),
        (["network.tubes[R1-R3].length"], "no such tube; did you mean 'R1-R2'"),
        (["network.tubes[x].length"], "no such tube; the tubes are inlet-R1, R1-R2"),
        (["network.tubes[*].lenght"], "no such key; did you mean 'length'"),
        (["network..tube_length"], "no such number"),
        ([""], "a free key is empty"),
        (["input.rows[3].pressure"], "no such row; the rows are 0 to 2"),
        (["input.rows[1].presure"], "no such column; did you mean 'pressure'"),
        (["input.rows[1].x"], "no such column; the columns are time, pressure"),
        (["input.kind"], "not a number that may change by a little"),
        (["bellows.count"], "not a number that may change by a little"),
        (["bellows"], "not a number that may change by a little"),
        (["run.duration"], "run.duration: cannot be free: times of the run"),
        (["accuracy"], "accuracy: cannot be free"),
        (["input.transient_time"], "decides only which effects are included"),
        (["fluid.fraction"], "has no derivatives"),
        (["fluid.bulk_modulus"], "gives it no value to start from"),
        (["network.tube_wall.thickness"], "no such number"),
        (["loads.payload", "loads.payload"], "stands for the same number as loads.payload"),
        (["network.tubes[*].length", "network.tubes[R1-R2].length"], "stands for the same number"),
        (["network.tube_length", "network.tubes[*].length"], "overlaps with network.tube_length"),
        (["network.tubes[R1-R2].radius", "network.tube_radius"], "overlaps with network.tube_rad"),
        ([], "no key is free"),
    ],
)
def test_refusals_say_why(free: list[str], message: str) -> None:
    with pytest.raises(SpecError, match=message):
        keys(*free, overrides=(TABLE,))


def test_a_changed_tube_does_not_overlap_with_the_length_of_the_others() -> None:
    own = keys("network.tube_length", "network.tubes[R1-R2].length", overrides=(CHANGED,))
    tubes = own.placed([0.3, 0.4]).graph.tubes
    assert [tube.length for tube in tubes] == [0.3, 0.4, 0.3, 0.3]


@pytest.mark.parametrize("key", ["temperature", "ambient_pressure"])
def test_what_a_library_of_fluids_depends_on_is_refused(key: str) -> None:
    with pytest.raises(SpecError, match=f"{key}: cannot be free: the library that gives the prop"):
        keys(key, overrides=("fluid=water",))
