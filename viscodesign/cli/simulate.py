"""`viscodesign simulate`: the motion of a spec, as files in a folder."""

from __future__ import annotations

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
    PictureStyle,
    PictureWidth,
    Quiet,
    RunFolder,
    Specs,
)
from viscodesign.cli.output import complain
from viscodesign.cli.specs import SpecResult, read_any, run_specs
from viscodesign.errors import InterruptedRunError, RunFailedError, ViscodesignError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.picture_options import PictureOptions, picture_options

if TYPE_CHECKING:
    from viscodesign.report.run_folder import WrittenRun
    from viscodesign.results.trajectory import Trajectory
    from viscodesign.scene.robot_scene import RobotScene
    from viscodesign.scene.scene import Scene

EXAMPLE = """\b
Examples:
  viscodesign simulate leg.yaml
  viscodesign simulate leg.yaml -o runs/water --set fluid=water
  viscodesign simulate leg.yaml --prove
  viscodesign simulate leg.yaml --set uncertainty=typical
  viscodesign simulate configs/leg_*.yaml --no-plots"""


def command(
    context: typer.Context,
    specs: Specs,
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
    no_uncertainty: Annotated[
        bool,
        typer.Option(
            "--no-uncertainty", help="Leave out the band that the spec's `uncertainty` gives."
        ),
    ] = False,
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
    """Simulate specs and write their motions.

    Writes CSV tables, pictures, a page that shows the motion, the resolved spec and a
    summary to one folder for each spec; `-` reads a spec from standard input. In runs,
    results of another spec with the same name are kept; in a folder given by -o, an earlier
    run is replaced. A failed run, or one interrupted by Ctrl-C, keeps what it computed,
    labelled as such. One spec that fails does not stop the others; the exit code is then the
    largest.
    """
    pictures = picture_options(picture_format, style, width)
    options = RunOptions(
        prove,
        not no_verify,
        not no_uncertainty,
        not no_plots,
        not no_report,
        pictures,
        force,
        json,
        quiet,
    )
    begun = Beginnings(context.obj)
    taken: set[Path] = set()

    def run(spec: Path) -> SpecResult:
        from viscodesign import RobotScene
        from viscodesign.cli.run_folders import folder_for
        from viscodesign.scene.several_scene import SeveralScene

        began, scene = next(begun), read_any(spec, overrides)
        if isinstance(scene, RobotScene):
            return _walked(scene, _own_output(scene, output, len(specs)), options)
        folder, remark = folder_for(scene, output, taken if len(specs) > 1 else None)
        taken.add(folder)
        if remark and not quiet:
            complain(remark)
        if isinstance(scene, SeveralScene):
            from viscodesign.cli.several import simulated_several

            return simulated_several(scene, folder, options)
        return _simulated(scene, folder, options, began)

    run_specs(specs, run, json=json, quiet=quiet, debug=_debug)


@dataclass(frozen=True)
class RunOptions:
    """What the command line asks of every spec."""

    prove: bool
    verify: bool
    uncertainty: bool
    plots: bool
    report: bool
    pictures: PictureOptions
    force: bool
    json: bool
    quiet: bool


class Beginnings:
    """When each spec was begun: the first one with the command itself [s]."""

    def __init__(self, first: float) -> None:
        self._first: float | None = first

    def __next__(self) -> float:
        began, self._first = self._first, None
        return clock.perf_counter() if began is None else began


def _walked(scene: RobotScene, output: Path | None, options: RunOptions) -> SpecResult:
    """The motion of a robot is its gait: the same as `walk`."""
    from viscodesign.cli.walk import no_speed, walked

    study, files, lines = walked(
        scene,
        output,
        plots=options.plots,
        report=options.report,
        pictures=options.pictures,
        force=options.force,
        quiet=options.quiet,
    )
    document = {**study.document(), "files": [str(file) for file in files]}
    return SpecResult(document, lines, no_speed(study))


def _own_output(scene: RobotScene, output: Path | None, specs: int) -> Path | None:
    """The folder given by -o, or one of its own in it where there are many specs."""
    from viscodesign.cli.run_folders import folder_name

    return output if output is None or specs == 1 else output / folder_name(scene.name)


def _simulated(scene: Scene, folder: Path, options: RunOptions, began: float) -> SpecResult:
    """Simulate one scene and write its files."""
    from viscodesign import simulate as solve
    from viscodesign.cli.progress import progress
    from viscodesign.cli.spare_folder import written
    from viscodesign.interrupt import gentle_interrupt
    from viscodesign.report.folder import new_folder
    from viscodesign.report.run_folder import write_timed

    load_s = clock.perf_counter() - began
    later = "verifying and measuring effects" if options.prove else "verifying"
    with (
        new_folder(folder, force=options.force),
        gentle_interrupt() as interrupt,
        progress(options.quiet, later) as advance,
    ):
        trajectory = _kept(
            lambda: solve(
                scene,
                verify=options.verify,
                prove=options.prove,
                uncertainty=options.uncertainty,
                progress=advance,
                scratch=folder,
            )
        )
    if options.plots:
        from viscodesign.report.layout.undocumented import import_undocumented

        import_undocumented()
    files = written(
        lambda place: write_timed(
            trajectory.with_time(load_s=load_s),
            place,
            plots=options.plots,
            report=options.report,
            force=options.force,
            pictures=options.pictures,
        ),
        folder,
    )
    return _result(files, folder, options, interrupted=interrupt.asked)


def _result(
    written: WrittenRun, folder: Path, options: RunOptions, *, interrupted: bool
) -> SpecResult:
    from viscodesign.cli.texts.ablation_text import ablation_lines
    from viscodesign.cli.texts.run_text import summary_lines

    trajectory, files = written.trajectory, written.files
    document = {**trajectory.summary(), "files": [str(file) for file in files]}
    error = _incomplete(trajectory, folder, interrupted=interrupted)
    if options.json:
        _warn(trajectory, options.quiet)
        return SpecResult(document, (), error)
    measured = ["", *ablation_lines(trajectory)] if options.prove else []
    lines = [*summary_lines(trajectory, folder, files), *measured]
    return SpecResult(document, lines, error)


def _warn(trajectory: Trajectory, quiet: bool) -> None:
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


def _incomplete(
    trajectory: Trajectory, folder: Path, *, interrupted: bool
) -> ViscodesignError | None:
    """An incomplete run as an error, to be raised when its files are written."""
    kept = f"partial results are in {folder}"
    message = trajectory.failure or f"{trajectory.name}: the run is {trajectory.status}"
    if trajectory.status == "failed":
        return RunFailedError(f"{message}\n{kept}")
    if trajectory.status == "interrupted":
        return InterruptedRunError(f"{message}\n{kept}")
    if interrupted:
        return InterruptedRunError(
            f"{trajectory.interrupted_afterwards}\nits files are in {folder}"
        )
    return None
