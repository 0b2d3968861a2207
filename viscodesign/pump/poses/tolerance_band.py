"""Where one servo may be in each frame, and which moves of the pose engine stay there.

A move from a count at a frame is known by its goal and its frames, for the engine's law leaves
no other choice; it may be taken if every frame of it lies in the band.
"""

from __future__ import annotations

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.protocol.registers import FULL
from viscodesign.pump.poses.engine import EIGHTHS, EXACT_FRAMES
from viscodesign.storage.cached_property import cached_property


@dataclass(frozen=True)
class ToleranceBand:
    """Where one servo may be: N + 1 frames, goals on a grid of whole counts."""

    low: np.ndarray
    """(N + 1,) lowest position allowed [1/8 count]."""
    high: np.ndarray
    """(N + 1,) highest."""
    grid: int
    """Goals are multiples of this [counts]."""

    @classmethod
    def around(
        cls,
        lowest: np.ndarray,
        highest: np.ndarray,
        margin: float,
        travel: tuple[int, int],
        *,
        closed: bool,
    ) -> ToleranceBand:
        """All within a margin of both bounds (N + 1,), and within travel [counts].

        ``closed``: the last frame is the first one of the next round.
        """
        # The servo is sent whole counts, rounded down; the slack keeps round-off out.
        low = EIGHTHS * np.ceil(highest - margin - 1e-9).astype(int)
        high = EIGHTHS * np.floor(lowest + margin + 1e-9).astype(int) + EIGHTHS - 1
        if closed:
            low[[0, -1]], high[[0, -1]] = max(low[0], low[-1]), min(high[0], high[-1])
        low = np.clip(low, EIGHTHS * travel[0], None)
        high = np.clip(high, None, EIGHTHS * travel[1])
        fitting, coarsest = round(margin / 3), (travel[1] - travel[0]) // 8
        return cls(low, high, max(min(fitting, coarsest), 1))

    @property
    def last(self) -> int:
        """The last frame N."""
        return len(self.low) - 1

    @property
    def unit(self) -> int:
        """A step of the grid [1/8 count]."""
        return EIGHTHS * self.grid

    @cached_property
    def base(self) -> np.ndarray:
        """(N + 1,) lowest goal of each frame, in steps of the grid."""
        return -(-self.low // self.unit)

    @cached_property
    def width(self) -> int:
        """Most goals that any frame has."""
        return max(int(np.max(self.high // self.unit - self.base)) + 1, 1)

    @cached_property
    def stay(self) -> np.ndarray:
        """(N + 1, G) last frame up to which a goal may be held from a frame on; -1 if not there.

        G: goals from 0 on, in steps of the grid.
        """
        goals = self.unit * np.arange(FULL // self.grid + 1 + self.width)
        stay = np.full((self.last + 2, len(goals)), -1, dtype=np.int32)
        for frame in range(self.last, -1, -1):
            inside = (self.low[frame] <= goals) & (goals <= self.high[frame])
            stay[frame] = np.where(inside, np.maximum(stay[frame + 1], frame), -1)
        return stay

    def goals(self, frame: int) -> np.ndarray:
        """Goals at a frame, in steps of the grid."""
        return np.arange(self.base[frame], self.high[frame] // self.unit + 1)

    def moves_from(self, frame: int, goal: int) -> np.ndarray:
        """(H, W) whether a move from a goal may last so many frames, to goals above the base.

        A row for each of `EXACT_FRAMES` up to the longest move there is; its goals count from
        the base of the frame in which it ends.
        """
        frames = _EXACT[: np.searchsorted(_EXACT, self.last - frame, side="right"), None]
        ends = frame + frames
        # The last column of `stay` is beyond all counts.
        goals = np.minimum(self.base[ends] + np.arange(self.width), self.stay.shape[1] - 1)
        distance = self.unit * np.abs(goals - goal)
        step = distance // frames + 1
        speed = np.sign(goals - goal) * step
        slowest, fastest = self._speeds(frame, goal)
        # Only in whole steps is it under way; in the frame behind them it arrives.
        under_way, arrival = distance // step, frame - (-distance // step)
        allowed = (
            (slowest[under_way] <= speed)
            & (speed <= fastest[under_way])
            & (self.stay[arrival, goals] >= ends)
        )
        used = np.flatnonzero(allowed.any(axis=1))
        return np.asarray(allowed[: int(used[-1]) + 1 if len(used) else 0])

    def _speeds(self, frame: int, goal: int) -> tuple[np.ndarray, np.ndarray]:
        """Lowest and highest speed [1/8 count per frame] that stay inside for 0, 1, ... frames."""
        ahead = slice(frame + 1, frame + 1 + int(_EXACT[-1]))
        frames = np.arange(1, len(self.low[ahead]) + 1)
        start, any_speed = self.unit * goal, np.array([self.unit * (FULL + 1)])
        slowest = -((start - self.low[ahead]) // frames)
        fastest = (self.high[ahead] - start) // frames
        return (
            np.maximum.accumulate(np.append(-any_speed, slowest)),
            np.minimum.accumulate(np.append(any_speed, fastest)),
        )


_EXACT = np.array(EXACT_FRAMES)
