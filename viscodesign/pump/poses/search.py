"""Fewest moves of the pose engine that keep its servos inside their tolerance bands.

All places that can be reached with one move more are found at a time, so the first path to the
end is a shortest one. The phantom goes up and down in turn, so that a pose is the goals and the
phase: 0 after an even number of moves, 1 after an odd one.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from viscodesign.pump.poses.tolerance_band import ToleranceBand

Pose = tuple[tuple[int, ...], int]
"""Counts of the servos, and the phase."""
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
    parent: int
    root: tuple[int, ...]


class MoveSearch:
    """One search through P bands at once; every servo's moves begin and end together."""

    def __init__(
        self, bands: list[ToleranceBand], *, closed: bool, poses: Iterable[Pose] | None = None
    ) -> None:
        """``poses``: if given, the only ones to go to."""
        self.bands = bands
        self.closed = closed
        self.last = bands[0].last
        self.grid = bands[0].grid
        self._poses = None if poses is None else frozenset(poses)
        self._nodes: list[_Node] = []
        widths = [band.width for band in bands]
        self._seen = np.zeros((2, self.last + 1, *widths), dtype=bool)
        self._moves: dict[tuple[int, int, int], np.ndarray] = {}

    def vertices(self, most: int) -> list[Vertex] | None:
        """Corners of a path with at most so many moves; none where there is no such path.

        The first lies at frame 0. A closed path lacks its last move, back to the first corner.
        """
        layer = self._roots()
        for moves in range(most + 1):
            for number in layer:
                if self._is_end(self._nodes[number], moves % 2):
                    return self._trace(number)
            if moves < most:
                layer = [n for parent in layer for n in self._expand(parent, (moves + 1) % 2)]
        return None

    def _roots(self) -> list[int]:
        ranges = [band.goals(0) for band in self.bands]
        rows = np.stack(np.meshgrid(*ranges, indexing="ij"), -1).reshape(-1, len(ranges))
        roots = [tuple(row) for row in rows.tolist()]
        return [self._add(0, goals, -1, goals) for goals in roots if self._is_allowed(goals, 0)]

    def _add(self, frame: int, goals: tuple[int, ...], parent: int, root: tuple[int, ...]) -> int:
        self._nodes.append(_Node(frame, goals, parent, root))
        return len(self._nodes) - 1

    def _is_allowed(self, goals: tuple[int, ...], phase: int) -> bool:
        return self._poses is None or (self._counts(goals), phase) in self._poses

    def _counts(self, goals: tuple[int, ...]) -> tuple[int, ...]:
        return tuple(self.grid * goal for goal in goals)

    def _expand(self, parent: int, phase: int) -> list[int]:
        """New places that one move leads to from a node."""
        node = self._nodes[parent]
        if node.frame == self.last:
            return []
        options = self._options(node)
        ahead = slice(node.frame + 1, node.frame + 1 + len(options))
        new = options & ~self._seen[phase, ahead]
        self._seen[phase, ahead] |= new
        rows = np.argwhere(new)
        frames = node.frame + 1 + rows[:, 0]
        goals = rows[:, 1:] + np.stack([band.base[frames] for band in self.bands], -1)
        return [
            self._add(frame, tuple(row), parent, node.root)
            for frame, row in zip(frames.tolist(), goals.tolist(), strict=True)
            if self._is_allowed(tuple(row), phase)
        ]

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
        at_root = node.goals == node.root
        if phase == 0 and at_root:
            # Nothing is to go anywhere in the first entry: it lasts one frame.
            return node.frame == self.last - 1
        if node.frame != self.last - FIRST_FRAMES:
            return False
        ends = zip(self.bands, node.goals, node.root, strict=True)
        return all(band.is_open(self.last - FIRST_FRAMES, a, b) for band, a, b in ends)

    def _trace(self, number: int) -> list[Vertex]:
        path: list[Vertex] = []
        while number >= 0:
            node = self._nodes[number]
            path.append(Vertex(node.frame, self._counts(node.goals)))
            number = node.parent
        return path[::-1]
