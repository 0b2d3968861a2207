"""Reducing long runs to what a picture can show."""

from __future__ import annotations

import numpy as np

from viscodesign.storage.disk_arrays import blocks, extremes

MAX_PLOTTED_ROWS = 40_000
"""Number of rows up to which a run is drawn in full."""
ENVELOPE_FIELDS = 1000
"""Number of time intervals of a long run; of each, lowest and highest values are drawn."""
PATH_STRETCHES = 40
"""Number of excerpts of a long path, each drawn in full."""
BEGINNING_SHARE = 0.25
"""Share of the drawn rows that is used for the beginning of a long path."""


def envelope(time: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Times (n,) and curves (n, m) that cover the same area as rows (T, m).

    Of a long run, the lowest and highest value of every interval in turn, so that no peak
    is lost, however short it is.
    """
    if len(time) <= MAX_PLOTTED_ROWS:
        return time, values
    size = -(-len(time) // ENVELOPE_FIELDS)
    found = [
        (time[rows.start], time[rows.stop - 1], part.min(axis=0), part.max(axis=0))
        for rows in blocks(len(time), time, values, rows=size)
        for part in [values[rows]]
    ]
    starts, ends, low, high = (np.array(part) for part in zip(*found, strict=True))
    when = np.stack((starts, ends), axis=1).reshape(-1)
    return when, np.stack((low, high), axis=1).reshape(len(when), -1)


def stretches(values: np.ndarray) -> list[slice]:
    """Excerpts of rows (T, m) that show where a long path runs; all rows of a short one.

    A long excerpt at the beginning, then some spread over the run to its end, and those with
    the lowest and highest values of the columns. Each is complete, since a path without some
    of its rows is another path.
    """
    count = len(values)
    if count <= MAX_PLOTTED_ROWS:
        return [slice(0, count)]
    size = int((1 - BEGINNING_SHARE) * MAX_PLOTTED_ROWS) // PATH_STRETCHES
    low, high = extremes(values)
    wanted = [int(k) for k in np.linspace(0, count - size, PATH_STRETCHES)]
    wanted += [k - size // 2 for k in _where(values, low, high)]
    inside = sorted(min(max(k, 0), count - size) for k in wanted)
    return _joined(
        [slice(0, int(BEGINNING_SHARE * MAX_PLOTTED_ROWS)), *(slice(k, k + size) for k in inside)]
    )


def _where(values: np.ndarray, low: np.ndarray, high: np.ndarray) -> list[int]:
    """The first rows with the lowest and highest value of each column."""
    found: dict[tuple[int, int], int] = {}
    for rows in blocks(len(values), values):
        hits = np.stack((values[rows] == low, values[rows] == high))
        for side, column in zip(*np.nonzero(hits.any(axis=1)), strict=True):
            first = rows.start + int(np.argmax(hits[side, :, column]))
            found.setdefault((int(side), int(column)), first)
    return list(found.values())


def _joined(parts: list[slice]) -> list[slice]:
    """Excerpts, sorted by their beginning, with those that touch merged."""
    found = parts[:1]
    for part in parts[1:]:
        if part.start <= found[-1].stop:
            found[-1] = slice(found[-1].start, max(part.stop, found[-1].stop))
        else:
            found.append(part)
    return found
