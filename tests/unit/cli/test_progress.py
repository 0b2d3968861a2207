"""A bar where somebody watches, silence elsewhere."""

from __future__ import annotations

import pytest

from viscodesign.cli.progress import Bar, progress


def test_a_pipe_sees_nothing(capsys: pytest.CaptureFixture[str]) -> None:
    with progress(quiet=False) as advance:
        advance(0.5)
    assert capsys.readouterr() == ("", "")


def test_quiet_sees_nothing_on_a_terminal(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    with progress(quiet=True) as advance:
        advance(0.5)
    assert capsys.readouterr() == ("", "")


def test_a_terminal_sees_a_bar_that_goes_away(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    with progress(quiet=False) as advance:
        advance(0.5)
    out, err = capsys.readouterr()
    assert out == ""
    assert "50%  solving" in err
    assert err.endswith("\r\x1b[K")


def test_the_bar_goes_away_on_an_error(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    with pytest.raises(ValueError, match="stop"), progress(quiet=False):
        raise ValueError("stop")
    assert capsys.readouterr().err == "\r\x1b[K"


def test_a_fall_back_is_the_next_pass() -> None:
    bar = Bar()
    for fraction in (0.1, 0.9, 0.05, 0.5, 0.2):
        bar.advance(fraction)
    assert bar.passes == 3


def test_later_passes_are_named(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("viscodesign.cli.progress.REDRAW_S", 0.0)
    bar = Bar("proving")
    for fraction in (0.9, 0.1):
        bar.advance(fraction)
    assert capsys.readouterr().err.endswith(" 10%  proving, pass 2")
