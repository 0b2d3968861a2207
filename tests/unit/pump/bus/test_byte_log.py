"""The log of bytes: whole lines, and never in the way of the pump."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from tests.pumps import bench, stepped
from tests.rig.bus import BusAdapter
from viscodesign.errors import PumpError, UsageError
from viscodesign.pump.bus.byte_log import ByteLog, LoggedLine
from viscodesign.pump.simulated.device import DirectLine

PING = bytes.fromhex("ffff010201fb")


def entries(path: Path) -> list[dict[str, object]]:
    return [json.loads(line) for line in path.read_text().splitlines() if line]


def logged(log: ByteLog) -> LoggedLine:
    return LoggedLine(DirectLine(BusAdapter(bench(1)), stepped()), log)


def test_every_byte_and_event_is_in_the_file_at_once(tmp_path: Path) -> None:
    path, told = tmp_path / "log.jsonl", []
    log = ByteLog(path, told.append)
    line = logged(log)
    line.write(PING)
    assert entries(path)[-1]["hex"] == "ff ff 01 02 01 fb"
    line.read(100, 1.0)
    log.event("setpoint", count=300, pressure_pa=1e3)
    assert [entry["kind"] for entry in entries(path)] == ["tx", "rx", "setpoint"]
    assert all(entry["wall_s"] and entry["monotonic_s"] for entry in entries(path))
    assert told == []


def test_a_full_disk_is_told_once_and_stops_nothing() -> None:
    told: list[str] = []
    line = logged(ByteLog(Path("/dev/full"), told.append))
    for _ in range(3):
        line.write(PING)
        assert line.read(100, 1.0) == bytes.fromhex("ffff010200fc")
    assert len(told) == 1
    assert "No space left on device" in told[0]


def test_a_torn_line_spoils_no_other(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path, told = tmp_path / "log.jsonl", []
    log = ByteLog(path, told.append)
    real = os.write
    with monkeypatch.context() as patch:
        patch.setattr(os, "write", lambda file, data: real(file, data[:20]))
        log.event("torn")
    log.event("whole")
    assert json.loads(path.read_text().splitlines()[-1])["kind"] == "whole"
    assert len(told) == 1


def test_a_failed_write_is_logged_and_raised(tmp_path: Path) -> None:
    path = tmp_path / "log.jsonl"
    line = logged(ByteLog(path, print))
    line.line.close()
    with pytest.raises(PumpError):
        line.write(PING)
    assert entries(path)[-1]["kind"] == "tx failed"


def test_an_unusable_log_path_is_reported_before_anything_moves(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="No such file"):
        ByteLog(tmp_path / "none" / "log.jsonl", print)


def test_no_file_is_no_log() -> None:
    log = ByteLog(None, print)
    log.event("nothing")
    log.close()
