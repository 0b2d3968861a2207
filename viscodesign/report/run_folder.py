"""The files of a run."""

from __future__ import annotations

import time as clock
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import numpy as np

from viscodesign.interrupt import StopRequest, gentle_interrupt
from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.csv_text import csv_rows, csv_table
from viscodesign.report.folder import (
    BAND_TABLE,
    EFFECTS_PICTURE,
    PAGE,
    RUN_PICTURES,
    RUN_TABLES,
    SUMMARY,
    draw_picture,
    in_every_format,
    json_bytes,
    prepare_folder,
    remove_files,
    text_bytes,
)
from viscodesign.report.picture_options import AS_USUAL, PictureOptions
from viscodesign.results.channels import shape_columns, trajectory_columns
from viscodesign.results.coefficient_band import BAND_COLUMNS, CoefficientBand
from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.atomic_files import write_all, write_bytes
from viscodesign.storage.disk_arrays import DISK_ROWS, blocks


@dataclass(frozen=True)
class WrittenRun:
    """The files of a run, and the run as its summary describes it."""

    files: list[Path]
    trajectory: Trajectory


def write_run(
    trajectory: Trajectory,
    directory: str | Path,
    *,
    plots: bool = True,
    report: bool = True,
    force: bool = False,
    pictures: PictureOptions = AS_USUAL,
) -> list[Path]:
    """Write a run's files and return them, as `write_timed` does."""
    return write_timed(
        trajectory,
        directory,
        plots=plots,
        report=report,
        force=force,
        pictures=pictures,
    ).files


def write_timed(
    trajectory: Trajectory,
    directory: str | Path,
    *,
    plots: bool = True,
    report: bool = True,
    force: bool = False,
    pictures: PictureOptions = AS_USUAL,
) -> WrittenRun:
    """Write a run's files, and how long that took; an earlier run's are replaced or removed.

    Tables come first, all or none, so that a failing picture cannot lose them; the summary
    comes last: a folder that holds one is complete. ``plots`` and ``report`` ask for pictures and
    page. An interrupt leaves out those that are not yet begun, and raises `KeyboardInterrupt`
    when all else is written. Raises `OutputError` where the disk is full, `UsageError` where the
    folder cannot be written, or (without ``force``) holds files that are not ours.
    """
    began = clock.perf_counter()
    folder = prepare_folder(directory, force=force)
    contents = {
        folder / name: lines
        for name, lines in zip(
            RUN_TABLES,
            (
                trajectory_lines(trajectory),
                shape_lines(trajectory),
                [text_bytes(trajectory.spec_text)],
            ),
            strict=True,
        )
    }
    if trajectory.uncertainty is not None:
        contents[folder / BAND_TABLE] = band_lines(trajectory.uncertainty)
    summary = folder / SUMMARY
    drawn = in_every_format([*RUN_PICTURES, EFFECTS_PICTURE])
    old = [summary, *(folder / name for name in (*drawn, PAGE, BAND_TABLE))]
    # A run that took long to solve may take a while to write: it is not lost for an interrupt.
    with gentle_interrupt() as interrupt:
        write_all(contents, first=lambda: remove_files(old))
        drawings = list(draw_run(trajectory, folder, pictures, interrupt)) if plots else []
        if report and not interrupt.asked:
            drawings.append(_write_page(trajectory, folder / PAGE))
        told = trajectory.with_time(write_s=clock.perf_counter() - began)
        write_bytes(summary, json_bytes(told.summary()))
    if interrupt.asked:
        raise KeyboardInterrupt
    return WrittenRun([*contents, *drawings, summary], told)


def draw_run(
    trajectory: Trajectory,
    folder: Path,
    options: PictureOptions,
    interrupt: StopRequest | None = None,
) -> Iterator[Path]:
    """Draw the pictures of a run one by one, until an interrupt; yields the files, in order."""
    if interrupt is not None and interrupt.asked:
        return
    # Drawing is slow to import, and a run without pictures does not need it.
    from viscodesign.report.charts.effects import draw_effects
    from viscodesign.report.charts.pressures import draw_pressures
    from viscodesign.report.charts.shapes import draw_shapes
    from viscodesign.report.charts.tip import draw_tip

    drawers = dict(zip(RUN_PICTURES, (draw_tip, draw_pressures, draw_shapes), strict=True))
    if trajectory.proof:
        drawers[EFFECTS_PICTURE] = draw_effects
    for name, draw in drawers.items():
        if interrupt is not None and interrupt.asked:
            return
        yield draw_picture(partial(draw, trajectory), folder / name, options)


def _write_page(trajectory: Trajectory, file: Path) -> Path:
    from viscodesign.report.page.page import write_page

    return write_page(trajectory, file)


def band_lines(band: CoefficientBand) -> Iterator[bytes]:
    """`uncertainty.csv`."""
    yield csv_table(BAND_COLUMNS, [])
    yield csv_rows(np.column_stack([band.time, band.deviation, band.covariance[:, 2]]))


def trajectory_lines(trajectory: Trajectory) -> Iterator[bytes]:
    """`trajectory.csv`, block by block."""
    names, _ = trajectory_columns(trajectory, slice(0))
    yield csv_table(names, [])
    for rows in blocks(len(trajectory.time), *trajectory.arrays.values()):
        yield csv_rows(trajectory_columns(trajectory, rows)[1])


def shape_lines(trajectory: Trajectory) -> Iterator[bytes]:
    """`shape.csv`, block by block."""
    names, _ = shape_columns(trajectory, slice(0))
    yield csv_table(names, [])
    for rows in blocks(len(trajectory.shape), trajectory.shape, rows=DISK_ROWS // 32):
        yield csv_rows(shape_columns(trajectory, rows)[1])
