"""The files of a study of sensitivities."""

from __future__ import annotations

from pathlib import Path

from viscodesign.report.csv_text import csv_rows, csv_table
from viscodesign.report.folder import SENSITIVITY_FILES
from viscodesign.report.picture_options import AS_USUAL, PictureOptions
from viscodesign.results.sensitivity_study import SensitivityStudy


def write_sensitivity(
    study: SensitivityStudy,
    directory: str | Path,
    *,
    plots: bool = True,
    force: bool = False,
    pictures: PictureOptions = AS_USUAL,
) -> list[Path]:
    """Write a study's files and return them; see `FileSet.write`."""

    def draw(picture: Path) -> None:
        # Drawing is slow to import, and a study without a picture does not need it.
        from viscodesign.report.charts.tornado import draw_tornado

        draw_tornado(study, picture)

    return SENSITIVITY_FILES.write(
        directory,
        csv_table(study.table_columns, ()) + csv_rows(study.rows()),
        study.document(),
        draw if plots else None,
        force=force,
        pictures=pictures,
    )
