"""Records are whole rows whatever happens, and say what they are."""

from __future__ import annotations

import errno
import json
import os
import signal
import subprocess
import sys
from io import FileIO
from pathlib import Path

import pandas as pd
import pytest

from tests.unit.pump.samples import sample, servo
from viscodesign.errors import OutputError, UsageError
from viscodesign.pump.kinds.servo import CHANNELS
from viscodesign.pump.play.stream_result import RecordingError
from viscodesign.pump.sessions.record_file import FLUSH_INTERVAL_S, columns, recorded
from viscodesign.pump.sessions.record_folder import refuse_measured


class FullDisk:
    """A file that takes no more."""

    def __init__(self, file: FileIO) -> None:
        self.truncate, self.seek = file.truncate, file.seek

    def write(self, data: bytes) -> int:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


FACTS = {"board": "simulated", "simulated": True}


def test_one_inlet_has_the_simulators_columns() -> None:
    assert columns(["inlet"], CHANNELS)[:3] == ["time_s", "inlet_pressure_pa", "wanted_pressure_pa"]
    assert columns(["inlet"], CHANNELS)[3:] == [
        "position_counts", "goal_counts", "load_rel", "voltage_v", "temperature_degc",
    ]  # fmt: skip


def test_several_inlets_are_named_as_the_simulator_names_them() -> None:
    names = columns(["left", "right"], CHANNELS)
    assert names[1:3] == ["inlet_pressure_left_pa", "inlet_pressure_right_pa"]
    assert names[5] == "position_left_counts"
    assert len(names) == len(set(names)) == 1 + 2 * 2 + 2 * 5


def test_rows_are_read_back_unchanged(tmp_path: Path) -> None:
    path = tmp_path / "run" / "record.csv"
    with recorded(path, ["inlet"], FACTS, CHANNELS) as record:
        record.add(-0.5, sample(pressure=None, wanted=None))
        record.add(0.0, sample(pressure=1234.5, wanted=1000.0, state=servo(498, goal=500)))
        record.state("complete", skipped_ticks=0)
    table = pd.read_csv(path)
    assert list(table.columns) == columns(["inlet"], CHANNELS)
    assert table["inlet_pressure_pa"].isna().tolist() == [True, False]
    assert table.iloc[1].tolist() == [0.0, 1234.5, 1000.0, 498, 500, 0.0, 11.1, 30.0]
    beside = json.loads((tmp_path / "run" / "record.json").read_text())
    assert (beside["status"], beside["partial"], beside["rows"]) == ("complete", False, 2)
    assert beside["simulated"] is True
    assert beside["skipped_ticks"] == 0


def test_a_running_record_is_labelled_partial(tmp_path: Path) -> None:
    path = tmp_path / "record.csv"
    with recorded(path, ["inlet"], FACTS, CHANNELS) as record:
        beside = json.loads(record.beside.read_text())
        assert (beside["status"], beside["partial"]) == ("running", True)
    assert path.read_text() == ",".join(columns(["inlet"], CHANNELS)) + "\n"


def test_a_killed_writer_leaves_whole_rows_and_a_partial_label(tmp_path: Path) -> None:
    path = tmp_path / "record.csv"
    program = (
        "import os, signal, sys, pathlib\n"
        "import viscodesign.pump.sessions.record_file as r\n"
        "from tests.unit.pump.samples import sample\n"
        "r.FLUSH_INTERVAL_S = 0.0\n"
        "with r.recorded(pathlib.Path(sys.argv[1]), ['inlet'], {}, {}) as record:\n"
        "    for k in range(100):\n"
        "        record.add(0.1 * k, sample())\n"
        "    os.kill(os.getpid(), signal.SIGKILL)\n"
    )
    root = Path(__file__).resolve().parents[4]
    done = subprocess.run([sys.executable, "-c", program, str(path)], cwd=root, env=_paths(root))
    assert done.returncode == -signal.SIGKILL
    assert len(pd.read_csv(path)) == 100
    assert path.read_text().endswith("\n")
    assert json.loads(path.with_suffix(".json").read_text())["partial"] is True


def _paths(root: Path) -> dict[str, str]:
    return os.environ | {"PYTHONPATH": str(root)}


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_a_full_disk_is_one_error_with_a_remedy(tmp_path: Path) -> None:
    path = tmp_path / "record.csv"
    path.symlink_to("/dev/full")
    with (
        pytest.raises(OutputError, match="No space left"),
        recorded(path, ["inlet"], FACTS, CHANNELS),
    ):
        pass


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_a_disk_that_fills_up_during_a_run_is_not_a_usage_error(tmp_path: Path) -> None:
    path = tmp_path / "record.csv"

    def fill() -> None:
        with FileIO("/dev/full", "w") as full, recorded(path, ["inlet"], FACTS, CHANNELS) as record:
            record.table = full
            record.add(0.0, sample())
            record.flush()

    with pytest.raises(RecordingError, match="No space left") as raised:
        fill()
    assert raised.value.exit_code == 4


def test_a_disk_that_fills_up_keeps_whole_rows_and_a_label(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "record.csv"
    monkeypatch.setattr("viscodesign.pump.sessions.record_file.FLUSH_INTERVAL_S", 0.0)
    with recorded(path, ["inlet"], FACTS, CHANNELS) as record:
        record.add(0.0, sample())
        monkeypatch.setattr(record, "table", FullDisk(record.table))
        with pytest.raises(RecordingError, match="No space left"):
            record.add(0.1, sample())
        record.state("stopped", rule="record")
    assert len(pd.read_csv(path)) == 1
    beside = json.loads(path.with_suffix(".json").read_text())
    assert (beside["status"], beside["partial"], beside["rule"]) == ("stopped", True, "record")


def test_rows_are_flushed_once_a_second(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    now = [0.0]
    monkeypatch.setattr("viscodesign.pump.sessions.record_file.time.monotonic", lambda: now[0])
    path = tmp_path / "record.csv"
    with recorded(path, ["inlet"], FACTS, CHANNELS) as record:
        record.add(0.0, sample())
        assert len(path.read_text().splitlines()) == 1
        now[0] += FLUSH_INTERVAL_S
        record.add(0.1, sample())
        assert len(path.read_text().splitlines()) == 3


def test_an_interrupted_record_is_kept(tmp_path: Path) -> None:
    path = tmp_path / "record.csv"

    def work() -> None:
        with recorded(path, ["inlet"], FACTS, CHANNELS) as record:
            record.add(0.0, sample())
            raise KeyError

    with pytest.raises(KeyError):
        work()
    assert len(path.read_text().splitlines()) == 2


def test_only_a_table_that_holds_something_is_kept(tmp_path: Path) -> None:
    table = tmp_path / "record.csv"
    table.touch()  # as a full disk leaves it before anything has moved
    refuse_measured(table, force=False)
    table.write_text("time_s\n")
    with pytest.raises(UsageError, match="--force"):
        refuse_measured(table, force=False)
