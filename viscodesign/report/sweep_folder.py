"""The files of a sweep."""

from __future__ import annotations

from pathlib import Path

from viscodesign.report.csv_text import csv_table
from viscodesign.report.folder import SWEEP_FILES
from viscodesign.report.picture_options import AS_USUAL, PictureOptions
from viscodesign.results.metrics import METRIC_NAMES
from viscodesign.results.sweep_table import Sweep


def write_sweep(
    sweep: Sweep,
    directory: str | Path,
    *,
    metric: str = METRIC_NAMES[0],
    plots: bool = True,
    force: bool = False,
    pictures: PictureOptions = AS_USUAL,
) -> list[Path]:
    """Write a sweep's files and return them; see `FileSet.write`.

    ``metric``: what the picture shows.
    """

    def draw(picture: Path) -> None:
        # Drawing is slow to import, and a sweep without a picture does not need it.
        from viscodesign.report.charts.sweep import draw_sweep

        draw_sweep(sweep, metric, picture)

    drawer = draw if plots and sweep.results else None
    return SWEEP_FILES.write(
        directory,
        csv_table(sweep.table_columns, sweep.rows()),
        sweep.document(),
        drawer,
        force=force,
        pictures=pictures,
    )
