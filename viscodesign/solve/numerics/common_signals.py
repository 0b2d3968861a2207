"""Many rows that are multiples of few signals."""

from __future__ import annotations

import numpy as np

SAME_REL = 1e-14
"""Difference of rows that are the same but for round-off."""


def combined(rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rows (D, N) as sums of few signals: (D, S) and (S, N).

    Many tubes that begin at one inlet see the same pressure.
    """
    size = np.max(np.abs(rows), axis=1, initial=0.0)[:, None]
    rest = rows / np.where(size > 0.0, size, 1.0)
    shares: list[np.ndarray] = []
    signals: list[np.ndarray] = []
    while len(rest) and len(signals) < len(rows):
        largest = np.abs(rest).max(axis=1)
        k = int(np.argmax(largest))
        if largest[k] <= SAME_REL:
            break
        signal = rest[k].copy()
        share = rest @ signal / (signal @ signal)
        rest -= share[:, None] * signal
        shares.append(share)
        signals.append(signal)
    found = np.array(shares).T.reshape(len(rows), len(shares)) * size
    return found, np.array(signals).reshape(len(signals), rows.shape[1])
