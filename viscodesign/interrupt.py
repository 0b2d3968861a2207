"""Ctrl-C during a solve: heard at once, obeyed between two stretches of the motion."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType


@dataclass
class Interrupt:
    """Whether the user asked to stop."""

    asked: bool = False

    def note(self, number: int, frame: FrameType | None) -> None:
        """Remember the wish; a second Ctrl-C ends the process on the spot."""
        del number, frame
        self.asked = True
        signal.signal(signal.SIGINT, signal.SIG_DFL)


_open: list[Interrupt] = []
"""Those of the main thread that listen, one inside of the other."""


@contextmanager
def gentle_interrupt() -> Iterator[Interrupt]:
    """Note Ctrl-C instead of raising it.

    An exception raised while the integrator calls back is taken there for a failed
    step, which is tried again: the wish would be lost. Only the main thread may
    handle signals; in any other, nothing changes. Whoever is around this hears of it, too.
    """
    interrupt = Interrupt()
    if threading.current_thread() is not threading.main_thread():
        yield interrupt
        return
    before = signal.signal(signal.SIGINT, interrupt.note)
    _open.append(interrupt)
    try:
        yield interrupt
    finally:
        _open.pop()
        if interrupt.asked and _open:
            _open[-1].asked = True
        signal.signal(signal.SIGINT, before)
