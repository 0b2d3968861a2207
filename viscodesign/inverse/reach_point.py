"""The input that brings a tip to a point at a time, by the run's own effects, and verified."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.interrupt import StopRequest
from viscodesign.inverse.confirmation import confirm
from viscodesign.inverse.free_choice import FreeChoice
from viscodesign.inverse.free_range import FreeRange
from viscodesign.inverse.number_search import NumberDesign, search_numbers
from viscodesign.inverse.posed_scene import posed_scene
from viscodesign.inverse.search_task import DescentPlan, SearchLog, SearchTask
from viscodesign.inverse.wanted_path import WantedPath
from viscodesign.results.reach_study import ReachedPoint
from viscodesign.scene.effects_choice import EffectsChoice, Mode
from viscodesign.scene.reading.write import resolved_yaml
from viscodesign.scene.scene import Scene
from viscodesign.simulation.simulate import simulate

REACHED_DISTANCE = 0.2e-3
"""Distance at which a point counts as reached [m]."""
LEFT = (0.95, 0.72, 0.52, 0.36, 0.24, 0.15, 0.08, 0.035, 0.0)
"""Times of the free rows of the input before the end, relative to the run: what lies far from the
inlet has a long memory, what lies near it a short one."""
KNOTS = len(LEFT)
BUDGET_S = 60.0
PLAN = DescentPlan(
    draws_per_number=1,
    least_draws=8,
    descents=2,
    converged=1e-4,
    exact_share=0.03,
    drawn_converged=1e-3,
)
"""A point out of reach is about as far off from every start, and known well enough by 1e-4."""
PATH_TIMES = 200


def reach_point(
    scene: Scene,
    at: tuple[float, float],
    time_s: float,
    limits: tuple[float, float],
    stop: StopRequest,
    seed: int,
) -> ReachedPoint:
    """The input within limits that brings the tip nearest to a point at a time.

    From the baseline at t = 0 (or the limit nearest to it), straight between rows that
    are the closer the later they are. Interrupted, the best so far, not verified. Raises
    `SolveError` where no start has a solution, `KeyboardInterrupt` before a first one.
    """
    began = clock.perf_counter()
    wanted = WantedPath(np.array([at]), np.array([time_s]), False, "given")
    begins = min(max(0.0, limits[0]), limits[1])
    level = (limits[0] + limits[1]) / 2
    times = np.append(0.0, time_s * (1.0 - np.array(LEFT)))
    rows = [[0.0, begins], *([t, level] for t in times[1:].tolist())]
    posed = posed_scene(
        scene.replace(
            {
                "input": {"kind": "table", "rows": rows},
                "run.duration": time_s,
                "run.output_times": [time_s],
                "run.start": "equilibrium" if scene.run.start == "periodic" else scene.run.start,
            }
        ),
        wanted,
        REACHED_DISTANCE,
    )
    ranges = tuple(FreeRange(f"input.rows[{k}].pressure", *limits) for k in range(1, KNOTS + 1))
    log = SearchLog(began)
    task = SearchTask(
        wanted,
        FreeChoice(ranges),
        REACHED_DISTANCE,
        began + BUDGET_S,
        BUDGET_S,
        stop,
        log,
        seed,
        plan=PLAN,
    )
    found = search_numbers(task, posed)[0]
    unverified = ReachedPoint(
        at,
        time_s,
        (math.nan, math.nan),
        found.distance.rms_m,
        None,
        REACHED_DISTANCE,
        np.zeros((0, 2)),
        times,
        np.append(begins, found.values),
        resolved_yaml(_with_path(posed, found.values, times, begins)),
        log.evaluations,
    )
    try:
        return unverified if stop.asked else _verified(task, posed, found, unverified)
    except KeyboardInterrupt:
        if not stop.asked:
            raise
        return unverified


def _verified(
    task: SearchTask, posed: Scene, found: NumberDesign, point: ReachedPoint
) -> ReachedPoint:
    """A found point by a run with the effects that it calls for."""
    times, begins = point.times, float(point.pressures[0])
    run = confirm(task.wanted, found.scene, REACHED_DISTANCE)
    if run.distance.rms_m > REACHED_DISTANCE >= found.distance.rms_m:
        # The run has more effects than the search had: go on with them.
        pinned = posed.replace({"effects": _pinned(posed, run.effects, "auto")})
        again = search_numbers(task, pinned, start=found.values, several_starts=False)[0]
        changed = found.scene.replace(dict(_rows(again.values, times, begins)))
        better = confirm(task.wanted, changed, REACHED_DISTANCE)
        if better.distance.rms_m < run.distance.rms_m:
            found, run = again, better
    final = _with_path(posed, found.values, times, begins)
    # Of the same run at more times the effects are known.
    pinned = final.replace({"effects": _pinned(final, run.effects, "off")})
    path = np.asarray(simulate(pinned, verify=False).tip)[:, :2]
    if not len(path):
        raise SolveError("the run has no motion", quantity="tip", where="rod")
    return replace(
        point,
        tip=(float(run.tip[-1, 0]), float(run.tip[-1, 1])),
        miss_m=run.distance.rms_m,
        stated_error_m=run.run.accuracy.estimated_tip_error_m,
        path=path,
        pressures=np.append(begins, found.values),
        spec_text=resolved_yaml(final),
        evaluations=task.log.evaluations,
        violations=run.run.violations,
        is_cut=task.log.is_cut,
    )


def _with_path(posed: Scene, values: np.ndarray, times: np.ndarray, begins: float) -> Scene:
    """The scene with an input, and output times that show the tip's path."""
    shown = np.linspace(0.0, float(times[-1]), PATH_TIMES).tolist()
    return posed.replace({**_rows(values, times, begins), "run.output_times": shown})


def _pinned(scene: Scene, names: Sequence[str], others: Mode) -> EffectsChoice:
    """The effects of a scene with these on."""
    return scene.effects.with_modes(dict.fromkeys(names, "on"), others)


def _rows(values: np.ndarray, times: np.ndarray, begins: float) -> dict[str, object]:
    pairs = zip(times.tolist(), [begins, *values.tolist()], strict=True)
    return {"input": {"kind": "table", "rows": [list(pair) for pair in pairs]}}
