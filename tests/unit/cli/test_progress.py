"""A bar where somebody watches, silence elsewhere."""

from __future__ import annotations

import re

import pytest

from viscodesign.cli.progress import progress

ESCAPES = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]")
CLEARED = "\r\x1b[1A\x1b[2K"
"""Back to an empty line."""


def on_terminal(monkeypatch: pytest.MonkeyPatch, columns: int = 80) -> None:
    """Let standard error be a terminal; not as a fixture, which would run before the capture."""
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    monkeypatch.setattr("viscodesign.cli.progress.REDRAW_S", 0.0)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", str(columns))


def seen(text: str) -> list[str]:
    """The lines as drawn one after the other, without control codes."""
    return [" ".join(line.split()) for line in re.split(r"[\r\n]+", ESCAPES.sub("", text))]


def test_a_pipe_sees_nothing(capsys: pytest.CaptureFixture[str]) -> None:
    with progress(quiet=False) as advance:
        advance(0.5)
    assert capsys.readouterr() == ("", "")


def test_quiet_sees_nothing_on_a_terminal(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    on_terminal(monkeypatch)
    with progress(quiet=True) as advance:
        advance(0.5)
    assert capsys.readouterr() == ("", "")


def test_a_terminal_sees_a_bar_that_goes_away(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    on_terminal(monkeypatch)
    with progress(quiet=False) as advance:
        advance(0.5)
    out, err = capsys.readouterr()
    assert out == ""
    assert any("50% solving" in line for line in seen(err))
    assert err.endswith(CLEARED)


def test_the_bar_goes_away_on_an_error(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    on_terminal(monkeypatch)
    with pytest.raises(ValueError, match="stop"), progress(quiet=False):
        raise ValueError("stop")
    assert capsys.readouterr().err.endswith(CLEARED)


def test_a_fall_back_is_the_next_pass_and_named(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    on_terminal(monkeypatch)
    with progress(False, "measuring effects") as advance:
        for fraction in (0.1, 0.9, 0.05, 0.5, 0.2):
            advance(fraction)
    lines = seen(capsys.readouterr().err)
    assert any("5% measuring effects, pass 2" in line for line in lines)
    assert any("20% measuring effects, pass 3" in line for line in lines)
    assert not any("pass 4" in line for line in lines)


def test_the_cursor_is_never_left_hidden(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whenever the process is killed: a hidden cursor would stay hidden."""
    on_terminal(monkeypatch)
    with progress(quiet=False):
        err = capsys.readouterr().err
    assert err.rfind("\x1b[?25h") > err.rfind("\x1b[?25l")


@pytest.mark.parametrize("columns", [20, 40])
def test_a_bar_fits_a_narrow_terminal(
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    columns: int,
) -> None:
    on_terminal(monkeypatch, columns)
    with progress(quiet=False) as advance:
        advance(0.5)
    assert all(len(line) <= columns for line in seen(capsys.readouterr().err))


def test_colour_is_left_out_where_nobody_wants_it(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("NO_COLOR", "1")
    on_terminal(monkeypatch)
    with progress(quiet=False) as advance:
        advance(0.5)
    assert not re.search(r"\x1b\[[0-9;]*3[0-9]", capsys.readouterr().err)
