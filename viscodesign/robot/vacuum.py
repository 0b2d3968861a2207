"""Pressures of a robot that no fluid can have, refused before anything is solved."""

from __future__ import annotations

from collections.abc import Iterator

from viscodesign.checks.vacuum import vacuum_faults
from viscodesign.errors import Fault, SpecError
from viscodesign.scene.robot_scene import RobotScene


def refuse_baseline_in_vacuum(scene: RobotScene) -> None:
    """Raise `SpecError` where the baseline pressure is zero absolute or less."""
    _raise(
        vacuum_faults(
            "gauge_pressure", scene.gauge_pressure, scene.ambient_pressure, file=scene.source.file
        )
    )


def refuse_sources_in_vacuum(scene: RobotScene) -> None:
    """Raise `SpecError` where the baseline or a source is at zero absolute or less."""
    refuse_baseline_in_vacuum(scene)
    duration = scene.run.duration
    lowest = {name: own.extremes(duration)[0] for name, own in scene.sources.items()}
    name = min(lowest, key=lowest.__getitem__)
    gauge = scene.gauge_pressure + lowest[name]
    _raise(
        vacuum_faults(
            f"inputs.{name}", gauge, scene.ambient_pressure, varies=True, file=scene.source.file
        )
    )


def _raise(faults: Iterator[Fault]) -> None:
    if found := list(faults):
        raise SpecError(found)
