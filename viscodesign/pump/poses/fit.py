"""The closest fit of poses and moves to a profile that the ArbotiX's limits allow.

The tolerance band around the profile is narrowed until no path with that many moves fits
through it; the stated error is measured afterwards, by playing the poses by the engine's law.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Sequence

import numpy as np

from viscodesign.errors import PumpError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.protocol.registers import FULL
from viscodesign.pump.poses.engine import (
    EIGHTHS,
    FRAME,
    MAX_MOVES,
    MAX_POSES,
    PHANTOM,
    Move,
    PoseSequence,
    frames_asked,
    play,
    time_asking,
)
from viscodesign.pump.poses.search import FIRST_FRAMES, MoveSearch, ToleranceBand
from viscodesign.pump.profile import Profile


@dataclass(frozen=True)
class FitNumbers:
    """Margins that are tried around a profile."""

    finest: float = 0.5
    """The narrowest margin [counts]; within less, whole counts cannot follow a slope."""
    ratio: float = 1.04
    """Between successive margins."""
    margins: int = 197
    """How many there are; the last is wider than all counts."""
    max_frames: int = 10_000
    """Longest profile [frames]: searching one of a minute takes about as long."""


FIT = FitNumbers()


@dataclass(frozen=True)
class PoseFit:
    """What the board plays, and how closely it follows the profile."""

    sequence: PoseSequence
    looped: bool
    frames: int
    """From the start of the profile to its end, or of one round."""
    requested_duration: float
    """[s]"""
    time: np.ndarray
    """(T,) times at which either has a corner [s]."""
    requested: np.ndarray
    """(T, P) counts; of a loop, at the pace that fills whole frames."""
    played: np.ndarray
    """(T, P) counts sent to the servos, linear between frames."""

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
        """(T, P) played minus requested [counts]."""
        error: np.ndarray = self.played - self.requested
        return error

    @property
    def largest_error(self) -> float:
        """[counts]"""
        return float(np.max(np.abs(self.error)))


def fit_poses(
    profile: Profile,
    *,
    loop: bool = False,
    travel: tuple[int, int] = (0, FULL),
    progress: Callable[[float], None] = lambda part: None,
) -> PoseFit:
    """The closest that 30 poses and 46 moves come to a profile; all within travel [counts].

    ``progress`` is given the part that is done, roughly.
    """
    exact = profile.duration / FRAME
    if exact > FIT.max_frames:
        raise PumpError(
            f"the profile lasts {profile.duration:.6g} s; poses are fitted to at most "
            f"{FIT.max_frames * FRAME:.0f} s. Loop one cycle of it, or use `pump stream`"
        )
    frames = max(round(exact) if loop else int(np.ceil(exact - 1e-9)), 2 * FIRST_FRAMES)
    pace = profile.duration / (frames * FRAME) if loop else 1.0
    bounds = [_bounds(profile.time, c, FRAME * pace, frames) for c in profile.steps.T]
    found: dict[int, PoseSequence] = {}

    def has_sequence(number: int) -> bool:
        margin = FIT.finest * FIT.ratio**number
        bands = [ToleranceBand.around(*b, margin, travel, closed=loop) for b in bounds]
        if path := MoveSearch(bands, closed=loop).path(MAX_MOVES - 1):
            found[number] = _sequence(*path)
        tried.append(number)
        progress(min(len(tried) / FIT.margins.bit_length(), 1.0))
        return path is not None and len(found[number].poses) <= MAX_POSES

    tried: list[int] = []
    narrowest = bisect_left(range(FIT.margins), True, key=has_sequence)
    if narrowest == FIT.margins:
        raise PumpError("no poses keep within the servo's travel; check home and travel")
    return _measured(profile, found[narrowest], loop)


def _bounds(
    time: np.ndarray, counts: np.ndarray, frame: float, frames: int
) -> tuple[np.ndarray, np.ndarray]:
    """Lowest and highest (N + 1,) that a goal in a frame has to be near to [counts].

    Between frames the profile leaves its chord by its bumps; what is within a margin of
    these bounds in both frames is within it of the profile all the path.
    """
    instants = np.arange(frames + 1) * frame
    chord = np.interp(instants, time, counts)
    place = np.searchsorted(instants, time, side="right") - 1
    inside = (place >= 0) & (place < frames)
    bumps = (counts - np.interp(time, instants, chord))[inside]
    up, down = np.zeros(frames + 1), np.zeros(frames + 1)
    for end in (0, 1):
        np.maximum.at(up, place[inside] + end, bumps)
        np.minimum.at(down, place[inside] + end, bumps)
    return chord + down, chord + up


def _sequence(frames: Sequence[int], goals: Sequence[Sequence[int]]) -> PoseSequence:
    """Poses and moves along corners; the phantom goes up and down in turn.

    The first entry brings it to its zero.
    """
    at_corners = [(*goal, PHANTOM * (k % 2)) for k, goal in enumerate(goals)]
    poses = list(dict.fromkeys(at_corners))
    lengths = [FIRST_FRAMES, *np.diff(frames).tolist()]
    pairs = zip(at_corners, lengths, strict=True)
    moves = tuple(Move(poses.index(pose), time_asking(length)) for pose, length in pairs)
    return PoseSequence(tuple(poses), moves)


def _measured(profile: Profile, sequence: PoseSequence, loop: bool) -> PoseFit:
    """A sequence, played from its first pose, against the profile it is for.

    The profile begins when the first entry is done. The entry that opens the next round of a
    loop is the last piece of this one.
    """
    # The servos are at the first pose already: the first entry lasts one frame.
    moves = sequence.moves + (sequence.moves[:1] if loop else ())
    program = PoseSequence(sequence.poses, moves)
    counts = play(program, sequence.poses[0])[:, :-1] // EIGHTHS
    frames = len(counts) - 1
    instants = np.arange(frames + 1) * FRAME
    pace = profile.duration / (frames * FRAME) if loop else 1.0
    corners = profile.time / pace
    time = np.union1d(instants, corners[corners <= instants[-1]])
    return PoseFit(
        sequence=sequence,
        looped=loop,
        frames=frames,
        requested_duration=profile.duration,
        time=time,
        requested=np.stack([np.interp(time * pace, profile.time, c) for c in profile.steps.T], -1),
        played=np.stack([np.interp(time, instants, c) for c in counts.T], -1),
    )
