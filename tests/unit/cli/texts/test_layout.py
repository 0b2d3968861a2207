"""Lines that fit a terminal and stay whole in a pipe."""

from __future__ import annotations

import math

import pytest

from viscodesign.cli.texts import layout as text

LONG = "a sentence of many words that goes on and on " * 5


def test_a_pipe_gets_whole_lines() -> None:
    assert text.wrap(LONG.strip(), "  ") == ["  " + LONG.strip()]


@pytest.mark.parametrize("columns", [20, 40, 80, 300])
def test_a_terminal_is_never_overrun(monkeypatch: pytest.MonkeyPatch, columns: int) -> None:
    monkeypatch.setenv("COLUMNS", str(columns))
    monkeypatch.setattr("sys.stdout.isatty", lambda: True, raising=False)
    room = max(columns, text.MIN_COLUMNS)
    lines = text.table([("name", "1.5", LONG), ("a_longer_name", "x", LONG)])
    assert len(lines) > 2
    assert all(len(line) <= room for line in lines)


def test_a_terminal_narrower_than_the_columns_gets_wrapped_rows(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("COLUMNS", "40")
    monkeypatch.setattr("sys.stdout.isatty", lambda: True, raising=False)
    for head in ("x" * 30, "x" * 45):
        lines = text.table([(head[:20], head[20:], "last", "a few words")])
        assert all(len(line) <= 40 for line in lines)
        assert " ".join(" ".join(lines).split()) == f"{head[:20]} {head[20:]} last a few words"


def test_columns_are_aligned_and_lines_end_bare() -> None:
    assert text.table([("a", "long", "z"), ("abc", "b", "")]) == ["  a    long  z", "  abc  b"]


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (0.029196, "0.0292 s"),
        (math.inf, "infinite"),
        (-math.inf, "-infinite"),
        (math.nan, "unknown"),
        (None, "unknown"),
        (0.0, "0 s"),
    ],
)
def test_numbers(value: float | None, shown: str) -> None:
    assert text.number(value, "s") == shown
