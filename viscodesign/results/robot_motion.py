"""The motion of a robot over the ground: plain data."""

from __future__ import annotations

import numpy as np

from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True, eq=False)
class RobotMotion:
    """Body, feet and sources of a robot at the ends of all steps, the start first."""

    legs: tuple[str, ...]
    sources: tuple[str, ...]
    source_of: tuple[int, ...]
    """Which source feeds each leg."""
    foot_radius: float
    """[m]"""
    period: float
    """[s]"""
    time: np.ndarray
    """(T,) [s]"""
    body: np.ndarray
    """x, height of the hips over the ground [m], pitch, roll [rad] (T, 4)."""
    feet: np.ndarray
    """x, gap over the ground [m] and rotation [rad] of every foot (T, L, 3)."""
    normal: np.ndarray
    """Normal force of the ground on every foot (T, L) [N]."""
    friction: np.ndarray
    """Friction of the ground on every foot, positive forward (T, L) [N]."""
    slip: np.ndarray
    """Way of every foot's contact point over the ground in the step before (T, L) [m]."""
    pressure: np.ndarray
    """Gauge, of every source (T, S) [Pa]."""
    delivered: np.ndarray
    """By every source since the start, as volume at ambient density (T, S) [m3]."""
    barrel: np.ndarray
    """Volume of that fluid which each pump still holds, at its pressure (T, S) [m3]; the smallest
    barrel that is never empty."""
    rows: np.ndarray
    """Steps (R,) at which legs are known."""
    axes: np.ndarray
    """x and height of the ends of all sections of every leg (R, L, n, 2) [m]; NaN where a leg has
    fewer than others."""

    @property
    def step(self) -> float:
        """[s]"""
        return float(self.time[1] - self.time[0])

    @property
    def steps_per_cycle(self) -> int:
        """Steps in a period."""
        return round(self.period / self.step)

    @property
    def last_cycle(self) -> slice:
        """The rows of the last period, both ends; all of them where the motion ended before."""
        return slice(max(len(self.time) - 1 - self.steps_per_cycle, 0), None)

    @property
    def advances(self) -> np.ndarray:
        """How far the body came in every whole period (n,) [m]."""
        return np.diff(self.body[:: self.steps_per_cycle, 0])
