"""How far each number of a scene moves its tip: `sensitivity`."""

from __future__ import annotations

import time as clock
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from viscodesign._version import __version__
from viscodesign.compiled.free_keys import candidates
from viscodesign.compiled.function import CompiledFunction
from viscodesign.compiled.outputs import TIP_COLUMNS
from viscodesign.effects.effects_key import scene_key
from viscodesign.errors import SpecError
from viscodesign.results.sensitivity_study import (
    SensitiveNumber,
    SensitivityInterruptedError,
    SensitivityStudy,
)
from viscodesign.scene.reading.write import resolved_sha256
from viscodesign.scene.scene import Scene
from viscodesign.storage.lru_cache import LruCache
from viscodesign.studies.differentiable import LeftOut, differentiable
from viscodesign.studies.sampled_variance import sampled_variance
from viscodesign.studies.tolerances import deviations

QUADRATURE_DEVIATIONS = np.sqrt(3.0)
"""Distance of the outer points from the middle, in standard deviations; the middle weighs 4/6."""
_FUNCTIONS: LruCache[tuple[CompiledFunction, LeftOut]] = LruCache(4)
"""Those of the latest scenes, for other tolerances of the same numbers."""


def sensitivity(
    scene: Scene,
    tolerances: Mapping[str, Any] | Sequence[str] | str | None = None,
    *,
    sobol: bool = False,
    seed: int = 0,
) -> SensitivityStudy:
    """Derivatives of the tip's motion by the numbers of a scene, and the band of tolerances.

    ``tolerances``: one standard deviation by key, ``{"network.tube_radius": "5 %"}`` or texts
    ``KEY=5%``; numbers are independent and normal. Without any, all numbers that can be free and
    are not zero, tubes all together. Derivatives are those of `compile`, exact for the solution,
    with the effects that the scene calls for. The band adds up what each number does alone, by
    two more solutions for each; ``sobol`` solves a sample by ``seed`` as well, which has what they
    do together.

    Raises `SpecError` for keys that cannot be free and for tolerances that are none, `SolveError`
    where the scene has no solution. Ctrl-C after the derivatives raises
    `SensitivityInterruptedError`, a `KeyboardInterrupt` that holds the study as far as it came.
    """
    began = clock.perf_counter()
    if not isinstance(scene, Scene):
        raise SpecError.plain(f"scene: needs a scene, such as load({scene!r}); got {scene!r}")
    if sobol and tolerances is None:
        raise SpecError.plain("a sample needs tolerances, such as network.tube_radius=5%")
    spread = None if tolerances is None else deviations(scene, tolerances)
    function, left_out = _function(scene, None if spread is None else tuple(spread))
    outputs, slopes, used = function(), function.jacobian(), function.is_used
    numbers = zip(function.names, function.values, function.units, used, strict=True)
    study = SensitivityStudy(
        name=scene.name,
        version=__version__,
        spec_sha256=scene.source.sha256,
        time=function.times,
        tip=np.column_stack([outputs[name] for name in TIP_COLUMNS]),
        numbers=tuple(
            SensitiveNumber(name, float(value), unit, (spread or {}).get(name))
            for name, value, unit, is_used in numbers
            if is_used
        ),
        slopes=np.stack([slopes[name][:, used] for name in TIP_COLUMNS], axis=1),
        effects=function.effects,
        left_out=left_out,
        resolved_sha256=resolved_sha256(scene),
    )
    try:
        if spread is not None:
            study = replace(study, variances=_variances(study, function))
        if sobol:
            study = _checked(study, function, seed)
    except KeyboardInterrupt:
        study = replace(study, wall_s=clock.perf_counter() - began)
        missing = "the sample that checks the band" if study.has_band else "the band"
        raise SensitivityInterruptedError(study, missing) from None
    return replace(study, wall_s=clock.perf_counter() - began)


def _function(scene: Scene, keys: tuple[str, ...] | None) -> tuple[CompiledFunction, LeftOut]:
    """The tip as a function of numbers, all that can be free by default, and what cannot."""
    kept = scene_key(scene), scene.source, keys
    if keys is not None:
        return _FUNCTIONS.get(kept, lambda: (CompiledFunction(scene, keys, TIP_COLUMNS), ()))
    return _FUNCTIONS.get(kept, lambda: _of_all_numbers(scene))


def _of_all_numbers(scene: Scene) -> tuple[CompiledFunction, LeftOut]:
    keys = [key for key in candidates(scene) if "[" not in key]
    return differentiable(scene, keys, TIP_COLUMNS, by_percent=True)


def _variances(study: SensitivityStudy, function: CompiledFunction) -> np.ndarray:
    """(T, 2, k): variance of the tip [m2] with each number alone.

    By Gauss-Hermite quadrature in three points, exact for polynomials of order two: pressures go
    with the fourth power of a radius, of which slopes alone miss five percent at a tolerance of
    five percent. Where a solution fails, slopes have to do.
    """
    spread = _spread(study)
    moved = np.diag(QUADRATURE_DEVIATIONS * spread)
    found = function.batch(np.concatenate([function.values + moved, function.values - moved]))
    ends = np.stack([found[name] for name in TIP_COLUMNS], axis=2).reshape(2, len(spread), -1, 2)
    more, less = ends.transpose(0, 2, 3, 1)
    here = study.tip[:, :, None]
    mean = (4 * here + more + less) / 6
    variance = (4 * (here - mean) ** 2 + (more - mean) ** 2 + (less - mean) ** 2) / 6
    return np.asarray(np.where(np.isfinite(variance), variance, (study.slopes * spread) ** 2))


def _spread(study: SensitivityStudy) -> np.ndarray:
    """(k,) standard deviations of the numbers."""
    return np.array([number.deviation or 0.0 for number in study.numbers])


def _checked(study: SensitivityStudy, function: CompiledFunction, seed: int) -> SensitivityStudy:
    """The study with variances of a sample, at the time at which its band is widest."""
    row = study.worst_row

    def tip_at(rows: np.ndarray) -> np.ndarray:
        found = function.batch(rows)
        return np.column_stack([found[name][:, row] for name in TIP_COLUMNS])

    spread, slopes = _spread(study), study.slopes[row]
    sampled = sampled_variance(tip_at, function.values, spread, slopes, seed)
    return replace(study, sampled=sampled)
