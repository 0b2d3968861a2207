"""`viscodesign accuracy`: a spec in, what accuracy costs in time out."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.options import Debug, Json, Overrides, Quiet, Spec
from viscodesign.cli.simulate import folder_name
from viscodesign.errors import InterruptedRunError, UsageError

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
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", metavar="DIR", help="The folder; runs/<name> by default."),
    ] = None,
    budget: Annotated[
        str | None,
        typer.Option(
            "--budget",
            metavar="TIME",
            help="Name the most accurate setting whose solve takes no longer, as in `20 ms`.",
        ),
    ] = None,
    limit: Annotated[
        str, typer.Option("--limit", metavar="TIME", help="Time that the whole study may take.")
    ] = "60 s",
    no_plots: Annotated[bool, typer.Option("--no-plots", help="Draw no picture.")] = False,
    force: Annotated[
        bool, typer.Option("--force", help="Write into a folder that holds other files.")
    ] = False,
    json: Json = False,
    quiet: Quiet = False,
    _debug: Debug = False,
) -> None:
    """Measure what accuracy costs in time.

    Solves a spec with every form of the model that it allows, with edges, tolerances and
    solvers from coarse to fine, and holds each against a converged reference. Writes
    accuracy.csv, accuracy.json and accuracy.png; a run's files in the same folder stay.
    A study that is interrupted keeps what it measured.
    """
    budget_s = None if budget is None else _time("--budget", budget)
    limit_s = _time("--limit", limit)
    from viscodesign import accuracy, load
    from viscodesign.cli.output import json_text, say
    from viscodesign.cli.progress import progress
    from viscodesign.cli.texts.accuracy_text import price_lines
    from viscodesign.report.accuracy_folder import write_study
    from viscodesign.report.folder import prepare_folder

    scene = load(spec, overrides or ())
    folder = output if output is not None else Path("runs") / folder_name(scene.name)
    prepare_folder(folder, force=force)
    with progress(quiet, first="measuring") as advance:
        study = accuracy(scene, limit=limit_s, progress=advance)
    files = write_study(study, folder, budget_s=budget_s, plots=not no_plots, force=force)
    if json:
        document = study.document(budget_s)
        say(json_text({**document, "files": [str(file) for file in files]}))
    elif not quiet:
        say("\n".join(price_lines(study, budget_s, folder, files)))
    _end(study, folder)


def _time(option: str, text: str) -> float:
    """A time [s] that is given to an option, above zero."""
    from pydantic_core import PydanticCustomError

    from viscodesign.units import QuantityKind

    try:
        value = QuantityKind("time", "s", "20 ms").parse(text)
    except PydanticCustomError as error:
        raise UsageError(f"{option}: {error.message()}") from error
    if value <= 0.0:
        raise UsageError(f"{option}: '{text}' is not above zero; a time is wanted, like '20 ms'")
    return value


def _end(study: AccuracyStudy, folder: Path) -> None:
    """A study that was stopped is an error, after its files are written."""
    if study.status == "interrupted":
        raise InterruptedRunError(
            f"interrupted after {study.spent_s:.3g} s and {len(study.points)} points\n"
            f"what was measured is in {folder}"
        )
