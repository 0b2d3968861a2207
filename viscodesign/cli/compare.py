"""`viscodesign compare`: motions in one picture, one page and one table."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.comparison_options import ComparisonOptions, rest_of
from viscodesign.cli.options import Markers
from viscodesign.cli.specs import STANDARD_INPUT, read_scene
from viscodesign.errors import InterruptedRunError, UsageError, ViscodesignError

if TYPE_CHECKING:
    from viscodesign.results.run_comparison import Comparison
    from viscodesign.scene.scene import Scene

EXAMPLE = """\b
Examples:
  viscodesign compare runs/leg runs/leg_water
  viscodesign compare leg.yaml camera.csv
  viscodesign compare straight.yaml crossed.yaml --set fluid=water
  viscodesign compare --figure 3 --set effects=auto
"""


class ComparedRunFailedError(ViscodesignError):
    """A spec that was simulated for a comparison ended early; its part was compared."""

    exit_code = 3
    kind = "solve"


def command(
    motions: Annotated[
        list[Path] | None,
        typer.Argument(
            metavar="A B...",
            help="Folders of runs, specs, or tables (CSV) of time and tip.",
        ),
    ] = None,
    figure: Annotated[
        int | None,
        typer.Option(
            "--figure", metavar="1|3|4", help="Make a figure of the paper, and check its words."
        ),
    ] = None,
    period: Annotated[
        str | None,
        typer.Option(
            "--period",
            metavar="TIME",
            help="Period of tables; by default that of the first cyclic run.",
        ),
    ] = None,
    markers: Markers = None,
    *,
    options: ComparisonOptions,
) -> None:
    """Compare runs, specs and measured tables.

    Specs are simulated first. Each motion is compared with the first: at the same time
    and, of cyclic motions, at the same phase, beside what numerical errors explain. Writes
    compare.csv, compare.json, compare.png and compare.html. Runs of specs are kept in the
    folder and read when the same command is given again; Ctrl-C keeps those that are done.

    With --figure the scenes of a figure of the paper are simulated, and each of its
    statements is checked: figure_3.csv, figure_3.json and figure_3.png.
    """
    if figure is None:
        _compare(motions or [], period, markers, options)
    elif motions:
        raise UsageError(f"--figure {figure} takes no motions; got {motions[0]}")
    else:
        from viscodesign.cli.compare_figure import compare_figure

        compare_figure(figure, options)


def _compare(
    motions: Sequence[Path],
    period: str | None,
    markers: Path | None,
    options: ComparisonOptions,
) -> None:
    from viscodesign.cli.option_values import positive_time

    period_s = None if period is None else positive_time("--period", period)
    from viscodesign import compare
    from viscodesign.cli.progress import progress
    from viscodesign.cli.spare_folder import written
    from viscodesign.cli.texts.compare_text import comparison_lines
    from viscodesign.report.comparison_folder import write_comparison
    from viscodesign.report.folder import COMPARED_RUNS, new_folder

    files, answer, overrides = options.files, options.answer, options.overrides or ()
    folder = files.output or _default_folder(motions)
    with (
        new_folder(folder, force=files.force),
        progress(answer.quiet, first="simulating") as advance,
    ):
        found = _kept(
            lambda: compare(
                *(_operand(motion, overrides) for motion in motions),
                overrides=overrides,
                period=period_s,
                markers=markers,
                verify=not options.no_verify,
                folder=folder / COMPARED_RUNS,
                progress=advance,
            ),
            folder,
        )
    paths = written(
        lambda place: write_comparison(found, place, report=not options.no_report, **files.writing),
        folder,
    )
    answer.give(found.document(), comparison_lines(found, folder, paths), paths)
    if answer.json:
        answer.remark("\n".join(f"note: {note}" for note in found.notes))
    _end(found, folder)


def _operand(given: Path, overrides: Sequence[str]) -> Path | Scene:
    """What is named; `-` is a spec on standard input."""
    return read_scene(given, overrides) if str(given) == STANDARD_INPUT else given


def _default_folder(motions: Sequence[Path]) -> Path:
    from viscodesign.report.folder_names import folder_name

    first = folder_name(motions[0].stem) if motions else "nothing"
    return Path("runs") / f"{first}_compare"


def _kept(compare: Callable[[], Comparison], folder: Path) -> Comparison:
    """A comparison, or as much of it as there was before an interrupt."""
    from viscodesign.results.run_comparison import ComparisonInterruptedError

    try:
        return compare()
    except ComparisonInterruptedError as stopped:
        if stopped.comparison is None:
            raise InterruptedRunError(f"interrupted\n{rest_of(folder)}") from None
        return stopped.comparison


def _end(found: Comparison, folder: Path) -> None:
    """Report what is incomplete as an error, after its files are written."""
    if found.missing:
        raise InterruptedRunError(
            f"interrupted: without {', '.join(found.missing)}\n{rest_of(folder)}"
        )
    failed = [m for m in found.motions if m.origin == "spec" and m.status == "failed"]
    if failed:
        words = "; ".join(f"{m.label}: {m.failure}" for m in failed)
        raise ComparedRunFailedError(f"{words}\nwhat was computed is compared in {folder}")
