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

    ``walls`` (S,): the law of every row, None for the linear one.
    """

    def __init__(self, setting: EstimateSetting, walls: Sequence[WallLaw | None]) -> None:
        self._linear = setting.compliance, setting.curvature, setting.stretch
        self._rows = list(rows_by_law(walls))

    def __call__(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """[m3], [1/m] and [1], for gauge pressures (S, ...)."""
        found = np.empty((3, *pressure.shape))
        for wall, rows in self._rows:
            given = pressure[rows]
            values = [c * given for c in self._linear] if wall is None else wall(given)
            for k, value in enumerate(values):
                found[k, rows] = value
        volume, curvature, stretch = found
        return volume, curvature, stretch
