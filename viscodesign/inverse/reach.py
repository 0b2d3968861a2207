"""Where a tip can be with inputs within limits, and what brings it to a point: `reach`."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Sequence

import numpy as np

from viscodesign.checks.vacuum import vacuum_faults
from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.errors import SolveError, SpecError, UsageError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.interrupt import StopRequest, gentle_interrupt
from viscodesign.inverse.arc_rod import ArcRod
from viscodesign.inverse.quick_motion import QuickMotion
from viscodesign.inverse.reach_edge import (
    DIRECTIONS,
    FEW_DIRECTIONS,
    HarmonicExtremes,
    LinearBellows,
    PastInput,
    TwoInlets,
    column_of,
    edge_pressures,
)
from viscodesign.inverse.reach_point import reach_point
from viscodesign.inverse.tree_graph import sizes_of, tree_of, with_tree
from viscodesign.results.reach_study import ReachStudy
from viscodesign.scene.far_places import far_words
from viscodesign.scene.inputs.harmonics import MAX_HARMONICS
from viscodesign.scene.scene import Scene
from viscodesign.simulation.simulate import simulate


def reach(
    scene: Scene,
    *,
    limits: tuple[float, float] | None = None,
    harmonics: int | None = None,
    at: Sequence[float] | None = None,
    time: float | None = None,
    seed: int = 0,
) -> ReachStudy:
    """The set of points that the tip can visit, and the input that brings it to one of them.

    ``limits`` of the inlet's pressure above the baseline [Pa], by default the extremes of the
    scene's input. The edge is that of slow flow in a linear network without loads, for any input
    within the limits, or for ``harmonics`` of a period; some of its points are simulated with the
    scene's own effects, and the largest distance is stated. Beside it the set with one inlet a
    column. ``at``: x, z [m] of a point instead, to be reached at ``time`` [s], by default the end
    of the run, on the scene's own model and verified.

    Ctrl-C raises nothing once there is something to keep: the study then says that it was
    interrupted. Raises `SpecError` for scenes that it is not made for, `UsageError` for values that
    make no sense, `SolveError` where no input has a solution.
    """
    began = clock.perf_counter()
    if scene.input is None or not scene.input.gives_pressure:
        raise SpecError.plain("reach needs a spec with one `input` that is a pressure")
    low, high = limits or scene.input.extremes(scene.run.duration)
    _check_limits(scene, low, high)
    if harmonics is not None and not 1 <= harmonics <= MAX_HARMONICS:
        raise UsageError(f"harmonics: must be from 1 to {MAX_HARMONICS}; got {harmonics}")
    if time is not None and at is None:
        raise UsageError("time: needs a point to be at, given by --at (at=(x, z) in Python)")
    rod = ArcRod.of(SceneQuantities(scene))
    around = scene.gauge_pressure + low, scene.gauge_pressure + high
    edge, point = np.zeros((0, 2)), None
    error: float | None = None
    failures: tuple[str, ...] = ()
    with gentle_interrupt(second_raises=True) as stop:
        if at is not None:
            place, when = _point(at, scene), scene.run.duration if time is None else time
            if not (math.isfinite(when) and when > 0.0):
                raise UsageError(f"time: must be above 0 s; got {when:g}")
            point = reach_point(scene, place, when, (low, high), stop, seed)
        if tree_of(scene.graph) is not None:
            bellows = _bellows(scene)
            past = PastInput.of(bellows, around)
            extreme = past if harmonics is None else HarmonicExtremes(bellows, around, harmonics)
            directions = DIRECTIONS if harmonics is None else FEW_DIRECTIONS
            middle = np.full(len(bellows.feed), sum(around) / 2)
            pressures = edge_pressures(extreme, rod, middle, directions)
            edge = rod.tip(pressures)
            if at is None and harmonics is None:
                error, failures = _verified(scene, past, rod, pressures, stop)
        elif at is None:
            raise SpecError.plain(
                "network: the set of points needs a network without junctions and loops; "
                "a point may be given by --at"
            )
    return ReachStudy(
        scene.name,
        (low, high),
        harmonics,
        edge,
        _two_inlets(scene, rod, around),
        error,
        point,
        clock.perf_counter() - began,
        edge_failures=failures,
        interrupted=stop.asked,
    )


def _check_limits(scene: Scene, low: float, high: float) -> None:
    """Raise a fault for limits of the pressure [Pa] that are none, or below vacuum."""
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise UsageError(
            f"limits: need two pressures, the lower one first; got {low:g} Pa, {high:g} Pa"
        )
    lowest = scene.gauge_pressure + low
    if faults := list(vacuum_faults("limits", lowest, scene.ambient_pressure, varies=True)):
        raise SpecError(faults)


def _point(at: Sequence[float], scene: Scene) -> tuple[float, float]:
    found = tuple(float(value) for value in at)
    if len(found) != 2 or not all(map(math.isfinite, found)):
        raise UsageError(f"at: needs x and z, two lengths; got {tuple(at)}")
    if words := far_words(np.array([found]), scene.actuator.length):
        raise UsageError(f"at: {words} Write each with its unit, such as 20 mm, 105 mm")
    return found[0], found[1]


def _two_inlets(scene: Scene, rod: ArcRod, limits: tuple[float, float]) -> np.ndarray:
    """(M, 2) The edge with one inlet a column, by chains of mean tubes."""
    quantities, sections = SceneQuantities(scene), scene.bellows.count // 2
    resistance = float(np.mean(list(quantities.resistances.values())))
    own = TwoInlets(column_of(sections, resistance, quantities.bellow.compliance), limits)
    middle = np.full(2 * sections, sum(limits) / 2)
    return rod.tip(edge_pressures(own, rod, middle))


def _bellows(scene: Scene) -> LinearBellows:
    graph = tree_of(scene.graph)
    assert graph is not None, "asked before"
    plain = with_tree(scene, graph, sizes_of(scene, scene.bellows.count))
    keys = FreeKeys(plain, ["network.tubes[*].length"])
    return LinearBellows(*QuickMotion(keys, graph).network(keys.values))


def _verified(
    scene: Scene, past: PastInput, rod: ArcRod, pressures: np.ndarray, stop: StopRequest
) -> tuple[float | None, tuple[str, ...]]:
    """Largest miss of the leftmost, rightmost, lowest and highest point by `simulate` with their
    inputs, and why some of these runs failed."""
    tip = rod.tip(pressures)
    ends = [tip[:, 0].argmin(), tip[:, 0].argmax(), tip[:, 1].argmin(), tip[:, 1].argmax()]
    apart: list[float] = []
    failures: list[str] = []
    for k in dict.fromkeys(int(end) for end in ends):
        way = np.roll(tip, -1, axis=0)[k] - np.roll(tip, 1, axis=0)[k]
        normal = np.array([way[1], -way[0]])
        direction = normal @ rod.slopes(pressures[k : k + 1])[0]
        try:
            run = simulate(_driven(scene, past, direction), verify=False)
        except SolveError as error:
            failures.append(str(error))
            continue
        except KeyboardInterrupt:
            if not stop.asked:
                raise
            break
        if run.status == "complete":
            expected = rod.tip(past(direction)[None])[0]
            apart.append(float(np.linalg.norm(run.tip[-1, :2] - expected)))
        else:
            failures.append(run.failure or run.status)
    return max(apart, default=None), tuple(failures)


def _driven(scene: Scene, past: PastInput, direction: np.ndarray) -> Scene:
    """The scene with an input at its limits that leads to an extreme at the end of the run."""
    drive = past.drive(direction) - scene.gauge_pressure
    end = float(past.ages[-1])
    changes = np.flatnonzero(np.diff(drive))
    rows = [[0.0, float(drive[-1])]]
    for k in changes[::-1]:
        at = end - float(past.ages[k + 1])
        rows += [[at, float(drive[k + 1])], [at, float(drive[k])]]
    rows.append([end, float(drive[0])])
    return scene.replace(
        {
            "input": {"kind": "table", "rows": rows},
            "run.duration": end,
            "run.output_times": [end],
            "run.start": "equilibrium",
        }
    )
