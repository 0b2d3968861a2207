"""`viscodesign stand`: a robot on its legs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.options import Answer, Overrides, ResultFiles, Spec
from viscodesign.errors import ViscodesignError

if TYPE_CHECKING:
    from viscodesign.results.stand_study import StandStudy

EXAMPLE = """\b
Examples:
  viscodesign init hexapod.yaml --template hexapod
  viscodesign stand hexapod.yaml
  viscodesign stand hexapod.yaml --set robot.payload=500g --crouch 0.85"""


class CrouchNotMetError(ViscodesignError):
    """A crouch that was asked for is out of reach; the tables are on disk."""

    exit_code = 3
    kind = "solve"


class SwayError(ViscodesignError):
    """The robot is heavier than its legs bear, slides or tips over; its tables are on disk."""

    exit_code = 3
    kind = "solve"


def command(
    spec: Spec,
    overrides: Overrides = None,
    crouch: Annotated[
        list[float] | None,
        typer.Option(
            "--crouch",
            metavar="RATIO",
            help="Height of a crouch, over that of the legs at the spec's pressure; repeatable.",
        ),
    ] = None,
    *,
    files: ResultFiles,
    answer: Answer,
) -> None:
    """Compute how a robot stands on its legs.

    Height, sway limit and stiffness against gauge pressure and payload, and the
    barrel that a crouch needs; writes stand.csv, stand.json and stand.png. A robot
    that is heavier than its legs bear, slides or tips over exits with 3 and says why, and
    so does a --crouch out of reach.
    """
    from viscodesign import stand as study_of
    from viscodesign.cli.run_folders import named_folder
    from viscodesign.cli.specs import read_robot
    from viscodesign.cli.texts.stand_text import stand_lines
    from viscodesign.report.folder import new_folder
    from viscodesign.report.stand_folder import write_stand

    scene = read_robot(spec, overrides)
    folder = named_folder(scene.name, files.output, "_stand")
    with new_folder(folder, force=files.force):
        study = study_of(scene, **({"height_ratios": crouch} if crouch else {}))
    paths = write_stand(study, folder, **files.writing)
    answer.give(study.document(), stand_lines(study, folder, paths), paths)
    _refuse_sway(study)
    if crouch:
        _refuse_crouch(study)


def _refuse_crouch(study: StandStudy) -> None:
    """Report a crouch that no pressure reaches as an error, after the files are written."""
    told = [f"{1e2 * own.height_ratio:g} %: {own.reason}" for own in study.crouch if own.reason]
    if told:
        raise CrouchNotMetError(f"{study.name}: not met: no crouch to {'; nor to '.join(told)}")


def _refuse_sway(study: StandStudy) -> None:
    """Report a stance beyond sway as an error, after the files are written."""
    own = study.own
    if study.fall is not None:
        raise SwayError(f"{study.name}: the robot {study.fall.how}: {study.fall.why}")
    if not own.stands:
        gauge = f"{1e-3 * own.gauge_pressure_pa:.4g} kPa gauge"
        raise SwayError(
            f"{study.name}: the stance is beyond sway: the robot weighs {own.weight_n:.4g} N, and "
            f"at {gauge} its legs bear {own.sway_limit_n:.4g} N. Lower its payload or its pressure"
        )
