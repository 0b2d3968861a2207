"""The pump from Python: what is public, what it costs to import, and what it asks for."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.plans import planned_once
from tests.scenes import leg
from viscodesign import pump
from viscodesign.errors import PumpError, UsageError
from viscodesign.pump.play.stream_result import TickReport

SESSIONS = (
    "plan", "stream", "upload", "record", "rehearse", "calibrate", "status", "stop", "ports",
)  # fmt: skip
SHORT = ("input={kind: sine, amplitude: 4 kPa, frequency: 0.5 Hz}", "run={duration: 2 s}")


def test_every_session_is_a_documented_function() -> None:
    assert set(SESSIONS) <= set(pump.__all__)
    assert all(callable(getattr(pump, name)) and getattr(pump, name).__doc__ for name in SESSIONS)
    with pytest.raises(AttributeError, match="no attribute 'fly'"):
        pump.fly  # noqa: B018


def test_importing_the_pump_imports_nothing_heavy() -> None:
    program = (
        "import sys; from viscodesign import pump;"
        "print([m for m in ('numpy', 'casadi', 'pydantic', 'serial') if m in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert done.stdout == "[]\n"


def test_a_real_board_needs_consent() -> None:
    real = pump.BoardAddress("dynamixel", "/dev/none")
    with pytest.raises(UsageError, match="pass `confirm`"):
        real.require_consent(None, "Move the pump?")
    with pytest.raises(UsageError, match="nothing moved"):
        real.require_consent(lambda text: False, "Move the pump?")
    real.require_consent(lambda text: True, "Move the pump?")
    pump.BoardAddress("simulated").require_consent(None, "Move the pump?")


def test_a_stream_is_stopped_from_the_program(tmp_path: Path) -> None:
    scene = leg("run={duration: 2 s}", "input={kind: constant, value: 1 Pa}", config="leg_16_pump")
    request, seen = pump.StopRequest(), []

    def on_tick(tick: TickReport) -> None:
        seen.append(tick.time)
        if len(seen) == 10:
            request.ask("button")

    board = pump.BoardAddress(pace="max")
    report = pump.stream(scene, tmp_path, board, achievable=True, on_tick=on_tick, stop=request)
    assert (report.status, len(seen)) == ("interrupted", 10)
    assert report.document()["reason"] == "asked to stop (button)"
    assert report.document()["hold_verified"]


@pytest.mark.parametrize(
    ("address", "confirm", "error"),
    [
        (pump.BoardAddress(pace="max"), lambda text: False, UsageError),
        (pump.BoardAddress("dynamixel", "/dev/there-is-none"), lambda text: True, PumpError),
    ],
)
def test_a_stream_that_does_not_begin_leaves_no_folder(
    address: pump.BoardAddress,
    confirm: Callable[[str], bool],
    error: type[Exception],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("viscodesign.pump.sessions.streaming.plan_pump", planned_once)
    scene = leg(*SHORT, config="leg_16_pump")
    with pytest.raises(error):
        pump.stream(scene, tmp_path / "runs" / "leg", address, confirm=confirm)
    assert not list(tmp_path.iterdir())


def test_a_refused_stream_leaves_an_earlier_log(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("viscodesign.pump.sessions.streaming.plan_pump", planned_once)
    (tmp_path / "log.jsonl").write_text("{}\n")
    board = pump.BoardAddress(pace="max")
    with pytest.raises(UsageError, match="nothing moved"):
        pump.stream(leg(*SHORT, config="leg_16_pump"), tmp_path, board, confirm=lambda text: False)
    assert (tmp_path / "log.jsonl").read_text().startswith("{}\n")


def test_a_recording_of_a_real_pump_is_not_replaced(tmp_path: Path) -> None:
    table, board = tmp_path / "rest.csv", pump.BoardAddress(pace="max")
    table.write_text("time_s\n0.0\n")
    with pytest.raises(UsageError, match=r"rest\.csv exists and may hold what a real pump"):
        pump.record(table, board, duration=0.1)
    assert table.read_text() == "time_s\n0.0\n"
    assert pump.record(table, board, duration=0.1, force=True).rows > 1
    assert pump.record(table, board, duration=0.1).rows > 1  # a simulated one is


def test_a_rehearsal_says_what_would_be_sent_and_prints_nothing(
    capsys: pytest.CaptureFixture[str],
) -> None:
    scene = leg(*SHORT, config="leg_16_pump")
    stream = pump.rehearse(scene, pump.BoardAddress("dynamixel"))
    poses = pump.rehearse(scene, pump.BoardAddress("arbotix"), playback="loop")
    assert stream.text.startswith("[dry run] no port is opened")
    assert "packets" in poses.text
    assert len(stream.packets) > 60
    assert capsys.readouterr() == ("", "")
