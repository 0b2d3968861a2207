"""What of a quantity lasts long enough to matter."""

from __future__ import annotations

import numpy as np

from viscodesign.solve.numerics.linear_recurrence import marched


class Sustained:
    """A quantity that comes block by block, as something that takes a while to yield to it sees it.

    A lag of first order, from zero at the first time: a burst counts by how long it lasts, at
    whatever times it was sampled.
    """

    def __init__(self, lag_s: float) -> None:
        self._lag_s = lag_s
        self._time: float | None = None
        self._value = np.zeros(0)

    def update(self, time: np.ndarray, values: np.ndarray) -> np.ndarray:
        """The lagged values (T, n) of ``values`` (T, n) at times (T,), after those before."""
        before = time[0] if self._time is None else self._time
        passed = np.diff(time, prepend=before)
        lag_s = max(self._lag_s, 1e-300)
        kept = np.exp(-np.minimum(passed / lag_s, 1e3))
        value = np.zeros(values.shape[1]) if self._time is None else self._value
        found = marched(kept[None], (1 - kept) * values.T, value)[:, 1:].T
        self._time, self._value = float(time[-1]), found[-1]
        return found
