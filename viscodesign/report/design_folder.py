"""The files of a design."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from viscodesign.report.csv_text import csv_table
from viscodesign.report.folder import (
    DESIGN_ALTERNATIVES,
    DESIGN_FILES,
    draw_picture,
    in_every_format,
    json_bytes,
    prepare_folder,
    remove_files,
    text_bytes,
)
from viscodesign.report.picture_options import AS_USUAL, PictureOptions
from viscodesign.results.path_design import PathDesign
from viscodesign.storage.atomic_files import write_all, write_errors_as_usage

HISTORY_COLUMNS = ("evaluation", "wall_s", "rms_m", "graph")
SPEC = "spec.yaml"


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
    old = [folder / SPEC, *(folder / name for name in in_every_format([DESIGN_FILES.picture]))]
    old += sorted(others.glob("alternative_*.yaml"))
    contents = _contents(found, folder)
    if any(path.parent == others for path in contents):
        with write_errors_as_usage(others):
            others.mkdir(exist_ok=True)
    write_all(contents, first=lambda: remove_files(old))
    if not plots:
        return list(contents)
    # Drawing is slow to import, and a design without a picture does not need it.
    from viscodesign.report.charts.design import draw_design

    file = folder / DESIGN_FILES.picture
    return [*contents, draw_picture(partial(draw_design, found), file, pictures)]


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
