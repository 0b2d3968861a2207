"""How far the points of a found path are from a wanted one, whose own points may all be met.

A tip that leaves the path, goes round elsewhere and comes back passes every wanted point; only the
way back, from the found points to the wanted line, tells.
"""

from __future__ import annotations

import math

import numpy as np

from viscodesign.inverse.path_match import PathMatch
from viscodesign.inverse.wanted_path import WantedPath
from viscodesign.lazy_dataclass import dataclass

ROWS_AT_ONCE = 2000


@dataclass(frozen=True, eq=False)
class PathExcess:
    """Deviation of T points from the requested path, none beyond the ends of an open one."""

    distances: np.ndarray
    """(T,) [m]"""
    directions: np.ndarray
    """(T, 2) unit vectors away from the line; 0 on it."""

    @property
    def place(self) -> int:
        """The row that is farthest off."""
        return int(self.distances.argmax())

    def beyond(self, allowed: float) -> np.ndarray:
        """(T,) what is more than allowed, over the root of T: squares add up to the mean square."""
        found: np.ndarray = np.maximum(self.distances - allowed, 0.0)
        return found / math.sqrt(len(found))

    def slopes(self, slopes: np.ndarray, allowed: float) -> np.ndarray:
        """(T, f) of `beyond` for slopes of the points (T, 2, f): the nearest point of the line
        moves at right angles to its distance."""
        counted = self.directions * (self.distances > allowed)[:, None]
        found: np.ndarray = np.einsum("tc,tcf->tf", counted, slopes)
        return found / math.sqrt(len(found))


def path_excess(wanted: WantedPath, match: PathMatch, tip: np.ndarray) -> PathExcess:
    """How far the tip's points (T, 2) are from the line, between the places of its ends."""
    line = wanted.way if wanted.line is None else wanted.line
    count = math.ceil(len(tip) / ROWS_AT_ONCE)
    apart = np.concatenate([_from_line(line, part) for part in np.array_split(tip, count)])
    if not wanted.closed:
        rows = np.arange(len(tip))
        apart[(rows < match.after[0]) | (rows > match.before[-1])] = 0.0
    distances = np.linalg.norm(apart, axis=1)
    return PathExcess(distances, apart / np.where(distances > 0, distances, 1.0)[:, None])


def _from_line(line: np.ndarray, points: np.ndarray) -> np.ndarray:
    """(T, 2) To points (T, 2) from the nearest places of a line (M, 2)."""
    begins, steps = line[:-1], np.diff(line, axis=0)
    squares = (steps**2).sum(axis=1)
    from_begins = points[:, None] - begins[None]
    share = np.einsum("tmc,mc->tm", from_begins, steps) / np.where(squares > 0, squares, 1.0)
    apart = from_begins - np.clip(share, 0.0, 1.0)[:, :, None] * steps
    nearest = (apart**2).sum(axis=2).argmin(axis=1)
    found: np.ndarray = apart[np.arange(len(points)), nearest]
    return found
