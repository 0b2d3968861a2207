"""The files of a fit."""

from __future__ import annotations

from pathlib import Path

from viscodesign.report.folder import FIT_FILES, text_bytes
from viscodesign.report.picture_options import AS_USUAL, PictureOptions
from viscodesign.results.fit_result import Fit


def write_fit(
    found: Fit,
    directory: str | Path,
    *,
    plots: bool = True,
    force: bool = False,
    pictures: PictureOptions = AS_USUAL,
) -> list[Path]:
    """Write a fit's files and return them; see `FileSet.write`."""

    def draw(picture: Path) -> None:
        # Drawing is slow to import, and a fit without a picture does not need it.
        from viscodesign.report.charts.fit import draw_fit

        draw_fit(found, picture)

    return FIT_FILES.write(
        directory,
        text_bytes(found.spec),
        found.document(),
        draw if plots else None,
        force=force,
        pictures=pictures,
    )
