"""The folder that holds a run, and what other commands add to it."""

from __future__ import annotations

import contextlib
import json
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from viscodesign.errors import UsageError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.picture_options import (
    AS_USUAL,
    FORMATS,
    PictureOptions,
    picture_name,
)
from viscodesign.storage.atomic_files import (
    clear_leftovers,
    write_all,
    write_bytes,
    write_errors_as_usage,
)

PROBE = ".write-test"


def in_every_format(pictures: Iterable[str]) -> list[str]:
    """Names of pictures in all formats."""
    return [picture_name(name, each) for name in pictures for each in FORMATS]


@dataclass(frozen=True)
class FileSet:
    """A table, the document about it and its picture, side by side with a run's files."""

    table: str
    document: str
    picture: str

    @property
    def names(self) -> tuple[str, str, str]:
        """Names of all its files, the picture as PNG."""
        return self.table, self.document, self.picture

    def write(
        self,
        directory: str | Path,
        table: bytes,
        document: Mapping[str, Any],
        draw: Callable[[Path], None] | None,
        *,
        force: bool = False,
        pictures: PictureOptions = AS_USUAL,
    ) -> list[Path]:
        """Write the files and return them; those of an earlier set are replaced.

        No other file is touched. Table and document come first, both or none, so that a
        failing picture cannot lose them; ``draw`` is None where there is no picture. Raises
        `UsageError` where the folder cannot be written, or (without ``force``) holds files
        that are not ours.
        """
        folder = prepare_folder(directory, force=force)
        contents = {folder / self.table: [table], folder / self.document: [json_bytes(document)]}
        return write_with_picture(contents, folder / self.picture, draw, pictures)


def write_with_picture(
    contents: Mapping[Path, Sequence[bytes]],
    picture: Path,
    draw: Callable[[Path], object] | None,
    pictures: PictureOptions,
    old: Iterable[Path] = (),
) -> list[Path]:
    """Write files, all or none, then their picture; returns all of them.

    ``old`` files and the ``picture`` of every format are removed first; ``draw`` is None where
    there is no picture.
    """
    former = [*old, *map(picture.with_name, in_every_format([picture.name]))]
    write_all(contents, first=lambda: remove_files(former))
    return [*contents, *([draw_picture(draw, picture, pictures)] if draw is not None else [])]


def draw_picture(draw: Callable[[Path], object], file: Path, pictures: PictureOptions) -> Path:
    """Draw a picture as the options ask; returns its file, that of ``file`` in their format."""
    from viscodesign.report.layout.look import drawn_as

    made = file.with_name(picture_name(file.name, pictures.format))
    with drawn_as(pictures):
        draw(made)
    return made


SPEC = "spec.yaml"
RUN_TABLES = ("trajectory.csv", "shape.csv", SPEC)
BAND_TABLE = "uncertainty.csv"
"""Written where the spec says how well its numbers are known."""
RUN_PICTURES = ("tip.png", "pressures.png", "shapes.png")
EFFECTS_PICTURE = "effects.png"
"""Drawn where a run measured its effects."""
SUMMARY = "summary.json"
PAGE = "report.html"
STUDY_FILES = FileSet("accuracy.csv", "accuracy.json", "accuracy.png")
PLAN_FILES = FileSet("plan.csv", "plan.json", "plan.png")
SWEEP_FILES = FileSet("sweep.csv", "sweep.json", "sweep.png")
SENSITIVITY_FILES = FileSet("sensitivity.csv", "sensitivity.json", "sensitivity.png")
DESIGN_FILES = FileSet("history.csv", "result.json", "design.png")
FIT_FILES = FileSet(SPEC, "fit.json", "fit.png")
COMPARISON_FILES = FileSet("compare.csv", "compare.json", "compare.png")
FIGURE_FILES = {
    number: FileSet(f"figure_{number}.csv", f"figure_{number}.json", f"figure_{number}.png")
    for number in (1, 3, 4)
}
"""By the paper's figure."""
COMPARISON_PAGE = "compare.html"
COMPARED_RUNS = "runs"
"""Folder of the runs of specs that were compared."""
REACH_FILES = FileSet("reach.csv", "reach.json", "reach.png")
SEVERAL_PICTURE = "tips.png"
"""Drawn of several actuators."""
STAND_FILES = FileSet("stand.csv", "stand.json", "stand.png")
WALK_TABLE, LEGS_TABLE, WALK_PICTURE = "walk.csv", "legs.csv", "walk.png"
"""Files of a gait, beside its summary and its spec."""
REACH_INPUT = "input.csv"
"""The input that brings a tip to a point."""
DESIGN_ALTERNATIVES = "alternatives"
"""Folder of other designs beside the best one."""
FILE_SETS = (
    *(STUDY_FILES, PLAN_FILES, SWEEP_FILES, SENSITIVITY_FILES, DESIGN_FILES),
    *(COMPARISON_FILES, *FIGURE_FILES.values(), FIT_FILES, REACH_FILES, STAND_FILES),
)
SWEEP_ROWS = "sweep.rows.jsonl"
"""Rows of a sweep as they are computed."""
OUR_FILES = {
    *RUN_TABLES,
    BAND_TABLE,
    WALK_TABLE,
    LEGS_TABLE,
    *in_every_format(
        [*RUN_PICTURES, EFFECTS_PICTURE, WALK_PICTURE, *(own.picture for own in FILE_SETS)]
    ),
    SUMMARY,
    PAGE,
    SWEEP_ROWS,
    DESIGN_ALTERNATIVES,
    REACH_INPUT,
    COMPARISON_PAGE,
    COMPARED_RUNS,
    *in_every_format([SEVERAL_PICTURE]),
    *(name for own in FILE_SETS for name in own.names),
}
DOCUMENTS = {SUMMARY, *(own.document for own in FILE_SETS)}
"""At least one of these is in every complete folder of ours."""


def prepare_folder(directory: str | Path, *, force: bool = False) -> Path:
    """Make the folder; refuse one that holds other files.

    A command does so before it computes (`new_folder`): an unusable folder costs no time.
    """
    folder = Path(directory)
    with write_errors_as_usage(folder):
        if folder.exists() and not folder.is_dir():
            raise UsageError(f"{folder} is a file; the run needs a folder. Use -o DIR")
        folder.mkdir(parents=True, exist_ok=True)
        names = sorted(file.name for file in folder.iterdir())
    others = [name for name in names if not _is_ours(name)]
    if others and not force and not DOCUMENTS & set(names):
        shown = ", ".join(others[:3]) + (", ..." if len(others) > 3 else "")
        raise UsageError(
            f"{folder} holds other files ({shown}); nothing was written. "
            "Use another folder with -o DIR, or --force"
        )
    _try_writing(folder)
    clear_leftovers(folder, [*OUR_FILES, PROBE])
    return folder


@contextmanager
def new_folder(directory: str | Path, *, force: bool = False) -> Iterator[None]:
    """A folder, prepared, for what is computed within; failing, it leaves none that it made empty.

    What the folder already holds by then stays.
    """
    with without_empty(Path(directory)):
        prepare_folder(directory, force=force)
        yield


@contextmanager
def new_file(path: Path) -> Iterator[None]:
    """The folder of a file that is made within, likewise: one that cannot be written costs no time.

    Raises `UsageError` and `OutputError` as `replaced` does.
    """
    with without_empty(path.parent):
        with write_errors_as_usage(path):
            if path.is_dir():
                raise UsageError(f"{path} is a folder; name a file")
            path.parent.mkdir(parents=True, exist_ok=True)
            _try_writing(path.parent)
        yield


@contextmanager
def without_empty(folder: Path) -> Iterator[None]:
    """Where what happens within fails, no folder remains that it made empty."""
    made = [path for path in (folder, *folder.parents) if not os.path.exists(path)]
    try:
        yield
    except BaseException:
        with contextlib.suppress(OSError):  # not empty
            for path in made:
                path.rmdir()
        raise


def _try_writing(folder: Path) -> None:
    probe = folder / PROBE
    write_bytes(probe, b"")
    remove_files([probe])


def _is_ours(name: str) -> bool:
    return name in OUR_FILES or name.startswith(".")


def remove_files(files: Sequence[Path]) -> None:
    """Remove those of the files that exist."""
    for file in files:
        with write_errors_as_usage(file):
            file.unlink(missing_ok=True)


def json_bytes(document: Mapping[str, Any]) -> bytes:
    """A document as the text of a file."""
    return text_bytes(json.dumps(document, indent=2, ensure_ascii=False) + "\n")


def text_bytes(text: str) -> bytes:
    """UTF-8; a lone surrogate, which has no code there, as its escape."""
    return text.encode("utf-8", errors="backslashreplace")
