"""`viscodesign simulate`: the motion of a spec, as files in a folder."""

from __future__ import annotations

import time as clock
from collections.abc import Callable
from dataclasses import KW_ONLY, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from viscodesign.cli.options import Answer, NoReport, Overrides, ResultFiles, Specs
from viscodesign.cli.specs import SpecResult, read_any, run_specs
from viscodesign.errors import InterruptedRunError, RunFailedError, ViscodesignError
from viscodesign.lazy_dataclass import dataclass

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


@dataclass(frozen=True)
class RunOptions:
    """What the command line asks of every spec."""

    prove: Annotated[
        bool,
        typer.Option(
            "--prove", help="Measure each effect: switch it, solve again, compare the tips."
        ),
    ] = False
    no_verify: Annotated[
        bool, typer.Option("--no-verify", help="Skip the estimate of the tip error.")
    ] = False
    no_uncertainty: Annotated[
        bool,
        typer.Option(
            "--no-uncertainty", help="Leave out the band that the spec's `uncertainty` gives."
        ),
    ] = False
    no_report: NoReport = False
    _: KW_ONLY
    files: ResultFiles
    answer: Answer

    @property
    def solving(self) -> dict[str, bool]:
        """What a simulation takes."""
        verify, band = not self.no_verify, not self.no_uncertainty
        return {"prove": self.prove, "verify": verify, "uncertainty": band}

    @property
    def writing(self) -> dict[str, Any]:
        """What those who write a run's files take."""
        return {"report": not self.no_report, **self.files.writing}


def command(
    context: typer.Context,
    specs: Specs,
    overrides: Overrides = None,
    *,
    options: RunOptions,
) -> None:
    """Simulate specs and write their motions.

    Writes CSV tables, pictures, a page that shows the motion, the resolved spec and a
    summary to one folder for each spec; `-` reads a spec from standard input. In runs,
    results of another spec with the same name are kept; in a folder given by -o, an earlier
    run is replaced. A failed run, or one interrupted by Ctrl-C, keeps what it computed,
    labelled as such. One spec that fails does not stop the others; the exit code is then the
    largest.
    """
    files, answer = options.files, options.answer
    begun = Beginnings(context.obj)
    taken: set[Path] = set()

    def run(spec: Path) -> SpecResult:
        from viscodesign import RobotScene
        from viscodesign.cli.run_folders import folder_for
        from viscodesign.scene.several_scene import SeveralScene

        began, scene = next(begun), read_any(spec, overrides)
        if isinstance(scene, RobotScene):
            return _walked(scene, options, alone=len(specs) == 1)
        folder, remark = folder_for(scene, files.output, taken if len(specs) > 1 else None)
        taken.add(folder)
        answer.remark(remark)
        if isinstance(scene, SeveralScene):
            from viscodesign.cli.several import simulated_several

            return simulated_several(scene, folder, options)
        return _simulated(scene, folder, options, began)

    run_specs(specs, run, answer)


class Beginnings:
    """When each spec was begun: the first one with the command itself [s]."""

    def __init__(self, first: float) -> None:
        self._first: float | None = first

    def __next__(self) -> float:
        began, self._first = self._first, None
        return clock.perf_counter() if began is None else began


def _walked(scene: RobotScene, options: RunOptions, *, alone: bool) -> SpecResult:
    """The motion of a robot is its gait: the same as `walk`.

    Written to the folder given by -o where it is ``alone``, else to one of its own in it.
    """
    from viscodesign.cli.run_folders import folder_name
    from viscodesign.cli.walk import no_speed, walked

    files = options.files
    if files.output is not None and not alone:
        files = replace(files, output=files.output / folder_name(scene.name))
    study, paths, lines = walked(scene, files, options.answer, report=not options.no_report)
    document = {**study.document(), "files": [str(path) for path in paths]}
    return SpecResult(document, lines, no_speed(study))


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
        new_folder(folder, force=options.files.force),
        gentle_interrupt() as interrupt,
        progress(options.answer.quiet, later) as advance,
    ):
        trajectory = _kept(
            lambda: solve(scene, **options.solving, progress=advance, scratch=folder)
        )
    if not options.files.no_plots:
        from viscodesign.report.layout.undocumented import import_undocumented

        import_undocumented()
    files = written(
        lambda place: write_timed(trajectory.with_time(load_s=load_s), place, **options.writing),
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
    if options.answer.json:
        _warn(trajectory, options.answer)
        return SpecResult(document, (), error)
    measured = ["", *ablation_lines(trajectory)] if options.prove else []
    lines = [*summary_lines(trajectory, folder, files), *measured]
    return SpecResult(document, lines, error)


def _warn(trajectory: Trajectory, answer: Answer) -> None:
    from viscodesign.cli.texts.ablation_text import wrongly_neglected_lines
    from viscodesign.cli.texts.check_text import notice_lines

    lines = notice_lines(trajectory.warnings)
    found = [*(["warnings", *lines] if lines else []), *wrongly_neglected_lines(trajectory)]
    answer.remark("\n".join(found))


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
