"""A spec is read from wherever it is, with overrides in any form, and all give the same scene."""

from __future__ import annotations

import io
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml

from tests.scenes import CONFIGS, leg
from viscodesign import Scene, check, classify, load, simulate
from viscodesign.errors import SpecError, ViscodesignError

FILE = CONFIGS / "leg_16_straight_air.yaml"
TEXT = FILE.read_text(encoding="utf-8")
KEYS: dict[str, Any] = yaml.safe_load(TEXT)
TABLE = "input: {kind: table, file: pulse.csv}"


def with_key(section: str, key: str, value: Any) -> dict[str, Any]:
    """The spec as a mapping with one more value."""
    return {**KEYS, section: {**KEYS[section], key: value}}


@pytest.mark.parametrize(
    "source",
    [
        str(FILE),
        TEXT,
        TEXT.encode(),
        json.dumps(KEYS),
        io.StringIO(TEXT),
        io.BytesIO(TEXT.encode()),
        KEYS,
        leg().model_dump(),
    ],
    ids=["path", "text", "bytes", "braces", "open text", "open bytes", "mapping", "dump"],
)
def test_every_source_gives_the_same_scene(source: Any) -> None:
    assert load(source).digest == load(FILE).digest


def test_an_open_file_brings_its_name_and_its_folder(tmp_path: Path) -> None:
    (tmp_path / "pulse.csv").write_text("time_s,pressure_pa\n0,0\n1,1000\n")
    start, end = TEXT.index("\ninput:") + 1, TEXT.index("\nrun:") + 1
    file = tmp_path / "leg.yaml"
    file.write_text(f"{TEXT[:start]}{TABLE}\n{TEXT[end:]}")
    with file.open() as opened:
        scene = load(opened)
    assert scene == load(file)
    assert scene.source == load(file).source


def test_a_spec_without_a_file_says_that_of_its_source() -> None:
    by_keys = load(KEYS)
    assert by_keys.source.file == load(TEXT).source.file == ""
    assert load(TEXT).source.sha256 == load(FILE).source.sha256
    assert by_keys.source.sha256 == load(leg().model_dump()).source.sha256
    assert by_keys.source.sha256 != load(KEYS, {"run.duration": 1.0}).source.sha256


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (np.float64(0.2), 0.2),
        (np.array(0.2), 0.2),
        ("20 cm", 0.2),
        (0.2, 0.2),
        (1, 1.0),
    ],
)
def test_numbers_of_a_mapping_are_SI_and_texts_have_units(value: Any, shown: float) -> None:  # noqa: N802
    assert load(with_key("network", "tube_length", value)).network.tube_length == shown


def test_arrays_tuples_and_parts_of_scenes_are_values() -> None:
    rows = np.array([[0.0, 0.0], [1.0, 1e3]])
    made = load({**KEYS, "input": {"kind": "table", "rows": rows}, "actuator": leg().actuator})
    assert made.input.rows == ((0.0, 0.0), (1.0, 1e3))
    assert made.actuator == leg().actuator


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ({}, "missing"),
        ({**KEYS, "bellow": 1}, "bellow: no such key; did you mean 'bellows'?"),
        (with_key("network", "tube_length", -1.0), "network.tube_length: must be above 0 m; got -1"),
        (with_key("network", "tube_length", [1]), "network.tube_length: a list is not a number"),
        (with_key("network", "tube_length", float("nan")), "network.tube_length: nan is not finite"),
        (with_key("network", "tube_length", object()), "network.tube_length: <object"),
        (with_key("network", True, 1), "network: a key must be a word; got on (or true)"),
        ({**KEYS, "effects": {"grvity": "on"}}, "effects.grvity: no such effect; did you mean"),
        (TEXT.replace("30 mm", "30 g", 1), "<text>:"),
        ("", "<text>: is empty"),
        (io.StringIO("- a\n"), "<text>:1: is a list"),
        (io.BytesIO(b"\xff\xfe\x00"), "not UTF-8 text"),
        (42, "expected a path, an open file, the text of a spec, or a mapping; got 42"),
        (None, "got nothing"),
        ("no_such_file.yaml", "no_such_file.yaml: No such file"),
    ],
)  # fmt: skip
def test_a_bad_source_is_told_in_words(source: Any, words: str) -> None:
    with pytest.raises(SpecError) as caught:
        load(source)
    assert words in str(caught.value)


def test_a_mapping_that_holds_itself_is_refused() -> None:
    keys = dict(KEYS)
    keys["network"] = keys
    with pytest.raises(SpecError, match="nested too deeply"):
        load(keys)


def test_a_closed_file_is_refused(tmp_path: Path) -> None:
    opened = FILE.open()
    opened.close()
    with pytest.raises(
        SpecError, match=r"leg_16_straight_air\.yaml: cannot be read: I/O operation"
    ):
        load(opened)


@pytest.mark.parametrize(
    "overrides",
    [
        {"network.tube_length": 0.2, "effects.gravity": "off"},
        {"network.tube_length": "20 cm", "effects.gravity": False},
        ["network.tube_length=20 cm", "effects.gravity=off"],
        ("network.tube_length=0.2", "effects.gravity=no"),
        {"network": {**KEYS["network"], "tube_length": 0.2}, "effects.gravity": "off"},
    ],
)
def test_overrides_are_a_mapping_or_texts(overrides: Any) -> None:
    one = load(FILE, overrides)
    assert one.network.tube_length == 0.2
    assert one.effects.mode("gravity") == "off"


def test_a_single_override_may_stand_alone() -> None:
    assert load(FILE, "run.duration=2 s").run.duration == 2.0


@pytest.mark.parametrize(
    ("overrides", "words"),
    [
        ({"network.tube_length": -1}, "overrides: network.tube_length: must be above 0 m; got -1"),
        ({"network.tube_lenght": 1}, "overrides: network.tube_lenght: no such key; did you mean"),
        ({"network..tube_length": 1}, "must have the form key.path=value"),
        ({"": 1}, "must have the form key.path=value"),
        ({"network.tubes.0.length": 1}, "network.tubes"),
        ({"effects.grvity": "on"}, "no such effect"),
    ],
)
def test_bad_overrides_are_told_by_key(overrides: Mapping[str, Any], words: str) -> None:
    with pytest.raises(SpecError) as caught:
        load(FILE, overrides)
    assert words in str(caught.value)


@pytest.mark.parametrize(
    "given", ["16", " +16 ", 16.0, np.int64(16), np.float64(16.0), np.array(16)]
)
@pytest.mark.parametrize("key", ["bellows.count", "run.shape_every"])
def test_an_integer_is_one_however_a_script_has_it(key: str, given: Any) -> None:
    assert load(FILE, {key: given}).digest == load(FILE, [f"{key}=16"]).digest


@pytest.mark.parametrize(
    "given", ["16.0", "1_6", "0x10", "sixteen", "", "٣", "9" * 5000, 16.5, 1e300, True, [16]]
)
@pytest.mark.parametrize("key", ["bellows.count", "run.max_steps", "run.shape_every"])
def test_what_is_no_integer_is_refused(key: str, given: Any) -> None:
    with pytest.raises(SpecError, match=rf"overrides: {key}: expected an integer, got "):
        load(FILE, {key: given})


def test_the_integers_of_a_pump_are_read_alike() -> None:
    texts = {"pump.home": "210", "pump.servo_id": "2", "pump.travel": ["100", 900.0]}
    pump = load(CONFIGS / "leg_16_pump.yaml", texts).pump
    assert pump.model_dump(include={"home", "servo_id", "travel"}) == {
        "home": 210,
        "servo_id": 2,
        "travel": (100, 900),
    }
    with pytest.raises(SpecError, match=r"home: expected an integer, got on"):
        load(CONFIGS / "leg_16_pump.yaml", {"pump.home": True})


def test_reading_a_mapping_leaves_it_as_it_was() -> None:
    before = json.dumps(KEYS)
    load(KEYS, {"network.tube_length": 0.2, "loads.payload": 0.02})
    assert json.dumps(KEYS) == before


def test_pydantic_reads_its_own_dump() -> None:
    scene = leg()
    assert Scene.model_validate(scene.model_dump()).digest == scene.digest


@pytest.mark.parametrize("use", [simulate, check, classify])
@pytest.mark.parametrize("given", ["leg.yaml", {"name": "leg"}, None])
def test_what_is_no_scene_is_refused_with_what_makes_one(use: Any, given: Any) -> None:
    with pytest.raises(
        ViscodesignError, match=r"expected a scene, such as load\('leg.yaml'\) returns"
    ):
        use(given)
