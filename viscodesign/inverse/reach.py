"""Where a tip can be with inputs within limits, and what brings it to a point: `reach`."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Sequence

import numpy as np

from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.errors import SpecError, UsageError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.interrupt import gentle_interrupt
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
from viscodesign.scene.inputs.harmonics import MOST_HARMONICS
from viscodesign.scene.scene import Scene
from viscodesign.simulation.simulate import simulate

VERIFIED = 4
"""Points of the edge that are simulated."""
LONGEST_S = 1e5
"""Run of a verified point [s]."""


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

    Raises `SpecError` for scenes that it is not made for, `UsageError` for values that make no
    sense, `SolveError` where no input has a solution.
    """
    began = clock.perf_counter()
    if scene.input is None or not scene.input.gives_pressure:
        raise SpecError.plain("reach needs a spec with one `input` that is a pressure")
    low, high = limits or scene.input.extremes(scene.run.duration)
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise UsageError(f"limits: need two pressures, the lower one first; got {low:g}, {high:g}")
    if harmonics is not None and not 1 <= harmonics <= MOST_HARMONICS:
        raise UsageError(f"harmonics: must be from 1 to {MOST_HARMONICS}; got {harmonics}")
    if time is not None and at is None:
        raise UsageError("time: needs a point to be at, given by --at (at=(x, z) in Python)")
    rod = ArcRod.of(SceneQuantities(scene))
    around = scene.gauge_pressure + low, scene.gauge_pressure + high
    edge, error, point = np.zeros((0, 2)), None, None
    with gentle_interrupt(second_raises=True) as stop:
        if at is not None:
            place, when = _point(at), scene.run.duration if time is None else time
            if not (math.isfinite(when) and when > 0.0):
                raise UsageError(f"time: must be above 0 s; got {when:g}")
            point = reach_point(scene, place, when, (low, high), stop, seed)
        if tree_of(scene.graph) is not None:
            edge, error = _edge(scene, rod, around, harmonics, verify=at is None)
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
    )


def _point(at: Sequence[float]) -> tuple[float, float]:
    found = tuple(float(value) for value in at)
    if len(found) != 2 or not all(map(math.isfinite, found)):
        raise UsageError(f"at: needs x and z, two lengths; got {tuple(at)}")
    return found[0], found[1]


def _edge(
    scene: Scene, rod: ArcRod, limits: tuple[float, float], harmonics: int | None, *, verify: bool
) -> tuple[np.ndarray, float | None]:
    """The edge (N, 2), and the largest distance of simulated points of it."""
    bellows = _bellows(scene)
    past = PastInput.of(bellows, limits)
    extreme = past if harmonics is None else HarmonicExtremes(bellows, limits, harmonics)
    count = len(bellows.feed)
    middle = np.full(count, sum(limits) / 2)
    directions = DIRECTIONS if harmonics is None else FEW_DIRECTIONS
    pressures = edge_pressures(extreme, rod, middle, directions)
    tip = rod.tip(pressures)
    error = _largest_error(scene, past, rod, pressures) if verify and harmonics is None else None
    return tip, error


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


def _largest_error(
    scene: Scene, past: PastInput, rod: ArcRod, pressures: np.ndarray
) -> float | None:
    """Largest miss of the leftmost, rightmost, lowest and highest point by `simulate` with their
    inputs."""
    tip = rod.tip(pressures)
    ends = [tip[:, 0].argmin(), tip[:, 0].argmax(), tip[:, 1].argmin(), tip[:, 1].argmax()]
    apart = []
    for k in dict.fromkeys(int(end) for end in ends[:VERIFIED]):
        way = np.roll(tip, -1, axis=0)[k] - np.roll(tip, 1, axis=0)[k]
        normal = np.array([way[1], -way[0]])
        direction = normal @ rod.slopes(pressures[k : k + 1])[0]
        run = simulate(_driven(scene, past, direction), verify=False)
        if run.status == "complete":
            expected = rod.tip(past(direction)[None])[0]
            apart.append(float(np.linalg.norm(run.tip[-1, :2] - expected)))
    return max(apart, default=None)


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
