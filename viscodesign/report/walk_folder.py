"""The files of a gait: `walk`."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from viscodesign.report.csv_text import csv_rows, csv_table
from viscodesign.report.folder import (
    PAGE,
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

SPEC = "spec.yaml"


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
    columns = list(_columns(study.motion))
    names, values = [name for name, _ in columns], np.column_stack([v for _, v in columns])
    contents = {
        folder / WALK_TABLE: [csv_table(names, ()), csv_rows(values)],
        folder / SUMMARY: [json_bytes(study.document())],
        folder / SPEC: [text_bytes(study.spec_text)],
    }

    def draw(path: Path) -> None:
        # Drawing is slow to import, and a gait without a picture does not need it.
        from viscodesign.report.charts.walk import draw_walk

        draw_walk(study, path)

    page, picture = folder / PAGE, folder / WALK_PICTURE
    files = write_with_picture(contents, picture, draw if plots else None, pictures, [page])
    return [*files, write_gait_page(study, page)] if report else files


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
