"""`viscodesign fit`: numbers of a spec from measurements."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.options import Answer, Markers, Overrides, ResultFiles, Spec
from viscodesign.cli.specs import read_scene
from viscodesign.errors import InterruptedRunError, ViscodesignError

if TYPE_CHECKING:
    from viscodesign.results.fit_result import Fit

EXAMPLE = """\b
Examples:
  viscodesign fit leg.yaml data.csv
  viscodesign fit leg.yaml slow.csv "fast.csv@loads.payload=200 g"
  viscodesign fit leg.yaml data.csv --free fluid.viscosity \\
    --free network.tube_radius
"""


class MismatchError(ViscodesignError):
    """The model does not describe the recordings; its best numbers are on disk."""

    exit_code = 3


def command(
    spec: Spec,
    data: Annotated[
        list[str],
        typer.Argument(
            metavar="DATA...",
            help="Recordings (CSV); DATA.csv@KEY=VALUE has another value of a key.",
        ),
    ],
    overrides: Overrides = None,
    free: Annotated[
        list[str] | None,
        typer.Option(
            "--free",
            metavar="KEY",
            help="Key to fit; repeatable. Default: all coefficients, viscosity and damping.",
        ),
    ] = None,
    markers: Markers = None,
    following: Annotated[
        bool | None,
        typer.Option(
            "--next/--no-next",
            help="Suggest the most informative experiment. Default: where a number is unknown.",
        ),
    ] = None,
    *,
    files: ResultFiles,
    answer: Answer,
) -> None:
    """Fit numbers of a spec to recordings of its motion.

    A recording has a column time_s, and some of inlet_pressure_pa, syringe_volume_m3,
    m1_x_m, m1_z_m, ... (markers at the ends of the sections, from the clamp), tip_x_m
    and tip_z_m. Writes spec.yaml with the fitted numbers, fit.json and fit.png, and
    says which numbers the data cannot tell apart. A model that does not describe the
    recordings exits with 3, its numbers kept. Ctrl-C keeps the best so far.
    """
    from viscodesign import fit as find
    from viscodesign.cli.progress import progress
    from viscodesign.cli.run_folders import folder_for
    from viscodesign.cli.spare_folder import written
    from viscodesign.cli.texts.fit_text import fit_lines
    from viscodesign.report.fit_folder import write_fit
    from viscodesign.report.folder import new_folder

    scene = read_scene(spec, overrides)
    folder, remark = folder_for(scene, files.output, suffix="_fit")
    answer.remark(remark)
    with new_folder(folder, force=files.force), progress(answer.quiet, first="fitting") as advance:
        found = find(
            scene,
            data,
            free or None,
            markers=markers,
            next_experiment=following,
            progress=advance,
        )
    paths = written(lambda place: write_fit(found, place, **files.writing), folder)
    answer.give(found.document(), fit_lines(found, folder, paths), paths)
    _end(found, folder)


def _end(found: Fit, folder: Path) -> None:
    """Report a fit that was stopped, or describes nothing, after its files are written."""
    if found.status == "mismatch":
        raise MismatchError(
            "the model does not describe the recording, and none of its numbers counts as "
            f"identified; they are in {folder}, marked so"
        )
    if found.status == "interrupted":
        raise InterruptedRunError(f"interrupted; the best numbers so far are in {folder}")
