"""A profile as poses and moves of the ArbotiX: the closest that its limits allow.

The tube around the profile is narrowed until no way through it is left with the moves there are;
what is stated as error is measured afterwards, by playing the poses through the engine's law.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from viscodesign.errors import PumpError
from viscodesign.pump.poses.engine import (
    EIGHTHS,
    FRAME,
    MOST_MOVES,
    MOST_POSES,
    PHANTOM,
    UNREAD,
    Move,
    PoseSequence,
    frames_asked,
    play,
    time_asking,
)
from viscodesign.pump.poses.pose_choice import poses_of, shared_poses
from viscodesign.pump.poses.search import FIRST_FRAMES, Pose, Search, Vertex
from viscodesign.pump.poses.tolerance_band import HIGHEST_COUNT, Tube
from viscodesign.pump.profile import Profile

FINEST = 0.5
"""Margin [counts] below which whole counts cannot follow any slope."""
RATIO = 1.04
"""Between the margins that are tried."""
MOST_FRAMES_FITTED = 10_000
"""Of a profile [frames]: the search of one of a minute takes about as long."""
USUAL_SEARCHES = 18
"""Of one fit."""
_WIDEST = 196
"""Number of a margin that is wider than all counts."""


@dataclass(frozen=True)
class PoseFit:
    """What the board is to play, and how far that is from what was wanted."""

    sequence: PoseSequence
    looped: bool
    frames: int
    """From the start of the profile to its end, or of one round."""
    wanted_duration: float
    """[s]"""
    time: np.ndarray
    """(T,) instants at which either of both has a corner [s]."""
    wanted: np.ndarray
    """(T, P) counts; of a loop, at the pace that fills whole frames."""
    played: np.ndarray
    """(T, P) counts that the servos are sent, straight between frames."""

    @property
    def duration(self) -> float:
        """From the start of the profile to its end, or of one round [s]."""
        return self.frames * FRAME

    @property
    def move_frames(self) -> list[int]:
        """Frames that each move lasts; the first, once or every round, one or two."""
        return [frames_asked(move.ms) for move in self.sequence.moves]

    @property
    def fastest(self) -> float:
        """Speed of the fastest servo [counts/s]."""
        steps = np.abs(np.diff(self.played, axis=0)) / np.diff(self.time)[:, None]
        return float(np.max(steps, initial=0.0))

    @property
    def error(self) -> np.ndarray:
        """(T, P) played less wanted [counts]."""
        error: np.ndarray = self.played - self.wanted
        return error

    @property
    def largest_error(self) -> float:
        """[counts]"""
        return float(np.max(np.abs(self.error)))


def fit_poses(
    profile: Profile,
    *,
    loop: bool = False,
    travel: tuple[int, int] = (0, HIGHEST_COUNT),
    progress: Callable[[float], None] = lambda part: None,
) -> PoseFit:
    """The closest that 30 poses and 46 moves come to a profile; all within travel [counts].

    ``progress`` is told the part that is done, roughly.
    """
    return _Fitting(profile, loop, travel, progress).best()


@dataclass(frozen=True)
class _Way:
    """Corners found, and the number of the margin they keep."""

    number: int
    vertices: list[Vertex]


_Finder = Callable[[int], list[Vertex] | None]
"""Corners within the margin of a number, if there is a way."""


class _Fitting:
    def __init__(
        self,
        profile: Profile,
        loop: bool,
        travel: tuple[int, int],
        progress: Callable[[float], None],
    ) -> None:
        self.profile, self.loop, self.travel = profile, loop, travel
        self.progress = progress
        self._searches = 0
        exact = profile.duration / FRAME
        if exact > MOST_FRAMES_FITTED:
            raise PumpError(
                f"the profile lasts {profile.duration:.6g} s; poses are fitted to at most "
                f"{MOST_FRAMES_FITTED * FRAME:.0f} s. Loop one cycle of it, or use `pump stream`"
            )
        self.frames = max(round(exact) if loop else int(np.ceil(exact - 1e-9)), 2 * FIRST_FRAMES)
        self.pace = profile.duration / (self.frames * FRAME) if loop else 1.0
        self._ways: dict[int, list[Vertex] | None] = {}
        self._bounds = [self._bounds_of(column) for column in profile.counts.T]

    def best(self) -> PoseFit:
        own = self._narrowest(self._with_own_poses, -1, _WIDEST)
        least = self._narrowest(self._shortest, -1, own.number, own)
        shared = self._narrowest(self._with_shared_poses, least.number - 1, own.number, own)
        fits = [self._played(way) for way in (own, shared)]
        return min(fits, key=lambda fit: fit.largest_error)

    def _narrowest(self, find: _Finder, below: int, number: int, known: _Way | None = None) -> _Way:
        """The narrowest margin with a way; ``below`` has none, ``number`` has the one known."""
        while number - below > 1 or known is None:
            middle = (below + number) // 2 if known else number
            vertices = find(middle)
            if vertices is not None:
                number, known = middle, _Way(middle, vertices)
            elif known is None:
                raise PumpError("no poses keep within the servo's travel; check home and travel")
            else:
                below = middle
        return known

    def _shortest(self, number: int) -> list[Vertex] | None:
        """The way with the fewest moves, however many poses it needs."""
        if number not in self._ways:
            self._ways[number] = self._search(number).vertices(MOST_MOVES - 1)
        return self._ways[number]

    def _with_own_poses(self, number: int) -> list[Vertex] | None:
        """The shortest way, if it happens to need few enough poses."""
        vertices = self._shortest(number)
        return vertices if vertices and len(poses_of(vertices)) <= MOST_POSES else None

    def _with_shared_poses(self, number: int) -> list[Vertex] | None:
        """A way that is content with few enough poses."""
        vertices = self._shortest(number)
        if vertices is None or len(poses_of(vertices)) <= MOST_POSES:
            return vertices
        poses = shared_poses(vertices, self._tubes(number)[0].grid)
        return self._search(number, poses).vertices(MOST_MOVES - 1)

    def _search(self, number: int, poses: set[Pose] | None = None) -> Search:
        self._searches += 1
        self.progress(min(self._searches / USUAL_SEARCHES, 1.0))
        return Search(self._tubes(number), closed=self.loop, poses=poses)

    def _tubes(self, number: int) -> list[Tube]:
        margin = FINEST * RATIO**number
        return [Tube.around(*b, margin, self.travel, closed=self.loop) for b in self._bounds]

    def _bounds_of(self, counts: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Lowest and highest (N + 1,) that a goal in a frame has to be near to [counts].

        Between frames the profile leaves its chord by its bumps; what is within a margin of
        these bounds in both frames is within it of the profile all the way.
        """
        instants = np.arange(self.frames + 1) * FRAME * self.pace
        wanted = np.interp(instants, self.profile.time, counts)
        place = np.searchsorted(instants, self.profile.time, side="right") - 1
        inside = (place >= 0) & (place < self.frames)
        bumps = (counts - np.interp(self.profile.time, instants, wanted))[inside]
        up, down = np.zeros(self.frames + 2), np.zeros(self.frames + 2)
        for end in (1, 2):
            np.maximum.at(up, place[inside] + end, bumps)
            np.minimum.at(down, place[inside] + end, bumps)
        return wanted + down[1:], wanted + up[1:]

    def _played(self, way: _Way) -> PoseFit:
        sequence = sequence_of(way.vertices)
        start = (*way.vertices[0].goals, UNREAD)
        return measured(self.profile, sequence, start, loop=self.loop)


def sequence_of(vertices: Sequence[Vertex]) -> PoseSequence:
    """Poses and moves along corners; the first entry brings the phantom to its zero."""
    poses = poses_of(vertices)
    number = {pose: index for index, pose in enumerate(poses)}
    frames = [FIRST_FRAMES, *np.diff([vertex.frame for vertex in vertices]).tolist()]
    return PoseSequence(
        tuple((*goals, PHANTOM * phase) for goals, phase in poses),
        tuple(
            Move(number[vertex.goals, place % 2], time_asking(length))
            for place, (vertex, length) in enumerate(zip(vertices, frames, strict=True))
        ),
    )


def measured(
    profile: Profile, sequence: PoseSequence, start: Sequence[int], *, loop: bool
) -> PoseFit:
    """A sequence, played from a start [counts], against the profile it is for.

    The profile begins when the first entry is done; of a loop, the second round is measured.
    """
    first = PoseSequence(sequence.poses, sequence.moves[:1])
    begun = len(play(first, start))
    once = play(sequence, start)
    if loop:
        twice = play(PoseSequence(sequence.poses, sequence.moves * 2), start)
        # The entry that opens a round is the last piece of the one before.
        again = play(first, (once[-1] // EIGHTHS).tolist())
        rows = twice[begun - 1 : len(once) + len(again)]
    else:
        rows = once[begun - 1 :]
    counts = rows[:, :-1] // EIGHTHS
    return _compared(profile, sequence, counts, loop)


def _compared(profile: Profile, sequence: PoseSequence, counts: np.ndarray, loop: bool) -> PoseFit:
    frames = len(counts) - 1
    instants = np.arange(frames + 1) * FRAME
    pace = profile.duration / (frames * FRAME) if loop else 1.0
    corners = profile.time / pace
    time = np.union1d(instants, corners[corners <= instants[-1]])
    return PoseFit(
        sequence=sequence,
        looped=loop,
        frames=frames,
        wanted_duration=profile.duration,
        time=time,
        wanted=np.stack([profile.at(float(moment * pace)) for moment in time]),
        played=np.stack([np.interp(time, instants, column) for column in counts.T], -1),
    )
