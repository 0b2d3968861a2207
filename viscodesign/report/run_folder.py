"""The folder of a run."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from viscodesign.errors import UsageError
from viscodesign.interrupt import gentle_interrupt
from viscodesign.results.channels import shape_columns, trajectory_columns
from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.atomic_files import refused_plainly, write_all, write_bytes
from viscodesign.storage.disk_arrays import BLOCK, blocks
from viscodesign.storage.leftovers import clear_leftovers

TABLES = ("trajectory.csv", "shape.csv", "spec.yaml")
PICTURES = ("tip.png", "pressures.png", "shapes.png")
PROOF_PICTURE = "effects.png"
"""Drawn where a run measured its effects."""
SUMMARY = "summary.json"
STUDY_FILES = ("accuracy.csv", "accuracy.json", "accuracy.png")
"""Of a study of accuracy, which may share the folder; a run leaves them alone."""
PLAN_FILES = ("plan.csv", "plan.json", "plan.png")
"""Of a plan of the pump, which may share it too."""
OURS = {*TABLES, *PICTURES, PROOF_PICTURE, SUMMARY, *STUDY_FILES, *PLAN_FILES}
LAST_WRITTEN = {SUMMARY, STUDY_FILES[1], PLAN_FILES[1]}
"""Documents of which one at least is in every folder of ours."""


def write_run(
    trajectory: Trajectory, directory: str | Path, *, plots: bool = True, force: bool = False
) -> list[Path]:
    """Write a run's files and return them; an earlier run's files are replaced or removed.

    Tables come first, all or none, so that no trouble with a picture can lose them;
    the summary comes last: a folder that holds one is whole. Raises `UsageError` where
    the folder cannot be written, or holds other files than a run's (without ``force``).
    """
    folder = prepare_folder(directory, force=force)
    contents = (
        trajectory_lines(trajectory),
        shape_lines(trajectory),
        [text_bytes(trajectory.spec_text)],
    )
    tables = [folder / name for name in TABLES]
    summary = folder / SUMMARY
    old = [summary, *(folder / name for name in (*PICTURES, PROOF_PICTURE))]
    with gentle_interrupt() as interrupt:
        write_all(dict(zip(tables, contents, strict=True)), first=lambda: _remove(old))
    if interrupt.asked:
        # What took long to solve may take a while to write: it is not given up for that.
        raise KeyboardInterrupt
    pictures = _draw(trajectory, folder) if plots else []
    document = json.dumps(trajectory.summary(), indent=2, ensure_ascii=False)
    write_bytes(summary, text_bytes(document + "\n"))
    return [*tables, *pictures, summary]


def _remove(files: list[Path]) -> None:
    for file in files:
        with refused_plainly(file):
            file.unlink(missing_ok=True)


def _draw(trajectory: Trajectory, folder: Path) -> list[Path]:
    """Draw what there is to draw; the files, in order."""
    # Drawing is slow to import, and a run without pictures does not need it.
    from viscodesign.report.charts.effects import draw_effects
    from viscodesign.report.charts.pressures import draw_pressures
    from viscodesign.report.charts.shapes import draw_shapes
    from viscodesign.report.charts.tip import draw_tip

    drawers = dict(zip(PICTURES, (draw_tip, draw_pressures, draw_shapes), strict=True))
    if trajectory.proof:
        drawers[PROOF_PICTURE] = draw_effects
    for name, draw in drawers.items():
        draw(trajectory, folder / name)
    return [folder / name for name in drawers]


def prepare_folder(directory: str | Path, *, force: bool = False) -> Path:
    """Make the folder, and refuse one that holds what is not a run's.

    A command calls it before it computes, so that a bad place costs no time.
    """
    folder = Path(directory)
    with refused_plainly(folder):
        if folder.exists() and not folder.is_dir():
            raise UsageError(f"{folder} is a file; the run needs a folder. Use -o DIR")
        folder.mkdir(parents=True, exist_ok=True)
        names = sorted(file.name for file in folder.iterdir())
    strangers = [name for name in names if not _is_ours(name)]
    if strangers and not force and not LAST_WRITTEN & set(names):
        shown = ", ".join(strangers[:3]) + (", ..." if len(strangers) > 3 else "")
        raise UsageError(
            f"{folder} holds other files ({shown}); nothing was written. "
            "Use another folder with -o DIR, or --force"
        )
    _try_writing(folder)
    clear_leftovers(folder, [*OURS, PROBE])
    return folder


PROBE = ".write-test"


def _try_writing(folder: Path) -> None:
    probe = folder / PROBE
    write_bytes(probe, b"")
    _remove([probe])


def _is_ours(name: str) -> bool:
    return name in OURS or name.startswith(".")


def trajectory_lines(trajectory: Trajectory) -> Iterator[bytes]:
    """`trajectory.csv`, block by block."""
    names, _ = trajectory_columns(trajectory, slice(0))
    yield csv_head(names)
    for rows in blocks(len(trajectory.time), *trajectory.arrays.values()):
        yield csv_rows(trajectory_columns(trajectory, rows)[1])


def shape_lines(trajectory: Trajectory) -> Iterator[bytes]:
    """`shape.csv`, block by block."""
    names, _ = shape_columns(trajectory, slice(0))
    yield csv_head(names)
    for rows in blocks(len(trajectory.shape), trajectory.shape, rows=BLOCK // 32):
        yield csv_rows(shape_columns(trajectory, rows)[1])


def csv_text(names: list[str], values: np.ndarray) -> bytes:
    """A table with every digit, so that reading it gives the same numbers."""
    return csv_head(names) + csv_rows(values)


def csv_head(names: list[str]) -> bytes:
    """The names of a table's columns."""
    header = io.StringIO()
    # A name may hold a comma or a quote; a number never does.
    csv.writer(header, lineterminator="\n").writerow(names)
    return text_bytes(header.getvalue())


def csv_rows(values: np.ndarray) -> bytes:
    """Rows (n, columns), each a line."""
    return "".join([",".join(map(repr, row)) + "\n" for row in values.tolist()]).encode()


def text_bytes(text: str) -> bytes:
    """UTF-8; half a surrogate pair, which has no code there, as its escape."""
    return text.encode("utf-8", errors="backslashreplace")
