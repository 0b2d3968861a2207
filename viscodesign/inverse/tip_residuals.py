"""Distances of the tip from a wanted path as residuals of free numbers, with exact slopes."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from viscodesign.compiled.function import CompiledFunction
from viscodesign.inverse.path_match import PathMatch, match_paths
from viscodesign.inverse.wanted_path import WantedPath, rms
from viscodesign.lazy_dataclass import dataclass

TIP = ("tip_x_m", "tip_z_m")


@dataclass(frozen=True)
class PathDistance:
    """How far a found path is from a wanted one."""

    rms_m: float
    worst_m: float
    place: int
    """Of the wanted points, the one that is farthest off."""


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
        return self._opened(np.column_stack([found[name] for name in TIP]))

    def slopes(self, values: np.ndarray) -> np.ndarray:
        """(T, 2, f)"""
        found = self.function.jacobian(values)
        return self._opened(np.stack([found[name] for name in TIP], axis=1))

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


def distance(wanted: WantedPath, tip: np.ndarray) -> PathDistance:
    """How far the tip (T, 2) passes from the wanted points."""
    _, apart = matched(wanted, tip)
    lengths = np.linalg.norm(apart, axis=1)
    return PathDistance(rms(lengths), float(lengths.max()), int(lengths.argmax()))


class PathResiduals:
    """Distances (2 N,) over the root of N, so that their squares add up to the mean square."""

    def __init__(self, model: TipModel, wanted: WantedPath, penalty: Penalty | None = None) -> None:
        self._model, self._wanted, self._penalty = model, wanted, penalty
        self._root = np.sqrt(len(wanted.points))
        self._latest: tuple[bytes, PathMatch | None, np.ndarray] | None = None

    def __call__(self, values: np.ndarray) -> np.ndarray:
        """(2 N,) and the penalties."""
        _, apart = self._matched(values)
        own = apart.ravel() / self._root
        return own if self._penalty is None else np.append(own, self._penalty(values))

    def jacobian(self, values: np.ndarray) -> np.ndarray:
        """(2 N, f)"""
        match, _ = self._matched(values)
        slopes = self._model.slopes(values)
        if match is not None:
            slopes = match.across(match.along(slopes))
        own = slopes.reshape(-1, slopes.shape[-1]) / self._root
        if self._penalty is None:
            return np.asarray(own)
        return np.concatenate([own, self._penalty.jacobian(values)])

    def _matched(self, values: np.ndarray) -> tuple[PathMatch | None, np.ndarray]:
        """As `matched`; kept for slopes at the same values."""
        latest = self._latest
        if latest is None or latest[0] != values.tobytes():
            latest = values.tobytes(), *matched(self._wanted, self._model.tip(values))
            self._latest = latest
        return latest[1:]
