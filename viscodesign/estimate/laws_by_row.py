"""Laws of several estimates side by side, of which some share one law."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from viscodesign.estimate.term import WallLaw

if TYPE_CHECKING:
    from viscodesign.estimate.setting import EstimateSetting

Law = TypeVar("Law")
Rows = slice | np.ndarray


def rows_by_law(laws: Sequence[Law]) -> Iterator[tuple[Law, Rows]]:
    """Every law that occurs, hashable, and the rows (n,) that have it; a slice where all do."""
    kinds = dict.fromkeys(laws)
    for law in kinds:
        own = np.flatnonzero([other == law for other in laws])
        yield law, slice(None) if len(kinds) == 1 else own


class WallsByRow:
    """Volume beyond rest, curvature and stretch of bellows, each row by its own law.

    ``walls`` (S,): the law of every row, None for the linear one. Laws are given the bellows on
    the last axis of a pressure.
    """

    def __init__(self, setting: EstimateSetting, walls: Sequence[WallLaw | None]) -> None:
        linear = setting.compliance, setting.curvature, setting.stretch
        self._linear = [np.reshape(slope, (-1, 1)) for slope in linear]
        self._rows = list(rows_by_law(walls))

    def __call__(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """[m3], [1/m] and [1] (S, B, T), for gauge pressures (S, B, T)."""
        if len(self._rows) == 1:
            return self._by_one(self._rows[0][0], pressure)
        found = np.empty((3, *pressure.shape))
        for wall, rows in self._rows:
            for k, value in enumerate(self._by_one(wall, pressure[rows])):
                found[k, rows] = value
        volume, curvature, stretch = found
        return volume, curvature, stretch

    def _by_one(
        self, wall: WallLaw | None, pressure: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        if wall is None:
            volume, curvature, stretch = (slope * pressure for slope in self._linear)
        else:
            found = wall(pressure.swapaxes(1, 2))
            volume, curvature, stretch = (value.swapaxes(1, 2) for value in found)
        return volume, curvature, stretch
