"""Which pump a command speaks of: a spec's, or without one what can be known all the same."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from viscodesign.pump.boards.base import Board
    from viscodesign.scene.pump import Pump
    from viscodesign.scene.scene import Scene

STANDARD_AMBIENT = 101_325.0
"""Absolute [Pa]."""
TRIED = range(1, 9)
"""Ids that are asked where no spec names them."""


@dataclass(frozen=True)
class Setting:
    """The drive, where known, and the air around it."""

    pump: Pump | None
    ambient: float
    """Absolute [Pa]."""
    inlets: tuple[str, ...] = ()
    """Names of the servos' inlets; empty where no spec names them."""

    @classmethod
    def of(cls, scene: Scene) -> Setting:
        """A spec's."""
        from viscodesign.pump.planning.scene_variants import pump_of

        return cls(pump_of(scene), scene.ambient_pressure, tuple(scene.inputs))

    def servos(self, board: Board) -> list[int]:
        """The spec's servos; without one all that answer."""
        from viscodesign.pump.sessions.open_board import servo_ids

        if self.pump is not None:
            return servo_ids(self.pump)
        return [servo for servo in TRIED if board.answers(servo)]

    def named(self, servos: Sequence[int]) -> tuple[str, ...]:
        """A name for each servo's inlet."""
        if self.inlets:
            return self.inlets
        return ("inlet",) if len(servos) == 1 else tuple(f"servo{id}" for id in servos)


def setting_of(spec: Path | None, overrides: Sequence[str] | None, simulated: bool) -> Setting:
    """From a spec; without one, a simulated pump is the default one."""
    from viscodesign import load
    from viscodesign.errors import UsageError
    from viscodesign.scene.pump import Pump

    if spec is not None:
        return Setting.of(load(spec, overrides or ()))
    if overrides:
        raise UsageError("--set changes a spec, and none is given")
    if not simulated:
        return Setting(None, STANDARD_AMBIENT)
    default = {"syringe_diameter": "34.9 mm", "sensor": {"channel": 0}}
    return Setting(Pump.model_validate(default), STANDARD_AMBIENT, ("inlet",))
