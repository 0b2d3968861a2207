"""`viscodesign pump record`: what the sensors show, into a file; moves nothing."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from viscodesign.cli.options import Answer, Overrides
from viscodesign.cli.pump._options import Board, Force, OptionalSpec, Pace, Wire, optional_scene

EXAMPLE = """\b
Examples:
  viscodesign pump record --board dynamixel --port /dev/ttyUSB0 -o rest.csv
  viscodesign pump record leg.yaml --board arbotix-ros --port /dev/ttyUSB0 \\
    -o rest.csv --duration 60"""


def command(
    spec: OptionalSpec = None,
    output: Annotated[
        Path, typer.Option("--output", "-o", metavar="FILE", help="The table, a CSV file.")
    ] = Path("record.csv"),
    duration: Annotated[
        float | None,
        typer.Option("--duration", metavar="S", min=0.0, help="By default until Ctrl-C."),
    ] = None,
    rate: Annotated[
        float, typer.Option("--rate", metavar="HZ", help="Rows per second, up to 100.")
    ] = 30.0,
    *,
    board: Board = "simulated",
    wire: Wire,
    pace: Pace = "1",
    force: Force = False,
    overrides: Overrides = None,
    answer: Answer,
) -> None:
    """Record what the pump's sensors show.

    Pressure, position, and what else an axis reports; only reads. The columns are the
    simulator's and those of `pump stream`. Without a spec all axes that answer are
    recorded, and no pressure.
    """
    from viscodesign.cli.output import complain
    from viscodesign.pump import record

    address, scene = wire.to(board, pace), optional_scene(spec, overrides)
    report = record(
        output, address, scene, rate=rate, duration=duration, force=force, tell=complain
    )
    answer.give(report.document(), [f"{address.label}{report.rows} rows in {output}"])
    report.raise_failure()
