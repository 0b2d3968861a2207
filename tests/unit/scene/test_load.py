"""Broken specs: one clear message for every fault, with file, line and key."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.scenes import CONFIGS, leg
from viscodesign import load
from viscodesign.errors import SpecError
from viscodesign.scene.dump import resolved_yaml

GOOD = (CONFIGS / "leg_16_straight_air.yaml").read_text()


def faults_of(tmp_path: Path, text: str | bytes) -> str:
    file = tmp_path / "leg.yaml"
    file.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(SpecError) as caught:
        load(file)
    message = str(caught.value)
    assert "Traceback" not in message
    assert "leg.yaml" in message
    assert "pydantic" not in message.lower()
    return message


def changed(old: str, new: str) -> str:
    assert GOOD.count(old) >= 1, old
    return GOOD.replace(old, new, 1)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "is empty"),
        ("   \n\n", "is empty"),
        (b"\x00\x01\x02\xff\xfe binary", "not a text in UTF-8"),
        (b"\x89PNG\r\n\x1a\n", "not a text in UTF-8"),
        ("- a\n- list\n", "is a list"),
        ("just a word", "is a single value"),
        ("a: 1\n---\nb: 2\n", "2 documents"),
        ("a: [1, 2\n", "not YAML"),
        ("a: &x [*x]\n", "nested too deeply"),
        ("!!python/object/apply:os.system ['true']\n", "is a list"),
        ("name: !!python/name:os.system\n", "the tag"),
        ("x: " + "[" * 60 + "]" * 60, "nested too deeply"),
        ("a: &a [x,x,x,x,x,x,x,x,x]\n"
         "b: &b [*a,*a,*a,*a,*a,*a,*a,*a,*a]\nc: &c [*b,*b,*b,*b,*b,*b,*b,*b,*b]\n"
         "d: &d [*c,*c,*c,*c,*c,*c,*c,*c,*c]\ne: &e [*d,*d,*d,*d,*d,*d,*d,*d,*d]\n"
         "f: [*e,*e,*e,*e,*e,*e,*e,*e,*e]\n", "aliases"),
    ],
)  # fmt: skip
def test_what_is_no_spec(tmp_path: Path, text: str | bytes, words: str) -> None:
    assert words in faults_of(tmp_path, text)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("  count: 16 ", "  count: 15 ", ["bellows.count", "15 is odd", "Use 14 or 16"]),
        ("  count: 16 ", "  count: 0 ", ["bellows.count", "even counts from 2"]),
        ("  count: 16 ", "  count: 16.5 ", ["bellows.count", "whole number"]),
        ("  count: 16 ", "  cout: 16 ", ["bellows.cout", "did you mean 'count'", "bellows.count: missing"]),
        ("  length: 109 mm", "  length: -109 mm", ["actuator.length", "above 0"]),
        ("  length: 109 mm", "  length: 0", ["actuator.length", "above 0"]),
        ("  length: 109 mm", "  length: 109 g", ["actuator.length", "a mass", "a length is wanted"]),
        ("  length: 109 mm", "  length: .nan", ["actuator.length", "length is wanted"]),
        ("  length: 109 mm", "  length: 1e999", ["actuator.length", "not finite"]),
        ("  length: 109 mm", "  length: 109 furlongz", ["no unit is called 'furlongz'"]),
        ("  length: 109 mm", "  length: [1, 2]", ["actuator.length", "a list is not a number"]),
        ("  length: 109 mm", "  length: mm", ["actuator.length", "has no number"]),
        ("  length: 109 mm", "  length:", ["actuator.length", "nothing is not a number"]),
        ("  youngs_modulus: 1.8 MPa", "", ["actuator.youngs_modulus: missing", "'40 kPa'"]),
        ("  layout: straight ", "  layout: strait ", ["allowed are straight, crossed, custom", "did you mean 'straight'"]),
        ("  layout: straight ", "  layout: crossed\n  changes: {R1-R9: {length: 1 mm}} ", ["R1-R9", "no such tube"]),
        ("  kind: double_sigmoid", "  kind: doubel_sigmoid", ["did you mean 'double_sigmoid'"]),
        ("  kind: double_sigmoid", "  kind: syringe", ["not in this version"]),
        ("  kind: double_sigmoid", "  sort: double_sigmoid", ["input", "the key 'kind'"]),
        ("  duration: 8 s", "  duration: 0 s", ["run.duration", "above 0"]),
        ("  output_interval: 20 ms", "  output_interval: 20 s", ["run.output_interval", "longer than the duration"]),
        ("  output_interval: 20 ms", "  output_interval: 1 ns", ["run.output_interval", "outputs"]),
        ("  output_interval: 20 ms", "  output_times: [1, 0.5]", ["output_times", "must ascend"]),
        ("  output_interval: 20 ms", "  output_times: [1, 9]", ["output_times", "from 0 to the duration"]),
        ("  start: equilibrium", "  start: equlibrium", ["did you mean 'equilibrium'"]),
        ("  others: off", "  others: maybe", ["effects.others", "auto, on and off"]),
        ("  others: off", "  gas_compresibility: off", ["no such effect", "did you mean 'gas_compressibility'"]),
        ("  others: off", "  collapse: on", ["effects.collapse", "only leave it off"]),
        ("accuracy: 0.5 %", "accuracy: 0 %", ["accuracy", "at least"]),
        ("accuracy: 0.5 %", "accuracy: 0.5 %\naccuracy: 1 %", ["accuracy", "stands twice"]),
        ("accuracy: 0.5 %", "acuracy: 0.5 %", ["acuracy", "did you mean 'accuracy'"]),
        ("  gravity: off", "  gravity: sideways", ["loads.gravity", "off, on or a mapping"]),
        ("  gravity: off", "  gravity: {tilt: 3 m}", ["loads.gravity.tilt", "angle is wanted"]),
        ("temperature: 15 degC", "temperature: -300 degC", ["temperature", "above 0"]),
        ("input:", "inputs: {left: {kind: constant, value: 1}}\ninput:", ["input", "one of them"]),
    ],
)  # fmt: skip
def test_single_faults(tmp_path: Path, old: str, new: str, words: list[str]) -> None:
    message = faults_of(tmp_path, changed(old, new))
    for word in words:
        assert word in message
    first = message.splitlines()[0]
    assert first.split(":")[-1]
    assert "leg.yaml:" in first  # with a line


def test_all_faults_are_told_at_once_in_the_order_of_lines(tmp_path: Path) -> None:
    text = changed("  length: 109 mm", "  length: 109 kg")
    text = text.replace("  count: 16 ", "  count: 15 ").replace("accuracy: 0.5 %", "accuracy: 2 m")
    message = faults_of(tmp_path, text)
    lines = message.splitlines()
    assert len(lines) == 3
    numbers = [int(line.split("leg.yaml:")[1].split(":")[0]) for line in lines]
    assert numbers == sorted(numbers)
    assert text.splitlines()[numbers[1] - 1].strip().startswith("count")


CUSTOM = "network: {{layout: custom, tube_radius: 1 mm, tube_length: 3 cm, tubes: [{}]}}"


@pytest.mark.parametrize(
    ("tubes", "words"),
    [
        ("{from: inlet, to: R1}, {from: R1, to: R9}", "the actuator has 8 sections"),
        ("{from: inlet, to: r1}", "did you mean 'R1'"),
        ("{from: inlet, to: inlet}", "to itself"),
        ("{from: R1, to: R2}", "no tube leads from the inlet"),
        ("{from: inlet, to: R1}, {from: inlet2, to: R2}", "unknown node 'inlet2'"),
        ("{from: inlet, to: R1}, {from: a, to: b}", "only junctions"),
        ("{from: inlet, to: R1, length: -1 mm}", "above 0"),
        ("{from: inlet, to: 'no good'}, {from: 'no good', to: R1}", "no name for a node"),
        ("{from: inlet}", "missing"),
    ],
)
def test_graph_faults_are_named(tubes: str, words: str) -> None:
    with pytest.raises(SpecError, match=words.replace("'", ".")):
        leg(CUSTOM.format(tubes).replace("network: ", "network=", 1))


def test_chain_with_several_inlets_is_refused_by_name() -> None:
    with pytest.raises(SpecError, match="straight chain has one inlet"):
        leg("input=null", "inputs={a: {kind: constant, value: 1}, b: {kind: constant, value: 1}}")


@pytest.mark.parametrize(
    ("table", "words"),
    [
        ("time_s,pressure_pa\n0,0\n1,\n", "line 3: pressure_pa is empty"),
        ("time_s,pressure_pa\n0,0\n1,high\n", "'high', not a number"),
        ("time_s,pressure_pa\n0,0\n2,5\n1,5\n", "time runs back from 2 s to 1 s"),
        ("time_s,pressure_pa\n0,0\n", "at least two"),
        ("t,p\n0,0\n1,1\n", "'time_s,pressure_pa' is wanted"),
        ("time_s,pressure_pa\n0,nan\n1,1\n", "not finite"),
        ("time_s,pressure_pa\n-1,0\n1,1\n", "before the start"),
        ("time_s,pressure_pa\n0,0,0\n1,1\n", "3 values"),
        ("", "is wanted"),
    ],
)
def test_broken_tables_name_the_row(tmp_path: Path, table: str, words: str) -> None:
    (tmp_path / "in.csv").write_text(table)
    file = tmp_path / "leg.yaml"
    start, end = GOOD.index("input:"), GOOD.index("loads:")
    file.write_text(GOOD[:start] + "input: {kind: table, file: in.csv}\n" + GOOD[end:])
    with pytest.raises(SpecError) as caught:
        load(file)
    assert words in str(caught.value)
    assert "leg.yaml:" in str(caught.value)


def test_missing_files_say_so(tmp_path: Path) -> None:
    with pytest.raises(SpecError, match="No such file"):
        load(tmp_path / "nothing.yaml")
    with pytest.raises(SpecError, match="is a folder"):
        load(tmp_path)
    with pytest.raises(SpecError, match=r"in\.csv cannot be read"):
        leg("input={kind: table, file: in.csv}")


@pytest.mark.parametrize(
    ("override", "words"),
    [
        ("bellows.cout=4", "--set bellows.cout=4"),
        ("bellows.count", "key.path=value"),
        ("bellows.count=15", "--set bellows.count=15: bellows.count: 15 is odd"),
        ("run.duration=[", "not YAML"),
        ("input.drop=3 mm", "--set input.drop=3 mm"),
    ],
)
def test_overrides_name_themselves(override: str, words: str) -> None:
    with pytest.raises(SpecError) as caught:
        leg(override)
    assert words in str(caught.value)


def test_overrides_reach_into_words_and_lists() -> None:
    assert leg("loads.gravity.tilt=90 deg").loads.gravity is not None
    changed_tube = leg("network.tubes.0.length=1 m", config="antagonistic_two_inlets")
    assert changed_tube.graph.tubes[0].length == 1.0
    assert leg("inputs.left.frequency=2 Hz", config="antagonistic_two_inlets").inputs["left"]


@pytest.mark.parametrize("config", sorted(p.stem for p in CONFIGS.glob("*.yaml")))
def test_a_resolved_spec_is_the_same_scene(config: str, tmp_path: Path) -> None:
    scene = load(CONFIGS / f"{config}.yaml")
    file = tmp_path / "spec.yaml"
    file.write_text(resolved_yaml(scene))
    assert load(file).model_dump() == scene.model_dump()


def test_a_table_resolves_into_rows(tmp_path: Path) -> None:
    (tmp_path / "in.csv").write_text("time_s,pressure_pa\n0,0\n1,1e3\n1,2e3\n4,0\n")
    file = tmp_path / "leg.yaml"
    start, end = GOOD.index("input:"), GOOD.index("loads:")
    file.write_text(GOOD[:start] + "input: {kind: table, file: in.csv}\n" + GOOD[end:])
    scene = load(file)
    other = tmp_path / "elsewhere.yaml"
    other.write_text(resolved_yaml(scene))
    assert "in.csv" not in other.read_text()
    assert load(other).model_dump() == scene.model_dump()
