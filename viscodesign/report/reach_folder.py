"""The files of a study of reach."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import numpy as np

from viscodesign.report.csv_text import csv_table
from viscodesign.report.folder import (
    REACH_FILES,
    REACH_INPUT,
    draw_picture,
    in_every_format,
    json_bytes,
    prepare_folder,
    remove_files,
    text_bytes,
)
from viscodesign.report.picture_options import AS_USUAL, PictureOptions
from viscodesign.results.reach_study import ReachStudy
from viscodesign.storage.atomic_files import write_all

SPEC = "spec.yaml"


def write_reach(
    study: ReachStudy,
    directory: str | Path,
    *,
    plots: bool = True,
    force: bool = False,
    pictures: PictureOptions = AS_USUAL,
) -> list[Path]:
    """Write a study's files and return them; those of an earlier one are replaced.

    Table, document, and with a point its input and spec come together; then the picture.
    """
    folder = prepare_folder(directory, force=force)
    old = [folder / name for name in in_every_format([REACH_FILES.picture])]
    if study.point is not None:
        old += [folder / REACH_INPUT, folder / SPEC]
    contents = {
        folder / REACH_FILES.table: [csv_table(("inlets", "x_m", "z_m"), _rows(study))],
        folder / REACH_FILES.document: [json_bytes(study.document())],
    }
    if study.point is not None:
        own = study.point
        rows = zip(own.times.tolist(), own.pressures.tolist(), strict=True)
        contents[folder / REACH_INPUT] = [csv_table(("time_s", "pressure_pa"), rows)]
        contents[folder / SPEC] = [text_bytes(own.spec_text)]
    write_all(contents, first=lambda: remove_files(old))
    if not plots:
        return list(contents)
    # Drawing is slow to import, and a study without a picture does not need it.
    from viscodesign.report.charts.reach import draw_reach

    file = folder / REACH_FILES.picture
    return [*contents, draw_picture(partial(draw_reach, study), file, pictures)]


def _rows(study: ReachStudy) -> list[tuple[int, float, float]]:
    edges: list[tuple[int, np.ndarray]] = [(1, study.edge), (2, study.edge_two_inlets)]
    return [(count, float(x), float(z)) for count, edge in edges for x, z in edge]
