"""`viscodesign compare --figure`: a figure of the paper, and which of its words the model keeps."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from viscodesign.cli.comparison_options import ComparisonOptions, rest_of
from viscodesign.errors import InterruptedRunError

if TYPE_CHECKING:
    from viscodesign.results.paper_figure import PaperFigure


def compare_figure(number: int, options: ComparisonOptions) -> None:
    """Make a figure, write its files and tell its statements."""
    from viscodesign.cli.progress import progress
    from viscodesign.cli.templates import DEFAULT, templates
    from viscodesign.comparison.paper_figures import figure_plan, paper_figure
    from viscodesign.report.comparison_folder import write_figure
    from viscodesign.report.folder import COMPARED_RUNS, new_folder

    plan = figure_plan(number, templates()[DEFAULT].path.parent)
    files = options.files
    folder = files.output or Path("runs") / f"figure_{number}"
    with (
        new_folder(folder, force=files.force),
        progress(options.answer.quiet, first="simulating") as advance,
    ):
        try:
            found = paper_figure(
                plan,
                overrides=options.overrides or (),
                verify=not options.no_verify,
                folder=folder / COMPARED_RUNS,
                progress=advance,
            )
        except KeyboardInterrupt:
            raise InterruptedRunError(f"interrupted\n{rest_of(folder)}") from None
    paths = write_figure(found, folder, **files.writing)
    options.answer.give(found.document(), _lines(found, folder, paths), paths)


def _lines(found: PaperFigure, folder: Path, files: Sequence[Path]) -> Iterator[str]:
    """Every statement with its verdict and its numbers."""
    from viscodesign.cli.texts.layout import table, wrap

    yield f"Figure {found.number}: {found.title}; {found.agreement}"
    yield from wrap(f"with {', '.join(found.changes)}") if found.changes else ()
    rows = [(c.panel or "-", c.verdict, c.section, f"{c.words}: {c.found}") for c in found.checks]
    yield from table(
        [("panel", "verdict", "section", "the paper's words: what the model gives"), *rows]
    )
    for panel in found.panels:
        if panel.assumed:
            yield from wrap(f"{panel.name}: assumed here: {panel.assumed}", "  ", "     ")
    if found.outside:
        yield from wrap(
            f"outside of what the model describes: {', '.join(found.outside)}", "  ", "    "
        )
    if found.beside:
        places = "; ".join(f"{quadrant}: {words}" for quadrant, words in found.beside.items())
        yield from wrap(
            f"published robots by quadrant, of which the paper prints no ratios: {places}",
            "  ", "    ",
        )  # fmt: skip
    yield f"files  {folder}: {', '.join(file.name for file in files)}"
