"""`viscodesign design`: numbers, input and graph that make the tip follow a path."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.options import Answer, Overrides, ResultFiles
from viscodesign.errors import InterruptedRunError, ViscodesignError

if TYPE_CHECKING:
    from viscodesign.results.path_design import PathDesign

EXAMPLE = """\b
Examples:
  viscodesign design target.yaml
  viscodesign design target.yaml --budget "5 min" -o designs/letter
  viscodesign design target.yaml --set fluid=water
"""


class DesignNotMetError(ViscodesignError):
    """The path cannot be followed closely enough; the best design is on disk."""

    exit_code = 3


def command(
    target: Annotated[
        Path, typer.Argument(metavar="TARGET", help="What is free, and the path (YAML file).")
    ],
    overrides: Overrides = None,
    budget: Annotated[
        str | None,
        typer.Option("--budget", metavar="TIME", help="Time of the search, such as `5 min`."),
    ] = None,
    seed: Annotated[int, typer.Option("--seed", min=0, help="Seed of the starts.")] = 0,
    workers: Annotated[
        int | None,
        typer.Option("--workers", min=1, metavar="N", help="Processes; by default one a core."),
    ] = None,
    *,
    files: ResultFiles,
    answer: Answer,
) -> None:
    """Find a design whose tip follows a path.

    Seeks numbers, input and graph on the model that the spec calls for, and
    simulates the result with its error stated. Writes spec.yaml, result.json,
    history.csv, design.png and other good designs in alternatives/. A path that
    cannot be followed exits with 3 and says what limits it. Ctrl-C keeps the
    best so far.
    """
    from viscodesign import design as find
    from viscodesign.cli.option_values import positive_time
    from viscodesign.cli.progress import progress
    from viscodesign.cli.run_folders import named_folder
    from viscodesign.cli.spare_folder import written
    from viscodesign.cli.texts.design_text import design_lines
    from viscodesign.report.design_folder import write_design
    from viscodesign.report.folder import new_folder

    seconds = None if budget is None else positive_time("--budget", budget)
    folder = named_folder(target.stem, files.output, "_design")
    with (
        new_folder(folder, force=files.force),
        progress(answer.quiet, first="designing") as advance,
    ):

        def tell(fraction: float, best_m: float) -> None:
            is_known = math.isfinite(best_m)
            advance(fraction, f"best so far {1e3 * best_m:.3g} mm rms" if is_known else "")

        found = find(
            target, overrides or (), budget=seconds, seed=seed, workers=workers, progress=tell
        )
    paths = written(lambda place: write_design(found, place, **files.writing), folder)
    answer.give(found.document(), design_lines(found, folder, paths), paths)
    _end(found, folder)


def _end(found: PathDesign, folder: Path) -> None:
    """Report a design that is not met as an error, after its files are written."""
    if found.interrupted:
        raise InterruptedRunError(f"interrupted; the best so far is in {folder}")
    if found.status != "met":
        words = "refused" if found.status == "refused" else "not met"
        stop = "" if found.reason.endswith("?") else "."
        hint = f"{stop} {found.hint}" if found.hint else ""
        raise DesignNotMetError(f"{words}: {found.reason}{hint}")
