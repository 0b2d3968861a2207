"""Several specs in one call, a spec from standard input, and a folder for each run."""

from __future__ import annotations

import io
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from viscodesign import Scene
from viscodesign.results.trajectory import RunInterruptedError, Trajectory
from viscodesign.scene.reading.write import resolved_yaml

from .conftest import CONFIGS, Call

AIR, WATER = CONFIGS / "leg_4_air.yaml", CONFIGS / "leg_4_water.yaml"
QUICK = ("--no-plots", "-q")


@pytest.fixture(autouse=True)
def desk(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, trajectory: Trajectory) -> None:
    """An empty folder to work in, and a solver that answers at once with the scene's own name."""

    def solve(scene: Scene, **_: object) -> Trajectory:
        if scene.run.duration == 13.0:
            raise RunInterruptedError(None)
        ended = {"status": "failed", "failure": "no luck"} if scene.run.duration == 7.0 else {}
        made: Any = {"name": scene.name, "spec_text": resolved_yaml(scene), **ended}
        return replace(trajectory, **made)

    monkeypatch.setattr("viscodesign.simulate", solve)
    monkeypatch.chdir(tmp_path)


def spec(path: str, text: str | None = None, **values: str) -> Path:
    """A spec in the current folder: the bundled one of air, with some values changed."""
    content = AIR.read_text() if text is None else text
    for key, value in values.items():
        old = next(line for line in content.splitlines() if line.strip().startswith(f"{key}:"))
        content = content.replace(old, f"{old.partition(':')[0]}: {value}", 1)
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    Path(path).write_text(content)
    return Path(path)


def folders() -> list[str]:
    return sorted(path.name for path in Path("runs").iterdir())


@pytest.mark.parametrize("command", ["check", "simulate"])
def test_each_spec_is_told_by_name(call: Call, command: str) -> None:
    words = ("--no-plots",) if command == "simulate" else ()
    outcome = call(command, AIR, WATER, *words)
    assert (outcome.status, outcome.err) == (0, "")
    assert outcome.out.index("leg_4_air: quadrant" if command == "check" else "leg_4_air") >= 0
    assert "leg_4_water" in outcome.out
    document = json.loads(call(command, AIR, WATER, "--json", *words, "-q").out)
    assert [one["name"] for one in document["specs"]] == ["leg_4_air", "leg_4_water"]
    assert [one["spec"] for one in document["specs"]] == [str(AIR), str(WATER)]


def test_each_run_has_its_folder(call: Call) -> None:
    assert call("simulate", AIR, WATER, *QUICK).status == 0
    assert folders() == ["leg_4_air", "leg_4_water"]


def test_with_a_folder_given_each_run_has_its_own_in_it(call: Call) -> None:
    for _ in range(2):
        assert call("simulate", AIR, WATER, "-o", "out", *QUICK).status == 0
        assert sorted(p.name for p in Path("out").iterdir()) == ["leg_4_air", "leg_4_water"]
    spec("other.yaml", tube_length="20 mm")
    assert call("simulate", AIR, "other.yaml", "-o", "out", *QUICK).status == 0
    assert {p.name for p in Path("out").iterdir()} == {"leg_4_air", "leg_4_air-2", "leg_4_water"}


@pytest.mark.parametrize("command", ["check", "simulate"])
@pytest.mark.parametrize(
    ("bad", "status"),
    [
        ({"name": "none.yaml"}, 2),
        ({"count": "3"}, 2),
        ({"duration": "7 s"}, 3),
    ],
)
def test_one_that_fails_does_not_stop_the_others(
    call: Call, command: str, bad: dict[str, str], status: int
) -> None:
    file = Path("none.yaml") if "name" in bad else spec("bad.yaml", **bad)
    status = 0 if (command, status) == ("check", 3) else status
    words = QUICK if command == "simulate" else ("-q",)
    outcome = call(command, file, AIR, *words, "--json")
    assert outcome.status == status
    first, second = json.loads(outcome.out)["specs"]
    assert first["spec"] == str(file)
    assert ("error" in first) == (status > 0)
    assert "error" not in second
    assert second["name"] == "leg_4_air"
    if status:
        assert first["error"]["exit_code"] == status
        assert str(file) in outcome.err


def test_the_exit_code_is_the_worst(call: Call) -> None:
    files = [spec("bad.yaml", count="3"), spec("failing.yaml", duration="7 s"), AIR]
    assert call("simulate", *files, *QUICK).status == 3
    assert call("simulate", *files[::-1], *QUICK).status == 3
    assert call("simulate", files[0], AIR, *QUICK).status == 2


def test_an_internal_error_in_one_does_not_stop_the_others(
    call: Call, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("viscodesign.check", lambda scene: 1 / 0)
    outcome = call("check", AIR, WATER)
    assert outcome.status == 1
    assert outcome.err.count("internal error: ZeroDivisionError") == 2
    assert f"{AIR}: internal error" in outcome.err


def test_an_interrupt_stops_them_all(call: Call) -> None:
    outcome = call("simulate", WATER, spec("long.yaml", duration="13 s"), AIR, "--json", *QUICK)
    assert outcome.status == 130
    assert [one["spec"] for one in json.loads(outcome.out)["specs"]] == [str(WATER), "long.yaml"]
    assert folders()[-1] == "leg_4_water"


@pytest.mark.parametrize("command", ["check", "classify", "simulate"])
def test_standard_input_is_a_spec(
    call: Call, command: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    words = ("--no-plots",) if command == "simulate" else ()
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(AIR.read_bytes())))
    outcome = call(command, "-", *words, "--json", "--set", "run.duration=2 s")
    assert (outcome.status, outcome.err) == (0, "") or command == "simulate"
    document = json.loads(outcome.out)
    assert document.get("specs", [document])[0]["name"] == "leg_4_air"


@pytest.mark.parametrize(
    ("stdin", "words", "message"),
    [
        (b"", ("-",), "is empty"),
        (b"- a\n", ("-",), "is a list"),
        (b"\xff\xfe\x00", ("-",), "not UTF-8"),
        (b"name: [", ("-",), "not YAML"),
        (None, ("-",), "standard input is closed"),
        (b"", ("-", "-"), "'-' is given twice"),
    ],
)
def test_a_bad_standard_input_is_told(
    call: Call,
    monkeypatch: pytest.MonkeyPatch,
    stdin: bytes | None,
    words: tuple[str, ...],
    message: str,
) -> None:
    stream = None if stdin is None else io.TextIOWrapper(io.BytesIO(stdin))
    monkeypatch.setattr("sys.stdin", stream)
    outcome = call("check", *words)
    assert outcome.status == 2
    assert message in outcome.err


CHANGES: list[dict[str, str]] = [
    {"tube_length": "20 mm"},
    {"duration": "2 s"},
    {"accuracy": "1 %"},
    {"temperature": "16 degC"},
    {"collapse_fraction": "0.2"},
]


@pytest.mark.parametrize("change", CHANGES)
def test_another_file_of_the_same_name_keeps_the_first_run(
    call: Call, change: dict[str, str]
) -> None:
    assert call("simulate", AIR, *QUICK).status == 0
    before = Path("runs/leg_4_air/spec.yaml").read_bytes()
    outcome = call("simulate", spec("other/leg.yaml", **change), "--no-plots")
    assert outcome.status == 0
    assert folders() == ["leg_4_air", "leg_4_air-2"]
    assert Path("runs/leg_4_air/spec.yaml").read_bytes() == before
    assert outcome.err.count("\n") == 1
    assert "results of another spec of this name; these are in runs/leg_4_air-2" in outcome.err


def test_other_overrides_keep_it_too_and_equal_ones_replace_it(call: Call) -> None:
    for override in ("2 s", "3 s", "2000 ms", "3 s"):
        assert call("simulate", AIR, *QUICK, "--set", f"run.duration={override}").status == 0
    assert folders() == ["leg_4_air", "leg_4_air-2"]


def test_the_same_spec_in_another_place_replaces_it(call: Call) -> None:
    call("simulate", AIR, *QUICK)
    call("simulate", spec("copy.yaml"), *QUICK)
    assert folders() == ["leg_4_air"]


def test_an_explicit_folder_is_replaced(call: Call) -> None:
    for override in ("2 s", "3 s"):
        words = ("-o", "here", *QUICK, "--set", f"run.duration={override}")
        assert call("simulate", AIR, *words).err == ""
    assert Path("here/spec.yaml").read_text().count("3.0 s") == 1
    assert not Path("runs").exists()


@pytest.mark.parametrize("document", ["{}", "[]", "not JSON", '{"resolved_sha256": "0"}'])
def test_a_run_that_does_not_say_what_it_is_of_is_kept(call: Call, document: str) -> None:
    Path("runs/leg_4_air").mkdir(parents=True)
    Path("runs/leg_4_air/summary.json").write_text(document)
    call("simulate", AIR, *QUICK)
    assert folders() == ["leg_4_air", "leg_4_air-2"]
    assert Path("runs/leg_4_air/summary.json").read_text() == document


def test_what_a_killed_run_left_is_replaced(call: Call) -> None:
    Path("runs/leg_4_air").mkdir(parents=True)
    Path("runs/leg_4_air/trajectory.csv").write_text("time_s\n")
    call("simulate", AIR, *QUICK)
    assert folders() == ["leg_4_air"]
