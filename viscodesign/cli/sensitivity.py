"""`viscodesign sensitivity`: how far each number of a spec moves the tip."""

from __future__ import annotations

from typing import Annotated

import typer

from viscodesign.cli.options import (
    Debug,
    Force,
    Json,
    NoPlots,
    Overrides,
    PictureFormat,
    PictureStyle,
    PictureWidth,
    Quiet,
    RunFolder,
    Spec,
)
from viscodesign.errors import InterruptedRunError
from viscodesign.report.picture_options import picture_options

EXAMPLE = """\b
Examples:
  viscodesign sensitivity leg.yaml
  viscodesign sensitivity leg.yaml --tolerance network.tube_radius=5% \\
    --tolerance "network.tubes[*].length=0.5 mm"
  viscodesign sensitivity leg.yaml --tolerance fluid.viscosity=10% --sobol
"""


def command(
    spec: Spec,
    overrides: Overrides = None,
    tolerance: Annotated[
        list[str] | None,
        typer.Option(
            "--tolerance",
            metavar="KEY=5%",
            help="One standard deviation of a key, in % or with its unit; repeatable.",
        ),
    ] = None,
    sobol: Annotated[
        bool, typer.Option("--sobol", help="Check the band by solving a sample.")
    ] = False,
    seed: Annotated[int, typer.Option("--seed", min=0, help="Seed of the sample.")] = 0,
    output: RunFolder = None,
    no_plots: NoPlots = False,
    picture_format: PictureFormat = "png",
    style: PictureStyle = "plain",
    width: PictureWidth = None,
    force: Force = False,
    json: Json = False,
    quiet: Quiet = False,
    _debug: Debug = False,
) -> None:
    """Tell how far each number of a spec moves the tip.

    Without --tolerance for all numbers, in mm per percent; with it for these numbers, and the
    band that they give. Writes sensitivity.csv, sensitivity.json and sensitivity.png.
    """
    pictures = picture_options(picture_format, style, width)
    from viscodesign import sensitivity as study_of
    from viscodesign.cli.output import complain, say_result
    from viscodesign.cli.run_folders import folder_for
    from viscodesign.cli.spare_folder import written
    from viscodesign.cli.specs import read_scene
    from viscodesign.cli.texts.sensitivity_text import sensitivity_lines
    from viscodesign.report.folder import new_folder
    from viscodesign.report.sensitivity_folder import write_sensitivity
    from viscodesign.results.sensitivity_study import SensitivityInterruptedError

    scene = read_scene(spec, overrides)
    folder, remark = folder_for(scene, output)
    if remark and not quiet:
        complain(remark)
    stopped: SensitivityInterruptedError | None = None
    with new_folder(folder, force=force):
        try:
            study = study_of(scene, tolerance or None, sobol=sobol, seed=seed)
        except SensitivityInterruptedError as early:
            study, stopped = early.study, early
    files = written(
        lambda place: write_sensitivity(
            study, place, plots=not no_plots, force=force, pictures=pictures
        ),
        folder,
    )
    say_result(study.document(), files, sensitivity_lines(study, folder, files), json, quiet)
    if stopped is not None:
        raise InterruptedRunError(f"{stopped}\nwhat there is is in {folder}")
