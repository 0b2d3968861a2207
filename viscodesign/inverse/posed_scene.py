"""The scene that a search solves: at the target's times, or over one period."""

from __future__ import annotations

from typing import Any

import numpy as np

from viscodesign.errors import Fault, SpecError
from viscodesign.inverse.wanted_path import WantedPath
from viscodesign.scene.scene import Scene

ACCURACY_SHARE = 0.3
"""Part of the tolerance that the tip of a solution may be off."""
FINEST_ACCURACY = 1e-5
LOOP_STEPS = 128
"""Output times of a period."""


def posed_scene(scene: Scene, wanted: WantedPath, tolerance: float) -> Scene:
    """The scene solved well enough for a tolerance [m], where the target wants it.

    Raises `SpecError` where a loop is wanted and the inputs do not repeat.
    """
    share = max(ACCURACY_SHARE * tolerance / scene.actuator.length, FINEST_ACCURACY)
    changes: dict[str, Any] = {}
    if share < scene.accuracy:
        changes["accuracy"] = share
    if wanted.timing == "given" and wanted.times is not None:
        changes |= _at_times(scene, wanted.times)
    if wanted.closed:
        changes |= _over_one_period(scene, wanted)
    return scene.replace(changes) if changes else scene


def _at_times(scene: Scene, times: np.ndarray) -> dict[str, Any]:
    own = scene.run.output_times_array()
    if len(own) == len(times) and np.allclose(own, times, rtol=0.0, atol=1e-9 * own[-1]):
        return {}
    found: dict[str, Any] = {"run.output_times": times.tolist()}
    if times[-1] > scene.run.duration:
        found["run.duration"] = float(times[-1])
    return found


def _over_one_period(scene: Scene, wanted: WantedPath) -> dict[str, Any]:
    period = scene.period
    if period is None:
        kinds = ", ".join(sorted({own.name for own in scene.inputs.values()}))
        message = (
            f"is a loop, which the tip follows as a limit cycle; the input ({kinds}) does not "
            "repeat. Set input: {harmonics: 6, ...} free, give the spec a periodic input such as "
            "sine or square, or write closed: false"
        )
        raise SpecError([Fault(message, "target")])
    if wanted.timing == "given":
        return {"run.start": "periodic"}
    return {
        "run.start": "periodic",
        "run.duration": period,
        "run.output_interval": period / LOOP_STEPS,
    }
