"""The files of several actuators: a folder for each, and what concerns all."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from pathlib import Path

from viscodesign.report.csv_text import csv_rows, csv_table
from viscodesign.report.folder import (
    PAGE,
    RUN_TABLES,
    SEVERAL_PICTURE,
    SUMMARY,
    draw_picture,
    in_every_format,
    json_bytes,
    prepare_folder,
    remove_files,
    text_bytes,
)
from viscodesign.report.page.several_page import write_several_page
from viscodesign.report.picture_options import AS_USUAL, PictureOptions
from viscodesign.report.run_folder import write_run
from viscodesign.results.several_runs import SeveralRuns
from viscodesign.storage.atomic_files import write_all, write_bytes


def write_several(
    found: SeveralRuns,
    directory: str | Path,
    *,
    plots: bool = True,
    report: bool = True,
    force: bool = False,
    pictures: PictureOptions = AS_USUAL,
) -> list[Path]:
    """Write one folder for each actuator, as `write_run` does, and beside them what all share.

    `trajectory.csv` has the columns of every actuator after its name, `tips.png` the paths of all
    tips; the summary comes last. Raises `UsageError` where the folder cannot be written, or
    (without ``force``) holds files that are not ours.
    """
    folder = prepare_folder(directory, force=force)
    table, _, spec = RUN_TABLES
    contents = {
        folder / table: list(_lines(found)),
        folder / spec: [text_bytes(found.spec_text)],
    }
    old = [
        folder / SUMMARY,
        folder / PAGE,
        *(folder / name for name in in_every_format([SEVERAL_PICTURE])),
    ]
    write_all(contents, first=lambda: remove_files(old))
    files = list(contents)
    for name, run in found.runs.items():
        own = {"plots": plots, "report": report, "force": force}
        files += write_run(run, folder / name, **own, pictures=pictures)
    if plots and found.runs:
        files.append(draw_picture(partial(draw_tips, found), folder / SEVERAL_PICTURE, pictures))
    if report:
        files.append(write_several_page(found, folder / PAGE))
    write_bytes(folder / SUMMARY, json_bytes(found.summary()))
    return [*files, folder / SUMMARY]


def draw_tips(found: SeveralRuns, to: Path) -> None:
    """Draw `tips.png`."""
    # Drawing is slow to import, and runs without pictures do not need it.
    from viscodesign.report.charts.several_tips import draw_several_tips

    draw_several_tips(found, to)


def _lines(found: SeveralRuns) -> Iterator[bytes]:
    names, values = found.table()
    yield csv_table(names, [])
    yield csv_rows(values).replace(b"NaN", b"")
