"""Fewest moves of the pose engine that keep its servos inside their tolerance bands.

All places that can be reached with one move more are found at a time, so the first path to the
end is a shortest one. The phantom goes up and down in turn, so that a pose is the goals and the
phase: 0 after an even number of moves, 1 after an odd one.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.poses.engine import EXACT_FRAMES
from viscodesign.pump.poses.tolerance_band import ToleranceBand

FIRST_FRAMES = 2
"""The first entry asks for this many frames; one would send a phantom that was never read
wandering for minutes, for its step then overflows 16 bits."""


@dataclass(frozen=True)
class Vertex:
    """Where a move begins or ends."""

    frame: int
    goals: tuple[int, ...]
    """Counts of the servos."""


@dataclass(frozen=True)
class _Node:
    frame: int
    goals: tuple[int, ...]
    """In steps of the grid."""
    parent: _Node | None
    root: tuple[int, ...]


class MoveSearch:
    """One search through P bands at once; every servo's moves begin and end together."""

    def __init__(self, bands: list[ToleranceBand], *, closed: bool) -> None:
        self.bands = bands
        self.closed = closed
        self.last = bands[0].last
        widths = [band.width for band in bands]
        self._seen = np.zeros((2, self.last + 1, *widths), dtype=bool)
        self._moves: dict[tuple[int, int, int], np.ndarray] = {}

    def vertices(self, most: int) -> list[Vertex] | None:
        """Corners of a path with at most so many moves; none where there is no such path.

        The first lies at frame 0. A closed path lacks its last move, back to the first corner.
        """
        rows = np.stack(np.meshgrid(*(band.goals(0) for band in self.bands), indexing="ij"), -1)
        roots = map(tuple, rows.reshape(-1, len(self.bands)).tolist())
        layer = [_Node(0, goals, None, goals) for goals in roots]
        for moves in range(most + 1):
            for node in layer:
                if self._is_end(node, moves % 2):
                    return self._path_to(node)
            layer = [new for node in layer for new in self._expand(node, (moves + 1) % 2)]
        return None

    def _expand(self, node: _Node, phase: int) -> Iterator[_Node]:
        """New places that one move leads to from a node."""
        if node.frame == self.last:
            return
        options = self._options(node)
        ends = node.frame + np.array(EXACT_FRAMES[: len(options)], dtype=int)
        new = options & ~self._seen[phase, ends]
        self._seen[phase, ends] |= new
        rows = np.argwhere(new)
        frames = ends[rows[:, 0]]
        goals = rows[:, 1:] + np.stack([band.base[frames] for band in self.bands], -1)
        for frame, row in zip(frames.tolist(), goals.tolist(), strict=True):
            yield _Node(frame, tuple(row), node, node.root)

    def _options(self, node: _Node) -> np.ndarray:
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

    def _is_end(self, node: _Node, phase: int) -> bool:
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

    def _path_to(self, end: _Node) -> list[Vertex]:
        path, node, grid = [], end, self.bands[0].grid
        while True:
            path.append(Vertex(node.frame, tuple(grid * goal for goal in node.goals)))
            if node.parent is None:
                return path[::-1]
            node = node.parent
