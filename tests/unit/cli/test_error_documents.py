"""With `--json` every failure is one JSON document on standard output, beside the message."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from viscodesign.cli import main as entry
from viscodesign.errors import (
    InterruptedRunError,
    PumpError,
    SolveError,
    SpecError,
    UsageError,
    ViscodesignError,
)
from viscodesign.results.trajectory import Trajectory

from .conftest import Call


def error_of(out: str) -> dict[str, Any]:
    document = json.loads(out)
    assert list(document) == ["error"]
    return dict(document["error"])


@pytest.mark.parametrize(
    ("error", "kind", "status"),
    [
        (ViscodesignError("broken"), "other", 1),
        (SpecError.plain("broken"), "spec", 2),
        (UsageError("broken"), "usage", 2),
        (SolveError("broken", quantity="tip", where="R1"), "solve", 3),
        (PumpError("broken"), "pump", 4),
        (InterruptedRunError("broken"), "interrupted", 130),
        (KeyboardInterrupt(), "interrupted", 130),
        (ZeroDivisionError("broken"), "internal", 1),
    ],
)
def test_every_error_is_a_document(
    call: Call, monkeypatch: pytest.MonkeyPatch, error: BaseException, kind: str, status: int
) -> None:
    def fail(words: list[str]) -> int:
        raise error

    monkeypatch.setattr(entry, "_run", fail)
    outcome = call("check", "leg.yaml", "--json")
    told = error_of(outcome.out)
    assert (outcome.status, told["exit_code"], told["type"]) == (status, status, kind)
    assert told["message"] + "\n" == outcome.err
    assert call("check", "--", "--json").out == ""


def test_a_solve_error_has_its_quantity_place_time_and_remedy(
    call: Call, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(words: list[str]) -> int:
        raise SolveError("no", quantity="stretch", where="R3", time_s=0.5, remedy="Do less")

    monkeypatch.setattr(entry, "_run", fail)
    told = error_of(call("simulate", "--json").out)
    assert (told["quantity"], told["where"], told["time_s"]) == ("stretch", "R3", 0.5)
    assert told["remedy"] == "Do less"


@pytest.mark.parametrize(
    "words",
    [
        ("check",),
        ("bogus",),
        ("check", "leg.yaml", "--nonsense"),
        ("accuracy", "a.yaml", "b.yaml"),
        ("simulate", "leg.yaml", "--format", "gif"),
        ("pump", "stream"),
    ],
)
def test_wrong_usage_is_a_document(call: Call, words: tuple[str, ...]) -> None:
    plain, outcome = call(*words), call(*words, "--json")
    assert outcome.status == plain.status == 2
    told = error_of(outcome.out)
    assert told["type"] == "usage"
    assert told["message"] in outcome.err
    assert plain.out == ""


FAULTY = [
    ("height: 30 mm", "height: 3 kg", "actuator.height", "3 kg", "a length above 0 m, such as '30 mm'"),
    ("length: 109 mm", "length: -1 mm", "actuator.length", "-1 mm", "a length above 0 m, such as '109 mm'"),
    ("layout: straight", "layout: strait", "network.layout", "strait", "one of straight, crossed, custom"),
    ("count: 16", "count: 15", "bellows.count", 15, "an integer"),
    ("solid_fraction: 0.47", "solid_fraction: 47", "actuator.solid_fraction", 47,
     "a fraction above 0 and at most 1, such as '47 %'"),
    ("kind: double_sigmoid", "kind: sinus", "input", None, "a mapping whose kind is one of constant, double_sigmoid"),
    ("youngs_modulus: 1.8 MPa", "youngs: 1.8 MPa", "actuator.youngs", "1.8 MPa", "one of the keys length, height"),
]  # fmt: skip


@pytest.mark.parametrize(("old", "new", "key", "given", "allowed"), FAULTY)
def test_a_fault_has_file_line_key_what_is_given_and_what_is_allowed(
    call: Call, leg: Path, tmp_path: Path, old: str, new: str, key: str, given: Any, allowed: str
) -> None:
    spec, lines = tmp_path / "leg.yaml", leg.read_text().replace(old, new, 1)
    spec.write_text(lines)
    outcome = call("check", spec, "--json")
    faults = {fault["key"]: fault for fault in error_of(outcome.out)["faults"]}
    found = faults[key]
    assert found["file"] == str(spec)
    line = 1 + next(k for k, text in enumerate(lines.splitlines()) if new in text)
    assert found["line"] in (line, line - 1)
    assert given is None or found["given"] == given
    assert found["allowed"].startswith(allowed)
    assert found["message"] in outcome.err


@pytest.mark.parametrize(
    ("override", "key", "given", "allowed"),
    [
        ("effects.grvity=on", "effects.grvity", True, "one of the effects"),
        ("effects.gravity=perhaps", "effects.gravity", "perhaps", "one of auto, on, off"),
        ("run.duration=8 kg", "run.duration", "8 kg", "a time above 0 s"),
        ("run.max_steps=few", "run.max_steps", "few", "an integer at least 100"),
        ("name=", "name", "", "text"),
    ],
)
def test_faults_of_overrides_likewise(
    call: Call, leg: Path, override: str, key: str, given: Any, allowed: str
) -> None:
    faults = error_of(call("check", leg, "--json", "--set", override).out)["faults"]
    found = next(fault for fault in faults if fault["key"] == key)
    assert (found["file"], found["line"]) == (f"--set {override}", None)
    assert found["given"] in (given, "on")
    assert found["allowed"].startswith(allowed)


def test_a_run_that_fails_prints_its_own_document_alone(
    call: Call, tmp_path: Path, leg: Path, trajectory: Trajectory, monkeypatch: pytest.MonkeyPatch
) -> None:
    failed = replace(trajectory, status="failed", failure="stretch below 0.2")
    monkeypatch.setattr("viscodesign.simulate", lambda scene, **_: failed)
    outcome = call("simulate", leg, "-o", tmp_path / "run", "--no-plots", "--json")
    assert outcome.status == 3
    assert json.loads(outcome.out)["failure"] == "stretch below 0.2"


@pytest.mark.parametrize(
    "words",
    [
        ("simulate", "-o", "FILE"),
        ("accuracy", "--budget", "soon"),
        ("classify", "--plot", "plane.gif"),
        ("init", "--template", "leg_17"),
        ("effects", "grvity"),
        ("pump", "plan"),
    ],
)
def test_failures_of_every_command_are_documents(
    call: Call, leg: Path, tmp_path: Path, words: tuple[str, ...]
) -> None:
    (tmp_path / "FILE").write_text("")
    needs_spec = words[0] not in ("init", "effects")
    given = [str(tmp_path / word) if word == "FILE" else word for word in words]
    outcome = call(*given, *([leg] if needs_spec else []), "--json")
    assert outcome.status == 2
    assert error_of(outcome.out)["message"] in outcome.err


def test_a_closed_pipe_ends_quietly(call: Call, monkeypatch: pytest.MonkeyPatch) -> None:
    def gone(text: str) -> None:
        raise entry.ReaderGoneError

    monkeypatch.setattr(entry, "say", gone)
    assert call("check", "none.yaml", "--json").status == 2
