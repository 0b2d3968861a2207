"""Ctrl-C and its like while a pump moves: heard at once, obeyed between two transactions."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType

SIGNALS = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if name in dir(signal)]
"""Ctrl-C, the end of the session, and a terminal that goes away."""


@dataclass
class Wish:
    """How often, and by which signal first, the pump was asked to stop."""

    times: int = 0
    first: str = ""

    @property
    def asked(self) -> bool:
        """To stand still."""
        return self.times > 0

    @property
    def urgent(self) -> bool:
        """To drop the torque: asked again while the pump was being stopped."""
        return self.times > 1

    def note(self, number: int, frame: FrameType | None) -> None:
        """Remember the wish and nothing else: a transaction must not be cut in two."""
        del frame
        self.times += 1
        self.first = self.first or signal.Signals(number).name


@contextmanager
def noted_signals() -> Iterator[Wish]:
    """Note signals instead of dying of them.

    Only the main thread may handle signals; in any other, nothing changes.
    """
    wish = Wish()
    if threading.current_thread() is not threading.main_thread():
        yield wish
        return
    before = {number: signal.signal(number, wish.note) for number in SIGNALS}
    try:
        yield wish
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
