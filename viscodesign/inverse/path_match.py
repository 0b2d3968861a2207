"""Which point of a found path belongs to each point of a wanted one, passed in the same order."""

from __future__ import annotations

import numpy as np

from viscodesign.lazy_dataclass import dataclass

COARSE_STARTS = 16
"""Rows of a loop that are tried first as its beginning."""
COARSE_POINTS = 4
"""Steps between the wanted points that tell them apart."""
CLAMPED = 1e-9
"""Share of a step at which a place is at its end."""


@dataclass(frozen=True, eq=False)
class PathMatch:
    """Places on a found path (M, 2) for N wanted points.

    Of equal sums of squared distances any; the order is kept, to within one step of the path.
    """

    before: np.ndarray
    """(N,) The row before each place."""
    after: np.ndarray
    """(N,) The row behind it."""
    share: np.ndarray
    """(N,) Of the way between the two."""
    slides: np.ndarray
    """(N,) Whether the place may slide along the path: its distance is then the shortest."""
    tangents: np.ndarray
    """(N, 2) Unit vectors along the path there."""

    def along(self, rows: np.ndarray) -> np.ndarray:
        """(N, ...) What rows (M, ...) of the found path are at the places."""
        share = self.share.reshape(-1, *(1,) * (rows.ndim - 1))
        found: np.ndarray = (1 - share) * rows[self.before] + share * rows[self.after]
        return found

    def across(self, slopes: np.ndarray) -> np.ndarray:
        """(N, 2, f) Slopes of the distances for those of the places: what moves a path along
        itself brings it no nearer."""
        way = np.einsum("nc,ncf->nf", self.tangents, slopes) * self.slides[:, None]
        found: np.ndarray = slopes - self.tangents[:, :, None] * way[:, None]
        return found


def match_paths(wanted: np.ndarray, found: np.ndarray, *, closed: bool) -> PathMatch:
    """The places on ``found`` (M, 2) nearest to ``wanted`` (N, 2), passed in the same order.

    The sum of the squared distances is the least over the rows of the path (dynamic programming;
    of a loop for many rows that it may begin at), then each place slides along its two steps.
    """
    squares = ((wanted[:, None] - found[None]) ** 2).sum(axis=2)
    rows = _rows_of_loop(squares) if closed else _rows_of_way(squares)
    return _slid(wanted, found, rows, closed=closed)


def _rows_of_way(squares: np.ndarray) -> np.ndarray:
    """(N,) Rows that do not go back, with the least sum of squares (N, M)."""
    totals, least = _sums(squares[:, None, :])
    return _traced(totals[:, 0], least[:, 0])


def _rows_of_loop(squares: np.ndarray) -> np.ndarray:
    """The same around a loop, from the row that is best to begin at: coarsely, then beside it."""
    count = squares.shape[1]
    stride = max(1, count // COARSE_STARTS)
    starts = np.arange(0, count, stride)
    totals, _ = _sums(_begun_at(squares[::COARSE_POINTS], starts))
    best = int(starts[_best_of(totals)])
    starts = np.arange(best - stride + 1, best + stride) % count
    totals, least = _sums(_begun_at(squares, starts))
    place = _best_of(totals)
    around: np.ndarray = (_traced(totals[:, place], least[:, place]) + starts[place]) % count
    return around


def _begun_at(squares: np.ndarray, starts: np.ndarray) -> np.ndarray:
    """(N, S, M) Squares (N, M) of a loop that begins at each of some rows (S,)."""
    count = squares.shape[1]
    found: np.ndarray = squares[:, (starts[:, None] + np.arange(count)[None]) % count]
    return found


def _best_of(totals: np.ndarray) -> int:
    """Which of S cases has the least sum."""
    return int(totals[-1].min(axis=1).argmin())


def _sums(squares: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Least sums (N, S, M) of S cases up to each wanted point, at each row and at any up to it."""
    totals, least = np.empty_like(squares), np.empty_like(squares)
    totals[0] = squares[0]
    for k in range(len(squares) - 1):
        np.minimum.accumulate(totals[k], axis=1, out=least[k])
        np.add(squares[k + 1], least[k], out=totals[k + 1])
    np.minimum.accumulate(totals[-1], axis=1, out=least[-1])
    return totals, least


def _traced(totals: np.ndarray, least: np.ndarray) -> np.ndarray:
    """(N,) The rows that made the least sum, for the sums (N, M) of one case."""
    # The last row up to each one at which the least was reached.
    place = np.where(totals <= least, np.arange(totals.shape[1]), 0)
    back = np.maximum.accumulate(place, axis=1).tolist()
    here = int(totals[-1].argmin())
    rows = [here]
    for own in reversed(back[:-1]):
        here = own[here]
        rows.append(here)
    return np.array(rows[::-1])


def _slid(wanted: np.ndarray, found: np.ndarray, rows: np.ndarray, *, closed: bool) -> PathMatch:
    """Places on the steps beside the rows that are nearest."""
    count = len(found)
    best = np.full(len(wanted), np.inf)
    before, after, share = rows.copy(), rows.copy(), np.zeros(len(wanted))
    for first, second in ((rows - 1, rows), (rows, rows + 1)):
        if closed:
            a, b = first % count, second % count
        else:
            a, b = np.clip(first, 0, count - 1), np.clip(second, 0, count - 1)
        step = found[b] - found[a]
        square = (step**2).sum(axis=1)
        part = ((wanted - found[a]) * step).sum(axis=1) / np.where(square > 0, square, 1.0)
        part = np.clip(np.where(square > 0, part, 0.0), 0.0, 1.0)
        distance = ((found[a] + part[:, None] * step - wanted) ** 2).sum(axis=1)
        nearer = distance < best
        best = np.where(nearer, distance, best)
        before, after = np.where(nearer, a, before), np.where(nearer, b, after)
        share = np.where(nearer, part, share)
    step = found[after] - found[before]
    length = np.linalg.norm(step, axis=1)
    tangents = step / np.where(length > 0, length, 1.0)[:, None]
    # At a corner of the path a place is held: its distance is not at right angles to either step.
    slides = (share > CLAMPED) & (share < 1 - CLAMPED) & (length > 0)
    return PathMatch(before, after, share, slides, tangents)
