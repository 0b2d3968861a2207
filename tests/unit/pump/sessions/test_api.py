"""The pump from Python: what is public, what it costs to import, and what it asks for."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.scenes import leg
from viscodesign import pump
from viscodesign.errors import UsageError
from viscodesign.pump.play.stream_result import TickReport

SESSIONS = (
    "plan", "stream", "upload", "record", "rehearse", "calibrate", "status", "stop", "ports",
)  # fmt: skip


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


def test_a_rehearsal_says_what_would_be_sent_and_prints_nothing(
    capsys: pytest.CaptureFixture[str],
) -> None:
    words = ("input={kind: sine, amplitude: 4 kPa, frequency: 0.5 Hz}", "run={duration: 2 s}")
    scene = leg(*words, config="leg_16_pump")
    stream = pump.rehearse(scene, pump.BoardAddress("dynamixel"))
    poses = pump.rehearse(scene, pump.BoardAddress("arbotix"), playback="loop")
    assert stream.text.startswith("[dry run] no port is opened")
    assert "packets" in poses.text
    assert len(stream.packets) > 60
    assert capsys.readouterr() == ("", "")
