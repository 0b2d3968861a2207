"""What a person wants to know of a run, before looking at its pictures."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

from viscodesign.cli.texts.check_text import notice_lines, percent, quadrant_lines
from viscodesign.cli.texts.layout import number, table
from viscodesign.results.findings import RetryAttempt
from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.disk_arrays import extremes


def summary_lines(trajectory: Trajectory, folder: Path, files: Sequence[Path]) -> list[str]:
    """Status, times, where the tip went and how surely, effects, warnings, files."""
    warnings = notice_lines(trajectory.warnings)
    rows = [
        ("run", _course(trajectory)),
        ("timescales", _times(trajectory)),
        ("tip", _tip_extents(trajectory)),
        ("tip error", _tip_error(trajectory)),
        ("made of", _error_parts(trajectory)),
        *(("ladder", _rung(rung)) for rung in trajectory.ladder[:MOST_RUNGS]),
        ("effects", ", ".join(v.name for v in trajectory.effects if v.taken) or "none"),
        ("left out", ", ".join(v.name for v in trajectory.effects if not v.taken) or "none"),
        ("files", f"{folder}: {', '.join(file.name for file in files)}"),
    ]
    return [
        *quadrant_lines(trajectory.classification),
        *table(rows),
        *(["warnings", *warnings] if warnings else []),
    ]


MOST_RUNGS = 6
"""Attempts that are told; all of them are in `summary.json`."""


def _rung(rung: RetryAttempt) -> str:
    """One attempt where a solver had stopped."""
    ended = "it went on" if rung.solved else "in vain"
    return f"at {number(rung.time_s, 's')}: {rung.tried}, {ended}"


def _course(trajectory: Trajectory) -> str:
    cost = trajectory.cost
    reached = float(trajectory.time[-1]) if trajectory.time.size else 0.0
    wall = cost.build_s + cost.solve_s + cost.verify_s
    return (
        f"{trajectory.status}: {number(reached, 's')} of motion "
        f"in {number(wall, 's')} and {cost.steps} steps"
    )


def _times(trajectory: Trajectory) -> str:
    scales = trajectory.classification.scales
    times = {"t_s": scales.t_s, "t_f": scales.t_f, "t_i": scales.t_i, "t_net": scales.t_net}
    return ", ".join(f"{name} {number(value, 's')}" for name, value in times.items())


def _tip_extents(trajectory: Trajectory) -> str:
    if not trajectory.time.size:
        return "nothing computed"
    low, high = extremes(trajectory.tip)
    return (
        f"x {1e3 * low[0]:.1f} to {1e3 * high[0]:.1f} mm, "
        f"z {1e3 * low[1]:.1f} to {1e3 * high[1]:.1f} mm, "
        f"angle {math.degrees(low[2]):.0f} to {math.degrees(high[2]):.0f} deg"
    )


def _tip_error(trajectory: Trajectory) -> str:
    accuracy, length = trajectory.accuracy, trajectory.length
    asked = (
        f"asked for {number(1e3 * accuracy.requested_m, 'mm')}, "
        f"{percent(accuracy.requested_m, length)}"
    )
    error = accuracy.estimated_tip_error_m
    if error is None:
        return f"{accuracy.method} ({asked})"
    return f"{number(1e3 * error, 'mm')}, {percent(error, length)} of the length ({asked})"


def _error_parts(trajectory: Trajectory) -> str:
    """What the error is made of, and what it cost to know it."""
    accuracy, cost = trajectory.accuracy, trajectory.cost
    parts = (
        ("time", accuracy.time_m),
        ("space", accuracy.space_m),
        ("omitted effects", accuracy.omitted_m),
    )
    told = [f"{name} {number(1e3 * size, 'mm')}" for name, size in parts if size is not None]
    price = [f"known after {number(cost.verify_s, 's')} more"] if cost.verify_s else []
    return "; ".join([", ".join(told), *price])
