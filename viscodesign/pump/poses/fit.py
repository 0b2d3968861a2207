"""A profile as poses and moves of the ArbotiX: the closest that its limits allow.

The tolerance band around the profile is narrowed until the moves there are find no path
through it; the stated error is measured afterwards, by playing the poses by the engine's law.
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
from viscodesign.pump.poses.search import FIRST_FRAMES, MoveSearch, Pose, Vertex
from viscodesign.pump.poses.tolerance_band import HIGHEST_COUNT, ToleranceBand
from viscodesign.pump.profile import Profile


@dataclass(frozen=True)
class FitNumbers:
    """How the margin around a profile is narrowed."""

    finest: float = 0.5
    """Margin below which whole counts cannot follow any slope [counts]."""
    ratio: float = 1.04
    """Between the margins that are tried."""
    widest: int = 196
    """Number of a margin that is wider than all counts."""
    most_frames: int = 10_000
    """Of a profile: searching one of a minute takes about as long."""
    usual_searches: int = 18
    """Of one fit."""


FIT = FitNumbers()


@dataclass(frozen=True)
class PoseFit:
    """What the board plays, and how far that is from the profile."""

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

    ``progress`` is given the part that is done, roughly.
    """
    return _PoseFitting(profile, loop, travel, progress).best()


@dataclass(frozen=True)
class _BandPath:
    """Corners found, and the number of the margin they keep."""

    number: int
    vertices: list[Vertex]


_Finder = Callable[[int], list[Vertex] | None]
"""Finds corners within the margin of a number, if there is a path."""


class _PoseFitting:
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
        if exact > FIT.most_frames:
            raise PumpError(
                f"the profile lasts {profile.duration:.6g} s; poses are fitted to at most "
                f"{FIT.most_frames * FRAME:.0f} s. Loop one cycle of it, or use `pump stream`"
            )
        self.frames = max(round(exact) if loop else int(np.ceil(exact - 1e-9)), 2 * FIRST_FRAMES)
        self.pace = profile.duration / (self.frames * FRAME) if loop else 1.0
        self._paths: dict[int, list[Vertex] | None] = {}
        self._bounds = [self._bounds_of(column) for column in profile.counts.T]

    def best(self) -> PoseFit:
        own = self._narrowest(self._with_own_poses, -1, FIT.widest)
        least = self._narrowest(self._shortest, -1, own.number, own)
        shared = self._narrowest(self._with_shared_poses, least.number - 1, own.number, own)
        fits = [self._played(path) for path in (own, shared)]
        return min(fits, key=lambda fit: fit.largest_error)

    def _narrowest(
        self, find: _Finder, below: int, number: int, known: _BandPath | None = None
    ) -> _BandPath:
        """The narrowest margin with a path; ``below`` has none, ``number`` has the one known."""
        while number - below > 1 or known is None:
            middle = (below + number) // 2 if known else number
            vertices = find(middle)
            if vertices is not None:
                number, known = middle, _BandPath(middle, vertices)
            elif known is None:
                raise PumpError("no poses keep within the servo's travel; check home and travel")
            else:
                below = middle
        return known

    def _shortest(self, number: int) -> list[Vertex] | None:
        """The path with the fewest moves, however many poses it needs."""
        if number not in self._paths:
            self._paths[number] = self._search(number).vertices(MOST_MOVES - 1)
        return self._paths[number]

    def _with_own_poses(self, number: int) -> list[Vertex] | None:
        """The shortest path, if it happens to need few enough poses."""
        vertices = self._shortest(number)
        return vertices if vertices and len(poses_of(vertices)) <= MOST_POSES else None

    def _with_shared_poses(self, number: int) -> list[Vertex] | None:
        """A path that is content with few enough poses."""
        vertices = self._shortest(number)
        if vertices is None or len(poses_of(vertices)) <= MOST_POSES:
            return vertices
        poses = shared_poses(vertices, self._bands(number)[0].grid)
        return self._search(number, poses).vertices(MOST_MOVES - 1)

    def _search(self, number: int, poses: set[Pose] | None = None) -> MoveSearch:
        self._searches += 1
        self.progress(min(self._searches / FIT.usual_searches, 1.0))
        return MoveSearch(self._bands(number), closed=self.loop, poses=poses)

    def _bands(self, number: int) -> list[ToleranceBand]:
        margin = FIT.finest * FIT.ratio**number
        return [
            ToleranceBand.around(*b, margin, self.travel, closed=self.loop) for b in self._bounds
        ]

    def _bounds_of(self, counts: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Lowest and highest (N + 1,) that a goal in a frame has to be near to [counts].

        Between frames the profile leaves its chord by its bumps; what is within a margin of
        these bounds in both frames is within it of the profile all the path.
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

    def _played(self, path: _BandPath) -> PoseFit:
        sequence = sequence_of(path.vertices)
        start = (*path.vertices[0].goals, UNREAD)
        return measure_fit(self.profile, sequence, start, loop=self.loop)


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


def measure_fit(
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
