"""The band in which the tip lies by what its spec says of its numbers."""

from __future__ import annotations

import time as clock

import numpy as np

from viscodesign.compiled.outputs import TIP_COLUMNS
from viscodesign.compiled.scene_numbers import NOTHING_DEPENDS
from viscodesign.effects.effects_key import scene_key
from viscodesign.errors import SolveError, SpecError
from viscodesign.results.coefficient_band import CoefficientBand, UncertainNumber
from viscodesign.results.findings import Notice
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.scene import Scene
from viscodesign.storage.lru_cache import LruCache
from viscodesign.studies.differentiable import LeftOut, differentiable
from viscodesign.studies.stated_uncertainty import StatedDeviation

WIDEST_BAND = 0.43
"""Half-width, relative to the length, up to which bands were found to hold
(`benchmarks/results/uncertainty_coverage.md`)."""
BAND_STEP_TOLERANCE = 1e-3
"""Of the steps: bands by it are within a percent of those by far smaller ones."""
Stated = dict[str, StatedDeviation]
Slopes = tuple[np.ndarray, tuple[tuple[str, float, str], ...], LeftOut]
"""Derivatives of the tip (T, 2, k) [m/unit]; key, value and unit of each number; other keys."""
_SLOPES: LruCache[Slopes] = LruCache(4)
"""Those of the latest scenes."""


def coefficient_band(
    scene: Scene, run: Trajectory, stated: Stated
) -> CoefficientBand | Notice | None:
    """The band of a complete run, with the effects that it included, or why there is none.

    By one more solution and its exact derivatives with respect to the numbers whose deviations
    are ``stated``.
    """
    if run.status != "complete":
        return None
    began = clock.perf_counter()
    try:
        slopes, numbers, left_out = _slopes(scene, run, stated)
    except (SolveError, SpecError) as error:
        if isinstance(error, SpecError) and (still := _unmoved(error, stated)):
            zero = np.zeros((len(run.time), 3))
            return CoefficientBand(
                zero, np.array(run.time), (), still, clock.perf_counter() - began
            )
        return Notice("no_band", f"the uncertainty of the tip is unknown: {error}", "uncertainty")
    if slopes.shape[0] != len(run.time) or not np.all(np.isfinite(slopes)):
        reason = "the motion cannot be differentiated with respect to its numbers"
        return Notice("no_band", reason, "uncertainty")
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


def _unmoved(error: SpecError, stated: Stated) -> LeftOut:
    """All that was stated and why it moves nothing, where the equations have none of it."""
    told = tuple((own.key, own.message) for own in error.faults)
    unmoved = all(why.startswith(NOTHING_DEPENDS) for _, why in told)
    return told if unmoved and {key for key, _ in told} == set(stated) else ()


def width_notices(band: CoefficientBand, run: Trajectory) -> tuple[Notice, ...]:
    """A warning of a band that is wider than such bands were found to hold."""
    if band.half_width_m <= WIDEST_BAND * run.length:
        return ()
    message = (
        f"the band of the coefficients is +-{band.half_width_m:.3g} m wide, "
        f"{100 * band.half_width_m / run.length:.0f} % of the length: it is of the first order, "
        f"and was found to hold up to {100 * WIDEST_BAND:.0f} %; most is by {band.numbers[0].key}: "
        "measure it, or state less"
    )
    return (Notice("wide_band", message, f"uncertainty.{band.numbers[0].key}"),)


def _slopes(scene: Scene, run: Trajectory, stated: Stated) -> Slopes:
    """With the effects that the run has included."""
    effects = frozenset(verdict.name for verdict in run.effects if verdict.taken)

    def solved() -> Slopes:
        keys = list(stated)
        function, left_out = differentiable(
            scene,
            keys,
            TIP_COLUMNS,
            by_percent=False,
            tolerance=BAND_STEP_TOLERANCE,
            effects=effects,
        )
        used, slopes = function.is_used, function.jacobian()
        units = zip(function.names, map(float, function.values), function.units, strict=True)
        return (
            np.stack([slopes[name][:, used] for name in TIP_COLUMNS], axis=1),
            tuple(number for number, is_used in zip(units, used, strict=True) if is_used),
            left_out,
        )

    return _SLOPES.get((scene_key(scene), scene.source, tuple(stated), effects), solved)


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
