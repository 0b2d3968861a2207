"""The files of a study of reach."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from viscodesign.report.csv_text import csv_table
from viscodesign.report.folder import (
    REACH_FILES,
    REACH_INPUT,
    SPEC,
    json_bytes,
    prepare_folder,
    text_bytes,
    write_with_picture,
)
from viscodesign.report.picture_options import AS_USUAL, PictureOptions
from viscodesign.results.reach_study import ReachStudy


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
    old = [folder / REACH_INPUT, folder / SPEC] if study.point is not None else []
    contents = {
        folder / REACH_FILES.table: [csv_table(("inlets", "x_m", "z_m"), _rows(study))],
        folder / REACH_FILES.document: [json_bytes(study.document())],
    }
    if study.point is not None:
        own = study.point
        rows = zip(own.times.tolist(), own.pressures.tolist(), strict=True)
        contents[folder / REACH_INPUT] = [csv_table(("time_s", "pressure_pa"), rows)]
        contents[folder / SPEC] = [text_bytes(own.spec_text)]

    def draw(path: Path) -> None:
        # Drawing is slow to import, and a study without a picture does not need it.
        from viscodesign.report.charts.reach import draw_reach

        draw_reach(study, path)

    picture = folder / REACH_FILES.picture
    return write_with_picture(contents, picture, draw if plots else None, pictures, old)


def _rows(study: ReachStudy) -> list[tuple[int, float, float]]:
    edges: list[tuple[int, np.ndarray]] = [(1, study.edge), (2, study.edge_two_inlets)]
    return [(count, float(x), float(z)) for count, edge in edges for x, z in edge]
