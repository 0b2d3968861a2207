"""Specs that are compared are simulated first, and their runs are kept at once."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Protocol

from viscodesign._version import __version__
from viscodesign.errors import SolveError, UsageError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.folder_names import folder_name, numbered
from viscodesign.report.read_run import read_run
from viscodesign.report.run_folder import write_run
from viscodesign.results.trajectory import RunInterruptedError, Trajectory
from viscodesign.scene.reading.write import resolved_yaml
from viscodesign.scene.scene import Scene
from viscodesign.studies.simulate import simulate


class Progress(Protocol):
    """Told the fraction done, 0 to 1, and words to show beside it."""

    def __call__(self, fraction: float, words: str = "", /) -> None: ...


@dataclass(frozen=True)
class SimulatedRun:
    """The run of a scene."""

    run: Trajectory
    folder: Path | None
    """Where it is kept."""
    was_kept: bool
    """Whether it was read from there instead of computed."""


def runs_of(
    scenes: list[Scene], folder: Path | None, *, verify: bool, progress: Progress | None
) -> Iterator[SimulatedRun]:
    """The runs of scenes, one after the other; each is written before the next one begins.

    A run of the same scene that is in the folder already is read. After Ctrl-C the part of a
    run that was computed is the last, and ``run.status`` says so.
    """
    taken: set[Path] = set()
    for k, scene in enumerate(scenes):
        own = None if folder is None else _own_folder(scene, folder, taken)
        if own is not None:
            taken.add(own)
        if kept := _kept(scene, own, verify=verify):
            yield SimulatedRun(kept, own, True)
            continue
        run = _simulated(scene, verify, _share(progress, k, len(scenes), scene.name))
        if own is not None and len(run.time):
            write_run(run, own, plots=False, force=True)
        yield SimulatedRun(run, own, False)
        if run.status == "interrupted":
            return


def _own_folder(scene: Scene, folder: Path, taken: set[Path]) -> Path:
    return next(path for path in numbered(folder / folder_name(scene.name)) if path not in taken)


def _kept(scene: Scene, folder: Path | None, *, verify: bool) -> Trajectory | None:
    """The run of the same scene in a folder, if there is a complete one of this version."""
    if folder is None:
        return None
    try:
        run = read_run(folder)
    except UsageError:
        return None
    is_same = run.spec_text == resolved_yaml(scene) and run.version == __version__
    is_enough = run.accuracy.estimated_tip_error_m is not None or not verify
    return run if is_same and run.status == "complete" and is_enough else None


def _simulated(scene: Scene, verify: bool, progress: Progress | None) -> Trajectory:
    """A run, or as much of it as there was before Ctrl-C."""
    try:
        return simulate(scene, verify=verify, progress=progress)
    except RunInterruptedError as stopped:
        if stopped.trajectory is None:
            raise
        return stopped.trajectory
    except SolveError as error:
        raise SolveError(
            f"{scene.name}: {error.short}",
            quantity=error.quantity,
            where=error.where,
            time_s=error.time_s,
            remedy=error.remedy,
        ) from error


def _share(progress: Progress | None, k: int, count: int, name: str) -> Progress | None:
    """Progress of the k-th of several runs; verifying one does not begin the bar again."""
    if progress is None:
        return None
    tell, reached = progress, 0.0

    def advance(fraction: float, words: str = "", /) -> None:
        nonlocal reached
        del words
        reached = max(reached, fraction)
        tell((k + reached) / count, f"{name} ({k + 1} of {count})")

    return advance
