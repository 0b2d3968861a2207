"""`viscodesign pump calibrate`: where home and the ends of travel are, kept in the pump too."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated

import typer

from viscodesign.cli.options import Debug, Overrides, Quiet, Spec
from viscodesign.cli.pump._options import DryRun, RealBoard, Wire, Yes
from viscodesign.errors import UsageError

EXAMPLE = """\b
Examples:
  viscodesign pump calibrate leg.yaml --board dynamixel --port /dev/ttyUSB0
  viscodesign pump calibrate leg.yaml --keep --board dynamixel \\
    --port /dev/ttyUSB0"""
READ_INTERVAL_S = 0.1
"""Between two readings of a plunger that is moved by hand."""


def command(
    spec: Spec,
    *,
    board: RealBoard,
    wire: Wire,
    keep: Annotated[
        bool, typer.Option("--keep", help="Take the spec's home and travel; measure nothing.")
    ] = False,
    rename: Annotated[
        str | None,
        typer.Option("--rename", metavar="OLD=NEW", help="Give an axis another id first."),
    ] = None,
    write: Annotated[
        bool, typer.Option("--write", help="Put home and travel into the spec's file.")
    ] = False,
    yes: Yes = False,
    dry_run: DryRun = False,
    overrides: Overrides = None,
    quiet: Quiet = False,
    _debug: Debug = False,
) -> None:
    """Find home and travel, and keep them in the pump.

    Against limit switches where the spec names them, slowly and with little torque; else by
    hand, with the torque off. Angle limits are set to the travel. The only command that
    writes what a pump keeps without power: ids, angle limits and whether it answers; only
    what differs, and each is asked for. A pump with nothing to calibrate is refused.
    """
    from viscodesign import load
    from viscodesign.cli.confirm import asking
    from viscodesign.cli.output import complain, say
    from viscodesign.pump import calibrate
    from viscodesign.pump.sessions.calibrating import calibration_steps
    from viscodesign.scene.reading.edit import write_values

    scene, ids = load(spec, overrides or ()), _ids(rename)
    if dry_run:
        return say("\n".join(calibration_steps(scene, keep, ids)))
    found = calibrate(
        scene,
        wire.to(board),
        confirm=asking(yes=yes),
        vented=asking(yes=False),
        by_hand=_position_by_hand,
        keep=keep,
        rename=ids,
        tell=complain,
    )
    values = {"home": str(found.home), "travel": str(list(found.travel))}
    if write:
        write_values(spec, "pump", values)
        complain(f"written to {spec}")
    if not quiet:
        say("\n".join(["pump:", *(f"  {key}: {value}" for key, value in values.items())]))
    return None


def _ids(words: str | None) -> tuple[int, int] | None:
    if words is None:
        return None
    try:
        old, new = (int(word) for word in words.split("="))
    except ValueError:
        raise UsageError(f"--rename {words}: expected two ids, like 1=2") from None
    return old, new


def _position_by_hand(task: str, read: Callable[[], int]) -> int:
    """The position [counts] when Enter is pressed; shown while the plunger is moved."""
    import select
    import sys

    if not sys.stdin.isatty():
        raise UsageError(
            "not a terminal, cannot ask to move the plunger by hand; use --keep to take home and "
            "travel from the spec"
        )
    while True:
        position = read()
        sys.stderr.write(f"\r\x1b[K{task}: {position} counts ")
        sys.stderr.flush()
        if select.select([sys.stdin], [], [], READ_INTERVAL_S)[0] and sys.stdin.readline():
            return position
