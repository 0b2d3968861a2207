"""`viscodesign sensitivity`: how far each number of a spec moves the tip."""

from __future__ import annotations

from typing import Annotated

import typer

from viscodesign.cli.options import Answer, Overrides, ResultFiles, Spec
from viscodesign.errors import InterruptedRunError

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
    *,
    files: ResultFiles,
    answer: Answer,
) -> None:
    """Measure how far each number of a spec moves the tip.

    Without --tolerance for all numbers, in mm per percent; with it for these numbers, and the
    band that they give. Writes sensitivity.csv, sensitivity.json and sensitivity.png.
    """
    from viscodesign import sensitivity as study_of
    from viscodesign.cli.run_folders import folder_for
    from viscodesign.cli.spare_folder import written
    from viscodesign.cli.specs import read_scene
    from viscodesign.cli.texts.sensitivity_text import sensitivity_lines
    from viscodesign.report.folder import new_folder
    from viscodesign.report.sensitivity_folder import write_sensitivity
    from viscodesign.results.sensitivity_study import SensitivityInterruptedError

    scene = read_scene(spec, overrides)
    folder, remark = folder_for(scene, files.output)
    answer.remark(remark)
    stopped: SensitivityInterruptedError | None = None
    with new_folder(folder, force=files.force):
        try:
            study = study_of(scene, tolerance or None, sobol=sobol, seed=seed)
        except SensitivityInterruptedError as early:
            study, stopped = early.study, early
    paths = written(lambda place: write_sensitivity(study, place, **files.writing), folder)
    answer.give(study.document(), sensitivity_lines(study, folder, paths), paths)
    if stopped is not None:
        raise InterruptedRunError(f"{stopped}\npartial results are in {folder}")
