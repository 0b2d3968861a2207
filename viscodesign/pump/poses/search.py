"""Fewest moves of the pose engine that keep its servos inside their tolerance bands.

A move from a count at a frame is known by its goal and its frames, for the engine's law leaves
no other choice; it may be taken if every frame of it lies in the band. All places that can be
reached with one move more are found at a time, so the first path to the end is a shortest one.
The phantom goes up and down in turn, so that a pose is the goals and the phase: 0 after an even
number of moves, 1 after an odd one.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.protocol.registers import FULL
from viscodesign.pump.poses.engine import EIGHTHS, EXACT_FRAMES
from viscodesign.storage.cached_property import cached_property

FIRST_FRAMES = 2
"""The first entry asks for this many frames; one would send a phantom that was never read
wandering for minutes, for its step then overflows 16 bits."""
_EXACT = np.array(EXACT_FRAMES)


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


class Corner(NamedTuple):
    """Where a move begins or ends."""

    frame: int
    goals: tuple[int, ...]
    """Of the servos, in steps of the grid."""
    parent: Corner | None
    root: tuple[int, ...]
    """Goals of the first corner."""


class MoveSearch:
    """One search through P bands at once; every servo's moves begin and end together."""

    def __init__(self, bands: list[ToleranceBand], *, closed: bool) -> None:
        self.bands = bands
        self.closed = closed
        self.last = bands[0].last
        widths = [band.width for band in bands]
        self._seen = np.zeros((2, self.last + 1, *widths), dtype=bool)
        self._moves: dict[tuple[int, int, int], np.ndarray] = {}

    def path(self, most: int) -> tuple[list[int], list[list[int]]] | None:
        """Frames, and goals [counts], of the corners of a path with at most so many moves, or none.

        The first lies at frame 0. A closed path lacks its last move, back to the first corner.
        """
        rows = np.stack(np.meshgrid(*(band.goals(0) for band in self.bands), indexing="ij"), -1)
        roots = map(tuple, rows.reshape(-1, len(self.bands)).tolist())
        layer = [Corner(0, goals, None, goals) for goals in roots]
        for moves in range(most + 1):
            for node in layer:
                if self._is_end(node, moves % 2):
                    return self._path_to(node)
            layer = [new for node in layer for new in self._expand(node, (moves + 1) % 2)]
        return None

    def _expand(self, node: Corner, phase: int) -> Iterator[Corner]:
        """New places that one move leads to from a node."""
        if node.frame == self.last:
            return
        options = self._options(node)
        ends = node.frame + _EXACT[: len(options)]
        new = options & ~self._seen[phase, ends]
        self._seen[phase, ends] |= new
        rows = np.argwhere(new)
        frames = ends[rows[:, 0]]
        goals = rows[:, 1:] + np.stack([band.base[frames] for band in self.bands], -1)
        for frame, row in zip(frames.tolist(), goals.tolist(), strict=True):
            yield Corner(frame, tuple(row), node, node.root)

    def _options(self, node: Corner) -> np.ndarray:
        """(H, W1, ...) moves that all servos can take together."""
        each = [self._moves_of(servo, node.frame, goal) for servo, goal in enumerate(node.goals)]
        together = each[0]
        for other in each[1:]:
            shorter = min(len(together), len(other))
            together = together[:shorter, ..., None] & other[:shorter, None, :]
        return together

    def _moves_of(self, servo: int, frame: int, goal: int) -> np.ndarray:
        key = (servo, frame, goal)
        if key not in self._moves:
            self._moves[key] = self.bands[servo].moves_from(frame, goal)
        return self._moves[key]

    def _is_end(self, node: Corner, phase: int) -> bool:
        if not self.closed:
            return node.frame == self.last
        if phase == 0 and node.goals == node.root:
            # Nothing is to go anywhere in the first entry: it lasts one frame.
            return node.frame == self.last - 1
        if node.frame != self.last - FIRST_FRAMES:
            return False
        pairs = zip(self.bands, node.root, strict=True)
        back = tuple(goal - int(band.base[-1]) for band, goal in pairs)
        return any(bool(row[back]) for row in self._options(node)[FIRST_FRAMES - 1 :])

    def _path_to(self, end: Corner) -> tuple[list[int], list[list[int]]]:
        path = [end]
        while (before := path[-1].parent) is not None:
            path.append(before)
        goals = self.bands[0].grid * np.array([corner.goals for corner in reversed(path)])
        return [corner.frame for corner in reversed(path)], goals.tolist()
