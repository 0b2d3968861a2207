"""The files of a gait: `walk`."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from pathlib import Path

import numpy as np

from viscodesign.report.csv_text import csv_rows, csv_table
from viscodesign.report.folder import (
    LEGS_TABLE,
    PAGE,
    SPEC,
    SUMMARY,
    WALK_PICTURE,
    WALK_TABLE,
    json_bytes,
    prepare_folder,
    text_bytes,
    write_with_picture,
)
from viscodesign.report.page.gait_page import write_gait_page
from viscodesign.report.picture_options import AS_USUAL, PictureOptions
from viscodesign.results.robot_motion import RobotMotion
from viscodesign.results.walk_study import WalkStudy


def write_walk(
    study: WalkStudy,
    directory: str | Path,
    *,
    plots: bool = True,
    report: bool = True,
    force: bool = False,
    pictures: PictureOptions = AS_USUAL,
) -> list[Path]:
    """Write a gait's files and return them; those of an earlier one are replaced."""
    folder = prepare_folder(directory, force=force)
    contents = {
        folder / WALK_TABLE: _table(_columns(study.motion)),
        folder / LEGS_TABLE: _table(_leg_columns(study.motion)),
        folder / SUMMARY: [json_bytes(study.document())],
        folder / SPEC: [text_bytes(study.spec_text)],
    }

    page, picture = folder / PAGE, folder / WALK_PICTURE
    draw = partial(draw_gait, study) if plots else None
    files = write_with_picture(contents, picture, draw, pictures, [page])
    return [*files, write_gait_page(study, page)] if report else files


def draw_gait(study: WalkStudy, path: Path) -> None:
    """Draw `walk.png`."""
    # Drawing is slow to import, and a gait without a picture does not need it.
    from viscodesign.report.charts.walk import draw_walk

    draw_walk(study, path)


def _table(columns: Iterator[tuple[str, np.ndarray]]) -> list[bytes]:
    names, values = zip(*columns, strict=True)
    return [csv_table(names, ()), csv_rows(np.column_stack(values))]


def _leg_columns(motion: RobotMotion) -> Iterator[tuple[str, np.ndarray]]:
    """Names and values (R,) of where the ends of all sections are, from the hips on."""
    yield "time_s", motion.time[motion.rows]
    for k, name in enumerate(motion.legs):
        own = motion.axes[:, k]
        for j in range(own.shape[1]):
            if not np.isnan(own[0, j, 0]):
                yield f"{name}.p{j}_x_m", own[:, j, 0]
                yield f"{name}.p{j}_height_m", own[:, j, 1]


def _columns(motion: RobotMotion) -> Iterator[tuple[str, np.ndarray]]:
    """Names and values (R,) of the table's columns."""
    rows = motion.rows
    yield "time_s", motion.time[rows]
    for k, name in enumerate(("body_x_m", "body_height_m", "body_pitch_rad", "body_roll_rad")):
        yield name, motion.body[rows, k]
    for k, leg in enumerate(motion.legs):
        yield f"{leg}.foot_x_m", motion.feet[rows, k, 0]
        yield f"{leg}.foot_gap_m", motion.feet[rows, k, 1]
        yield f"{leg}.normal_force_n", motion.normal[rows, k]
        yield f"{leg}.friction_force_n", motion.friction[rows, k]
    for k, source in enumerate(motion.sources):
        yield f"{source}.gauge_pressure_pa", motion.pressure[rows, k]
        yield f"{source}.delivered_m3", motion.delivered[rows, k]
        yield f"{source}.barrel_m3", motion.barrel[rows, k]
