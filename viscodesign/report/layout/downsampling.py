"""What a picture draws of a run that has more rows than it has room for."""

from __future__ import annotations

import numpy as np

from viscodesign.storage.disk_arrays import blocks, extremes

MOST_ROWS = 40_000
"""Rows up to which a run is drawn as it is."""
FIELDS = 1000
"""Parts of a long run's time, of which each curve shows the lowest and the highest."""
STRETCHES = 40
"""Parts of a long path that are drawn, each with all its rows."""
FIRST = 0.25
"""Part of what is drawn of a long path that stands together at its beginning."""


def envelope(time: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Times (n,) and curves (n, m) that fill the same places as rows (T, m).

    Of a long run the lowest and the highest of every field, by turns: nothing that
    sticks out is lost, however short it is.
    """
    if len(time) <= MOST_ROWS:
        return time, values
    size = -(-len(time) // FIELDS)
    found = [
        (time[rows.start], time[rows.stop - 1], part.min(axis=0), part.max(axis=0))
        for rows in blocks(len(time), time, values, rows=size)
        for part in [values[rows]]
    ]
    starts, ends, low, high = (np.array(part) for part in zip(*found, strict=True))
    when = np.stack((starts, ends), axis=1).reshape(-1)
    return when, np.stack((low, high), axis=1).reshape(len(when), -1)


def stretches(values: np.ndarray) -> list[slice]:
    """Stretches of rows (T, m) that show where a long path runs; of a short one all rows.

    A long one at the beginning, then some spread over the run to its end, and where
    columns are at their lowest and highest. Each is drawn whole, since a path without some
    of its rows is another path.
    """
    count = len(values)
    if count <= MOST_ROWS:
        return [slice(0, count)]
    size = int((1 - FIRST) * MOST_ROWS) // STRETCHES
    low, high = extremes(values)
    wanted = [int(k) for k in np.linspace(0, count - size, STRETCHES)]
    wanted += [k - size // 2 for k in _where(values, low, high)]
    inside = sorted(min(max(k, 0), count - size) for k in wanted)
    return _joined([slice(0, int(FIRST * MOST_ROWS)), *(slice(k, k + size) for k in inside)])


def _where(values: np.ndarray, low: np.ndarray, high: np.ndarray) -> list[int]:
    """The first rows at which columns are at their lowest and highest."""
    found: dict[tuple[int, int], int] = {}
    for rows in blocks(len(values), values):
        hits = np.stack((values[rows] == low, values[rows] == high))
        for side, column in zip(*np.nonzero(hits.any(axis=1)), strict=True):
            first = rows.start + int(np.argmax(hits[side, :, column]))
            found.setdefault((int(side), int(column)), first)
    return list(found.values())


def _joined(parts: list[slice]) -> list[slice]:
    """Stretches in the order of their beginnings, those that touch made one."""
    found = parts[:1]
    for part in parts[1:]:
        if part.start <= found[-1].stop:
            found[-1] = slice(found[-1].start, max(part.stop, found[-1].stop))
        else:
            found.append(part)
    return found
