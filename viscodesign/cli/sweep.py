"""`viscodesign sweep`: many designs of a spec, one table."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.options import Answer, Overrides, ResultFiles, Spec
from viscodesign.cli.specs import read_scene
from viscodesign.errors import InterruptedRunError, UsageError, ViscodesignError, not_among

if TYPE_CHECKING:
    from viscodesign.results.sweep_table import Sweep

EXAMPLE = """\b
Examples:
  viscodesign sweep leg.yaml --over "network.tube_radius=0.2 mm..0.6 mm:9"
  viscodesign sweep leg.yaml --over fluid=air,water \\
    --over "network.tube_length=20 mm..90 mm:5:log"
  viscodesign sweep leg.yaml --sample 1000 \\
    --over "network.tubes[*].length=20 mm..90 mm"
"""
DEFAULT_METRIC = "loop_width_m"


class SweepFailedError(ViscodesignError):
    """Rows are missing, or none could be solved; the table is on disk."""

    exit_code = 3


def command(
    spec: Spec,
    over: Annotated[
        list[str],
        typer.Option(
            "--over",
            metavar="KEY=VALUES",
            help="Values of a key: `a,b,c`, `low..high:n` or `low..high:n:log`; repeatable.",
        ),
    ],
    overrides: Overrides = None,
    sample: Annotated[
        int | None,
        typer.Option(
            "--sample",
            metavar="N",
            help="Draw N designs (Latin hypercube) in place of every combination.",
        ),
    ] = None,
    seed: Annotated[int, typer.Option("--seed", min=0, help="Seed of the drawing.")] = 0,
    workers: Annotated[
        int | None,
        typer.Option("--workers", metavar="N", help="Processes; by default one a core."),
    ] = None,
    cluster: Annotated[
        str | None,
        typer.Option("--cluster", metavar="ADDRESS", help="Use an existing Dask cluster."),
    ] = None,
    verify: Annotated[
        int,
        typer.Option(
            "--verify", metavar="N", min=0, help="Rows to simulate again with their error stated."
        ),
    ] = 2,
    metric: Annotated[
        str, typer.Option("--metric", metavar="NAME", help="What the picture shows.")
    ] = DEFAULT_METRIC,
    *,
    files: ResultFiles,
    answer: Answer,
) -> None:
    """Solve many designs of a spec and write one table.

    Every combination of the keys' values, or a sample, is solved at the spec's accuracy; the
    rows with the largest and the smallest loop are verified. Writes sweep.csv, sweep.json and
    sweep.png. A design that fails is named and the others go on. The same command continues
    what was interrupted or killed; --force replaces another sweep in the folder.
    """
    from viscodesign import sweep as solve
    from viscodesign.cli.progress import progress
    from viscodesign.cli.run_folders import named_folder
    from viscodesign.cli.spare_folder import written
    from viscodesign.cli.texts.check_text import notice_lines
    from viscodesign.cli.texts.sweep_text import sweep_lines
    from viscodesign.report.sweep_folder import write_sweep
    from viscodesign.results.metrics import METRIC_NAMES

    if metric not in METRIC_NAMES:
        raise UsageError(f"--metric: {not_among(metric, METRIC_NAMES)}")
    scene = read_scene(spec, overrides)
    folder = named_folder(scene.name, files.output, "_sweep")
    with progress(answer.quiet, first="sweeping") as advance:
        found = solve(
            scene,
            over,
            sample=sample,
            seed=seed,
            workers=workers,
            cluster=cluster,
            verify=verify,
            folder=folder,
            force=files.force,
            progress=advance,
        )
    paths = written(lambda place: write_sweep(found, place, metric=metric, **files.writing), folder)
    answer.give(found.document(), sweep_lines(found, folder, paths), paths)
    if answer.json and found.warnings:
        answer.remark("\n".join(["warnings", *notice_lines(found.warnings)]))
    _end(found, folder)


def _end(found: Sweep, folder: Path) -> None:
    """Report an incomplete table as an error, after its files are written."""
    there, rows = len(found.results), len(found.designs)
    kept = f"{there} of {rows} rows are in {folder}; the same command computes the others"
    if found.status == "interrupted":
        raise InterruptedRunError(f"interrupted\n{kept}")
    if found.status == "incomplete":
        raise SweepFailedError(
            f"a process died (killed, or out of memory) with {rows - there} rows\n{kept}"
        )
    if len(found.failures) == rows:
        raise SweepFailedError(f"no row could be solved; the first: {found.failures[0].failure}")
