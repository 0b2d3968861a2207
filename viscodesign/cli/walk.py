"""`viscodesign walk`: the gait of a robot."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.options import (
    Debug,
    Force,
    Json,
    NoPlots,
    NoReport,
    Overrides,
    PictureFormat,
    PictureStyle,
    PictureWidth,
    Quiet,
    RunFolder,
    Spec,
)
from viscodesign.errors import InterruptedRunError, ViscodesignError
from viscodesign.report.picture_options import PictureOptions, picture_options

if TYPE_CHECKING:
    from viscodesign.results.walk_study import WalkStudy
    from viscodesign.scene.robot_scene import RobotScene

EXAMPLE = """\b
Examples:
  viscodesign walk hexapod.yaml
  viscodesign walk hexapod.yaml --film walk.webp
  viscodesign walk hexapod.yaml --set inputs.A.frequency=0.8Hz \\
    --set inputs.B.delay=0.625s"""


class NoSpeedError(ViscodesignError):
    """The speed depends on the step; the motion is on disk."""

    exit_code = 3
    kind = "solve"


def command(
    spec: Spec,
    overrides: Overrides = None,
    film: Annotated[
        Path | None,
        typer.Option("--film", metavar="FILE", help="Also a film: .gif, .webp or .mp4."),
    ] = None,
    output: RunFolder = None,
    no_plots: NoPlots = False,
    no_report: NoReport = False,
    picture_format: PictureFormat = "png",
    style: PictureStyle = "plain",
    width: PictureWidth = None,
    force: Force = False,
    json: Json = False,
    quiet: Quiet = False,
    _debug: Debug = False,
) -> None:
    """Tell how a robot walks under its inputs.

    Body, feet, contact forces, advance per cycle, speed, and what the pumps have to do;
    writes walk.csv, summary.json, spec.yaml, walk.png and report.html, a page that shows it
    in motion. Where the advance depends on the step of the solution, no speed is stated, and
    it exits with 3.
    """
    pictures = picture_options(picture_format, style, width)
    from viscodesign.cli.specs import read_robot

    study, files, lines = walked(
        read_robot(spec, overrides),
        output,
        plots=not no_plots,
        report=not no_report,
        pictures=pictures,
        force=force,
        quiet=quiet,
        film=film,
    )
    from viscodesign.cli.output import say_result

    say_result(study.document(), files, lines, json, quiet)
    if (error := no_speed(study)) is not None:
        raise error


def walked(
    scene: RobotScene,
    output: Path | None,
    *,
    plots: bool,
    report: bool,
    pictures: PictureOptions,
    force: bool,
    quiet: bool,
    film: Path | None = None,
) -> tuple[WalkStudy, list[Path], list[str]]:
    """The gait of a robot, the files that it is written to, and its lines of text."""
    from viscodesign import walk as study_of
    from viscodesign.cli.film_file import film_file, told_what_is_kept
    from viscodesign.cli.progress import progress
    from viscodesign.cli.run_folders import named_folder
    from viscodesign.cli.texts.walk_text import walk_lines
    from viscodesign.report.film.walk_film import write_walk_film
    from viscodesign.report.folder import new_folder
    from viscodesign.report.walk_folder import write_walk

    folder = named_folder(scene.name, output)
    later = "halving the step", "walking"
    with film_file(film):
        with new_folder(folder, force=force), progress(quiet, *later) as advance:
            study = study_of(scene, progress=advance)
        files = write_walk(
            study, folder, plots=plots, report=report, force=force, pictures=pictures
        )
        with told_what_is_kept(files, film):
            if film is not None:
                files.append(write_walk_film(study, film))
    return study, files, walk_lines(study, folder, files)


def no_speed(study: WalkStudy) -> ViscodesignError | None:
    """Why no speed is stated, as an error to be raised when the files are written."""
    if not study.refusal:
        return None
    if study.end:
        kept = f"{study.name}: {study.refusal}; what was computed is kept"
        return InterruptedRunError(kept) if study.end == "interrupted" else NoSpeedError(kept)
    if study.refusal.startswith("interrupted"):
        return InterruptedRunError(f"{study.name}: {study.refusal}; the one before is kept")
    return NoSpeedError(f"{study.name}: no speed is stated: {study.refusal}")
