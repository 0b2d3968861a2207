"""Integrals of a force along a path, both known at a few times, and how sure they are."""

from __future__ import annotations

import numpy as np

GROUP = 4
"""Intervals that share one polynomial; the last of a stretch may have up to three more."""
SURE = 1 / 4
"""Error of a polynomial's integral over its distance from that of two of half the degree: a
fifteenth where these are quadratic and all is smooth, more at the edge of being resolved."""
SURE_OF_ONE = 1 / 6
"""The same of a single straight line over the change of the force times the way."""


def group_ends(first: int, last: int, stop: int) -> np.ndarray:
    """Ends, up to edge ``stop``, of the groups that make up a stretch from ``first`` to ``last``.

    ``first`` may be the end of any but the last of them.
    """
    ends = np.arange(first + GROUP, min(last, stop) + 1, GROUP)
    ends = ends[ends + GROUP <= last]
    return np.append(ends, last) if stop >= last > first else ends


def path_integrals(
    time: np.ndarray, force: np.ndarray, path: np.ndarray, cuts: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Integrals (g,) of force d(path) over groups of intervals, and their uncertainties (g,).

    ``time`` (m,); ``force``, ``path`` (m, n), summed over columns; the groups reach from one of
    the rows ``cuts`` (g + 1,) to the next. Inside a group both follow the polynomials through
    their values.
    """
    sizes = np.diff(cuts)
    found, unsure = np.zeros((2, len(sizes)))
    for size in np.unique(sizes):
        which = np.flatnonzero(sizes == size)
        rows = cuts[which, None] + np.arange(size + 1)
        found[which], unsure[which] = _groups(time[rows], force[rows], path[rows])
    return found, unsure


def _groups(time: np.ndarray, force: np.ndarray, path: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The same of groups of equal size: (g, k + 1), (g, k + 1, n)."""
    whole = _polynomial(time, force, path)
    if time.shape[1] == 2:
        change = np.sum((force[:, 1] - force[:, 0]) * (path[:, 1] - path[:, 0]), axis=1)
        return whole, SURE_OF_ONE * np.abs(change)
    middle = time.shape[1] // 2
    halves = slice(0, middle + 1), slice(middle, None)
    parts = sum(_polynomial(time[:, h], force[:, h], path[:, h]) for h in halves)
    return whole, SURE * np.abs(whole - parts)


def _polynomial(time: np.ndarray, force: np.ndarray, path: np.ndarray) -> np.ndarray:
    degree = np.arange(time.shape[1])
    share = (time - time[:, :1]) / (time[:, -1:] - time[:, :1])
    inverse = np.linalg.inv(share[:, :, None] ** degree)
    # Of monomials: the integral of s^i d(s^j) from 0 to 1 is j/(i + j).
    monomials = degree[None, :] / np.maximum(degree[:, None] + degree[None, :], 1)
    weights = np.swapaxes(inverse, 1, 2) @ monomials @ inverse
    return np.asarray(np.sum(force * (weights @ path), axis=(1, 2)))
