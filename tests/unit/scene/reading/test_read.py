"""Broken specs: one clear message for every fault, with file, line and key."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.scenes import CONFIGS, leg
from viscodesign import load
from viscodesign.errors import SpecError

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
        (b"\x00\x01\x02\xff\xfe binary", "not UTF-8 text"),
        (b"name: leg\n# B\xfcro\n", "leg.yaml:2: not UTF-8 text (byte 0xfc); expected a YAML file, saved"),
        (b"\xff\xfea", "not UTF-8 text"),
        (b"\x89PNG\r\n\x1a\n", "not UTF-8 text"),
        ("- a\n- list\n", "is a list"),
        ("just a word", "is a single value"),
        ("a: 1\n---\nb: 2\n", "2 documents"),
        ("a: [1, 2\n", "not YAML"),
        ("a: &x [*x]\n", "nested too deeply"),
        ("!!python/object/apply:os.system ['true']\n", "is a list"),
        ("name: !!python/name:os.system\n", "the tag"),
        ("x: " + "[" * 60 + "]" * 60, "nested too deeply"),
        ("x: " + "[" * 300_000, "nested too deeply"),  # overflows the stack of YAML's composer
        ("- " * 300_000, "nested too deeply"),
        ("# a comment alone\n", "is empty"),
        ("---\n", "is empty"),
        ("a: " + "x" * (4 << 20), "larger than 4 MiB"),
        ("a: &a [x,x,x,x,x,x,x,x,x]\n"
         "b: &b [*a,*a,*a,*a,*a,*a,*a,*a,*a]\nc: &c [*b,*b,*b,*b,*b,*b,*b,*b,*b]\n"
         "d: &d [*c,*c,*c,*c,*c,*c,*c,*c,*c]\ne: &e [*d,*d,*d,*d,*d,*d,*d,*d,*d]\n"
         "f: [*e,*e,*e,*e,*e,*e,*e,*e,*e]\n", "aliases"),
    ],
)  # fmt: skip
def test_files_that_are_not_specs(tmp_path: Path, text: str | bytes, words: str) -> None:
    assert words in faults_of(tmp_path, text)


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-be"])
def test_a_spec_is_read_as_any_editor_saves_it(tmp_path: Path, encoding: str, end: str) -> None:
    file = tmp_path / "leg.yaml"
    mark = "\ufeff" if encoding == "utf-16-be" else ""
    file.write_bytes((mark + GOOD + "# über\n").replace("\n", end).encode(encoding))
    assert load(file).digest == leg().digest


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("  count: 16 ", "  count: 15 ", ["bellows.count", "15 is odd", "Use 14 or 16"]),
        ("  count: 16 ", "  count: 0 ", ["bellows.count", "even number from 2"]),
        ("  count: 16 ", "  count: 16.5 ", ["bellows.count", "expected an integer, got 16.5"]),
        ("  count: 16 ", "  cout: 16 ", ["bellows.cout", "did you mean 'count'", "bellows.count: missing"]),
        ("  length: 109 mm", "  length: -109 mm", ["must be above 0 m; got '-109 mm'"]),
        ("  length: 109 mm", "  length: 0", ["actuator.length", "above 0"]),
        ("  length: 109 mm", "  length: 109 g", ["actuator.length", "a mass", "expected a length"]),
        ("  length: 109 mm", "  length: .nan", ["actuator.length", "expected a length"]),
        ("  length: 109 mm", "  length: 1e999", ["actuator.length", "not finite"]),
        ("  length: 109 mm", "  length: 109 furlongz", ["unknown unit 'furlongz'"]),
        ("  length: 109 mm", "  length: [1, 2]", ["actuator.length", "a list is not a number"]),
        ("  length: 109 mm", "  length: mm", ["actuator.length", "has no number"]),
        ("  length: 109 mm", "  length:", ["actuator.length", "nothing is not a number"]),
        ("  youngs_modulus: 1.8 MPa", "", ["actuator.youngs_modulus: missing", "'1.8 MPa'"]),
        ("  layout: straight ", "  layout: strait ", ["must be one of straight, crossed, custom; got 'strait'", "did you mean 'straight'"]),
        ("  layout: straight ", "  layout: crossed\n  changes: {R1-R9: {length: 1 mm}} ", ["R1-R9", "no such tube"]),
        ("  kind: double_sigmoid", "  kind: doubel_sigmoid", ["did you mean 'double_sigmoid'"]),
        ("  kind: double_sigmoid", "  kind: siringe", ["did you mean 'syringe'"]),
        ("  kind: double_sigmoid", "  sort: double_sigmoid", ["input", "the key 'kind'"]),
        ("  duration: 8 s", "  duration: 0 s", ["run.duration", "above 0"]),
        ("  output_interval: 20 ms", "  output_interval: 20 s", ["run.output_interval", "at most the duration"]),
        ("  output_interval: 20 ms", "  output_interval: 1 ns", ["run.output_interval", "outputs"]),
        ("  output_interval: 20 ms", "  output_times: [1, 0.5]", ["output_times", "must increase"]),
        ("  output_interval: 20 ms", "  output_times: [1, 9]", ["output_times", "from 0 to the duration"]),
        ("  start: equilibrium", "  start: equlibrium", ["did you mean 'equilibrium'"]),
        ("  others: off", "  others: maybe", ["effects.others", "one of auto, on, off"]),
        ("  others: off", "  gas_compresibility: off", ["no such effect", "did you mean 'gas_compressibility'"]),
        ("  others: off", "  colapse: on", ["no such effect", "did you mean 'collapse'"]),
        ("  inertia: on", "  inertia: atuo", ["effects.inertia", "one of auto, on, off", "did you mean 'auto'"]),
        ("accuracy: 0.5 %", "accuracy: 0 %", ["accuracy", "at least"]),
        ("accuracy: 0.5 %", "accuracy: 50", ["a percentage needs its sign"]),
        ("accuracy: 0.5 %", "accuracy: 0.5 %\naccuracy: 1 %", ["accuracy", "duplicate key, first defined on line"]),
        ("accuracy: 0.5 %", "acuracy: 0.5 %", ["acuracy", "did you mean 'accuracy'"]),
        ("  gravity: off", "  gravity: sideways", ["loads.gravity", "one of off, on; or give a mapping of acceleration, tilt; got 'sideways'"]),
        ("  gravity: off", "  gravity: onn", ["did you mean 'on'"]),
        ("  gravity: off", "  gravity: {tilt: 3 m}", ["loads.gravity.tilt", "expected an angle"]),
        ("temperature: 15 degC", "temperature: -300 degC", ["temperature", "above 0"]),
        ("name: leg", "name: ../leg", ["name", "use letters"]),
        ("input:", "inputs:\n  R1: {kind: constant, value: 1}\nspare:", ["inputs.R1", "the name of a bellow"]),
        ("input:", "inputs:\n  a b: {kind: constant, value: 1}\nspare:", ["inputs.a b", "not a valid inlet name"]),
        ("input:", "inputs: {}\nspare:", ["inputs", "at least one inlet"]),
        ("input:", "spare:", ["input: missing; give 'input'"]),
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


def test_all_faults_are_reported_at_once_in_order_of_lines(tmp_path: Path) -> None:
    text = changed("  length: 109 mm", "  length: 109 kg")
    text = text.replace("  count: 16 ", "  count: 15 ").replace("accuracy: 0.5 %", "accuracy: 2 m")
    message = faults_of(tmp_path, text)
    lines = message.splitlines()
    assert len(lines) == 3
    numbers = [int(line.split("leg.yaml:")[1].split(":")[0]) for line in lines]
    assert numbers == sorted(numbers)
    assert text.splitlines()[numbers[1] - 1].strip().startswith("count")


def test_cross_checks_are_reported_along_with_invalid_parts(tmp_path: Path) -> None:
    text = changed("  length: 109 mm", "  length: 109 kg").replace(
        "  layout: straight ", "  layout: straight\n  changes: {R1-R9: {}, R4-R7: {}} "
    )
    text = text.replace("  others: off", "  inerta: on\n  gravty: off\n  others: maybe")
    text += "bellowss: 3\naccuracy: 1 %\n"
    message = faults_of(tmp_path, text)
    for words in (
        "actuator.length: '109 kg' is a mass",
        "network.changes.R1-R9: the straight layout has no such tube; did you mean 'R1-R2'?",
        "network.changes.R4-R7",
        "effects.inerta: no such effect; did you mean 'inertia'?",
        "effects.gravty: no such effect; did you mean 'gravity'?",
        "effects.others: must be one of auto, on, off; got 'maybe'",
        "bellowss: no such key; did you mean 'bellows'? Allowed here:",
        "accuracy: duplicate key, first defined on line",
    ):
        assert words in message
    assert len(message.splitlines()) == 8


def test_an_unknown_key_of_an_input_lists_the_keys_of_its_kind() -> None:
    with pytest.raises(SpecError, match=r"input.start: no such key. Allowed here: .*value"):
        leg("input={kind: constant, value: 1, start: 2}")


@pytest.mark.parametrize("word", ["on", "yes", "true", "On", "YES", "True"])
def test_switches_on(word: str) -> None:
    assert leg(f"loads.gravity={word}").loads.gravity is not None
    assert leg(f"effects.inertia={word}").effects.mode("inertia") == "on"


@pytest.mark.parametrize("word", ["off", "no", "false", "No"])
def test_switches_off(word: str) -> None:
    assert leg(f"loads.gravity={word}").loads.gravity is None
    assert leg(f"effects.inertia={word}").effects.mode("inertia") == "off"


CUSTOM = "network: {{layout: custom, tube_radius: 1 mm, tube_length: 3 cm, tubes: [{}]}}"


@pytest.mark.parametrize(
    ("tubes", "words"),
    [
        ("{from: inlet, to: R1}, {from: R1, to: R9}", "the actuator has 8 sections"),
        ("{from: inlet, to: r1}", "did you mean 'R1'"),
        ("{from: inlet, to: inlet}", "to itself"),
        ("{from: R1, to: R2}", "the inlet 'inlet' has an input but no tube"),
        ("{from: inlet, to: R1}, {from: inlet2, to: R2}", "unknown node 'inlet2'"),
        ("{from: inlet, to: R1}, {from: a, to: b}", "junctions without a bellow or an inlet"),
        ("{from: inlet, to: R1, length: -1 mm}", "above 0"),
        ("{from: inlet, to: 'no good'}, {from: 'no good', to: R1}", "not a valid node name"),
        ("{from: inlet}", "missing"),
        ("{from: inlet, to: inlt}", "did you mean 'inlet'"),
        ("", "the inlet 'inlet' has an input but no tube"),
    ],
)
def test_faults_of_a_graph(tubes: str, words: str) -> None:
    with pytest.raises(SpecError, match=words.replace("'", ".")):
        leg(CUSTOM.format(tubes).replace("network: ", "network=", 1))


def test_all_faults_of_a_graph_are_reported() -> None:
    tubes = "{from: inlet, to: R9}, {from: r2, to: R2}, {from: R3, to: R3}"
    with pytest.raises(SpecError) as caught:
        leg(CUSTOM.format(tubes).replace("network: ", "network=", 1))
    keys = [fault.key for fault in caught.value.faults]
    assert keys == ["network.tubes.0", "network.tubes.1", "network.tubes.2"]


@pytest.mark.parametrize(("count", "use"), [(14, "12 or 16"), (2, "4")])
def test_a_crossed_chain_needs_an_even_number_of_sections(count: int, use: str) -> None:
    with pytest.raises(SpecError, match=f"even number of sections, not .*; use {use} bellows"):
        leg("network.layout=crossed", f"bellows.count={count}")


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ("servo_id: lots", "must be an integer from 0 to 253"),
        ("servo_id: 254", "must be an integer from 0 to 253"),
        ("servo_id: {left: 1}", "the inlets are inlet"),
        ("servo_id: {inlet: 1, left: 1}", "all different"),
        ("servo: ax12", "did you mean 'ax12a'"),
        ("home: 3", "must be within travel"),
        ("travel: [5, 1]", "low < high"),
        ("travel: [5, 6, 7]", "expected a pair"),
        ("sensor: {channel: 9}", "at most 7"),
        ("max_pressure: 25 m", "expected a pressure"),
    ],
)
def test_faults_of_a_pump(given: str, words: str) -> None:
    with pytest.raises(SpecError, match=words):
        leg(f"pump={{syringe_diameter: 34.9 mm, {given}}}")


def test_a_chain_with_several_inlets_is_refused() -> None:
    with pytest.raises(SpecError, match="straight chain has one inlet"):
        leg("input=null", "inputs={a: {kind: constant, value: 1}, b: {kind: constant, value: 1}}")


@pytest.mark.parametrize(
    ("table", "words"),
    [
        ("time_s,pressure_pa\n0,0\n1,\n", "line 3: pressure_pa is empty"),
        ("time_s,pressure_pa\n0,0\n1,high\n", "'high', not a number"),
        ("time_s,pressure_pa\n0,0\n2,5\n1,5\n", "time decreases from 2 s to 1 s"),
        ("time_s,pressure_pa\n0,0\n", "from 2 to 5000000 rows; got 1"),
        ("t,p\n0,0\n1,1\n", "expected 'time_s,pressure_pa', got 't,p'"),
        ("time_s,pressure_pa\n0,nan\n1,1\n", "not finite"),
        ("time_s,pressure_pa\n-1,0\n1,1\n", "before the start"),
        ("time_s,pressure_pa\n0,0,0\n1,1\n", "expected 2 values, got 3"),
        ("", "expected 'time_s,pressure_pa', got ''"),
        ("time_s,presure_p\n0,0\n1,1\n", "did you mean 'pressure_pa'"),
        ("time_s,pressure_pa\n0,0\n1,1\n1,2\n1,3\n", "line 5: third row at 1 s"),
        ("time_s,pressure_pa\n\n0,0\n\n2,5\n1,5\n", "line 6: time decreases"),
        ("time_s,pressure_pa\n" + "a,b\n" * 50, "and 80 more errors"),
        ("time_s,pressure_pa\n0," + "9" * 200_000 + "\n", "not a CSV"),
    ],
)
def test_faults_of_tables_name_the_row(tmp_path: Path, table: str, words: str) -> None:
    (tmp_path / "in.csv").write_text(table)
    file = tmp_path / "leg.yaml"
    start, end = GOOD.index("input:"), GOOD.index("loads:")
    file.write_text(GOOD[:start] + "input: {kind: table, file: in.csv}\n" + GOOD[end:])
    with pytest.raises(SpecError) as caught:
        load(file)
    assert words in str(caught.value)
    assert "leg.yaml:" in str(caught.value)


def test_an_endless_file_is_refused() -> None:
    with pytest.raises(SpecError, match="larger than 4 MiB"):
        load("/dev/zero")


def test_missing_files_are_reported(tmp_path: Path) -> None:
    with pytest.raises(SpecError, match="No such file"):
        load(tmp_path / "nothing.yaml")
    with pytest.raises(SpecError, match="is a folder"):
        load(tmp_path)
    with pytest.raises(SpecError, match=r"in\.csv cannot be read"):
        leg("input={kind: table, file: in.csv}")
    (tmp_path / "trace.csv").touch()
    with pytest.raises(SpecError, match=r"cannot be read: No such .*; did you mean 'trace.csv'\?"):
        leg(f"input={{kind: table, file: {tmp_path}/trce.csv}}")


@pytest.mark.parametrize(
    ("override", "words"),
    [
        ("bellows.cout=4", "--set bellows.cout=4"),
        ("bellows.count", "key.path=value"),
        ("bellows.count=15", "--set bellows.count=15: bellows.count: 15 is odd"),
        ("run.duration=[", "not YAML"),
        ("=3", "key.path=value"),
        ("name=\udcff", "not UTF-8 text"),
        ("a..b=3", "key.path=value"),
        ("name.x=3", "--set name.x=3: name: expected text, got a mapping"),
        ("inputs.left.value=3", "--set inputs.left.value=3: inputs.left"),
        ("network.changes.R1-R9.length=3 mm", "--set network.changes.R1-R9.length=3 mm: network"),
        (
            "network.tubes.0.length=1",
            "--set network.tubes.0.length=1: network.tubes: expected a list, got a mapping",
        ),
        (
            "bellows.count=!!python/name:os.system x",
            "--set bellows.count=!!python/name:os.system x: the tag",
        ),
        ("name=" + "[" * 10_000, "nested too deeply"),
        ("input.drop=3 mm", "--set input.drop=3 mm"),
    ],
)
def test_faults_of_overrides_name_the_override(override: str, words: str) -> None:
    with pytest.raises(SpecError) as caught:
        leg(override)
    assert words in str(caught.value)


def test_overrides_apply_to_words_and_lists() -> None:
    assert leg("loads.gravity.tilt=90 deg").loads.gravity is not None
    changed_tube = leg("network.tubes.0.length=1 m", config="antagonistic_two_inlets")
    assert changed_tube.graph.tubes[0].length == 1.0
    assert leg("inputs.left.frequency=2 Hz", config="antagonistic_two_inlets").inputs["left"]
