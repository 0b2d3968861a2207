"""Absolute pressures of zero or less, at which no fluid is: refused before anything is solved."""

from __future__ import annotations

from viscodesign.errors import Fault, SpecError
from viscodesign.scene.robot_scene import RobotScene


def refuse_baseline_in_vacuum(scene: RobotScene) -> None:
    """Raise `SpecError` where the baseline pressure is zero absolute or less."""
    _refuse(scene, "gauge_pressure", scene.gauge_pressure)


def refuse_sources_in_vacuum(scene: RobotScene) -> None:
    """Raise `SpecError` where the baseline or a source is at zero absolute or less."""
    refuse_baseline_in_vacuum(scene)
    duration = scene.run.duration
    lowest = {name: own.extremes(duration)[0] for name, own in scene.sources.items()}
    name = min(lowest, key=lowest.__getitem__)
    _refuse(scene, f"inputs.{name}", scene.gauge_pressure + lowest[name])


def _refuse(scene: RobotScene, key: str, gauge: float) -> None:
    absolute = scene.ambient_pressure + gauge
    if absolute > 0.0:
        return
    message = (
        f"the lowest pressure, {gauge / 1e3:.6g} kPa gauge at an ambient_pressure of "
        f"{scene.ambient_pressure / 1e3:.6g} kPa, is {absolute / 1e3:.4g} kPa absolute; must be "
        "above 0. Is an absolute pressure written as gauge, or an amplitude too large?"
    )
    raise SpecError([Fault(message, key, scene.source.file)])
