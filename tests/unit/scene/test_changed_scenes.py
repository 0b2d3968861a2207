"""A changed scene is a new one, checked like a loaded one; a scene's plain data give it back."""

from __future__ import annotations

import copy
import json
import math
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.scenes import ACTUATOR_SPECS, CONFIGS, leg
from viscodesign import Scene, load
from viscodesign.errors import SpecError, UsageError
from viscodesign.scene.inputs.table import TableInput
from viscodesign.scene.spec_part import SpecPart

Change = Callable[[Scene, float], Scene]


def by_nested_copies(scene: Scene, length: float) -> Scene:
    return scene.model_copy(update={"network": scene.network.model_copy(update={"tube_length": length})})  # fmt: skip


def by_a_copy_with_plain_data(scene: Scene, length: float) -> Scene:
    network = {**scene.network.model_dump(), "tube_length": length}
    return scene.model_copy(update={"network": network})


def by_replace(scene: Scene, length: float) -> Scene:
    return scene.replace({"network.tube_length": length})


def by_old_copies(scene: Scene, length: float) -> Scene:
    return scene.copy(update={"network": scene.network.copy(update={"tube_length": length})})


def by_its_plain_data(scene: Scene, length: float) -> Scene:
    return load(scene.model_dump(), {"network.tube_length": length})


CHANGES = [
    by_nested_copies,
    by_a_copy_with_plain_data,
    by_replace,
    by_old_copies,
    by_its_plain_data,
]


@pytest.mark.parametrize("change", CHANGES)
def test_what_follows_from_a_value_changes_with_it(change: Change) -> None:
    scene = leg()
    assert scene.graph.tubes[0].length != 0.2
    assert scene.digest
    changed = change(scene, 0.2)
    assert {tube.length for tube in changed.graph.tubes} == {0.2}
    assert changed.digest == leg("network.tube_length=0.2").digest
    assert scene.network.tube_length != 0.2


@pytest.mark.parametrize("change", CHANGES)
def test_a_value_that_is_not_allowed_is_refused(change: Change) -> None:
    with pytest.raises(SpecError, match=r"tube_length: .*(0 m; got -1|greater than 0)"):
        change(leg(), -1.0)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"bellows.count": 7}, "bellows.count: 7 is odd"),
        ({"bellow.count": 8}, "bellow: no such key; did you mean 'bellows'?"),
        ({"network.layout": "custom"}, "network.tubes: missing; a custom layout needs a list"),
        ({"effects.grvity": "on"}, "no such effect; did you mean 'gravity'?"),
        ({"input": {"kind": "sine"}}, "input.frequency: missing"),
        ({"run.start": "periodic"}, "'periodic' needs inputs that repeat"),
        ({"network.tube_length": "20 g"}, "'20 g' is a mass"),
    ],
)
def test_faults_of_a_changed_scene_are_those_of_a_loaded_one(
    changes: dict[str, Any], words: str
) -> None:
    with pytest.raises(SpecError) as caught:
        leg().replace(changes)
    assert words in str(caught.value)


@pytest.mark.parametrize(
    ("part", "update", "words"),
    [
        ("network", {"tube_lenght": 0.2}, "tube_lenght: no such key; did you mean 'tube_length'?"),
        ("bellows", {"count": 7}, "count: 7 is odd"),
        ("run", {"output_interval": 1e3}, "output_interval: must be at most the duration"),
        ("effects", {"others": "perhaps"}, "others: must be one of auto, on, off"),
        ("loads", {"payload": "20 s"}, "payload: '20 s' is a time"),
        ("fluid_choice", {"density": None}, "density: missing; a custom fluid needs both"),
        ("input", {"drop": float("inf")}, "drop: inf is not finite"),
    ],
)
def test_a_part_alone_is_checked_likewise(part: str, update: dict[str, Any], words: str) -> None:
    with pytest.raises(SpecError) as caught:
        getattr(leg(), part).model_copy(update=update)
    assert words in str(caught.value)


def test_a_scene_takes_its_fields_by_either_name() -> None:
    for key in ("fluid_choice", "fluid"):
        assert leg().model_copy(update={key: "water"}).fluid.name == "water"


def test_a_replaced_scene_keeps_where_it_came_from() -> None:
    scene = leg()
    assert scene.replace({"run.duration": 2}).source == scene.source
    assert scene.replace({}).digest == scene.digest


def test_an_input_by_table_takes_the_place_of_its_file() -> None:
    driven = load(CONFIGS / "leg_16_straight_air.yaml", {"input": {"kind": "table", "rows": [[0, 0], [1, 1e3]]}})  # fmt: skip
    longer = driven.replace({"input.rows": [[0, 0], [2, 1e3]]})
    assert longer.input.rows[-1] == (2.0, 1e3)


@pytest.mark.parametrize("config", [path.stem for path in ACTUATOR_SPECS])
def test_plain_data_give_the_scene_back(config: str) -> None:
    scene = leg(config=config)
    for data in (scene.model_dump(), json.loads(scene.model_dump_json())):
        assert load(data).digest == scene.digest
        assert Scene.model_validate(data).digest == scene.digest


def test_every_part_of_a_scene_comes_back_from_its_plain_data() -> None:
    scene = leg(config="antagonistic_two_inlets")
    parts = [
        value for name in Scene.model_fields if isinstance(value := getattr(scene, name), SpecPart)
    ]
    assert len(parts) >= 6
    for part in parts:
        assert type(part).model_validate(part.model_dump()) == part


@pytest.mark.parametrize(
    "again", [copy.copy, copy.deepcopy, lambda s: pickle.loads(pickle.dumps(s)), Scene.model_copy]
)
def test_a_plain_copy_is_equal(again: Callable[[Scene], Scene]) -> None:
    scene = leg()
    assert scene.graph
    assert again(scene) == scene
    assert again(scene).digest == scene.digest


def test_a_scene_cannot_be_changed_in_place() -> None:
    scene = leg()
    with pytest.raises(UsageError, match=r"scene\.replace\(\{'accuracy': 0\.1\}\)"):
        scene.accuracy = 0.1
    with pytest.raises(AttributeError, match=r"\{'SECTION\.tube_length': 0\.2\}"):
        scene.network.tube_length = 0.2
    with pytest.raises(UsageError, match="no such key; did you mean 'accuracy'"):
        scene.acuracy = 0.1  # type: ignore[attr-defined]
    with pytest.raises(UsageError, match="replaced"):
        del scene.accuracy
    assert scene == leg()


def test_equal_scenes_are_one_key_of_a_dictionary() -> None:
    other = leg().replace({"accuracy": 0.01})
    assert len({leg(): 1, leg(): 2, other: 3}) == 2


@pytest.mark.parametrize(
    "given", [[("accuracy", 0.01)], 5, [None]], ids=["pairs", "a number", "nothing"]
)
def test_overrides_that_are_neither_texts_nor_a_mapping_are_refused(given: Any) -> None:
    with pytest.raises(SpecError, match=r"overrides: must have the form key\.path=value; got"):
        leg().replace(given)


def test_a_scene_is_shown_in_one_short_line() -> None:
    for scene in (leg(), leg(config="antagonistic_two_inlets")):
        assert len(repr(scene)) < 120
        assert scene.name in repr(scene)
        assert str(scene) == repr(scene)


ROWS = "rows: [[0 s, 0 mm], [1 s, 2 mm]]"
SYRINGE = f"input={{kind: syringe, diameter: 20 mm, start: 50 mm, {ROWS}}}"


@pytest.fixture
def table(tmp_path: Path) -> Path:
    file = tmp_path / "table.csv"
    file.write_text("time_s,pressure_pa\n0,0\n1,10000\n2,0\n")
    return file


@pytest.mark.parametrize("was", ["rows: [[0, 0], [1, 5]]", "file: {}"])
def test_another_file_takes_the_place_of_rows(was: str, table: Path) -> None:
    """A loaded scene lists its rows, whatever file they came from."""
    scene = leg(f"input={{kind: table, {was.format(table)}}}")
    found = scene.replace({"input.file": str(table)}).inputs["inlet"]
    assert isinstance(found, TableInput)
    assert found.rows == ((0.0, 0.0), (1.0, 1e4), (2.0, 0.0))
    assert found.measured is not None
    assert found.measured.file == str(table)


def test_rows_take_the_place_of_a_file_and_of_what_was_read_from_it(table: Path) -> None:
    scene = leg(f"input={{kind: table, file: {table}}}")
    found = scene.replace({"input.rows": [[0, 0], [1, 5.0]]}).inputs["inlet"]
    assert isinstance(found, TableInput)
    assert found.rows == ((0.0, 0.0), (1.0, 5.0))
    assert found.measured is None


def test_speeds_take_the_place_of_positions() -> None:
    found = leg(SYRINGE).replace({"input.speeds": [["0 s", "1 mm/s"], ["1 s", "0 mm/s"]]})
    assert found.inputs["inlet"].profile()[-1][1] == pytest.approx(1e-3 * 1e-4 * math.pi)


def test_a_spec_that_gives_both_is_still_refused(table: Path) -> None:
    with pytest.raises(SpecError, match="exactly one of 'file' and 'rows'"):
        leg(f"input={{kind: table, file: {table}, rows: [[0, 0], [1, 5]]}}")
