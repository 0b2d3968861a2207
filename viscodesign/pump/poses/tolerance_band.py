"""Where one servo may be in each frame, and which moves of the pose engine stay there.

A move from a count at a frame is known by its goal and its frames, for the engine's law leaves
no other choice; it may be taken if every frame of it lies in the band.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from viscodesign.pump.poses.engine import EIGHTHS, EXACT_FRAMES, MOST_FRAMES

HIGHEST_COUNT = 1023


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

    @cached_property
    def base(self) -> np.ndarray:
        """(N + 1,) lowest goal of each frame, in steps of the grid."""
        return -(-self.low // (EIGHTHS * self.grid))

    @cached_property
    def width(self) -> int:
        """Most goals that any frame has."""
        return max(int(np.max(self.high // (EIGHTHS * self.grid) - self.base)) + 1, 1)

    @cached_property
    def stay(self) -> np.ndarray:
        """(N + 1, G) last frame up to which a goal may be held from a frame on; -1 if not there.

        G: goals from 0 on, in steps of the grid.
        """
        goals = EIGHTHS * self.grid * np.arange(HIGHEST_COUNT // self.grid + 1)
        stay = np.full((self.last + 2, len(goals)), -1, dtype=np.int32)
        for frame in range(self.last, -1, -1):
            inside = (self.low[frame] <= goals) & (goals <= self.high[frame])
            stay[frame] = np.where(inside, np.maximum(stay[frame + 1], frame), -1)
        held: np.ndarray = stay[:-1]
        return held

    def goals(self, frame: int) -> np.ndarray:
        """Goals at a frame, in steps of the grid."""
        return np.arange(self.base[frame], self.high[frame] // (EIGHTHS * self.grid) + 1)

    def moves_from(self, frame: int, goal: int) -> np.ndarray:
        """(H, W) whether a move from a goal may last so many frames, to goals above the base.

        Row F - 1 is for F frames, and its goals count from the base of the frame it ends in;
        the last row is that of the longest move there is.
        """
        longest = min(MOST_FRAMES, self.last - frame)
        allowed = np.zeros((longest, self.width), dtype=bool)
        for goals, first, end in (
            self._ramps(frame, goal, longest),
            self._jumps(frame),
            self._dwell(frame, goal),
        ):
            self._mark(allowed, frame, goals, first, np.minimum(end, longest))
        exact = np.array(EXACT_FRAMES)
        inexact = np.ones(longest, dtype=bool)
        inexact[exact[exact <= longest] - 1] = False
        allowed[inexact] = False
        return allowed[: int(np.max(np.flatnonzero(allowed.any(axis=1)), initial=-1)) + 1]

    def is_open(self, frame: int, start: int, goal: int) -> bool:
        """Whether a move of two frames between goals stays inside."""
        unit = EIGHTHS * self.grid
        step = unit * abs(goal - start) // 2 + 1
        middle = unit * start + min(step, unit * abs(goal - start)) * (1 if goal > start else -1)
        return bool(self.low[frame + 1] <= middle <= self.high[frame + 1])

    def _mark(
        self,
        allowed: np.ndarray,
        frame: int,
        goals: np.ndarray,
        first: np.ndarray,
        end: np.ndarray,
    ) -> None:
        """Allow moves to goals that last from the first to the end number of frames."""
        lengths = np.maximum(end - first + 1, 0)
        frames = np.repeat(first, lengths) + _counted(lengths)
        allowed[frames - 1, np.repeat(goals, lengths) - self.base[frame + frames]] = True

    def _jumps(self, frame: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Moves of one frame: any goal that is inside then."""
        goals = self.goals(frame + 1)
        one = np.ones_like(goals)
        return goals, one, one

    def _dwell(self, frame: int, goal: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Moves that go nowhere."""
        return np.array([goal]), np.array([1]), self.stay[frame + 1, [goal]] - frame

    def _ramps(
        self, frame: int, goal: int, longest: int
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Goals, with the fewest and the most frames, of moves that take more than one."""
        speeds, alive = self._speeds(frame, goal, longest)
        step = np.abs(speeds)
        unit = EIGHTHS * self.grid
        # While D // step frames are alive, all frames before the arrival are inside.
        number = (step * (alive + 1) - 1) // unit
        index = np.repeat(np.arange(len(speeds)), number)
        steps = _counted(number) + 1
        step, distance = step[index], unit * steps
        goals = goal + np.sign(speeds[index]) * steps
        there = -(-distance // step)
        inside = (there <= longest) & (goals >= 0) & (goals < self.stay.shape[1])
        step, distance, goals, there = (a[inside] for a in (step, distance, goals, there))
        first = distance // step + 1
        # The law takes this step for F with (step - 1) F <= D < step F.
        most = np.where(step > 1, distance // np.maximum(step - 1, 1), longest)
        return goals, first, np.minimum(most, self.stay[frame + there, goals] - frame)

    def _speeds(self, frame: int, goal: int, longest: int) -> tuple[np.ndarray, np.ndarray]:
        """Speeds [1/8 count per frame] and for how many frames each stays inside."""
        frames = np.arange(1, longest + 1)
        here = EIGHTHS * self.grid * goal
        ahead = slice(frame + 1, frame + longest + 1)
        slowest = np.maximum.accumulate(-((here - self.low[ahead]) // frames))
        fastest = np.minimum.accumulate((self.high[ahead] - here) // frames)
        speeds = np.arange(slowest[0], fastest[0] + 1)
        speeds = speeds[speeds != 0]
        under = longest - np.searchsorted(fastest[::-1], speeds, side="left")
        over = np.searchsorted(slowest, speeds, side="right")
        return speeds, np.minimum(under, over)


def _counted(lengths: np.ndarray) -> np.ndarray:
    """0, 1, ... for each length, one after the other."""
    ends = np.cumsum(lengths)
    starts = np.repeat(ends - lengths, lengths)
    number: np.ndarray = np.arange(len(starts)) - starts
    return number
