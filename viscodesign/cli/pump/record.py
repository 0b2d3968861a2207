"""`viscodesign pump record`: what the sensors say, into a file; moves nothing."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from viscodesign.cli.options import Debug, Json, Overrides, Quiet
from viscodesign.cli.pump._options import Baud, Board, Log, Pace, Port
from viscodesign.errors import InterruptedRunError, PumpError, UsageError

if TYPE_CHECKING:
    from viscodesign.cli.pump._session import Way
    from viscodesign.cli.pump._setting import Setting

EXAMPLE = """\b
Examples:
  viscodesign pump record --board dynamixel --port /dev/ttyUSB0 -o rest.csv
  viscodesign pump record leg.yaml --board arbotix-ros --port /dev/ttyUSB0 \\
    -o rest.csv --duration 60"""


def command(
    spec: Annotated[
        Path | None, typer.Argument(metavar="[SPEC]", help="Names servos, sensor and ambient.")
    ] = None,
    output: Annotated[
        Path, typer.Option("--output", "-o", metavar="FILE", help="The table, a CSV file.")
    ] = Path("record.csv"),
    duration: Annotated[
        float | None,
        typer.Option("--duration", metavar="S", min=0.0, help="Else until Ctrl-C."),
    ] = None,
    rate: Annotated[
        float, typer.Option("--rate", metavar="HZ", help="Rows a second, up to 100.")
    ] = 30.0,
    board: Board = "simulated",
    port: Port = None,
    baud: Baud = None,
    pace: Pace = "1",
    log: Log = None,
    overrides: Overrides = None,
    json: Json = False,
    quiet: Quiet = False,
    _debug: Debug = False,
) -> None:
    """Record what the pump's sensors say.

    Pressure, position, load, voltage and temperature; reads only, no torque. The columns are
    the simulator's and those of `pump stream`. Without a spec all servos that answer are
    recorded, and no pressure.
    """
    from viscodesign.cli.output import json_text, say
    from viscodesign.cli.pump._session import Way
    from viscodesign.cli.pump._setting import setting_of

    if not 0.0 < rate <= 100.0:
        raise UsageError(f"--rate {rate:g}; give more than 0, up to 100 Hz")
    if output.suffix == ".json":
        raise UsageError(f"{output}: its JSON would have the same name; call the table .csv")
    way = Way(board, port, baud, pace, log)
    if pace == "max" and duration is None:
        raise UsageError("--pace max needs a --duration: it would fill the disk before you look")
    told = _record(way, setting_of(spec, overrides, way.simulated), output, rate, duration)
    if json:
        say(json_text(told))
    elif not quiet:
        say(f"{way.label}{told['rows']} rows in {output}")
    if told["status"] == "interrupted":
        raise InterruptedRunError(f"stopped before its time; what was read is in {output}")


def _record(
    way: Way, setting: Setting, path: Path, rate: float, duration: float | None
) -> dict[str, Any]:
    """Read until the time is over; what the JSON beside the table says then."""
    from viscodesign.cli.pump._session import gauges, opened
    from viscodesign.interrupt import stop_on_signals
    from viscodesign.pump.play.listen import listen
    from viscodesign.pump.sessions.record import recorded

    clock = way.clock()
    with opened(way, clock, setting) as (board, log):
        identity = board.identify()
        servos = setting.servos(board)
        names = setting.named(servos)
        facts = {"board": way.board, "simulated": way.simulated, "identity": identity}
        with (
            gauges(board, setting.pump, setting.ambient, names) as sensors,
            recorded(path, names, facts) as record,
            stop_on_signals() as wish,
        ):
            try:
                ticks = listen(
                    board, servos, sensors, clock, wish, record.add, rate=rate, duration=duration
                )
            except PumpError as error:
                record.state("stopped", reason=str(error))
                raise
            # Without a duration there is no other end than the user's.
            early = wish.asked and duration is not None
            status = "interrupted" if early else "complete"
            log.event("ended", status=status, **ticks.document())
            record.state(status, ticks=ticks.document())
            return {"status": status, "rows": record.rows, "file": str(path), **facts}
