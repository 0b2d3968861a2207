"""The pose engine of PyPose in the integers of its processor, to check the law in closed form.

Source: vanadiumlabs/arbotix, libraries/Bioloid/BioloidController.cpp, interpolateSetup and
interpolateStep, whose 16 bit arithmetic on the ATmega644P is followed here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from viscodesign.errors import PumpError
from viscodesign.pump.poses.engine import EIGHTHS, FRAME_MS, PoseSequence, frames_taken

UNREAD = -1
"""Count that the engine holds for a servo which did not answer."""


def frames_in_16_bits(ms: int) -> int:
    """Frames F that a time stands for, as the firmware's 16 bits have it."""
    signed = (ms + 2**15) % 2**16 - 2**15
    toward_zero = abs(signed) // FRAME_MS * (1 if signed >= 0 else -1)
    return (toward_zero + 1) % 2**16


def frames_of_moves(sequence: PoseSequence, start: Sequence[int]) -> list[int]:
    """Frames that each move lasts, in closed form; the start [counts] has to be read."""
    taken, here = [], tuple(start)
    for move, goal in zip(sequence.moves, sequence.goals(), strict=True):
        frames = frames_in_16_bits(move.ms)
        taken.append(
            max(frames_taken(EIGHTHS * abs(b - a), frames) for a, b in zip(here, goal, strict=True))
        )
        here = goal
    return taken


def play_in_16_bits(sequence: PoseSequence, start: Sequence[int]) -> np.ndarray:
    """Positions (frames, servos) [1/8 count] at the end of each frame, frame by frame.

    ``start``: counts that the servos were read at, or `UNREAD`. Raises `PumpError` where the
    firmware would never end.
    """
    here = [EIGHTHS * count % 2**16 for count in start]
    rows: list[list[int]] = []
    for number, (move, goal) in enumerate(zip(sequence.moves, sequence.goals(), strict=True), 1):
        asked = [EIGHTHS * count % 2**16 for count in goal]
        rows += _frames(here, asked, frames_in_16_bits(move.ms))
        here = rows[-1]
        if here != asked:
            raise PumpError(f"move {number} of the sequence would never end on the board")
    return np.array(rows, dtype=int).reshape(-1, len(here))


def _frames(here: list[int], goal: list[int], frames: int) -> Iterator[list[int]]:
    """Positions at the end of each frame of one move; ends early where it would not end."""
    steps = [_step(a, b, frames) for a, b in zip(here, goal, strict=True)]
    seen: set[tuple[int, ...]] = set()
    arrived = False
    while not arrived and tuple(here) not in seen:
        seen.add(tuple(here))
        moved = [_advance(a, b, s) for a, b, s in zip(here, goal, steps, strict=True)]
        here = [place for place, _ in moved]
        arrived = all(done for _, done in moved)
        yield here


def _step(here: int, goal: int, frames: int) -> int:
    """Eighths a frame, an int of 16 bits; their division by zero gives all ones."""
    quotient = abs(goal - here) // frames if frames else 2**16 - 1
    return _signed(quotient + 1)


def _advance(here: int, goal: int, step: int) -> tuple[int, bool]:
    """One frame of one servo: where it is then, and whether it counts as arrived."""
    difference = _signed(goal - here)
    ahead = difference > 0
    if difference == 0 or _signed(difference if ahead else -difference) < step:
        return goal, True
    return (here + (step if ahead else -step)) % 2**16, False


def _signed(value: int) -> int:
    return (value + 2**15) % 2**16 - 2**15
