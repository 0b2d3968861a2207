"""What is seen while a pump moves, on a terminal and in a pipe."""

from __future__ import annotations

import io
import os
import pty

import numpy as np
import pytest

from tests.plans import made_plan
from tests.scenes import leg
from tests.unit.pump.samples import sample
from viscodesign.cli.texts.live_view import (
    REPORT_INTERVAL_S,
    LiveView,
    NonblockingText,
    live_view,
)
from viscodesign.pump.play.guard import Stop
from viscodesign.pump.play.stream_result import TickReport
from viscodesign.pump.profile import Profile


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def view(stream: io.TextIOBase, now: list[float], simulated: bool = False) -> LiveView:
    text = NonblockingText(stream)  # type: ignore[arg-type]
    return LiveView(
        ["inlet"], (-10e3, 20e3), 8.0, "[simulated]" if simulated else "", text, lambda: now[0]
    )


def shown(time: float = 1.0, skipped: int = 0, stop: Stop | None = None) -> TickReport:
    return TickReport(time, sample(pressure=10e3, wanted=12.5e3), skipped, stop)


def test_a_terminal_shows_numbers_and_bars_redrawn_in_place() -> None:
    stream, now = Terminal(), [0.0]
    picture = view(stream, now)
    picture.show(shown())
    first = stream.getvalue()
    assert "1.0 of 8.0 s" in first
    assert "wanted     12.50 kPa [..." in first
    assert "measured   10.00 kPa [..." in first
    assert first.count("#") > 10
    assert "\x1b[3A" not in first
    now[0] += 1.0
    picture.show(shown(2.0, skipped=3))
    assert stream.getvalue()[len(first) :].startswith("\x1b[3A")
    assert "(3 ticks skipped)" in stream.getvalue()


def test_bars_go_from_zero_to_both_sides() -> None:
    picture = view(Terminal(), [0.0])
    assert picture._bar(0.0, 30) == "[" + "." * 10 + "|" + "." * 20 + "]"
    assert picture._bar(20e3, 30) == "[" + "." * 10 + "|" + "#" * 20 + "]"
    assert picture._bar(-10e3, 30) == "[" + "#" * 10 + "|" + "." * 20 + "]"
    assert picture._bar(99e3, 30) == picture._bar(20e3, 30)
    assert picture._bar(None, 30) == picture._bar(0.0, 30)


def test_a_terminal_is_redrawn_ten_times_per_second() -> None:
    stream, now = Terminal(), [0.0]
    picture = view(stream, now)
    for k in range(100):
        now[0] = 0.01 * k
        picture.show(shown())
    assert 9 <= stream.getvalue().count("measured") <= 11


def test_a_pipe_gets_a_line_every_few_seconds_without_codes() -> None:
    stream, now = io.StringIO(), [0.0]
    picture = view(stream, now, simulated=True)
    for k in range(100):
        now[0] = 0.1 * k
        picture.show(shown(0.1 * k))
    lines = stream.getvalue().splitlines()
    assert len(lines) == 10.0 // REPORT_INTERVAL_S
    assert lines[0] == "[simulated] 0.0 of 8.0 s; wanted 12.50 kPa, measured 10.00 kPa"
    assert "\x1b" not in stream.getvalue()


def test_a_stop_is_shown_at_once() -> None:
    stream, now = io.StringIO(), [0.0]
    picture = view(stream, now)
    picture.show(shown())
    picture.show(shown(1.5, stop=Stop("pressure_cap", "too much")))
    assert "STOP at 1.5 s: pressure cap" in stream.getvalue().splitlines()[-1]


def test_the_way_to_the_start_is_labelled() -> None:
    stream, now = io.StringIO(), [0.0]
    view(stream, now).show(shown(-2.5))
    assert "moving to the start, 2.5 s left" in stream.getvalue()


def test_a_stopped_terminal_does_not_stop_the_pump() -> None:
    ours, theirs = pty.openpty()
    with os.fdopen(theirs, "w") as stream:
        now = [0.0]
        picture = view(stream, now)
        for _ in range(2000):  # nobody reads: the terminal's buffer is full long before
            now[0] += 1.0
            picture.show(shown())
        picture.text.close()
        assert os.get_blocking(theirs)  # others share it
        os.close(ours)


def test_a_closed_terminal_raises_nothing() -> None:
    ours, theirs = pty.openpty()
    with os.fdopen(theirs, "w") as stream:
        picture = view(stream, [0.0])
        os.close(ours)
        picture.show(shown())
        picture.text.close()


def test_a_full_pipe_does_not_stop_the_pump() -> None:
    ours, theirs = os.pipe()
    with os.fdopen(theirs, "w") as stream:
        now = [0.0]
        picture = view(stream, now)
        for _ in range(2000):
            now[0] += REPORT_INTERVAL_S
            picture.show(shown())
        os.close(ours)


@pytest.mark.parametrize("quiet", [False, True])
def test_a_hint_is_a_line_of_its_own_unless_quiet(
    quiet: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    moved = np.array([[200.0], [260.0]])
    profile = Profile(("inlet",), (1,), np.array([0.0, 1.0]), moved, np.zeros((2, 1)))
    plan, pump = made_plan(profile), leg(config="leg_16_pump").pump
    assert pump is not None
    with live_view(plan, pump, "", quiet) as (show, hint):
        hint("held")
        assert (show is None) == quiet
    assert capsys.readouterr().err == ("" if quiet else "held\n")
