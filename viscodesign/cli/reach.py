"""`viscodesign reach`: where the tip can be, and what brings it to a point."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.options import Answer, Overrides, ResultFiles, Spec
from viscodesign.errors import InterruptedRunError, ViscodesignError

if TYPE_CHECKING:
    from viscodesign.results.reach_study import ReachStudy
    from viscodesign.scene.scene import Scene

EXAMPLE = """\b
Examples:
  viscodesign reach leg.yaml --limits "-25 kPa, 30 kPa"
  viscodesign reach leg.yaml --at "20 mm, 105 mm" --time "2 s" \\
    --limits "-25 kPa, 30 kPa"
"""


class OutOfReachError(ViscodesignError):
    """No input brings the tip to the point; the nearest is on disk."""

    exit_code = 3


def command(
    spec: Spec,
    overrides: Overrides = None,
    at: Annotated[
        str | None,
        typer.Option("--at", metavar="X,Z", help="A point, such as `20 mm, 105 mm`."),
    ] = None,
    time: Annotated[
        str | None,
        typer.Option("--time", metavar="TIME", help="When to be there; by default at the end."),
    ] = None,
    limits: Annotated[
        str | None,
        typer.Option(
            "--limits",
            metavar="LOW,HIGH",
            help="Of the inlet's pressure; by default those of the spec's input.",
        ),
    ] = None,
    harmonics: Annotated[
        int | None,
        typer.Option("--harmonics", metavar="N", min=1, help="Periodic inputs of N harmonics."),
    ] = None,
    seed: Annotated[int, typer.Option("--seed", min=0, help="Seed of the starts.")] = 0,
    *,
    files: ResultFiles,
    answer: Answer,
) -> None:
    """Find where the tip can be, and what brings it there.

    Writes reach.csv, reach.json and reach.png, with one inlet and with one a
    column; with a point its input.csv and a runnable spec.yaml, verified. A
    point that is out of reach exits with 3 and says by how much. Ctrl-C keeps
    what there is.
    """
    from viscodesign import reach as study_of
    from viscodesign.cli.option_values import pair, positive_time
    from viscodesign.cli.run_folders import named_folder
    from viscodesign.cli.spare_folder import written
    from viscodesign.cli.specs import read_scene
    from viscodesign.cli.texts.reach_text import reach_lines
    from viscodesign.report.folder import new_folder
    from viscodesign.report.reach_folder import write_reach

    point = None if at is None else pair("--at", at, "m", "20 mm, 105 mm")
    ends = None if limits is None else pair("--limits", limits, "Pa", "-25 kPa, 30 kPa")
    seconds = None if time is None else positive_time("--time", time)
    scene = read_scene(spec, overrides)
    if limits is not None and scene.input is not None:
        _refuse_bare(limits, scene)
    folder = named_folder(scene.name, files.output, "_reach")
    with new_folder(folder, force=files.force):
        study = study_of(scene, limits=ends, harmonics=harmonics, at=point, time=seconds, seed=seed)
    paths = written(lambda place: write_reach(study, place, **files.writing), folder)
    answer.give(study.document(), reach_lines(study, folder, paths), paths)
    _end(study, folder)


def _refuse_bare(limits: str, scene: Scene) -> None:
    """Raise a fault for limits without a unit that are another order than the spec's input."""
    from viscodesign.inverse.free_choice import input_size
    from viscodesign.inverse.free_range import bounds

    bounds("--limits", "Pa", limits.strip("[]() ").split(","), input_size(scene))


def _end(study: ReachStudy, folder: Path) -> None:
    """Report a study that was stopped, or a point out of reach, after the files are written."""
    own = study.point
    if study.interrupted:
        raise InterruptedRunError(f"interrupted; partial results are in {folder}")
    if own is not None and not own.is_reached:
        raise OutOfReachError(
            f"out of reach by {1e3 * own.miss_m:.3g} mm, from several starts; the nearest input "
            "is in spec.yaml. Allow more with --limits, or another --time"
        )
