"""What a saved folder holds, to be drawn again: a run, several of them, or a gait."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

from viscodesign.errors import UsageError
from viscodesign.report.folder import (
    PAGE,
    SEVERAL_PICTURE,
    SUMMARY,
    WALK_PICTURE,
    draw_picture,
    prepare_folder,
)
from viscodesign.report.page.gait_page import write_gait_page
from viscodesign.report.page.page import write_page
from viscodesign.report.page.several_page import write_several_page
from viscodesign.report.picture_options import PictureOptions
from viscodesign.report.read_gait import read_gait
from viscodesign.report.read_run import read_run
from viscodesign.report.read_several import read_several
from viscodesign.report.run_folder import draw_run
from viscodesign.report.saved_files import saved_summary
from viscodesign.report.several_folder import draw_tips
from viscodesign.report.walk_folder import draw_gait


class SavedRun(ABC):
    """A saved folder, read again."""

    @abstractmethod
    def pages(self, folder: Path) -> Iterator[Path]:
        """Write the pages into a folder; yields the files."""

    @abstractmethod
    def pictures(self, folder: Path, options: PictureOptions) -> Iterator[Path]:
        """Draw the pictures likewise."""

    @abstractmethod
    def film(self, file: Path, **options: Any) -> Path:
        """Write a film; ``options`` are those of `FilmOptions`."""


def saved_run(directory: str | Path) -> SavedRun:
    """What a folder holds. Raises `UsageError` where that is nothing whole."""
    summary = saved_summary(Path(directory) / SUMMARY)
    kinds = (SavedSeveral, "actuators"), (SavedGait, "advances_by_step_m")
    kind = next((kind for kind, key in kinds if key in summary), SavedSingle)
    return kind(Path(directory))


class SavedSingle(SavedRun):
    """The run of one actuator."""

    def __init__(self, directory: Path) -> None:
        self._run = read_run(directory)

    def pages(self, folder: Path) -> Iterator[Path]:
        yield write_page(self._run, folder / PAGE)

    def pictures(self, folder: Path, options: PictureOptions) -> Iterator[Path]:
        yield from draw_run(self._run, prepare_folder(folder, force=True), options)

    def film(self, file: Path, **options: Any) -> Path:
        from viscodesign.report.film.film import write_film

        return write_film(self._run, file, **options)


class SavedSeveral(SavedRun):
    """The runs of several actuators: what shows all of them, and what each has by itself."""

    def __init__(self, directory: Path) -> None:
        self._runs, self._directory = read_several(directory), directory

    def pages(self, folder: Path) -> Iterator[Path]:
        yield write_several_page(self._runs, folder / PAGE)
        for name, run in self._runs.runs.items():
            yield write_page(run, folder / name / PAGE)

    def pictures(self, folder: Path, options: PictureOptions) -> Iterator[Path]:
        picture = prepare_folder(folder, force=True) / SEVERAL_PICTURE
        yield draw_picture(partial(draw_tips, self._runs), picture, options)
        for name, run in self._runs.runs.items():
            yield from draw_run(run, prepare_folder(folder / name, force=True), options)

    def film(self, file: Path, **options: Any) -> Path:
        name = next(iter(self._runs), "NAME")
        raise UsageError(
            f"{self._directory} holds several actuators, and a film shows one: give the folder of "
            f"one, such as {self._directory / name}"
        )


class SavedGait(SavedRun):
    """The gait of a robot."""

    def __init__(self, directory: Path) -> None:
        self._study = read_gait(directory)

    def pages(self, folder: Path) -> Iterator[Path]:
        yield write_gait_page(self._study, folder / PAGE)

    def pictures(self, folder: Path, options: PictureOptions) -> Iterator[Path]:
        picture = prepare_folder(folder, force=True) / WALK_PICTURE
        yield draw_picture(partial(draw_gait, self._study), picture, options)

    def film(self, file: Path, **options: Any) -> Path:
        from viscodesign.report.film.walk_film import write_walk_film

        return write_walk_film(self._study, file, **options)
