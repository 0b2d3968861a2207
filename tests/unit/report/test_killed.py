"""A run that is killed at any moment leaves whole files, and nothing that stays."""

from __future__ import annotations

import io
import json
import os
import signal
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from tests.scenes import CONFIGS
from tests.trajectories import made_run
from viscodesign import load
from viscodesign.cli.main import main
from viscodesign.report import run_folder as files
from viscodesign.report.folder import PAGE, RUN_PICTURES, RUN_TABLES, prepare_folder
from viscodesign.report.run_folder import write_run
from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.atomic_files import replaced, write_bytes

EVERY = {*RUN_TABLES, *RUN_PICTURES, PAGE, "summary.json"}
MOMENTS = 6


def hidden(folder: Path) -> list[str]:
    return [file.name for file in folder.iterdir() if file.name.startswith(".")]


def table(content: bytes) -> np.ndarray:
    """All numbers of a CSV; it must end with a whole line."""
    assert content.endswith(b"\n")
    return np.loadtxt(io.BytesIO(content), delimiter=",", skiprows=1, ndmin=2)


def picture(content: bytes) -> None:
    Image.open(io.BytesIO(content)).load()


def assert_whole(folder: Path, rows: int, is_picture: Callable[[bytes], Any] = picture) -> None:
    """Every file that bears its name is whole, and where a summary stands so does all else."""
    found = {f.name: f.read_bytes() for f in folder.iterdir() if not f.name.startswith(".")}
    assert set(found) <= EVERY
    for name, content in found.items():
        if name == "summary.json":
            json.loads(content)
            assert set(found) == EVERY
        elif name == "trajectory.csv":
            assert len(table(content)) == rows
        elif name == "shape.csv":
            assert len(np.unique(table(content)[:, 0])) == rows
        elif name == "spec.yaml":
            assert content.endswith(b"\n")
        elif name == PAGE:
            assert content.endswith(b"</html>")
        else:
            is_picture(content)


def killed_at(moment: int, run: Trajectory, folder: Path) -> bool:
    """Write in a child that kills itself before its n-th touch of the disk; whether it did."""
    child = os.fork()
    if not child:
        left = iter(range(moment, -1, -1))

        def mortal(act: Callable[..., Any]) -> Callable[..., Any]:
            def before(*given: Any, **named: Any) -> Any:
                if not next(left):
                    os.kill(os.getpid(), signal.SIGKILL)
                return act(*given, **named)

            return before

        os.replace, os.chmod, os.unlink = (mortal(f) for f in (os.replace, os.chmod, os.unlink))
        tempfile.mkstemp, Path.unlink = mortal(tempfile.mkstemp), mortal(Path.unlink)  # type: ignore[method-assign]
        files.csv_rows = mortal(files.csv_rows)  # type: ignore[assignment]
        try:
            write_run(run, folder)
        finally:
            os._exit(0)
    _, status = os.waitpid(child, 0)
    return os.WIFSIGNALED(status)


@pytest.mark.filterwarnings("ignore:.*multi-threaded, use of fork:DeprecationWarning")
def test_a_writer_killed_between_any_two_steps_leaves_whole_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def sketch(_: Trajectory, folder: Path, *__: object) -> list[Path]:
        for name in RUN_PICTURES:
            write_bytes(folder / name, b"a picture")
        return [folder / name for name in RUN_PICTURES]

    def is_sketch(content: bytes) -> None:
        assert content == b"a picture"

    monkeypatch.setattr(files, "draw_run", sketch)
    run = made_run(bellows=2, time=np.linspace(0.0, 1.0, 21))
    moment = 0
    while killed_at(moment, run, tmp_path):
        assert_whole(tmp_path, 21, is_sketch)
        assert len(hidden(tmp_path)) <= len(RUN_TABLES)  # of this writer; those before are cleared
        moment += 1
    assert moment > 20
    assert {file.name for file in tmp_path.iterdir()} == EVERY


def started(words: list[str]) -> int:
    """A child that runs one command line and nothing else: the modules are loaded already."""
    child = os.fork()
    if not child:
        status = 70
        try:
            status = main(words)
        finally:
            os._exit(status)
    return child


def finish(child: int) -> None:
    assert os.waitpid(child, 0)[1] == 0


def kill_after(child: int, seconds: float) -> None:
    """Kill it, unless it ends by itself before."""
    limit = time.monotonic() + seconds
    while time.monotonic() < limit:
        if os.waitpid(child, os.WNOHANG)[0]:
            return
        time.sleep(0.002)
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)


@pytest.mark.filterwarnings("ignore:.*multi-threaded, use of fork:DeprecationWarning")
def test_a_command_killed_at_any_time_leaves_whole_files(tmp_path: Path) -> None:
    words = ["simulate", "-q", "--no-verify", "-o", str(tmp_path)]
    words += [str(CONFIGS / "leg_16_straight_air.yaml"), "--set", "run.duration=2 s"]
    assert main(words) == 0
    began = time.monotonic()
    finish(started(words))
    whole = time.monotonic() - began
    for moment in range(1, MOMENTS + 1):
        kill_after(started(words), whole * moment / MOMENTS)
        assert_whole(tmp_path, 101)
    finish(started(words))
    assert {file.name for file in tmp_path.iterdir()} == EVERY
    assert load(tmp_path / "spec.yaml").run.duration == 2.0


def test_a_living_writers_file_is_not_cleared(tmp_path: Path) -> None:
    with replaced(tmp_path / "shape.csv") as file:
        file.write(b"half")
        prepare_folder(tmp_path)
        assert len(hidden(tmp_path)) == 1
    assert (tmp_path / "shape.csv").read_bytes() == b"half"


def test_only_leftovers_of_a_run_are_cleared(tmp_path: Path) -> None:
    for name in (".shape.csv.ab12_xyz", "..write-test.ab12_xyz"):
        (tmp_path / name).write_text("half")
    for name in (".notes.txt.ab12_xyz", ".shape.csv.backup", ".hidden"):
        (tmp_path / name).write_text("somebody's")
    prepare_folder(tmp_path)
    assert set(hidden(tmp_path)) == {".notes.txt.ab12_xyz", ".shape.csv.backup", ".hidden"}
