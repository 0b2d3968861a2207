"""What PyPose understands beyond the servos' protocol; sent to the board's own id.

Source: vanadiumlabs/arbotix, pypose/pypose.ino.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntEnum

from viscodesign.errors import PumpError
from viscodesign.pump.ax.protocol.packets import Packet
from viscodesign.pump.ax.protocol.transactions import ARBOTIX
from viscodesign.pump.poses.engine import LONGEST_MS, MOST_MOVES, MOST_POSES, Move, PoseSequence

END = Move(255, 0)
"""Stands behind the last move."""


class PoseInstruction(IntEnum):
    """What the firmware obeys; 25, which swings servo 1 and switches all pins, is left out."""

    SIZE_POSE = 7
    LOAD_POSE = 8
    LOAD_SEQUENCE = 9
    PLAY = 10
    LOOP = 11


def size_pose(servos: int) -> Packet:
    """Take poses of so many servos, ids from 1 on, and read where they are."""
    return Packet(ARBOTIX, PoseInstruction.SIZE_POSE, bytes([servos]))


def load_pose(index: int, counts: Sequence[int]) -> Packet:
    """Keep a pose; behind the last one lies other memory."""
    if not 0 <= index < MOST_POSES:
        raise PumpError(f"pose {index}; the board keeps poses 0 to {MOST_POSES - 1}")
    words = b"".join(count.to_bytes(2, "little") for count in counts)
    return Packet(ARBOTIX, PoseInstruction.LOAD_POSE, bytes([index]) + words)


def load_sequence(moves: Sequence[Move]) -> Packet:
    """Keep the moves; more than its buffer takes would hang the board."""
    if not 1 <= len(moves) <= MOST_MOVES:
        raise PumpError(f"{len(moves)} moves; the board takes 1 to {MOST_MOVES}")
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


def play() -> Packet:
    """Go through the moves once."""
    return Packet(ARBOTIX, PoseInstruction.PLAY)


def loop() -> Packet:
    """Go through the moves until it is halted."""
    return Packet(ARBOTIX, PoseInstruction.LOOP)
