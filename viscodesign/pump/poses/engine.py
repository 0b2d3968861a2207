"""The pose engine of PyPose: how long its moves last, where its servos are in each frame, and
what it is sent.

Positions are whole eighths of a count. A move over the distance D that is asked to take F
frames goes D // F + 1 eighths a frame, so it is over after D // (D // F + 1) + 1 frames, or
after one where D is 0; it lasts as long as its slowest servo, and the others wait at their own
goals. Slow moves therefore end early, and a wait lasts one frame, unless a servo that is not
there (the phantom) has a long way to go in each move.

Source: vanadiumlabs/arbotix, libraries/Bioloid/BioloidController.cpp, interpolateSetup and
interpolateStep, whose integers have 16 bits on the ATmega644P; no move that is sent overflows
them. Packets, to the board's own id: vanadiumlabs/arbotix, pypose/pypose.ino.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntEnum

import numpy as np

from viscodesign.errors import PumpError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.protocol.packets import Packet
from viscodesign.pump.ax.protocol.transactions import ARBOTIX

FRAME_MS = 33
FRAME = FRAME_MS / 1000
"""Between two set-points of a servo [s]."""
EIGHTHS = 8
"""Parts of a count that the engine reckons in; a servo is sent whole counts, rounded down."""
LONGEST_MS = 2**15 - 1
"""Longest time of a move [ms]; it is a signed number of 16 bits."""
MAX_FRAMES = LONGEST_MS // FRAME_MS + 1
PHANTOM = 1000
"""Counts that the phantom goes to and from."""
MAX_POSES = 30
MAX_MOVES = 46
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
    if not 1 <= frames <= MAX_FRAMES:
        raise PumpError(f"a move of {frames} frames; the firmware takes 1 to {MAX_FRAMES}")
    return min(FRAME_MS * frames - 1, LONGEST_MS)


def frames_taken(distance: int, frames: int) -> int:
    """Frames that one servo takes over a distance [1/8 count] when asked for ``frames``."""
    if distance == 0:
        return 1
    return distance // (distance // frames + 1) + 1


EXACT_FRAMES = tuple(
    frames
    for frames in range(1, MAX_FRAMES + 1)
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


class PoseInstruction(IntEnum):
    """What the firmware obeys; 25, which swings servo 1 and switches all pins, is left out."""

    SIZE_POSE = 7
    LOAD_POSE = 8
    LOAD_SEQUENCE = 9
    PLAY = 10
    LOOP = 11


PLAY = Packet(ARBOTIX, PoseInstruction.PLAY)
"""Go through the moves once."""
LOOP = Packet(ARBOTIX, PoseInstruction.LOOP)
"""Go through the moves until it is halted."""
END = Move(255, 0)
"""Stands behind the last move."""


def size_pose(servos: int) -> Packet:
    """Take poses of so many servos, ids from 1 on, and read where they are."""
    return Packet(ARBOTIX, PoseInstruction.SIZE_POSE, bytes([servos]))


def load_pose(index: int, counts: Sequence[int]) -> Packet:
    """Keep a pose; behind the last one lies other memory."""
    if not 0 <= index < MAX_POSES:
        raise PumpError(f"pose {index}; the board keeps poses 0 to {MAX_POSES - 1}")
    words = b"".join(count.to_bytes(2, "little") for count in counts)
    return Packet(ARBOTIX, PoseInstruction.LOAD_POSE, bytes([index]) + words)


def load_sequence(moves: Sequence[Move]) -> Packet:
    """Keep the moves; more than its buffer takes would hang the board."""
    if not 1 <= len(moves) <= MAX_MOVES:
        raise PumpError(f"{len(moves)} moves; the board takes 1 to {MAX_MOVES}")
    for move in moves:
        if not 0 <= move.ms <= LONGEST_MS:
            raise PumpError(f"a move of {move.ms} ms; the board takes 0 to {LONGEST_MS}")
    entries = [bytes([move.pose]) + move.ms.to_bytes(2, "little") for move in (*moves, END)]
    return Packet(ARBOTIX, PoseInstruction.LOAD_SEQUENCE, b"".join(entries))


def loading(sequence: PoseSequence) -> list[Packet]:
    """All that brings a sequence onto the board, in order."""
    return [
        size_pose(len(sequence.poses[0])),
        *(load_pose(index, counts) for index, counts in enumerate(sequence.poses)),
        load_sequence(sequence.moves),
    ]
