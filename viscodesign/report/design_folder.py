"""The files of a design."""

from __future__ import annotations

from pathlib import Path

from viscodesign.report.csv_text import csv_table
from viscodesign.report.folder import (
    DESIGN_ALTERNATIVES,
    DESIGN_FILES,
    SPEC,
    json_bytes,
    prepare_folder,
    text_bytes,
    write_with_picture,
)
from viscodesign.report.picture_options import AS_USUAL, PictureOptions
from viscodesign.results.path_design import PathDesign
from viscodesign.storage.atomic_files import write_errors_as_usage

HISTORY_COLUMNS = ("evaluation", "wall_s", "rms_m", "graph")


def write_design(
    found: PathDesign,
    directory: str | Path,
    *,
    plots: bool = True,
    force: bool = False,
    pictures: PictureOptions = AS_USUAL,
) -> list[Path]:
    """Write a design's files and return them; those of an earlier one are replaced.

    Spec, document, history and alternatives come together, all or none; then the picture.
    """
    folder = prepare_folder(directory, force=force)
    others = folder / DESIGN_ALTERNATIVES
    old = [folder / SPEC, *sorted(others.glob("alternative_*.yaml"))]
    contents = _contents(found, folder)
    if any(path.parent == others for path in contents):
        with write_errors_as_usage(others):
            others.mkdir(exist_ok=True)

    def draw(path: Path) -> None:
        # Drawing is slow to import, and a design without a picture does not need it.
        from viscodesign.report.charts.design import draw_design

        draw_design(found, path)

    picture = folder / DESIGN_FILES.picture
    return write_with_picture(contents, picture, draw if plots else None, pictures, old)


def _contents(found: PathDesign, folder: Path) -> dict[Path, list[bytes]]:
    rows = [(r.evaluation, r.wall_s, r.rms_m, r.graph) for r in found.history]
    contents = {
        folder / DESIGN_FILES.table: [csv_table(HISTORY_COLUMNS, rows)],
        folder / DESIGN_FILES.document: [json_bytes(found.document())],
    }
    if found.spec_text:
        contents[folder / SPEC] = [text_bytes(found.spec_text)]
    for k, other in enumerate(found.alternatives[1:], start=1):
        path = folder / DESIGN_ALTERNATIVES / f"alternative_{k}.yaml"
        contents[path] = [text_bytes(other.spec_text)]
    return contents
