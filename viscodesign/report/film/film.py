"""A run as a film."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from viscodesign.report.film.film_plan import FilmOptions, film_rows
from viscodesign.report.folder import new_file
from viscodesign.report.page.page_data import tube_ends
from viscodesign.report.page.sketch_numbers import scene_of
from viscodesign.results.trajectory import Trajectory


def write_film(run: Trajectory, file: str | Path, **options: Any) -> Path:
    """Write a run as GIF, WebP or MP4 (with ffmpeg), by the suffix of ``file``; `Trajectory.film`.

    ``options``: those of `FilmOptions`.

    Raises `UsageError` for another suffix, options that do not fit, and a file that cannot be
    written; then there is no film.
    """
    path = Path(file)
    chosen = FilmOptions(**options).checked(path)
    rows = film_rows(run.time, chosen)
    from viscodesign.report.film.encode import write_frames
    from viscodesign.report.film.film_frames import film_frames

    with new_file(path):
        frames = film_frames(run, tube_ends(run, scene_of(run)), rows, chosen)
        write_frames(frames, len(rows), path, chosen)
    return path
