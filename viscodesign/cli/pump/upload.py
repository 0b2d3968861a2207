"""`viscodesign pump upload`: a planned profile as poses that an ArbotiX plays by itself."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from viscodesign.cli.options import Debug, Json, Overrides, Quiet, Spec
from viscodesign.cli.pump._options import Baud, Board, DryRun, Log, Port, Yes
from viscodesign.cli.pump._playable import Achievable, refuse_unplayable
from viscodesign.errors import InterruptedRunError, PumpError, UsageError

if TYPE_CHECKING:
    from viscodesign.cli.pump._poses import Poses
    from viscodesign.pump.play.stream import StreamResult

EXAMPLE = """\b
Examples:
  viscodesign pump upload leg.yaml --dry-run --loop
  viscodesign pump upload leg.yaml --port /dev/ttyUSB0 --play
  viscodesign pump upload leg.yaml --tolerance "0.5 kPa" --export poses.h"""


def command(
    spec: Spec,
    board: Board = "arbotix",
    port: Port = None,
    baud: Baud = None,
    play: Annotated[bool, typer.Option("--play", help="Play it once.")] = False,
    loop: Annotated[
        bool, typer.Option("--loop", help="Play it round and round, until Ctrl-C.")
    ] = False,
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
        typer.Option("--picture", metavar="FILE", help="Draw wanted, played and error, as PNG."),
    ] = None,
    force: Annotated[bool, typer.Option("--force", help="Overwrite files that exist.")] = False,
    achievable: Achievable = False,
    log: Log = None,
    yes: Yes = False,
    dry_run: DryRun = False,
    overrides: Overrides = None,
    json: Json = False,
    quiet: Quiet = False,
    _debug: Debug = False,
) -> None:
    """Fit a spec's pressures to 30 poses and 46 moves, for an ArbotiX to play.

    For the firmware PyPose, with which the board comes. The fit follows that
    firmware's own timing; its largest error is that of the motion which the board
    plays, and above --tolerance it is refused. Before anything moves the plan is
    shown, and agreed to. Nothing supervises the pump while the board plays: Ctrl-C
    halts it after the move it is in.
    """
    from viscodesign import load
    from viscodesign.cli.progress import progress
    from viscodesign.cli.pump._pose_rehearsal import rehearsed
    from viscodesign.cli.pump._poses import FORGOTTEN, Poses, Upload
    from viscodesign.cli.pump._session import Way
    from viscodesign.pump.planning.plan import plan
    from viscodesign.pump.planning.scene_variants import pump_of
    from viscodesign.pump.poses.fit_error import Tolerance

    allowed = Tolerance.of(tolerance)
    _check(board, port, play, loop, bool(export or picture or dry_run))
    scene = load(spec, overrides or ())
    settings = pump_of(scene)
    with progress(quiet, "planning", "planning") as advance:
        planned = plan(scene, progress=advance)
    refuse_unplayable(planned, achievable)
    course = planned.wanted if planned.is_feasible else planned.achievable
    poses = Poses.of(scene, settings, planned, course, allowed, loop=loop, quiet=quiet)
    told: dict[str, Any] = poses.document()
    files = _write(poses, export, picture, force)
    if files:
        told |= {"status": "written", "files": [str(file) for file in files]}
    ending: StreamResult | None = None
    lines = poses.lines()
    if dry_run:
        told["status"], lines = "dry run", rehearsed(poses, moves=play or loop)
    elif port is not None:
        way = Way(board, port, baud, log=log)
        ending = Upload(poses, way, way.clock(), play or loop, yes, quiet).perform()
        told["status"], lines = "loaded", [] if play or loop else [FORGOTTEN]
    if export is not None:
        lines.append("a sketch that plays the header stands in its first lines")
    lines += [f"written: {file}" for file in files]
    _say(told, ending, lines, json, quiet)
    _leave(ending)


def _check(board: str, port: str | None, play: bool, loop: bool, portless: bool) -> None:
    from viscodesign.pump.boards.arbotix import Arbotix
    from viscodesign.pump.sessions.open_board import board_kind

    if not issubclass(board_kind(board), Arbotix):
        raise UsageError(
            f"--board {board} takes no poses; those go to --board {Arbotix.name}. "
            "`pump stream` sends this one set-points in real time"
        )
    if play and loop:
        raise UsageError("--play and --loop: once or round and round; give one of them")
    if port is None and not portless:
        raise UsageError(
            "--port is missing, such as /dev/ttyUSB0 (`viscodesign pump ports` lists them); or "
            "--export FILE for a sketch, or --dry-run to see what would be sent"
        )


def _write(poses: Poses, export: Path | None, picture: Path | None, force: bool) -> list[Path]:
    """The files asked for, each whole or not at all; none over another unless forced."""
    from viscodesign.cli.output import write_text

    taken = [file for file in (export, picture) if file is not None and file.exists()]
    if taken and not force:
        raise UsageError(f"{taken[0]} exists and is not overwritten; choose another, or --force")
    if export is not None:
        write_text(export, poses.header(), overwrite=force)
    if picture is not None:
        from viscodesign.pump.report.fit_chart import draw_fit

        draw_fit(poses.fit, poses.plan.wanted_run, picture)
    return [file for file in (export, picture) if file is not None]


def _say(
    told: dict[str, Any], ending: StreamResult | None, lines: list[str], json: bool, quiet: bool
) -> None:
    from viscodesign.cli.output import json_text, say
    from viscodesign.cli.pump._told import ending_document

    if json:
        say(json_text({**told, **(ending_document(ending) if ending else {})}))
    elif lines and not quiet:
        say("\n".join(lines))


def _leave(ending: StreamResult | None) -> None:
    """What did not end well is an error."""
    if ending is None:
        return
    if not ending.sure or ending.status == "stopped":
        raise PumpError(ending.reason)
    if ending.status == "interrupted":
        raise InterruptedRunError(ending.reason)
