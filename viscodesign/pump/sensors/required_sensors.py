"""Before a stream: every inlet has a pressure sensor, or the user goes without on purpose."""

from __future__ import annotations

from viscodesign.errors import UsageError
from viscodesign.scene.per_inlet import each
from viscodesign.scene.pumps.base import SensorSpec
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import copied

BOARD_CHANNELS = 8
"""Analog inputs of a board."""


def with_sensors(scene: Scene, *, simulated: bool, without: bool) -> Scene:
    """The scene with a sensor at every inlet, or with those that the user does without removed.

    A simulated board has them all. ``without``: where only some inlets have a sensor, these are
    still read; where all have one, none is. Raises `UsageError` where a real board would move
    a plunger whose pressure is not monitored.
    """
    inlets, pump = tuple(scene.inputs), scene.pump
    assert pump is not None, "sensors belong to a pump"
    sensors = each(pump.sensor, len(inlets))
    blind = [name for name, sensor in zip(inlets, sensors, strict=True) if sensor is None]
    if (0 < len(blind) < len(inlets)) if without else not blind:
        return scene
    if not (without or simulated):
        raise UsageError(_refusal(blind, inlets))
    # The first inlet's own sensor, if there is one; the others on free channels.
    own = [sensor for sensor in sensors if sensor is not None]
    free = set(range(BOARD_CHANNELS)) - {sensor.channel for sensor in own}
    every = [*own, *(SensorSpec(channel=channel) for channel in sorted(free))]
    chosen = None if without else dict(zip(inlets, every, strict=False))
    return copied(scene, {"pump": copied(pump, {"sensor": chosen})})


def _refusal(blind: list[str], inlets: tuple[str, ...]) -> str:
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
