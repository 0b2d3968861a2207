"""`viscodesign pump status`: what is connected and how it is; only reads."""

from __future__ import annotations

from typing import TYPE_CHECKING

from viscodesign.cli.options import Answer, Overrides
from viscodesign.cli.pump._options import Board, OptionalSpec, Wire, optional_scene
from viscodesign.errors import PumpError

if TYPE_CHECKING:
    from viscodesign.pump.sessions.inspecting import PumpStatus

EXAMPLE = """\b
Examples:
  viscodesign pump status --board dynamixel --port /dev/ttyUSB0
  viscodesign pump status leg.yaml --board arbotix-ros --port /dev/ttyUSB0"""


def command(
    spec: OptionalSpec = None,
    *,
    board: Board = "simulated",
    wire: Wire,
    overrides: Overrides = None,
    answer: Answer,
) -> None:
    """Show the axes that answer.

    With a spec, pressure and switches too. Only reads: nothing is switched, nothing is
    written. Exits with 4 where an axis must not be moved as it is, and says why.
    """
    from viscodesign.cli.output import complain
    from viscodesign.pump import status

    found = status(wire.to(board), optional_scene(spec, overrides), tell=complain)
    answer.give(found.document(), _lines(found))
    if found.objections:
        raise PumpError("\n".join(["the pump must not be moved as it is:", *found.objections]))


def _lines(found: PumpStatus) -> list[str]:
    from viscodesign.cli.texts.layout import table
    from viscodesign.pump.sessions.reports import axis_rows

    lines = [f"{found.address.label}{found.identity}"]
    lines += table(axis_rows(found.axes)) if found.axes else [f"  no {found.noun} answers"]
    for inlet, value in zip(found.inlets, found.pressure or (), strict=False):
        reading = "no sensor" if value is None else f"{value / 1e3:.2f} kPa gauge"
        name = f" of {inlet}" if len(found.inlets) > 1 else ""
        lines.append(f"  pressure{name}  {reading}")
    if found.pressed:
        lines.append(f"  pressed switches (or broken wires)  {', '.join(found.pressed)}")
    return [*lines, *(f"  {hint}" for hint in found.address.hints)]
