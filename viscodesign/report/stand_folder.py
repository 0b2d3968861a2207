"""The files of a study of statics: `stand`."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields
from pathlib import Path
from typing import Any

from viscodesign.report.csv_text import csv_table
from viscodesign.report.folder import STAND_FILES
from viscodesign.report.picture_options import AS_USUAL, PictureOptions
from viscodesign.results.stand_study import StanceRow, StandStudy

NAMES = tuple(field.name for field in fields(StanceRow))


def write_stand(
    study: StandStudy,
    directory: str | Path,
    *,
    plots: bool = True,
    force: bool = False,
    pictures: PictureOptions = AS_USUAL,
) -> list[Path]:
    """Write a study's table, document and picture, and return them."""

    def draw(path: Path) -> None:
        # Drawing is slow to import, and a study without a picture does not need it.
        from viscodesign.report.charts.stand import draw_stand

        draw_stand(study, path)

    return STAND_FILES.write(
        directory,
        csv_table(("table", *NAMES), _rows(study)),
        study.document(),
        draw if plots else None,
        force=force,
        pictures=pictures,
    )


def _rows(study: StandStudy) -> Iterator[list[Any]]:
    tables = (("own", (study.own,)), ("gauge", study.by_gauge), ("payload", study.by_payload))
    for name, rows in tables:
        for row in rows:
            yield [name, *(getattr(row, column) for column in NAMES)]
