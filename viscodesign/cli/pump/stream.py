"""`viscodesign pump stream`: a planned profile, set-point by set-point in real time."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.options import Debug, Json, Overrides, Quiet, Spec
from viscodesign.cli.pump._options import Baud, Board, DryRun, Log, Pace, Port, Yes
from viscodesign.cli.pump._playable import Achievable, refuse_unplayable
from viscodesign.errors import InterruptedRunError, PumpError, UsageError

if TYPE_CHECKING:
    from viscodesign.pump.play.stream import StreamResult

ON_STOP = ("hold", "release", "retract")
EXAMPLE = """\b
Examples:
  viscodesign pump stream leg.yaml
  viscodesign pump stream leg.yaml --pace max -o runs/rehearsal
  viscodesign pump stream leg.yaml --board arbotix-ros --port /dev/ttyUSB0"""


def command(
    spec: Spec,
    board: Board = "simulated",
    port: Port = None,
    baud: Baud = None,
    rate: Annotated[
        float, typer.Option("--rate", metavar="HZ", help="Set-points a second, 10 to 100.")
    ] = 30.0,
    on_stop: Annotated[
        str,
        typer.Option(
            "--on-stop", metavar="WHAT", help="At any end: hold, release (no torque), or retract."
        ),
    ] = "hold",
    achievable: Achievable = False,
    without_sensor: Annotated[
        bool,
        typer.Option(
            "--without-sensor",
            help="Go where an inlet has no pressure sensor, or all do without: no cap but the "
            "torque limit.",
        ),
    ] = False,
    pace: Pace = "1",
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", metavar="DIR", help="Its folder; runs/<name>-stream by default."
        ),
    ] = None,
    log: Log = None,
    yes: Yes = False,
    dry_run: DryRun = False,
    overrides: Overrides = None,
    json: Json = False,
    quiet: Quiet = False,
    _debug: Debug = False,
) -> None:
    """Play a spec's pressures, watched at every tick.

    Shows the plan and asks before anything moves. Every tick reads position, load, voltage,
    temperature and pressure, and stops at the first broken rule. Ctrl-C holds the plunger
    where it is; pressed again, it drops the torque. Writes record.csv, with the simulator's
    columns, record.json and log.jsonl (every byte) to one folder.
    """
    from viscodesign import load
    from viscodesign.cli.output import json_text, say
    from viscodesign.cli.progress import progress
    from viscodesign.cli.pump._performance import Performance
    from viscodesign.cli.pump._rehearsal import rehearsed
    from viscodesign.cli.pump._sensors import with_sensors
    from viscodesign.cli.pump._session import Way
    from viscodesign.cli.pump._told import ending_document
    from viscodesign.cli.simulate import folder_name
    from viscodesign.pump.planning.plan import plan
    from viscodesign.pump.planning.scene_variants import pump_of
    from viscodesign.pump.planning.simulated_actuator import ActuatorPlant
    from viscodesign.storage.atomic_files import refused_plainly

    _check(board, rate, on_stop)
    scene = with_sensors(load(spec, overrides or ()), board, without_sensor)
    folder = output or Path("runs") / f"{folder_name(scene.name)}-stream"
    way = Way(board, port, baud, pace, log or (None if dry_run else folder / "log.jsonl"))
    clock = way.clock()
    with progress(quiet, "planning", "planning") as advance:
        planned = plan(scene, progress=advance)
    refuse_unplayable(planned, achievable)
    performance = Performance(
        scene=scene,
        settings=pump_of(scene),
        plan=planned,
        way=way,
        clock=clock,
        plant=ActuatorPlant(scene) if way.simulated and not dry_run else None,
        rate=rate,
        on_stop=on_stop,  # type: ignore[arg-type]  # one of them, as checked
        table=folder / "record.csv",
        yes=yes,
        quiet=quiet,
    )
    if dry_run:
        return say("\n".join(rehearsed(performance)))
    with refused_plainly(folder):
        folder.mkdir(parents=True, exist_ok=True)
    ending = performance.perform()
    if json:
        say(json_text({"name": scene.name, **ending_document(ending), **performance.told}))
    _leave(ending, folder)
    return None


def _check(board: str, rate: float, on_stop: str) -> None:
    from viscodesign.pump.play.link_rate import HIGHEST_RATE, LOWEST_RATE
    from viscodesign.pump.sessions.open_board import board_kind, boards

    if not board_kind(board).streams:
        able = ", ".join(name for name, kind in boards().items() if kind.streams)
        raise UsageError(
            f"--board {board} takes no set-points in real time; those that do: {able}. "
            "`pump upload` gives it a whole profile"
        )
    if not LOWEST_RATE <= rate <= HIGHEST_RATE:
        raise UsageError(f"--rate {rate:g}; give {LOWEST_RATE:g} to {HIGHEST_RATE:g} Hz")
    if on_stop not in ON_STOP:
        raise UsageError(f"--on-stop {on_stop}: no such thing; one of {', '.join(ON_STOP)}")


def _leave(ending: StreamResult, folder: Path) -> None:
    """What did not end well is an error, after its files are written."""
    kept = f"the record up to there is in {folder}"
    if not ending.sure or ending.status == "stopped":
        raise PumpError(f"stopped ({ending.rule or 'hold not verified'}); {kept}")
    if ending.status == "interrupted":
        raise InterruptedRunError(f"interrupted; {kept}")
