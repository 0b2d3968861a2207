"""The band in which the tip lies by what its spec says of its numbers."""

from __future__ import annotations

import time as clock

import numpy as np

from viscodesign.compiled.outputs import TIP_COLUMNS
from viscodesign.effects.effects_key import scene_key
from viscodesign.errors import SolveError, SpecError
from viscodesign.exploration.differentiable import LeftOut, differentiable
from viscodesign.exploration.stated_uncertainty import StatedDeviation, stated_deviations
from viscodesign.results.coefficient_band import CoefficientBand, UncertainNumber
from viscodesign.results.findings import Notice
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.scene import Scene
from viscodesign.storage.lru_cache import LruCache

Stated = dict[str, StatedDeviation]
_SLOPES: LruCache[tuple[np.ndarray, tuple[tuple[str, float, str], ...], LeftOut]] = LruCache(4)
"""Those of the latest scenes."""


def refuse_uncertainty(scene: Scene) -> None:
    """Raise `SpecError` for what a scene says of numbers that it cannot say it of."""
    stated_deviations(scene)


def coefficient_band(scene: Scene, run: Trajectory) -> CoefficientBand | Notice | None:
    """The band of a complete run, with the effects that it included, or why there is none.

    By one more solution and its exact derivatives by all numbers. None where the spec says nothing.
    """
    stated = stated_deviations(scene)
    if not stated or run.status != "complete":
        return None
    began = clock.perf_counter()
    try:
        slopes, numbers, left_out = _slopes(_pinned(scene, run), stated)
    except (SolveError, SpecError) as error:
        return Notice("no_band", f"the uncertainty of the tip is unknown: {error}", "uncertainty")
    if slopes.shape[0] != len(run.time) or not np.all(np.isfinite(slopes)):
        return Notice("no_band", "the motion has no derivatives by its numbers", "uncertainty")
    spread = np.array([stated[key].deviation for key, _, _ in numbers])
    moved = slopes * spread
    covariance = [np.sum(moved[:, i] * moved[:, k], axis=1) for i, k in ((0, 0), (1, 1), (0, 1))]
    return CoefficientBand(
        covariance=np.stack(covariance, axis=1),
        time=np.array(run.time),
        numbers=_by_share(numbers, stated, moved),
        left_out=left_out,
        wall_s=clock.perf_counter() - began,
    )


def _pinned(scene: Scene, run: Trajectory) -> Scene:
    """The scene with the effects that its run has included."""
    modes = {f"effects.{v.name}": "on" if v.taken else "off" for v in run.effects}
    return scene.replace({**modes, "effects.others": "off"})


def _slopes(
    scene: Scene, stated: Stated
) -> tuple[np.ndarray, tuple[tuple[str, float, str], ...], LeftOut]:
    """Derivatives of the tip (T, 2, k) [m/unit]; key, value and unit of each number."""

    def solved() -> tuple[np.ndarray, tuple[tuple[str, float, str], ...], LeftOut]:
        function, left_out = differentiable(scene, list(stated), TIP_COLUMNS, by_percent=False)
        slopes, names = function.jacobian(), function.names
        found = tuple(zip(names, map(float, function.values), function.units, strict=True))
        return np.stack([slopes[name] for name in TIP_COLUMNS], axis=1), found, left_out

    return _SLOPES.get((scene_key(scene), scene.source, tuple(stated)), solved)


def _by_share(
    numbers: tuple[tuple[str, float, str], ...], stated: Stated, moved: np.ndarray
) -> tuple[UncertainNumber, ...]:
    """The numbers, those first that contribute most to the variances."""
    own = np.sum(moved**2, axis=(0, 1))
    shares = own / (own.sum() or 1.0)
    found = [
        UncertainNumber(key, value, unit, stated[key].deviation, stated[key].assumed, float(share))
        for (key, value, unit), share in zip(numbers, shares, strict=True)
    ]
    return tuple(sorted(found, key=lambda number: -number.share))
