"""Every error becomes one message and one exit code."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from viscodesign.cli import main as entry
from viscodesign.errors import (
    InterruptedRunError,
    PumpError,
    SpecError,
    UsageError,
    ViscodesignError,
)

from .conftest import Call


def _raising(error: BaseException) -> Callable[[list[str]], int]:
    def run(words: list[str]) -> int:
        raise error

    return run


@pytest.mark.parametrize(
    ("error", "status"),
    [
        (ViscodesignError("broken"), 1),
        (SpecError.plain("broken"), 2),
        (UsageError("broken"), 2),
        (PumpError("broken"), 4),
        (InterruptedRunError("broken"), 130),
        (KeyboardInterrupt(), 130),
    ],
)
def test_an_error_is_one_message_and_its_exit_code(
    call: Call, monkeypatch: pytest.MonkeyPatch, error: BaseException, status: int
) -> None:
    monkeypatch.setattr(entry, "_run", _raising(error))
    outcome = call("check", "leg.yaml")
    assert outcome.status == status
    assert outcome.out == ""
    assert outcome.err in ("broken\n", "interrupted\n")


def test_an_internal_error_is_one_line_that_names_debug(
    call: Call, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(entry, "_run", _raising(ZeroDivisionError("by zero\nsecond line")))
    outcome = call("check")
    assert outcome.status == 1
    assert outcome.err.count("\n") == 1
    assert outcome.err.startswith("internal error: ZeroDivisionError: by zero")
    assert "--debug" in outcome.err


@pytest.mark.parametrize("error", [ZeroDivisionError("by zero"), UsageError("broken")])
def test_debug_shows_the_traceback(
    call: Call, monkeypatch: pytest.MonkeyPatch, error: Exception
) -> None:
    monkeypatch.setattr(entry, "_run", _raising(error))
    assert "Traceback" in call("check", "--debug").err
    assert "Traceback" not in call("check", "--", "--debug").err


@pytest.mark.parametrize(
    "words",
    [
        (),
        ("bogus",),
        ("check",),
        ("classify",),
        ("check", "leg.yaml", "--nonsense"),
        ("check", "leg.yaml", "--set"),
        ("accuracy", "a.yaml", "b.yaml"),
    ],
)
def test_wrong_usage_is_2_and_leaves_stdout_empty(call: Call, words: tuple[str, ...]) -> None:
    outcome = call(*words)
    assert outcome.status == 2
    assert outcome.out == ""
    assert outcome.err.startswith(("Usage: viscodesign", "Error: "))


def test_version(call: Call) -> None:
    from viscodesign._version import __version__

    outcome = call("--version")
    assert (outcome.status, outcome.out) == (0, f"viscodesign {__version__}\n")
