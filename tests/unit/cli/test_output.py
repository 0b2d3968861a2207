"""JSON without NaN, text without control codes, files complete or absent."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from viscodesign.cli import output
from viscodesign.errors import OutputError, ViscodesignError


def test_what_is_not_finite_becomes_null() -> None:
    text = output.json_text({"a": float("nan"), "b": [float("inf"), 1.5], "c": {"d": -1e400}})
    assert json.loads(text) == {"a": None, "b": [None, 1.5], "c": {"d": None}}


def test_control_codes_are_escaped(capsys: pytest.CaptureFixture[str]) -> None:
    output.say("leg\x1b[2J\tnext\nline")
    assert capsys.readouterr().out == "leg\\x1b[2J\tnext\nline\n"


def test_a_closed_pipe_is_not_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("builtins.print", _refuse(BrokenPipeError()))
    with pytest.raises(output.ReaderGoneError):
        output.say("x")


def test_a_full_disk_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("builtins.print", _refuse(OSError(28, "No space left on device")))
    with pytest.raises(ViscodesignError, match="standard output: No space left"):
        output.say("x")


def test_a_write_that_fails_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("os.replace", _refuse(OSError(28, "No space left on device")))
    with pytest.raises(OutputError, match="No space left"):
        output.write_text(tmp_path / "leg.yaml", "text", overwrite=False)
    assert list(tmp_path.iterdir()) == []


def _refuse(error: OSError):  # type: ignore[no-untyped-def]
    def refuse(*_: object, **__: object) -> None:
        raise error

    return refuse
