"""The folder of a run."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from viscodesign.errors import UsageError
from viscodesign.report.atomic import write_bytes
from viscodesign.report.tables import shape_columns, summary_document, trajectory_columns
from viscodesign.trajectory import Trajectory

TABLES = ("trajectory.csv", "shape.csv", "spec.yaml")
PICTURES = ("tip.png", "pressures.png", "shapes.png")
SUMMARY = "summary.json"
OURS = {*TABLES, *PICTURES, SUMMARY}


def write_run(
    trajectory: Trajectory, directory: str | Path, *, plots: bool = True, force: bool = False
) -> list[Path]:
    """Write a run's files; an earlier run's are replaced, other files only with ``force``.

    The summary goes first out and last in: a folder that holds one is whole.
    Raises `UsageError` where the folder cannot be written.
    """
    folder = prepare_folder(directory, force=force)
    (folder / SUMMARY).unlink(missing_ok=True)
    for name in PICTURES:
        (folder / name).unlink(missing_ok=True)
    write_bytes(folder / "trajectory.csv", csv_text(*trajectory_columns(trajectory)))
    write_bytes(folder / "shape.csv", csv_text(*shape_columns(trajectory)))
    write_bytes(folder / "spec.yaml", trajectory.spec_text.encode())
    written = [folder / name for name in TABLES]
    if plots:
        written += _draw(trajectory, folder)
    document = json.dumps(summary_document(trajectory), indent=2, ensure_ascii=False)
    write_bytes(folder / SUMMARY, (document + "\n").encode())
    return [*written, folder / SUMMARY]


def _draw(trajectory: Trajectory, folder: Path) -> list[Path]:
    # Drawing is slow to import, and a run without pictures does not need it.
    from viscodesign.report.pressures import draw_pressures
    from viscodesign.report.shapes import draw_shapes
    from viscodesign.report.tip import draw_tip

    drawers = dict(zip(PICTURES, (draw_tip, draw_pressures, draw_shapes), strict=True))
    for name, draw in drawers.items():
        draw(trajectory, folder / name)
    return [folder / name for name in drawers]


def prepare_folder(directory: str | Path, *, force: bool = False) -> Path:
    """Make the folder, and refuse one that holds what is not a run's.

    A command calls it before it computes, so that a bad place costs no time.
    """
    folder = Path(directory)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        strangers = sorted(f.name for f in folder.iterdir() if not _is_ours(f.name))
    except FileExistsError as error:
        raise UsageError(f"{folder} is a file; the run needs a folder. Use -o DIR") from error
    except OSError as error:
        reason = error.strerror or str(error)
        raise UsageError(f"cannot write to {folder}: {reason}. Use another -o DIR") from error
    if strangers and not force and not (folder / SUMMARY).exists():
        shown = ", ".join(strangers[:3]) + (", ..." if len(strangers) > 3 else "")
        raise UsageError(
            f"{folder} holds other files ({shown}); nothing was written. "
            "Use another folder with -o DIR, or --force"
        )
    write_bytes(folder / ".write-test", b"")
    (folder / ".write-test").unlink()
    return folder


def _is_ours(name: str) -> bool:
    return name in OURS or name.startswith(".")


def csv_text(names: list[str], values: np.ndarray) -> bytes:
    """A table with every digit, so that reading it gives the same numbers."""
    lines = [",".join(names)]
    lines += [",".join(map(repr, row)) for row in values.tolist()]
    return ("\n".join(lines) + "\n").encode()
