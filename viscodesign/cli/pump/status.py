"""`viscodesign pump status`: what is there and how it does; reads only."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from viscodesign.cli.options import Debug, Json, Overrides, Quiet
from viscodesign.cli.pump._options import Baud, Board, Log, Port
from viscodesign.errors import PumpError

if TYPE_CHECKING:
    from viscodesign.cli.pump._session import Way
    from viscodesign.cli.pump._setting import Setting
    from viscodesign.pump.boards.base import Board as AnyBoard

EXAMPLE = """\b
Examples:
  viscodesign pump status --board dynamixel --port /dev/ttyUSB0
  viscodesign pump status leg.yaml --board arbotix-ros --port /dev/ttyUSB0"""


def command(
    spec: Annotated[
        Path | None,
        typer.Argument(metavar="[SPEC]", help="Names servos, sensor and switches."),
    ] = None,
    board: Board = "simulated",
    port: Port = None,
    baud: Baud = None,
    log: Log = None,
    overrides: Overrides = None,
    json: Json = False,
    quiet: Quiet = False,
    _debug: Debug = False,
) -> None:
    """Show the servos that answer.

    With a spec, pressure and switches too. Reads only: no torque is switched, nothing is
    written to a servo. Exits with 4 where a servo must not be moved as it is, and says why.
    """
    from viscodesign.cli.output import json_text, say
    from viscodesign.cli.pump._session import Way, opened
    from viscodesign.cli.pump._setting import setting_of

    way = Way(board, port, baud, "1", log)
    setting = setting_of(spec, overrides, way.simulated)
    with opened(way, way.clock(), setting) as (opened_board, _log):
        found = {**_found(opened_board, setting), "hints": way.hints}
    if json:
        say(json_text({"board": board, "simulated": way.simulated, **found}))
    elif not quiet:
        say("\n".join(_lines(way, found)))
    if found["objections"]:
        raise PumpError("\n".join(["it must not be moved as it is:", *found["objections"]]))


def _found(board: AnyBoard, setting: Setting) -> dict[str, Any]:
    """All that can be read, under names with units."""
    from viscodesign.cli.pump._told import servo_documents
    from viscodesign.pump.play.preflight import blocking_faults, identify

    identity = board.identify()
    servos = [identify(board, servo) for servo in setting.servos(board)]
    names = setting.named([servo.id for servo in servos])
    against = [] if setting.pump is None else [blocking_faults(s, setting.pump) for s in servos]
    return {
        "identity": identity,
        "servos": servo_documents(servos),
        "inlets": names,
        **_on_pins(board, setting, names),
        "objections": [reason for reasons in against for reason in reasons],
    }


def _on_pins(board: AnyBoard, setting: Setting, inlets: Sequence[str]) -> dict[str, Any]:
    """Pressure and switches, where the spec names them."""
    from viscodesign.cli.pump._session import gauges
    from viscodesign.pump.sensors.limit_switches import Switches
    from viscodesign.pump.sessions.open_board import servo_ids

    if setting.pump is None:
        return {}
    with gauges(board, setting.pump, setting.ambient, inlets) as sensors:
        pressure = sensors.read()
    servos = servo_ids(setting.pump)
    pressed = Switches.of(setting.pump, servos).read(board)
    of = dict(zip(servos, (f"{name} " for name in inlets), strict=True)) if len(inlets) > 1 else {}
    ends = [f"{of.get(servo, '')}{end}" for servo in pressed for end in sorted(pressed[servo])]
    return {"pressure_pa_gauge": pressure, "switches_pressed": ends}


def _lines(way: Way, found: dict[str, Any]) -> list[str]:
    from viscodesign.cli.pump._told import document_rows
    from viscodesign.cli.texts.layout import table

    lines = [f"{way.label}{found['identity']}"]
    lines += table(document_rows(found["servos"])) if found["servos"] else ["  no servo answers"]
    for inlet, value in zip(found["inlets"], found.get("pressure_pa_gauge", ()), strict=False):
        told = "no sensor" if value is None else f"{value / 1e3:.2f} kPa gauge"
        name = f" of {inlet}" if len(found["inlets"]) > 1 else ""
        lines.append(f"  pressure{name}  {told}")
    if pressed := found.get("switches_pressed"):
        lines.append(f"  pressed switches (or broken wires)  {', '.join(pressed)}")
    return [*lines, *(f"  {hint}" for hint in found["hints"])]
