"""Which output times of a run a page has room for."""

from __future__ import annotations

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.disk_arrays import blocks

MAX_SHOWN_ROWS = 1500
"""Number of output times up to which all are shown, where the bytes suffice."""
MAX_PAGE_BYTES = 1_050_000
"""Bytes of arrays, which become a third more in the file."""
PATH_KEPT = 0.97
"""Share of the path's length that evenly spaced times must keep; with less, motion is lost."""
MAX_FLOWS = 32
"""Tubes whose flows are shown: those with the largest."""
MAX_AXIS_POINTS = 257
"""Points of the axis, where one a section is not more."""


@dataclass(frozen=True)
class ShownRows:
    """The selected rows (n,), ascending, and what a reader must know of the others."""

    rows: np.ndarray
    note: str
    """Empty where all are shown."""
    from_start: bool
    """Whether the first output time is among them."""


def shown_rows(run: Trajectory) -> ShownRows:
    """All output times if they fit; else evenly spaced ones, or the last, if those lose motion."""
    total = len(run.time)
    most = max(2, min(MAX_SHOWN_ROWS, MAX_PAGE_BYTES // _row_bytes(run)))
    if total <= most:
        return ShownRows(np.arange(total), "", True)
    step = -(-(total - 1) // (most - 1))
    even = np.unique(np.append(np.arange(0, total, step), total - 1))
    if _path_length(run.tip[even]) >= PATH_KEPT * _whole_path_length(run.tip):
        return ShownRows(even, _of(len(even), total, f"every {_ordinal(step)}"), True)
    rows = np.arange(total - most, total)
    where = f"the last, from t = {run.time[rows[0]]:.6g} s on"
    return ShownRows(rows, _of(most, total, where), False)


def _of(shown: int, total: int, which: str) -> str:
    return (
        f"{shown:,} of {total:,} output times are shown, {which}; the metrics are those of the "
        "whole run, and all times are in trajectory.csv"
    )


def _ordinal(number: int) -> str:
    teen = number % 100 in (11, 12, 13)
    return f"{number:,}{'th' if teen else {1: 'st', 2: 'nd', 3: 'rd'}.get(number % 10, 'th')}"


def _row_bytes(run: Trajectory) -> int:
    columns = len(run.bellows) + len(shown_tubes(run)) + len(shown_points(run))
    return 8 * (4 + len(run.inlets)) + 4 * columns


def _path_length(tip: np.ndarray) -> float:
    return float(np.sum(np.hypot(*np.diff(tip[:, :2], axis=0).T)))


def _whole_path_length(tip: np.ndarray) -> float:
    parts = (tip[rows.start : rows.stop + 1] for rows in blocks(len(tip), tip))
    return sum(_path_length(part) for part in parts)


def shown_tubes(run: Trajectory) -> np.ndarray:
    """Columns (q,) of the tubes with the largest flows, in their order."""
    count = run.flow.shape[1]
    if count <= MAX_FLOWS:
        return np.arange(count)
    largest = np.zeros(count)
    for rows in blocks(len(run.flow), run.flow):
        largest = np.maximum(largest, np.abs(run.flow[rows]).max(axis=0))
    return np.sort(np.argsort(-largest, kind="stable")[:MAX_FLOWS])


def shown_points(run: Trajectory) -> np.ndarray:
    """Points (k,) of the axis, with the ends of every section."""
    sections, points = len(run.bellows) // 2, len(run.arc)
    inside, uneven = divmod(points - 1, sections)
    if uneven or points <= MAX_AXIS_POINTS:
        return np.arange(points)
    kept = max(n for n in range(1, inside + 1) if inside % n == 0 and _fits(n, sections))
    return np.arange(0, points, inside // kept)


def _fits(kept: int, sections: int) -> bool:
    return kept == 1 or kept * sections < MAX_AXIS_POINTS


def shapes_near(run: Trajectory, rows: np.ndarray) -> np.ndarray:
    """Which shapes (n,) of a run are nearest to some rows."""
    known = run.shape_rows
    if len(known) == 1:
        return np.zeros(len(rows), dtype=int)
    after = np.clip(np.searchsorted(known, rows), 1, len(known) - 1)
    nearer = rows - known[after - 1] <= known[after] - rows
    return np.asarray(after - nearer)


def evenly(count: int, most: int) -> np.ndarray:
    """Up to ``most`` of so many rows at even distances, among them the first and the last."""
    if count <= most:
        return np.arange(count)
    return np.unique(np.linspace(0, count - 1, most).round().astype(int))
