"""The pose engine of PyPose: how long its moves last, and where its servos are in each frame.

Positions are whole eighths of a count. A move over the distance D that is asked to take F
frames goes D // F + 1 eighths a frame, so it is over after D // (D // F + 1) + 1 frames, or
after one where D is 0; it lasts as long as its slowest servo, and the others wait at their own
goals. Slow moves therefore end early, and a wait lasts one frame, unless a servo that is not
there (the phantom) has a long way to go in each move.

Source: vanadiumlabs/arbotix, libraries/Bioloid/BioloidController.cpp, interpolateSetup and
interpolateStep, whose 16 bit arithmetic on the ATmega644P is followed here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from viscodesign.errors import PumpError

FRAME_MS = 33
FRAME = FRAME_MS / 1000
"""Between two set-points of a servo [s]."""
EIGHTHS = 8
"""Parts of a count that the engine reckons in; a servo is sent whole counts, rounded down."""
LONGEST_MS = 2**15 - 1
"""Of a move; the time is a signed number of 16 bits."""
MOST_FRAMES = LONGEST_MS // FRAME_MS + 1
UNREAD = -1
"""Count that the engine holds for a servo which did not answer."""
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
    """Frames F that a time stands for, as the firmware's 16 bits have it."""
    signed = (ms + 2**15) % 2**16 - 2**15
    toward_zero = abs(signed) // FRAME_MS * (1 if signed >= 0 else -1)
    return (toward_zero + 1) % 2**16


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
    """Positions (frames, servos) [1/8 count] at the end of each frame, frame by frame.

    ``start``: counts that the servos were read at, or `UNREAD`. Raises `PumpError` where the
    firmware would never end.
    """
    here = _position(start)
    rows: list[np.ndarray] = []
    for number, (move, goal) in enumerate(zip(sequence.moves, sequence.goals(), strict=True), 1):
        target = _position(goal)
        rows += _frames(here, target, frames_asked(move.ms))
        here = rows[-1]
        if (here != target).any():
            raise PumpError(f"move {number} of the sequence would never end on the board")
    return np.stack(rows).astype(int)


def _position(counts: Sequence[int]) -> np.ndarray:
    return (EIGHTHS * np.array(counts)).astype(np.uint16)


def _frames(here: np.ndarray, goal: np.ndarray, frames: int) -> Iterator[np.ndarray]:
    """Positions at the end of each frame of one move; ends early where it would not end."""
    distance = np.where(goal > here, goal - here, here - goal)
    # Dividing by zero gives all ones there.
    quotient = distance // np.uint16(frames) if frames else np.full_like(here, 2**16 - 1)
    step = (quotient + np.uint16(1)).astype(np.int16)
    seen: set[bytes] = set()
    arrived = False
    while not arrived and here.tobytes() not in seen:
        seen.add(here.tobytes())
        ahead = (goal - here).astype(np.int16)
        near = (ahead == 0) | (np.abs(ahead) < step)
        here = np.where(near, goal, here + (np.sign(ahead) * step).astype(np.uint16))
        arrived = bool(near.all())
        yield here
