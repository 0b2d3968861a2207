"""A pressure sensor at every inlet, before anything is streamed."""

from __future__ import annotations

from collections.abc import Sequence

from viscodesign.errors import UsageError
from viscodesign.pump.planning.scene_variants import pump_of
from viscodesign.pump.sessions.open_board import board_kind
from viscodesign.scene.per_inlet import each
from viscodesign.scene.pump import Sensor
from viscodesign.scene.scene import Scene

CHANNELS = 8
"""Of a board."""


def with_sensors(scene: Scene, board: str, without: bool) -> Scene:
    """The scene with a sensor at every inlet, or with the user's word that some have none.

    A simulated board has them all. ``without``: where only some inlets have one, these are read
    all the same; where all have one, none is. Raises `UsageError` where a real board would move
    a plunger whose pressure nobody watches.
    """
    pump, inlets = pump_of(scene), tuple(scene.inputs)
    sensors = each(pump.sensor, len(inlets))
    blind = [name for name, sensor in zip(inlets, sensors, strict=True) if sensor is None]
    if without:
        return scene if 0 < len(blind) < len(inlets) else _with(scene, None)
    if not blind:
        return scene
    if not board_kind(board).simulated:
        raise UsageError(_unwatched(blind, inlets))
    return _with(scene, _made_up(sensors, inlets))


def _with(scene: Scene, sensors: dict[str, Sensor] | None) -> Scene:
    pump = pump_of(scene).model_copy(update={"sensor": sensors})
    return scene.model_copy(update={"pump": pump})


def _made_up(sensors: Sequence[Sensor | None], inlets: Sequence[str]) -> dict[str, Sensor]:
    """The first inlet's own one if there is one, and others on free channels."""
    own = [sensor for sensor in sensors if sensor is not None]
    taken = {sensor.channel for sensor in own}
    others = [Sensor(channel=c) for c in range(CHANNELS) if c not in taken]
    return dict(zip(inlets, [*own, *others], strict=False))


def _unwatched(blind: Sequence[str], inlets: Sequence[str]) -> str:
    """What to do about inlets that no software would keep below the cap."""
    lacks, like = "the spec names no pressure sensor", "{channel: 0}"
    if len(inlets) > 1:
        lacks += f" for {' and '.join(blind)}"
        like = "{" + ", ".join(f"{name}: {{channel: {k}}}" for k, name in enumerate(inlets)) + "}"
    return (
        f"{lacks}, so no cap would be watched: add pump.sensor, like `sensor: {like}`, "
        "or go --without-sensor and rely on the servo's torque limit"
    )
