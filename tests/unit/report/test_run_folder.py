"""A run's folder: every file whole or absent, never two runs in one."""

from __future__ import annotations

import csv
import errno
import io
import json
import os
import signal
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import IO, Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from tests.trajectories import ablated_run
from tests.unit.report.conftest import Made
from viscodesign.errors import OutputError, UsageError
from viscodesign.report import run_folder as files
from viscodesign.report.csv_text import csv_rows, csv_table
from viscodesign.report.folder import (
    EFFECTS_PICTURE,
    PAGE,
    RUN_PICTURES,
    RUN_TABLES,
    prepare_folder,
)
from viscodesign.report.run_folder import write_run
from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.atomic_files import write_bytes


def names(folder: Path) -> set[str]:
    return {file.name for file in folder.iterdir()}


def fill_disk(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    """Let the disk be full while the file ``name`` is written."""
    real = os.fdopen

    class Full(io.RawIOBase):
        def write(self, _: Any) -> int:
            raise OSError(errno.ENOSPC, "No space left on device")

        def writable(self) -> bool:
            return True

    opened = []
    make = tempfile.mkstemp

    def mkstemp(**where: Any) -> tuple[int, str]:
        opened.append(where["prefix"])
        return make(**where)

    def fdopen(handle: int, mode: str) -> IO[Any]:
        if opened[-1] != f".{name}.":
            return real(handle, mode)
        os.close(handle)
        return Full()  # type: ignore[return-value]

    monkeypatch.setattr(tempfile, "mkstemp", mkstemp)
    monkeypatch.setattr(os, "fdopen", fdopen)


@pytest.fixture
def sketched(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pictures that cost no time."""

    def sketch(_: Trajectory, folder: Path, *_others: object) -> list[Path]:
        for name in RUN_PICTURES:
            write_bytes(folder / name, b"a picture")
        return [folder / name for name in RUN_PICTURES]

    monkeypatch.setattr(files, "draw_run", sketch)


def test_all_files_are_written_and_returned_in_order(run: Trajectory, tmp_path: Path) -> None:
    written = write_run(run, tmp_path / "deep" / "run")
    assert [file.name for file in written] == [*RUN_TABLES, *RUN_PICTURES, PAGE, "summary.json"]
    assert names(tmp_path / "deep" / "run") == {*RUN_TABLES, *RUN_PICTURES, PAGE, "summary.json"}
    assert (written[2]).read_text() == run.spec_text
    assert json.loads(written[-1].read_text())["name"] == run.name


def test_files_may_be_read_by_those_who_may_read_new_files(run: Trajectory, tmp_path: Path) -> None:
    (tmp_path / "plain").write_text("")
    for file in write_run(run, tmp_path / "run", plots=False):
        assert file.stat().st_mode == (tmp_path / "plain").stat().st_mode


@pytest.mark.parametrize("name", [*RUN_TABLES, *RUN_PICTURES, PAGE, "summary.json"])
@pytest.mark.usefixtures("sketched")
def test_a_full_disk_leaves_whole_files_alone(
    run: Trajectory, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    fill_disk(monkeypatch, name)
    with pytest.raises(OutputError, match=rf"{name}: No space.*Free some space"):
        write_run(run, tmp_path)
    order = [*RUN_PICTURES, PAGE, "summary.json"]
    expected = {*RUN_TABLES, *order[: order.index(name)]} if name in order else set()
    assert names(tmp_path) == expected


@pytest.mark.parametrize("name", RUN_TABLES)
def test_an_old_run_survives_tables_that_do_not_fit(
    made: Made, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    write_run(made(name="old"), tmp_path, plots=False)
    before = {file.name: file.read_bytes() for file in tmp_path.iterdir()}
    fill_disk(monkeypatch, name)
    with pytest.raises(OutputError):
        write_run(made(name="new", bellows=2), tmp_path)
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir()} == before


@pytest.mark.usefixtures("sketched")
def test_an_interrupt_while_drawing_keeps_the_tables_but_no_summary(
    run: Trajectory, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_run(run, tmp_path)

    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(files, "draw_run", stop)
    with pytest.raises(KeyboardInterrupt):
        write_run(run, tmp_path)
    assert names(tmp_path) == set(RUN_TABLES)
    assert write_run(run, tmp_path, plots=False)


def test_an_interrupt_while_tables_are_written_waits_for_them_and_the_summary(
    run: Trajectory, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(values: np.ndarray) -> bytes:
        os.kill(os.getpid(), signal.SIGINT)
        monkeypatch.undo()
        return csv_rows(values)

    monkeypatch.setattr(files, "csv_rows", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write_run(run, tmp_path)
    assert names(tmp_path) == {*RUN_TABLES, "summary.json"}
    assert len((tmp_path / "trajectory.csv").read_text().splitlines()) == len(run.time) + 1


def test_an_old_page_goes_when_none_is_made(run: Trajectory, tmp_path: Path) -> None:
    write_run(run, tmp_path, plots=False)
    assert PAGE in names(tmp_path)
    write_run(run, tmp_path, plots=False, report=False)
    assert names(tmp_path) == {*RUN_TABLES, "summary.json"}


@pytest.mark.usefixtures("sketched")
def test_old_pictures_go_when_none_are_drawn(run: Trajectory, tmp_path: Path) -> None:
    write_run(run, tmp_path)
    (tmp_path / "notes.txt").write_text("kept beside a run")
    write_run(run, tmp_path, plots=False)
    assert names(tmp_path) == {*RUN_TABLES, PAGE, "summary.json", "notes.txt"}


def test_effects_are_drawn_only_where_they_were_measured(run: Trajectory, tmp_path: Path) -> None:
    written = write_run(ablated_run(), tmp_path)
    assert [file.name for file in written] == [
        *RUN_TABLES,
        *RUN_PICTURES,
        EFFECTS_PICTURE,
        PAGE,
        "summary.json",
    ]
    assert (tmp_path / EFFECTS_PICTURE).read_bytes().startswith(b"\x89PNG")
    assert EFFECTS_PICTURE not in {file.name for file in write_run(run, tmp_path)}
    assert names(tmp_path) == {*RUN_TABLES, *RUN_PICTURES, PAGE, "summary.json"}


def test_an_old_picture_of_effects_is_removed_when_none_is_drawn(tmp_path: Path) -> None:
    write_run(ablated_run(), tmp_path)
    write_run(ablated_run(), tmp_path, plots=False)
    assert names(tmp_path) == {*RUN_TABLES, PAGE, "summary.json"}


def test_a_picture_of_effects_alone_is_accepted(tmp_path: Path) -> None:
    (tmp_path / EFFECTS_PICTURE).write_bytes(b"a picture")
    assert prepare_folder(tmp_path) == tmp_path


def test_a_folder_with_other_files_is_refused(run: Trajectory, tmp_path: Path) -> None:
    for name in ("a.txt", "b", "c.csv", "d"):
        (tmp_path / name).write_text("mine")
    with pytest.raises(UsageError, match=r"\(a\.txt, b, c\.csv, \.\.\.\).*-o DIR, or --force"):
        write_run(run, tmp_path, plots=False)
    assert names(tmp_path) == {"a.txt", "b", "c.csv", "d"}
    write_run(run, tmp_path, plots=False, force=True)
    assert (tmp_path / "c.csv").read_text() == "mine"


def test_a_place_that_cannot_be_a_folder_is_refused(tmp_path: Path) -> None:
    (tmp_path / "run").write_text("")
    with pytest.raises(UsageError, match=r"is a file; the run needs a folder\. Use -o DIR"):
        prepare_folder(tmp_path / "run")
    with pytest.raises(UsageError, match="Part of the path is a file"):
        prepare_folder(tmp_path / "run" / "below")
    with pytest.raises(UsageError, match="shorter name"):
        prepare_folder(tmp_path / ("x" * 300))


def test_a_folder_that_is_read_only_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(**_: Any) -> tuple[int, str]:
        raise OSError(errno.EROFS, "Read-only file system")

    monkeypatch.setattr(tempfile, "mkstemp", refuse)
    with pytest.raises(UsageError, match=r"Read-only file system\. Use a writable folder"):
        prepare_folder(tmp_path)


def test_a_table_is_read_back_to_the_last_digit(run: Trajectory) -> None:
    values = np.array([[0.1 + 0.2, 1e-300], [-0.0, 1 / 3]])
    lines = (csv_table(["plain", 'a "quoted", name'], []) + csv_rows(values)).decode().splitlines()
    rows = list(csv.reader(lines))
    assert rows[0] == ["plain", 'a "quoted", name']
    assert np.array_equal(np.array(rows[1:], dtype=float), values)


@given(values=arrays(np.float64, (5, 3), elements=st.floats(allow_nan=True, allow_infinity=True)))
def test_every_number_of_a_table_is_read_back_to_the_last_bit(values: np.ndarray) -> None:
    rows = csv.reader(csv_rows(values).decode().splitlines())
    read = np.array([[float(cell) for cell in row] for row in rows])
    assert np.array_equal(read, values, equal_nan=True)
    assert np.array_equal(np.signbit(read), np.signbit(values) & ~np.isnan(values))


def test_a_table_may_have_no_rows() -> None:
    assert csv_rows(np.zeros((0, 3))) == b""


def test_a_lone_surrogate_in_a_name_is_escaped(made: Made, tmp_path: Path) -> None:
    write_run(made(name="leg \ud800"), tmp_path)
    assert json.loads((tmp_path / "summary.json").read_text())["name"] == "leg \ud800"


def test_writing_needs_neither_data_frames_nor_a_window(run: Trajectory, tmp_path: Path) -> None:
    code = (
        "import sys; from pathlib import Path\n"
        "from tests.trajectories import made_run\n"
        "from viscodesign.report.run_folder import write_run\n"
        f"write_run(made_run(), {str(tmp_path)!r})\n"
        "print({'pandas', 'matplotlib.pyplot', 'scipy'} & set(sys.modules))"
    )
    root = Path(__file__).parents[3]
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", code], cwd=root, capture_output=True, text=True
    )
    assert (done.stdout, done.stderr) == ("set()\n", "")
