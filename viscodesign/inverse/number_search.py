"""The numbers of one scene that bring its tip nearest to a path, on the scene's own model.

Effects are those that the numbers call for: the search solves with the effects of its start, and
goes on from its end with those of the end until they are the same.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.compiled.function import CompiledFunction
from viscodesign.compiled.outputs import TIP_COLUMNS
from viscodesign.errors import SpecError
from viscodesign.inverse.confirmation import tip_of
from viscodesign.inverse.harmonic_input import InputLimits
from viscodesign.inverse.search_task import SearchTask
from viscodesign.inverse.tip_residuals import (
    CompiledTip,
    PathDistance,
    PathResiduals,
    distance,
)
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.scene import Scene
from viscodesign.simulation.simulate import simulate
from viscodesign.studies.least_squares import (
    AT_BOUND,
    BestSoFar,
    FitStatus,
    LeastSquaresFit,
    NumberRanges,
    SearchLimits,
    least_squares,
)

MAX_ROUNDS = 3
"""Choices of effects in one search."""
ENOUGH_SHARE = 0.1
"""Part of the tolerance at which a descent has found the path and no other start is tried."""
NEAR_SHARE = 0.3
"""Part of the tolerance at which nothing better is sought for a path without times, whose numbers
are not unique."""
PERCENT = 0.01
LIVELY_DRAWS = 3
"""Starts by chance where the spec's own numbers make no motion."""
SAME_SHARE = 0.02
"""Optima whose numbers differ by less than this part of the range count as the same."""


@dataclass(frozen=True, eq=False)
class NumberDesign:
    """The best numbers of one scene."""

    scene: Scene
    """With these numbers."""
    names: tuple[str, ...]
    units: tuple[str, ...]
    values: np.ndarray
    distance: PathDistance
    band: np.ndarray
    """(T, 2) standard deviation of the tip by one percent of each number [m]."""
    at_bounds: tuple[str, ...]
    status: FitStatus

    @property
    def parameters(self) -> Mapping[str, float]:
        """Values by key [SI]."""
        return dict(zip(self.names, self.values.tolist(), strict=True))


def search_numbers(
    task: SearchTask,
    scene: Scene,
    *,
    start: np.ndarray | None = None,
    several_starts: bool = True,
    graph: str = "",
) -> list[NumberDesign]:
    """The best numbers of a posed scene within their bounds, and other optima behind them.

    ``start``: instead of the scene's own numbers. Without free numbers, the scene as it is.
    Raises `ViscodesignError` where no start has a solution.
    """
    found = task.choice.numbers(scene)
    if found is None:
        return [_as_it_is(task, scene, graph)]
    keys, ranges = found
    values = keys.values if start is None else start
    function = _first_function(task, keys, ranges.starts(values, LIVELY_DRAWS, task.seed))
    limits = limits_of(task, keys)
    for turn in range(MAX_ROUNDS):
        model = CompiledTip(function, task.wanted.is_free_loop)
        residuals = PathResiduals(model, task.wanted, limits, allowed_m=task.tolerance_m)
        fit = _fit(task, residuals, ranges, function.values, graph, several_starts and not turn)
        is_last = turn == MAX_ROUNDS - 1 or (fit.status == "unfinished" and task.is_over)
        if is_last or function.judge(fit.values).suits or task.is_over:
            return _designs_of(task, model, fit, ranges, limits)
        function = _function(task, function.scene(fit.values))
    raise AssertionError("the last round returns")


def _first_function(
    task: SearchTask, keys: FreeKeys, starts: Sequence[np.ndarray]
) -> CompiledFunction:
    """The function at the first of some starts whose effects depend on all that is free.

    A start that rests calls for no effect of the motion that is sought. Raises the `SpecError` of
    the first start where there is none.
    """
    refusal: SpecError | None = None
    for values in starts:
        try:
            return _function(task, scene_with(keys, values))
        except SpecError as error:
            refusal = refusal or error
    assert refusal is not None
    raise refusal


def _function(task: SearchTask, scene: Scene) -> CompiledFunction:
    one_period = task.wanted.is_free_loop
    return CompiledFunction(scene, task.choice.keys, TIP_COLUMNS, one_period=one_period)


def limits_of(task: SearchTask, keys: FreeKeys) -> InputLimits | None:
    """What a free input must keep."""
    choice = task.choice.harmonics
    if choice is None:
        return None
    return InputLimits(choice, keys.names, choice.period[0], task.tolerance_m)


def scene_with(keys: FreeKeys, values: np.ndarray) -> Scene:
    """The scene with other numbers, checked."""
    return keys.validated(values) if np.any(values != keys.values) else keys.scene


def _fit(
    task: SearchTask,
    residuals: PathResiduals,
    ranges: NumberRanges,
    own: np.ndarray,
    graph: str,
    several: bool,
) -> LeastSquaresFit:
    draws = task.plan.draws(len(own)) if several else 0
    before = task.log.evaluations

    def report(best: BestSoFar) -> None:
        task.log.evaluations = before + best.evaluations
        task.log.note(math.sqrt(best.cost), graph)
        task.report()

    share = task.plan.exact_share if task.wanted.timing == "given" else NEAR_SHARE
    limits = SearchLimits(
        met_cost=(share * task.tolerance_m) ** 2,
        enough_cost=(ENOUGH_SHARE * task.tolerance_m) ** 2,
        converged=task.plan.converged,
        until=task.until,
        stop=task.stop,
        report=report,
    )
    # The spec's own numbers are a guess of the user: they are refined first.
    fit = least_squares(residuals, ranges, [own], limits=limits)
    if not draws or fit.cost <= limits.enough_cost or task.is_over:
        return fit
    before = task.log.evaluations
    starts = ranges.starts(own, draws, task.seed)[1:]
    coarse = replace(limits, converged=task.plan.drawn_converged)
    other = least_squares(residuals, ranges, starts, descents=task.plan.descents, limits=coarse)
    if other.cost < fit.cost and coarse.converged > limits.converged:
        before = task.log.evaluations
        other = least_squares(residuals, ranges, [other.values], limits=limits)
    optima = tuple(sorted((*fit.optima, *other.optima), key=lambda own: own.cost))
    return replace(min(fit, other, key=lambda own: own.cost), optima=optima)


def _designs_of(
    task: SearchTask,
    model: CompiledTip,
    fit: LeastSquaresFit,
    ranges: NumberRanges,
    limits: InputLimits | None,
) -> list[NumberDesign]:
    """The best, and every other optimum that is not nearly the same."""
    values = [fit.values]
    for other in fit.optima if not task.stop.asked else ():
        shares = ranges.shares(other.values)
        if math.isfinite(other.cost) and all(
            np.abs(shares - ranges.shares(own)).max() > SAME_SHARE for own in values
        ):
            values.append(other.values)
    kept = values if limits is None else [limits.within(own) for own in values]
    return [_design_of(task, model, own, fit.status, ranges, limits) for own in kept]


def _design_of(
    task: SearchTask,
    model: CompiledTip,
    values: np.ndarray,
    status: FitStatus,
    ranges: NumberRanges,
    limits: InputLimits | None,
) -> NumberDesign:
    function = model.function
    tip, slopes = model.tip(values), model.slopes(values)
    shares = ranges.shares(values)
    is_bound = (shares < AT_BOUND) | (shares > 1 - AT_BOUND)
    bound = [name for name, own in zip(function.names, is_bound, strict=True) if own]
    if limits is not None and limits.is_at_limit(values):
        bound.append("the limits of the input")
    return NumberDesign(
        function.scene(values),
        function.names,
        tuple(n.unit for n in FreeKeys(function.scene(), function.names).numbers),
        values,
        distance(task.wanted, tip, task.tolerance_m),
        np.sqrt(((PERCENT * values * slopes) ** 2).sum(axis=2)),
        tuple(bound),
        status,
    )


def _as_it_is(task: SearchTask, scene: Scene, graph: str) -> NumberDesign:
    """A scene without free numbers, by one solution."""
    tip = tip_of(task.wanted, scene, simulate(scene, verify=False))
    found = distance(task.wanted, tip, task.tolerance_m)
    task.log.evaluations += 1
    task.log.note(found.total_m, graph)
    task.report()
    return NumberDesign(scene, (), (), np.zeros(0), found, np.zeros((0, 2)), (), "converged")
