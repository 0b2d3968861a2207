"""`viscodesign simulate`: the motion of a spec, as files in a folder."""

from __future__ import annotations

import re
import time as clock
from collections.abc import Callable
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
    Quiet,
    RunFolder,
    Spec,
)
from viscodesign.errors import InterruptedRunError, ViscodesignError

if TYPE_CHECKING:
    from viscodesign.results.trajectory import Trajectory

EXAMPLE = """\b
Examples:
  viscodesign simulate leg.yaml
  viscodesign simulate leg.yaml -o runs/water --set fluid=water
  viscodesign simulate leg.yaml --prove"""


class RunFailedError(ViscodesignError):
    """The solver stopped before the end of the run; partial results are on disk."""

    exit_code = 3


def command(
    context: typer.Context,
    spec: Spec,
    overrides: Overrides = None,
    output: RunFolder = None,
    prove: Annotated[
        bool,
        typer.Option(
            "--prove", help="Measure each effect: switch it, solve again, compare the tips."
        ),
    ] = False,
    no_verify: Annotated[
        bool, typer.Option("--no-verify", help="Skip the estimate of the tip error.")
    ] = False,
    no_plots: NoPlots = False,
    no_report: NoReport = False,
    picture_format: PictureFormat = "png",
    force: Force = False,
    json: Json = False,
    quiet: Quiet = False,
    _debug: Debug = False,
) -> None:
    """Simulate a spec and write its motion.

    Writes CSV tables, pictures, a page that shows the motion, the resolved spec and a
    summary to one folder. Files of an earlier run in the same folder are replaced. A failed
    or interrupted run keeps what it computed, labelled as such.
    """
    from viscodesign import load
    from viscodesign import simulate as solve
    from viscodesign.cli.output import json_text, say
    from viscodesign.cli.progress import progress
    from viscodesign.cli.texts.ablation_text import ablation_lines
    from viscodesign.cli.texts.run_text import summary_lines
    from viscodesign.interrupt import gentle_interrupt
    from viscodesign.report.folder import prepare_folder
    from viscodesign.report.run_folder import write_timed

    scene = load(spec, overrides or ())
    folder = output if output is not None else Path("runs") / folder_name(scene.name)
    prepare_folder(folder, force=force)
    load_s = clock.perf_counter() - context.obj
    later = "verifying and measuring effects" if prove else "verifying"
    with gentle_interrupt() as interrupt, progress(quiet, later) as advance:
        trajectory = _kept(
            lambda: solve(
                scene, verify=not no_verify, prove=prove, progress=advance, scratch=folder
            )
        )
    if not no_plots:
        from viscodesign.report.layout.undocumented import import_undocumented

        import_undocumented()
    written = write_timed(
        trajectory.with_time(load_s=load_s),
        folder,
        plots=not no_plots,
        report=not no_report,
        force=force,
        picture_format=picture_format,
    )
    trajectory, files = written.trajectory, written.files
    if json:
        say(json_text({**trajectory.summary(), "files": [str(file) for file in files]}))
        _warn(trajectory, quiet)
    elif not quiet:
        measured = ["", *ablation_lines(trajectory)] if prove else []
        say("\n".join([*summary_lines(trajectory, folder, files), *measured]))
    _end(trajectory, folder, interrupted=interrupt.asked)


def folder_name(name: str) -> str:
    """A scene's name as the name of a folder."""
    return re.sub(r"[^\w.+-]+", "_", name).strip("._") or "run"


def _warn(trajectory: Trajectory, quiet: bool) -> None:
    from viscodesign.cli.output import complain
    from viscodesign.cli.texts.ablation_text import wrongly_neglected_lines
    from viscodesign.cli.texts.check_text import notice_lines

    lines = notice_lines(trajectory.warnings)
    found = [*(["warnings", *lines] if lines else []), *wrongly_neglected_lines(trajectory)]
    if found and not quiet:
        complain("\n".join(found))


def _kept(solve: Callable[[], Trajectory]) -> Trajectory:
    """A run, or as much of it as there was before an interrupt."""
    from viscodesign.results.trajectory import RunInterruptedError

    try:
        return solve()
    except RunInterruptedError as stopped:
        if stopped.trajectory is None:
            raise
        return stopped.trajectory


def _end(trajectory: Trajectory, folder: Path, *, interrupted: bool) -> None:
    """Report an incomplete run as an error, after its files are written."""
    kept = f"partial results are in {folder}"
    message = trajectory.failure or f"{trajectory.name}: the run is {trajectory.status}"
    if trajectory.status == "failed":
        raise RunFailedError(f"{message}\n{kept}")
    if interrupted or trajectory.status == "interrupted":
        raise InterruptedRunError(f"{message}\n{kept}")
