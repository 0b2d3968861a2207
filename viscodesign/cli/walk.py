"""`viscodesign walk`: the gait of a robot."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.options import Answer, NoReport, Overrides, ResultFiles, Spec
from viscodesign.errors import InterruptedRunError, ViscodesignError

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
    no_report: NoReport = False,
    *,
    files: ResultFiles,
    answer: Answer,
) -> None:
    """Simulate how a robot walks under its inputs.

    Body, feet, contact forces, advance per cycle, speed, and what the pumps have to do;
    writes walk.csv, summary.json, spec.yaml, walk.png and report.html, a page that shows it
    in motion. Where the advance depends on the step of the solution, no speed is stated, and
    it exits with 3.
    """
    from viscodesign.cli.specs import read_robot

    scene = read_robot(spec, overrides)
    study, paths, lines = walked(scene, files, answer, report=not no_report, film=film)
    answer.give(study.document(), lines, paths)
    if (error := no_speed(study)) is not None:
        raise error


def walked(
    scene: RobotScene,
    files: ResultFiles,
    answer: Answer,
    *,
    report: bool,
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

    folder = named_folder(scene.name, files.output)
    later = "halving the step", "walking"
    with film_file(film):
        with new_folder(folder, force=files.force), progress(answer.quiet, *later) as advance:
            study = study_of(scene, progress=advance)
        paths = write_walk(study, folder, report=report, **files.writing)
        with told_what_is_kept(paths, film):
            if film is not None:
                paths.append(write_walk_film(study, film))
    return study, paths, walk_lines(study, folder, paths)


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
