"""The files of a comparison, and of a figure of the paper."""

from __future__ import annotations

from pathlib import Path

from viscodesign.report.csv_text import csv_table
from viscodesign.report.folder import (
    COMPARISON_FILES,
    COMPARISON_PAGE,
    FIGURE_FILES,
    remove_files,
)
from viscodesign.report.picture_options import AS_USUAL, PictureOptions
from viscodesign.results.paper_figure import CHECK_COLUMNS, PaperFigure
from viscodesign.results.run_comparison import Comparison


def write_comparison(
    found: Comparison,
    directory: str | Path,
    *,
    plots: bool = True,
    report: bool = True,
    force: bool = False,
    pictures: PictureOptions = AS_USUAL,
) -> list[Path]:
    """Write table, document, picture and page of a comparison and return them.

    Those of an earlier one are replaced; see `FileSet.write`.
    """
    page = Path(directory) / COMPARISON_PAGE

    def draw(picture: Path) -> None:
        # Drawing is slow to import, and a comparison without a picture does not need it.
        from viscodesign.report.charts.compare import draw_comparison

        draw_comparison(found, picture)

    files = COMPARISON_FILES.write(
        directory,
        csv_table(found.columns, found.rows()),
        found.document(),
        draw if plots else None,
        force=force,
        pictures=pictures,
    )
    if not report:
        remove_files([page])
        return files
    from viscodesign.report.page.comparison_page import write_comparison_page

    return [*files, write_comparison_page(found, page)]


def write_figure(
    found: PaperFigure,
    directory: str | Path,
    *,
    plots: bool = True,
    force: bool = False,
    pictures: PictureOptions = AS_USUAL,
) -> list[Path]:
    """Write the statements about a figure of the paper, and draw it; see `FileSet.write`."""

    def draw(picture: Path) -> None:
        from viscodesign.report.charts.paper_figure import draw_figure

        draw_figure(found, picture)

    return FIGURE_FILES[found.number].write(
        directory,
        csv_table(CHECK_COLUMNS, found.rows()),
        found.document(),
        draw if plots else None,
        force=force,
        pictures=pictures,
    )
