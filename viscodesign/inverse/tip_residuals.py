"""Distances of the tip from a wanted path as residuals of free numbers, with exact slopes."""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np

from viscodesign.compiled.function import CompiledFunction
from viscodesign.compiled.outputs import TIP_COLUMNS
from viscodesign.inverse.path_excess import PathExcess, path_excess
from viscodesign.inverse.path_match import PathMatch, match_paths
from viscodesign.inverse.wanted_path import WantedPath, rms
from viscodesign.lazy_dataclass import dataclass

STRAY_TIMES = 3.0
"""A found path strays where it is farther off than any wanted point by this many tolerances."""


@dataclass(frozen=True)
class PathDistance:
    """How far a found path is from a wanted one."""

    rms_m: float
    worst_m: float
    place: int
    """Place of the wanted point that is farthest off."""
    excess_m: float | None = None
    """Largest distance of a found point from the wanted line [m]; None where times decide."""
    excess_at: tuple[float, float] | None = None
    """That point, x and z [m]."""
    stray_m: float = 0.0
    """Root mean square of what found points are off beyond the tolerance [m]."""
    strays: bool = False
    """Whether the found path leaves the wanted one for a while."""

    @property
    def total_m(self) -> float:
        """Both ways: what a search ranks by [m]."""
        return math.hypot(self.rms_m, self.stray_m)

    def meets(self, tolerance_m: float) -> bool:
        """Whether the wanted path is followed within a tolerance [m], and no other besides."""
        return self.rms_m <= tolerance_m and not self.strays


class TipModel(Protocol):
    """The path of a tip as a function of free numbers (f,); of a loop without its end."""

    def tip(self, values: np.ndarray, /) -> np.ndarray:
        """(T, 2) [m]"""

    def slopes(self, values: np.ndarray, /) -> np.ndarray:
        """(T, 2, f)"""


class Penalty(Protocol):
    """More residuals of the free numbers: what a design must keep besides the path."""

    def __call__(self, values: np.ndarray, /) -> np.ndarray: ...

    def jacobian(self, values: np.ndarray, /) -> np.ndarray: ...


@dataclass(frozen=True)
class CompiledTip:
    """The tip of a compiled function."""

    function: CompiledFunction
    is_loop: bool

    def tip(self, values: np.ndarray) -> np.ndarray:
        """(T, 2) [m]"""
        found = self.function(values)
        return self._opened(np.column_stack([found[name] for name in TIP_COLUMNS]))

    def slopes(self, values: np.ndarray) -> np.ndarray:
        """(T, 2, f)"""
        found = self.function.jacobian(values)
        return self._opened(np.stack([found[name] for name in TIP_COLUMNS], axis=1))

    def _opened(self, rows: np.ndarray) -> np.ndarray:
        return rows[:-1] if self.is_loop else rows


def matched(wanted: WantedPath, tip: np.ndarray) -> tuple[PathMatch | None, np.ndarray]:
    """The match of a tip's path (T, 2), None where times decide, and distances (N, 2) [m]."""
    if wanted.timing == "given":
        return None, tip - wanted.points
    match = match_paths(wanted.points, tip, closed=wanted.closed)
    apart = match.along(tip) - wanted.points
    if wanted.any_sense:
        turned = match_paths(wanted.points[::-1], tip, closed=wanted.closed)
        other = turned.along(tip) - wanted.points[::-1]
        if np.sum(other**2) < np.sum(apart**2):
            return turned, other
    return match, apart


def distance(wanted: WantedPath, tip: np.ndarray, tolerance_m: float) -> PathDistance:
    """How far the tip (T, 2) passes from the wanted points, and strays from their line."""
    match, apart = matched(wanted, tip)
    lengths = np.linalg.norm(apart, axis=1)
    near = rms(lengths), float(lengths.max()), int(lengths.argmax())
    if match is None:
        return PathDistance(*near)
    excess = path_excess(wanted, match, tip)
    largest, (x, z) = float(excess.distances[excess.place]), tip[excess.place].tolist()
    return PathDistance(
        *near,
        excess_m=largest,
        excess_at=(x, z),
        stray_m=float(np.linalg.norm(excess.beyond(tolerance_m))),
        strays=largest > max(near[1], STRAY_TIMES * tolerance_m),
    )


class PathResiduals:
    """Distances (2 N,) over the root of N, so that their squares add up to the mean square.

    ``allowed_m``: of found points what they are farther off than that, so that a path that is left
    for a while loses, and one that is followed is judged by its wanted points alone.
    ``both_ways``: all distances of the tip's path from the wanted one instead, for a search that
    begins far off: a path that is passed nearby on wide ways is near, but leads nowhere.
    """

    def __init__(
        self,
        model: TipModel,
        wanted: WantedPath,
        penalty: Penalty | None = None,
        *,
        allowed_m: float = math.inf,
        both_ways: bool = False,
    ) -> None:
        self._model, self._wanted, self._penalty = model, wanted, penalty
        self._both_ways = both_ways and wanted.timing == "free" and not wanted.any_sense
        self._allowed_m = allowed_m
        self._latest: tuple[bytes, list[_Part | _Stray]] | None = None

    def __call__(self, values: np.ndarray) -> np.ndarray:
        """(2 N,), what is asked for besides, and the penalties."""
        own = [part.residuals() for part in self._parts(values)]
        return np.concatenate([*own, self._penalty(values)] if self._penalty else own)

    def jacobian(self, values: np.ndarray) -> np.ndarray:
        """The same, f columns."""
        slopes = self._model.slopes(values)
        own = [part.slopes(slopes) for part in self._parts(values)]
        return np.concatenate([*own, self._penalty.jacobian(values)] if self._penalty else own)

    def _parts(self, values: np.ndarray) -> list[_Part | _Stray]:
        """Distances each way; kept for slopes at the same values."""
        if self._latest is None or self._latest[0] != values.tobytes():
            tip = self._model.tip(values)
            match, apart = matched(self._wanted, tip)
            found: list[_Part | _Stray] = [_Part(match, apart, is_of_tip=False)]
            if self._both_ways:
                back = match_paths(tip, self._wanted.points, closed=self._wanted.closed)
                found.append(_Part(back, tip - back.along(self._wanted.points), is_of_tip=True))
            elif match is not None and math.isfinite(self._allowed_m):
                found.append(_Stray(path_excess(self._wanted, match, tip), self._allowed_m))
            self._latest = values.tobytes(), found
        return self._latest[1]


@dataclass(frozen=True, eq=False)
class _Part:
    """Distances between two paths, and which of them slides along the other."""

    match: PathMatch | None
    apart: np.ndarray
    is_of_tip: bool
    """Whether every row of the tip is matched, rather than every wanted point."""

    @property
    def root(self) -> float:
        """Root of the number of distances."""
        return math.sqrt(len(self.apart))

    def residuals(self) -> np.ndarray:
        """(2 N,)"""
        found: np.ndarray = self.apart.ravel() / self.root
        return found

    def slopes(self, slopes: np.ndarray) -> np.ndarray:
        """(2 N, f) of the residuals for those of the tip (T, 2, f)."""
        if self.match is not None:
            own = slopes if self.is_of_tip else self.match.along(slopes)
            slopes = self.match.across(own)
        return slopes.reshape(-1, slopes.shape[-1]) / self.root


@dataclass(frozen=True, eq=False)
class _Stray:
    """What found points are off beyond a distance."""

    excess: PathExcess
    allowed_m: float

    def residuals(self) -> np.ndarray:
        """(T,)"""
        return self.excess.beyond(self.allowed_m)

    def slopes(self, slopes: np.ndarray) -> np.ndarray:
        """(T, f) for slopes of the tip (T, 2, f)."""
        return self.excess.slopes(slopes, self.allowed_m)
