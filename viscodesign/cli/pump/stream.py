"""`viscodesign pump stream`: a planned profile, set-point by set-point in real time."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from viscodesign.cli.options import Answer, Overrides, Spec
from viscodesign.cli.pump._options import Achievable, Board, DryRun, Force, Pace, Wire, Yes

EXAMPLE = """\b
Examples:
  viscodesign pump stream leg.yaml
  viscodesign pump stream leg.yaml --pace max -o runs/rehearsal
  viscodesign pump stream leg.yaml --board arbotix-ros --port /dev/ttyUSB0"""


def command(
    spec: Spec,
    *,
    board: Board = "simulated",
    wire: Wire,
    rate: Annotated[
        float, typer.Option("--rate", metavar="HZ", help="Set-points per second, 10 to 100.")
    ] = 30.0,
    on_stop: Annotated[
        str,
        typer.Option(
            "--on-stop", metavar="WHAT", help="At any end: hold, release (no force), or retract."
        ),
    ] = "hold",
    achievable: Achievable = False,
    without_sensor: Annotated[
        bool,
        typer.Option(
            "--without-sensor",
            help="Move inlets without a pressure sensor (or do without all): only the torque "
            "limit caps the pressure.",
        ),
    ] = False,
    pace: Pace = "1",
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", metavar="DIR", help="Its folder; runs/<name>-stream by default."
        ),
    ] = None,
    force: Force = False,
    yes: Yes = False,
    dry_run: DryRun = False,
    overrides: Overrides = None,
    answer: Answer,
) -> None:
    """Play a spec's pressures, monitored at every tick.

    Shows the plan and asks before anything moves. Every tick reads the pump and its
    pressures, and stops at the first broken rule. Ctrl-C holds it where it is; pressed
    again within 3 s, it drops the torque or vents. Writes record.csv, with the
    simulator's columns, record.json and log.jsonl (every byte) to one folder. In runs,
    records of a real pump and of another spec of the same name are kept; a folder given
    by -o that holds a record of a real pump is refused without --force.
    """
    from viscodesign.cli.confirm import asking
    from viscodesign.cli.output import complain
    from viscodesign.cli.progress import progress
    from viscodesign.cli.specs import read_pumped
    from viscodesign.cli.texts.live_view import live_view
    from viscodesign.pump.sessions.dry_run import rehearse_stream
    from viscodesign.pump.sessions.record_folder import TABLE, refuse_measured
    from viscodesign.pump.sessions.streaming import StreamSession

    scene = read_pumped(spec, overrides)
    address, quiet = wire.to(board, pace), answer.quiet
    if output is not None and not dry_run:
        refuse_measured(output / TABLE, force=force)
    with progress(quiet, "planning", "planning") as advance:
        # `on_stop` is one of the words, as the session checks.
        options: Any = (rate, on_stop, achievable, without_sensor, advance, dry_run)
        session = StreamSession(scene, address, *options)
    if dry_run:
        lines = rehearse_stream(session).text.splitlines()
        return answer.give({"status": "dry run", "lines": lines}, lines)
    folder = output or _own_folder(scene.name, session.plan.resolved_sha256, answer, force)
    confirm = asking(yes=yes, quiet=quiet)
    with live_view(session.plan, session.settings, address.label, quiet) as (show, hint):
        report = session.perform(folder, confirm=confirm, tell=complain, hint=hint, on_tick=show)
    if report.status == "complete" and not quiet:
        complain("\n".join(report.lines))
    answer.give(report.document(), ())
    return report.raise_failure()


def _own_folder(name: str, resolved_sha256: str, answer: Answer, force: bool) -> Path:
    """The folder in `runs` for a scene's record: the next free one where an earlier is kept."""
    from viscodesign.cli.run_folders import named_folder
    from viscodesign.pump.sessions.record_folder import TABLE, is_of_another
    from viscodesign.report.folder_names import numbered

    plain = named_folder(name, None, "-stream")
    if force:
        return plain
    chosen = next(p for p in numbered(plain) if not is_of_another(p / TABLE, resolved_sha256))
    if chosen != plain:
        answer.remark(f"{plain} holds an earlier record, which is kept; this one is in {chosen}")
    return chosen
