"""Few straight pieces that follow many rows within a bound."""

from __future__ import annotations

import math

import numpy as np

HALVED_FROM = 40
"""Rounds after which pieces are halved too: smooth curves need fewer, and rounds have an end."""


def straight_pieces(
    time: np.ndarray, value: np.ndarray, bound: float, most: float = math.inf
) -> np.ndarray:
    """Indices of rows (k,) whose straight connection keeps every row (n,) within a bound.

    Each piece is split at its worst row until none is worse, all pieces at once (U. Ramer, 1972;
    D. H. Douglas and T. K. Peucker, 1973). Two rows at one time, a jump, are both kept. Ends early
    with more than ``most`` rows.
    """
    jumps = np.flatnonzero(np.diff(time) == 0.0)
    knots = np.unique(np.concatenate([[0, len(time) - 1], jumps, jumps + 1]))
    rounds = 0
    while len(knots) <= most:
        apart = np.abs(connected(time, value, knots) - value)
        worst = np.maximum.reduceat(apart, knots[:-1])
        piece = _pieces(len(time), knots)
        is_worst = np.flatnonzero((apart == worst[piece]) & (apart > bound))
        if not len(is_worst):
            break
        split, first = np.unique(piece[is_worst], return_index=True)
        halves = (knots[split] + knots[split + 1]) // 2 if rounds >= HALVED_FROM else knots[:0]
        knots = np.unique(np.concatenate([knots, is_worst[first], halves]))
        rounds += 1
    return np.asarray(knots)


def connected(time: np.ndarray, value: np.ndarray, knots: np.ndarray) -> np.ndarray:
    """Values (n,) at all rows on the straight lines between the knots' rows."""
    piece = _pieces(len(time), knots)
    first, last = knots[piece], knots[piece + 1]
    span = time[last] - time[first]
    share = (time - time[first]) / np.where(span > 0.0, span, 1.0)
    share = np.where(span > 0.0, share, np.arange(len(time)) == last)
    return np.asarray(value[first] + share * (value[last] - value[first]))


def _pieces(rows: int, knots: np.ndarray) -> np.ndarray:
    """The piece of every row (n,), from one knot up to the next."""
    lengths = np.diff(knots)
    lengths[-1] += 1
    return np.repeat(np.arange(len(lengths)), lengths)
