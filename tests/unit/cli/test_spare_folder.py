"""What was computed is kept, also where the folder that was asked for takes no more."""

from __future__ import annotations

import errno
import json
import os
import re
import tempfile
from pathlib import Path

import pytest

from tests.fuzz.commands import run_command
from tests.scenes import CONFIGS
from viscodesign.cli.spare_folder import written
from viscodesign.errors import OutputError, UsageError
from viscodesign.storage import atomic_files

SPEC = str(CONFIGS / "leg_4_air.yaml")
SHORT = ["--set", "run={duration: 0.2 s, output_interval: 0.1 s}", "--no-verify", "--no-plots"]


def fill(monkeypatch: pytest.MonkeyPatch, *folders: Path) -> None:
    """Let disks be full: no file appears below these folders."""
    real = os.replace

    def replace(source: str, target: Path) -> None:
        if target.name != ".write-test" and any(f in Path(target).parents for f in folders):
            raise OSError(errno.ENOSPC, "No space left on device")
        real(source, target)

    monkeypatch.setattr(atomic_files.os, "replace", replace)


@pytest.fixture
def spare(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The system's folder for temporary files."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    return folder


def test_a_run_that_finds_no_room_is_kept_elsewhere(
    tmp_path: Path, spare: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fill(monkeypatch, tmp_path / "full")
    found = run_command(["simulate", SPEC, *SHORT, "-o", str(tmp_path / "full" / "leg"), "--json"])
    assert found.code == 3
    error = json.loads(found.out)["error"]
    assert (error["type"], error["exit_code"]) == ("output", 3)
    place = re.search(r"the results are in (\S+) instead", error["message"])
    assert place is not None
    folder = Path(place[1])
    assert folder.parent == spare
    assert {"trajectory.csv", "summary.json", "report.html"} <= {f.name for f in folder.iterdir()}
    assert not (tmp_path / "full" / "leg").exists()


def test_no_room_anywhere_says_so_and_leaves_nothing(
    tmp_path: Path, spare: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fill(monkeypatch, tmp_path)
    found = run_command(["simulate", SPEC, *SHORT, "-o", str(tmp_path / "leg")])
    assert found.code == 3
    assert "nothing could be kept elsewhere: cannot write" in found.err
    assert not list(spare.iterdir())


def test_a_folder_that_is_gone_after_all_that_work_is_no_wrong_usage(
    tmp_path: Path, spare: Path
) -> None:
    def write(folder: Path) -> str:
        if folder.name == "gone":
            raise UsageError("cannot write gone: the share is not there")
        return folder.name

    with pytest.raises(OutputError, match=r"(?s)the share is not there.*the results are in"):
        written(write, tmp_path / "gone")
    assert len(list(spare.iterdir())) == 1
    assert written(write, tmp_path / "there") == "there"


@pytest.mark.parametrize(
    "command", ["sweep", "sensitivity", "reach", "design", "fit", "accuracy", "compare"]
)
def test_every_command_that_computes_for_long_writes_so(command: str) -> None:
    code = (Path(__file__).parents[3] / "viscodesign" / "cli" / f"{command}.py").read_text()
    assert re.search(r"= written\(\s*lambda place: write_", code)
