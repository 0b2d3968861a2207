"""Trying for a verified end of a motion."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from viscodesign.errors import PumpError
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.play.axis import FinalAxisState

RETRY_PAUSE_S = 0.02  # between tries [s]
HOLD_TIMEOUT_S = 1.0  # to try for a verified hold [s]


def until_verified(
    axes: Sequence[int], clock: Clock, noun: str, attempt: Callable[[int], str]
) -> list[FinalAxisState]:
    """Try each axis in turns until it is verified or the time is over; at least once.

    ``attempt`` says how an axis was left; it raises `PumpError` where that was not read back.
    """
    deadline = clock.now() + HOLD_TIMEOUT_S
    left: dict[int, FinalAxisState] = {}
    waiting = list(axes)
    while waiting:
        for axis in waiting:
            try:
                left[axis] = FinalAxisState(axis, True, attempt(axis), noun)
            except PumpError as error:
                left[axis] = FinalAxisState(axis, False, str(error), noun)
        waiting = [axis for axis in waiting if not left[axis].verified]
        if clock.now() >= deadline:
            break
        if waiting:
            clock.sleep(RETRY_PAUSE_S)
    return [left[axis] for axis in axes]
