"""The pose engine of PyPose: how long its moves last, and where its servos are in each frame.

Positions are whole eighths of a count. A move over the distance D that is asked to take F
frames goes D // F + 1 eighths a frame, so it is over after D // (D // F + 1) + 1 frames, or
after one where D is 0; it lasts as long as its slowest servo, and the others wait at their own
goals. Slow moves therefore end early, and a wait lasts one frame, unless a servo that is not
there (the phantom) has a long way to go in each move.

Source: vanadiumlabs/arbotix, libraries/Bioloid/BioloidController.cpp, interpolateSetup and
interpolateStep. Its integers have 16 bits on the ATmega644P; no move that is sent overflows them.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from viscodesign.errors import PumpError
from viscodesign.lazy_dataclass import dataclass

FRAME_MS = 33
FRAME = FRAME_MS / 1000
"""Between two set-points of a servo [s]."""
EIGHTHS = 8
"""Parts of a count that the engine reckons in; a servo is sent whole counts, rounded down."""
LONGEST_MS = 2**15 - 1
"""Longest time of a move [ms]; it is a signed number of 16 bits."""
MOST_FRAMES = LONGEST_MS // FRAME_MS + 1
PHANTOM = 1000
"""Counts that the phantom goes to and from."""
MOST_POSES = 30
MOST_MOVES = 46
"""LOAD_SEQ takes 143 bytes: 47 entries of three, the last of which marks the end."""


@dataclass(frozen=True)
class Move:
    """One entry of a sequence."""

    pose: int
    """Index of the pose to go to."""
    ms: int
    """Time asked for [ms]."""


@dataclass(frozen=True)
class PoseSequence:
    """Poses and the moves between them, as the firmware takes them."""

    poses: tuple[tuple[int, ...], ...]
    """Counts of servo 1, 2, ... and, last, of the phantom."""
    moves: tuple[Move, ...]

    def goals(self) -> list[tuple[int, ...]]:
        """The pose of each move."""
        return [self.poses[move.pose] for move in self.moves]


def frames_asked(ms: int) -> int:
    """Frames F that a time stands for."""
    return ms // FRAME_MS + 1


def time_asking(frames: int) -> int:
    """Time [ms] that asks for a number of frames."""
    if not 1 <= frames <= MOST_FRAMES:
        raise PumpError(f"a move of {frames} frames; the firmware takes 1 to {MOST_FRAMES}")
    return min(FRAME_MS * frames - 1, LONGEST_MS)


def frames_taken(distance: int, frames: int) -> int:
    """Frames that one servo takes over a distance [1/8 count] when asked for ``frames``."""
    if distance == 0:
        return 1
    return distance // (distance // frames + 1) + 1


EXACT_FRAMES = tuple(
    frames
    for frames in range(1, MOST_FRAMES + 1)
    if frames_taken(EIGHTHS * PHANTOM, frames) == frames
)
"""Durations that the phantom holds exactly: all up to 92 frames (3 s), then ever fewer."""


def play(sequence: PoseSequence, start: Sequence[int]) -> np.ndarray:
    """Positions (frames, servos) [1/8 count] at the end of each frame, from a start [counts]."""
    here, rows = np.array(start), []
    for move, goal in zip(sequence.moves, sequence.goals(), strict=True):
        way = EIGHTHS * (np.array(goal) - here)
        distance = np.abs(way)
        step = distance // frames_asked(move.ms) + 1
        frames = int(np.max(np.where(distance > 0, distance // step + 1, 1)))
        gone = np.minimum(step * np.arange(1, frames + 1)[:, None], distance)
        rows.append(EIGHTHS * here + np.sign(way) * gone)
        here = np.array(goal)
    return np.concatenate(rows)
