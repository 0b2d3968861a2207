"""The files of an accuracy study."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path

from viscodesign.report.csv_text import csv_table
from viscodesign.report.folder import STUDY_FILES
from viscodesign.report.picture_options import AS_USUAL, PictureOptions
from viscodesign.results.accuracy_points import POINT_COLUMNS
from viscodesign.results.accuracy_study import AccuracyStudy


def write_study(
    study: AccuracyStudy,
    directory: str | Path,
    *,
    budget_s: float | None = None,
    plots: bool = True,
    force: bool = False,
    pictures: PictureOptions = AS_USUAL,
) -> list[Path]:
    """Write a study's files and return them; see `FileSet.write`."""

    def draw(picture: Path) -> None:
        # Drawing is slow to import, and a study without a picture does not need it.
        from viscodesign.report.charts.accuracy import draw_accuracy

        draw_accuracy(study, picture)

    drawer = draw if plots and study.points else None
    document = study.document(budget_s)
    return STUDY_FILES.write(
        directory, points_csv(study), document, drawer, force=force, pictures=pictures
    )


def points_csv(study: AccuracyStudy) -> bytes:
    """Every point with every digit."""
    points = [asdict(point) for point in study.points]
    return csv_table(POINT_COLUMNS, ([point[name] for name in POINT_COLUMNS] for point in points))
