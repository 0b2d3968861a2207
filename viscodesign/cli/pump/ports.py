"""`viscodesign pump ports`: which serial ports there are."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING

from viscodesign.cli.options import Answer

if TYPE_CHECKING:
    from viscodesign.pump.bus.ports import Port

EXAMPLE = """\b
Example:
  viscodesign pump ports"""


def command(*, answer: Answer) -> None:
    """List serial ports, opening none.

    Also says what would make a slow one faster.
    """
    from viscodesign.pump.bus import ports

    found = ports.ports()
    answer.give({"ports": [asdict(port) for port in found]}, _lines(found))


def _lines(found: list[Port]) -> list[str]:
    from viscodesign.cli.texts.layout import table

    if not found:
        return ["no serial ports; plug the board in, and check that its driver loads (dmesg)"]
    rows = table([(p.name, p.maker, p.serial_number, p.description) for p in found], indent="")
    return [*rows, *(f"{port.name} {port.hint}" for port in found if port.hint)]
