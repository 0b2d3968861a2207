"""Text for somebody who watches, and who must never be waited for."""

from __future__ import annotations

import contextlib
import os
import select
from typing import TextIO


class Outlet:
    """Takes text, or drops it where its reader takes none now.

    A terminal that was stopped (Ctrl-S), or a link that sleeps, would otherwise stop a pump.
    """

    def __init__(self, stream: TextIO) -> None:
        self.terminal = stream.isatty()
        self._stream = stream
        self._own = _opened_anew(stream) if self.terminal else None

    def write(self, text: str) -> None:
        """All of it, some of it, or none; what is gone for good is no error either."""
        with contextlib.suppress(OSError):
            if self._own is not None:
                os.write(self._own, text.encode())
            elif self._ready():
                self._stream.write(text)
                self._stream.flush()

    def close(self) -> None:
        """Let go of what was opened here."""
        if self._own is not None:
            os.close(self._own)
            self._own = None

    def _ready(self) -> bool:
        """Whether a pipe has room for a line (POSIX: for 512 bytes); what is none always has."""
        try:
            return bool(select.select([], [self._stream], [], 0.0)[1])
        except (OSError, ValueError):
            return True


def _opened_anew(stream: TextIO) -> int | None:
    """The same terminal, without waiting; the one that others share stays as it is."""
    try:
        name = os.ttyname(stream.fileno())
        return os.open(name, os.O_WRONLY | os.O_NONBLOCK | os.O_NOCTTY)
    except (OSError, AttributeError):
        return None
