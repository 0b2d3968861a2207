"""`viscodesign pump upload`: a planned profile as poses that an ArbotiX plays by itself."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.options import Answer, Overrides, PictureStyle, PictureWidth, Spec
from viscodesign.cli.pump._options import Achievable, Board, DryRun, Force, Wire, Yes
from viscodesign.errors import UsageError
from viscodesign.report.picture_options import PictureOptions, picture_options

if TYPE_CHECKING:
    from viscodesign.pump.kinds.base import ProfileUpload
    from viscodesign.pump.profile import Playback

EXAMPLE = """\b
Examples:
  viscodesign pump upload leg.yaml --dry-run --loop
  viscodesign pump upload leg.yaml --port /dev/ttyUSB0 --play
  viscodesign pump upload leg.yaml --tolerance "0.5 kPa" --export poses.h"""
VOLATILE = (
    "loaded, not played. The board keeps it in RAM only: a reset, a loss of power, or opening "
    "the port (which may reset the board) erases it. Add --play or --loop to play it now, or "
    "--export poses.h for a sketch that keeps it"
)


def command(
    spec: Spec,
    *,
    board: Board = "arbotix",
    wire: Wire,
    play: Annotated[bool, typer.Option("--play", help="Play it once.")] = False,
    loop: Annotated[bool, typer.Option("--loop", help="Loop it until Ctrl-C.")] = False,
    tolerance: Annotated[
        str,
        typer.Option(
            "--tolerance", metavar="ERROR", help="Largest error: '1 kPa', '0.1 mL' or '2 counts'."
        ),
    ] = "1 kPa",
    export: Annotated[
        Path | None,
        typer.Option(
            "--export", metavar="FILE", help="Write poses.h, for a sketch that needs no computer."
        ),
    ] = None,
    picture: Annotated[
        Path | None,
        typer.Option(
            "--picture",
            metavar="FILE",
            help="Plot requested and played motion (.png, .pdf or .svg).",
        ),
    ] = None,
    style: PictureStyle = "plain",
    width: PictureWidth = None,
    force: Force = False,
    achievable: Achievable = False,
    yes: Yes = False,
    dry_run: DryRun = False,
    overrides: Overrides = None,
    answer: Answer,
) -> None:
    """Fit a spec's pressures to 30 poses and 46 moves, for an ArbotiX to play.

    For PyPose, the firmware that the board comes with. The fit follows that firmware's own
    timing; its largest error is that of the motion which the board plays, and above
    --tolerance it is refused. Shows the plan and asks before anything moves. Nothing
    monitors the pump while the board plays: Ctrl-C halts it after the current move.
    """
    pictures = picture_options("png", style, width)
    from viscodesign.cli.confirm import asking
    from viscodesign.cli.output import complain
    from viscodesign.cli.progress import progress
    from viscodesign.cli.specs import read_pumped
    from viscodesign.pump.sessions.dry_run import rehearse_upload
    from viscodesign.pump.sessions.uploading import UploadSession, refuse_board

    scene = read_pumped(spec, overrides)
    refuse_board(board, scene)
    address, quiet = wire.to(board), answer.quiet
    playable = wire.port is not None or address.simulated
    _refuse_options(play, loop, playable or bool(export or picture or dry_run))
    playback: Playback = "loop" if loop else "once" if play else "none"
    with progress(quiet, "planning and fitting", "planning") as advance:
        session = UploadSession(scene, tolerance, playback, achievable, advance)
    files = _write(session.poses, export, picture, pictures, force)
    document, lines, report = session.poses.document(), session.description(), None
    if files:
        document |= {"status": "written", "files": [str(file) for file in files]}
    if dry_run:
        document["status"], lines = "dry run", rehearse_upload(session).text.splitlines()
    elif playable:
        confirm = asking(yes=yes, quiet=quiet)
        with progress(quiet or playback == "none", "round", "playing") as advance:
            report = session.perform(address, confirm=confirm, tell=complain, on_round=advance)
        if report.status == "complete" and not quiet:
            complain("\n".join(report.lines))
        document |= report.document()
        lines = [] if report.result else [VOLATILE]
    if export is not None:
        lines.append("the header's first lines show a sketch that plays it")
    lines += [f"written: {file}" for file in files]
    answer.give(document, lines)
    if report is not None:
        report.raise_failure()


def _refuse_options(play: bool, loop: bool, has_target: bool) -> None:
    if play and loop:
        raise UsageError("--play and --loop are mutually exclusive; remove one of them")
    if not has_target:
        raise UsageError(
            "--port is missing, such as /dev/ttyUSB0 (`viscodesign pump ports` lists them); or "
            "--export FILE for a sketch, or --dry-run to see what would be sent"
        )


def _write(
    poses: ProfileUpload,
    export: Path | None,
    picture: Path | None,
    pictures: PictureOptions,
    force: bool,
) -> list[Path]:
    """The files asked for, each whole or not at all; none over another unless forced."""
    from viscodesign.cli.output import write_text
    from viscodesign.pump.report.fit_chart import draw_fit
    from viscodesign.report.layout.look import drawn_as

    files = [file for file in (export, picture) if file is not None]
    existing = [file for file in files if file.exists()]
    if existing and not force:
        raise UsageError(f"{existing[0]} exists and is not overwritten; choose another, or --force")
    if export is not None:
        write_text(export, poses.header(), overwrite=force)
    if picture is not None:
        with drawn_as(pictures):
            draw_fit(poses.fit, poses.plan.wanted_run, picture)
    return files
