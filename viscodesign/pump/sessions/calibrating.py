"""Where the axes of a pump start and how far they may go."""

from __future__ import annotations

from viscodesign.errors import UsageError
from viscodesign.pump.consent import Confirm, ShowPosition, Tell, ignore
from viscodesign.pump.kinds.base import Calibration, CalibrationRequest
from viscodesign.pump.sessions.arguments import typed
from viscodesign.pump.sessions.board_names import kind_of
from viscodesign.pump.sessions.connection import BoardAddress, connected
from viscodesign.scene.scene import Scene


@typed
def calibrate(
    scene: Scene,
    address: BoardAddress,
    *,
    confirm: Confirm,
    by_hand: ShowPosition | None = None,
    vented: Confirm | None = None,
    keep: bool = False,
    rename: tuple[int, int] | None = None,
    tell: Tell = ignore,
) -> Calibration:
    """Find home and travel of the scene's axes, and keep them where the pump can keep them.

    With the scene's limit switches, slowly and with little force; without them by hand, with the
    force off: ``vented`` (by default ``confirm``) is asked before, and ``by_hand`` for each
    position. ``keep`` takes the scene's values and measures nothing; ``rename`` first gives an
    axis another id (old, new). The only session that writes what a pump keeps without power:
    only what differs, each after ``confirm``. Raises `UsageError` where a kind of pump has
    nothing to calibrate.
    """
    request = CalibrationRequest(confirm, by_hand, vented, keep, rename, tell)
    kind = kind_of(scene)
    if (reason := kind.not_calibrated) or address.simulated:
        raise UsageError(reason or "a simulated pump is calibrated as its spec says")
    with connected(address, scene, tell=tell) as link:
        found = kind.calibrate(link, request)
        link.log.event("calibrated", home_counts=found.home, travel_counts=found.travel)
    return found


def calibration_steps(scene: Scene, keep: bool, rename: tuple[int, int] | None) -> list[str]:
    """What `calibrate` would do; opens no port."""
    kind = kind_of(scene)
    request = CalibrationRequest(lambda text: False, keep=keep, rename=rename)
    steps = kind.calibration_steps(scene.pump, request)
    return ["[dry run] no port is opened; it would", *(f"  {step}" for step in steps)]
