"""`viscodesign compare`: motions in one picture, one page and one table."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.options import (
    Debug,
    Force,
    Json,
    NoPlots,
    Overrides,
    PictureFormat,
    Quiet,
    RunFolder,
)
from viscodesign.cli.specs import STANDARD_INPUT, read_scene
from viscodesign.errors import InterruptedRunError, ViscodesignError

if TYPE_CHECKING:
    from viscodesign.results.run_comparison import Comparison
    from viscodesign.scene.scene import Scene

EXAMPLE = """\b
Examples:
  viscodesign compare runs/leg runs/leg_water
  viscodesign compare leg.yaml camera.csv
  viscodesign compare straight.yaml crossed.yaml --set fluid=water
"""


class ComparedRunFailedError(ViscodesignError):
    """A spec that was simulated for a comparison ended early; its part was compared."""

    exit_code = 3
    kind = "solve"


def command(
    motions: Annotated[
        list[Path],
        typer.Argument(
            metavar="A B...",
            help="Folders of runs, specs, or tables (CSV) of time and tip.",
        ),
    ],
    overrides: Overrides = None,
    period: Annotated[
        str | None,
        typer.Option(
            "--period",
            metavar="TIME",
            help="Period of tables; by default that of the first cyclic run.",
        ),
    ] = None,
    no_verify: Annotated[
        bool, typer.Option("--no-verify", help="Skip the error estimate of specs.")
    ] = False,
    output: RunFolder = None,
    no_plots: NoPlots = False,
    no_report: Annotated[
        bool, typer.Option("--no-report", help="Skip the page, compare.html.")
    ] = False,
    picture_format: PictureFormat = "png",
    force: Force = False,
    json: Json = False,
    quiet: Quiet = False,
    _debug: Debug = False,
) -> None:
    """Compare runs, specs and measured tables with the first of them.

    Specs are simulated first. Differences are told at the same time and, of cyclic
    motions, at the same phase, beside what numerical errors explain. Writes compare.csv,
    compare.json, compare.png and compare.html; runs of specs are kept in the folder and
    read when the same command is given again. Ctrl-C keeps the runs that are done.
    """
    from viscodesign.cli.option_values import positive_time

    period_s = None if period is None else positive_time("--period", period)
    from viscodesign import compare
    from viscodesign.cli.output import complain, json_text, say
    from viscodesign.cli.progress import progress
    from viscodesign.cli.texts.compare_text import comparison_lines
    from viscodesign.report.comparison_folder import write_comparison
    from viscodesign.report.folder import COMPARED_RUNS, prepare_folder

    folder = output if output is not None else _default_folder(motions)
    is_new = not folder.exists()
    prepare_folder(folder, force=force)
    try:
        with progress(quiet, first="simulating") as advance:
            found = _kept(
                lambda: compare(
                    *(_operand(motion, overrides) for motion in motions),
                    overrides=overrides or (),
                    period=period_s,
                    verify=not no_verify,
                    folder=folder / COMPARED_RUNS,
                    progress=advance,
                ),
                folder,
            )
    finally:
        if is_new and not any(folder.iterdir()):
            folder.rmdir()
    files = write_comparison(
        found,
        folder,
        plots=not no_plots,
        report=not no_report,
        force=force,
        picture_format=picture_format,
    )
    if json:
        say(json_text({**found.document(), "files": [str(file) for file in files]}))
        if not quiet and found.notes:
            complain("\n".join(f"note: {note}" for note in found.notes))
    elif not quiet:
        say("\n".join(comparison_lines(found, folder, files)))
    _end(found, folder)


def _operand(given: Path, overrides: list[str] | None) -> Path | Scene:
    """What is named; `-` is a spec on standard input."""
    return read_scene(given, overrides) if str(given) == STANDARD_INPUT else given


def _default_folder(motions: Sequence[Path]) -> Path:
    from viscodesign.report.folder_names import folder_name

    return Path("runs") / f"{folder_name(motions[0].stem)}_compare"


def _kept(compare: Callable[[], Comparison], folder: Path) -> Comparison:
    """A comparison, or as much of it as there was before an interrupt."""
    from viscodesign.results.run_comparison import ComparisonInterruptedError

    try:
        return compare()
    except ComparisonInterruptedError as stopped:
        if stopped.comparison is None:
            raise InterruptedRunError(f"interrupted\n{_rest(folder)}") from None
        return stopped.comparison


def _rest(folder: Path) -> str:
    return f"runs that are done are in {folder}; the same command reads them and does the others"


def _end(found: Comparison, folder: Path) -> None:
    """Report what is incomplete as an error, after its files are written."""
    if found.missing:
        raise InterruptedRunError(
            f"interrupted: without {', '.join(found.missing)}\n{_rest(folder)}"
        )
    failed = [m for m in found.motions if m.origin == "spec" and m.status == "failed"]
    if failed:
        words = "; ".join(f"{m.label}: {m.failure}" for m in failed)
        raise ComparedRunFailedError(f"{words}\nwhat was computed is compared in {folder}")
