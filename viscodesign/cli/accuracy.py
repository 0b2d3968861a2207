"""`viscodesign accuracy`: what accuracy costs in solve time."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.options import Answer, Overrides, ResultFiles, Spec
from viscodesign.cli.specs import read_scene
from viscodesign.errors import InterruptedRunError

if TYPE_CHECKING:
    from viscodesign.results.accuracy_study import AccuracyStudy

EXAMPLE = """\b
Examples:
  viscodesign accuracy leg.yaml
  viscodesign accuracy leg.yaml --budget "20 ms"
  viscodesign accuracy leg.yaml --set effects=auto --limit "5 min\""""


def command(
    spec: Spec,
    overrides: Overrides = None,
    budget: Annotated[
        str | None,
        typer.Option(
            "--budget",
            metavar="TIME",
            help="Report the most accurate setting that solves within this time, such as `20 ms`.",
        ),
    ] = None,
    limit: Annotated[
        str, typer.Option("--limit", metavar="TIME", help="Time limit of the whole study.")
    ] = "60 s",
    *,
    files: ResultFiles,
    answer: Answer,
) -> None:
    """Measure what accuracy costs in solve time.

    Solves a spec with every form of the model that it allows, with meshes, tolerances and
    solvers from coarse to fine, and compares each with a converged reference. Writes
    accuracy.csv, accuracy.json and accuracy.png; a run's files in the same folder stay. An
    interrupted study keeps what it measured.
    """
    from viscodesign.cli.option_values import positive_time
    from viscodesign.cli.spare_folder import written

    budget_s = None if budget is None else positive_time("--budget", budget)
    limit_s = positive_time("--limit", limit)
    from viscodesign import accuracy
    from viscodesign.cli.progress import progress
    from viscodesign.cli.run_folders import folder_for
    from viscodesign.cli.texts.accuracy_text import cost_lines
    from viscodesign.report.accuracy_folder import write_study
    from viscodesign.report.folder import new_folder

    scene = read_scene(spec, overrides)
    folder, remark = folder_for(scene, files.output)
    answer.remark(remark)
    with (
        new_folder(folder, force=files.force),
        progress(answer.quiet, first="measuring") as advance,
    ):
        study = _kept(lambda: accuracy(scene, limit=limit_s, progress=advance))
    paths = written(
        lambda place: write_study(study, place, budget_s=budget_s, **files.writing), folder
    )
    answer.give(study.document(budget_s), cost_lines(study, budget_s, folder, paths), paths)
    _end(study, folder)


def _kept(measure: Callable[[], AccuracyStudy]) -> AccuracyStudy:
    """A study, or as much of it as there was before an interrupt."""
    from viscodesign.results.accuracy_study import AccuracyInterruptedError

    try:
        return measure()
    except AccuracyInterruptedError as stopped:
        return stopped.study


def _end(study: AccuracyStudy, folder: Path) -> None:
    """Report an interrupted study as an error, after its files are written."""
    if study.status == "interrupted":
        raise InterruptedRunError(
            f"interrupted after {study.spent_s:.3g} s with {len(study.points)} points measured\n"
            f"partial results are in {folder}"
        )
