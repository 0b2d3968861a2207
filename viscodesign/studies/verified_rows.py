"""Some rows of a sweep simulated again, with their error stated and their validity judged."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from viscodesign.errors import ViscodesignError
from viscodesign.interrupt import StopRequest
from viscodesign.results.metrics import METRIC_NAMES
from viscodesign.results.sweep_table import COMPLETE, DesignResult, VerifiedRow
from viscodesign.simulation.simulate import simulate
from viscodesign.studies.design_solver import DesignSolver
from viscodesign.studies.designs import Design

EXTENTS = ("tip_x_min_m", "tip_x_max_m", "tip_z_min_m", "tip_z_max_m")
"""Metrics whose distance from a verified run is a distance of tips."""
RANKED = ("loop_width_m", "loop_height_m", "path_length_m")
"""Rows with their largest and smallest values are verified, in this order."""


def verified_rows(
    solver: DesignSolver,
    designs: Sequence[Design],
    results: Iterable[DesignResult],
    count: int,
    stop: StopRequest,
) -> tuple[VerifiedRow, ...]:
    """So many of the complete rows, those with the largest and the smallest loops first."""
    found = []
    for own in _chosen([r for r in results if r.status == COMPLETE], count):
        try:
            found.append(_verified(solver, designs[own.row], own))
        except (ViscodesignError, KeyboardInterrupt) as error:
            if stop.asked:
                break
            found.append(VerifiedRow(own.row, None, None, "unknown", (str(error),)))
    return tuple(found)


def _chosen(complete: Sequence[DesignResult], count: int) -> list[DesignResult]:
    chosen: dict[int, DesignResult] = {}
    for name in RANKED:
        k = METRIC_NAMES.index(name)
        ranked = sorted(
            (r for r in complete if math.isfinite(r.metrics[k])), key=lambda r: r.metrics[k]
        )
        chosen |= {r.row: r for r in (*ranked[-1:], *ranked[:1])}
    for own in complete[:: max(1, len(complete) // max(count, 1))]:
        chosen.setdefault(own.row, own)
    return [*chosen.values()][:count]


def _verified(solver: DesignSolver, design: Design, own: DesignResult) -> VerifiedRow:
    run = simulate(solver.scene_of(design))
    places = [METRIC_NAMES.index(name) for name in EXTENTS]
    apart = max(abs(own.metrics[k] - run.metrics[METRIC_NAMES[k]]) for k in places)
    return VerifiedRow(
        own.row,
        run.accuracy.estimated_tip_error_m,
        apart if run.status == COMPLETE else None,
        run.validity,
        tuple(notice.message for notice in run.violations),
    )
