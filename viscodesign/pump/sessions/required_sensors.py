"""Before a stream: every inlet has a pressure sensor, or the user goes without on purpose."""

from __future__ import annotations

from collections.abc import Sequence

from viscodesign.errors import UsageError
from viscodesign.pump.planning.scene_variants import pump_of
from viscodesign.scene.per_inlet import each
from viscodesign.scene.pump import SensorSpec
from viscodesign.scene.scene import Scene

BOARD_CHANNELS = 8
"""Analog inputs of a board."""


def with_sensors(scene: Scene, *, simulated: bool, without: bool) -> Scene:
    """The scene with a sensor at every inlet, or with those that the user does without removed.

    A simulated board has them all. ``without``: where only some inlets have a sensor, these are
    still read; where all have one, none is. Raises `UsageError` where a real board would move
    a plunger whose pressure is not monitored.
    """
    inlets = tuple(scene.inputs)
    sensors = each(pump_of(scene).sensor, len(inlets))
    blind = [name for name, sensor in zip(inlets, sensors, strict=True) if sensor is None]
    if without:
        return scene if 0 < len(blind) < len(inlets) else _with(scene, None)
    if not blind:
        return scene
    if not simulated:
        raise UsageError(_refusal(blind, inlets))
    return _with(scene, _invented(sensors, inlets))


def _with(scene: Scene, sensors: dict[str, SensorSpec] | None) -> Scene:
    pump = pump_of(scene).model_copy(update={"sensor": sensors})
    return scene.model_copy(update={"pump": pump})


def _invented(sensors: Sequence[SensorSpec | None], inlets: Sequence[str]) -> dict[str, SensorSpec]:
    """The first inlet's own sensor if there is one, the others on free channels."""
    own = [sensor for sensor in sensors if sensor is not None]
    used = {sensor.channel for sensor in own}
    others = [SensorSpec(channel=c) for c in range(BOARD_CHANNELS) if c not in used]
    return dict(zip(inlets, [*own, *others], strict=False))


def _refusal(blind: Sequence[str], inlets: Sequence[str]) -> str:
    """What to do about inlets that no software would keep below the cap."""
    missing, example = "the spec names no pressure sensor", "{channel: 0}"
    if len(inlets) > 1:
        missing += f" for {' and '.join(blind)}"
        channels = ", ".join(f"{name}: {{channel: {k}}}" for k, name in enumerate(inlets))
        example = f"{{{channels}}}"
    return (
        f"{missing}, so the pressure cap could not be enforced: add pump.sensor, like "
        f"`sensor: {example}`, or use --without-sensor and rely on the servo's torque limit"
    )
