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
        f"the lowest absolute pressure is {1e-3 * absolute:.4g} kPa ({1e-3 * gauge:.4g} kPa gauge "
        f"at an ambient_pressure of {1e-3 * scene.ambient_pressure:.4g} kPa), but no fluid has "
        "one of zero or less; is an absolute pressure given as gauge, or an amplitude too large?"
    )
    raise SpecError([Fault(message, key, scene.source.file)])
