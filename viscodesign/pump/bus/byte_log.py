"""Every byte and event of a session, as JSON lines."""

from __future__ import annotations

import json
import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from viscodesign.errors import UsageError
from viscodesign.pump.bus.line import ForwardingLine, Line


class ByteLog:
    """One JSON object a line, each whole in the file before the next thing is done.

    A log that cannot be written must not keep a pump from being stopped: that is reported once,
    and the work goes on.
    """

    def __init__(self, path: Path | None, tell: Callable[[str], None]) -> None:
        self._path = path
        self._tell = tell
        self._torn = self._reported = False
        """Whether the last line is not whole, and whether that was reported."""
        self._file: int | None = None
        if path is not None:
            try:
                self._file = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o644)
            except OSError as error:
                raise UsageError(
                    f"{path}: {error.strerror}; the log cannot be written there"
                ) from None

    def event(self, kind: str, **fields: Any) -> None:
        """Log anything, bytes among it; units go into the fields' names."""
        if self._file is None:
            return
        entry = {"wall_s": time.time(), "monotonic_s": time.monotonic(), "kind": kind, **fields}
        line = ("\n" * self._torn + json.dumps(entry, default=str) + "\n").encode()
        try:
            self._torn = os.write(self._file, line) != len(line)
            reason: str | None = "the disk is full"
        except OSError as error:
            self._torn, reason = True, error.strerror
        if self._torn and not self._reported:
            self._reported = True
            self._tell(f"{self._path}: {reason}; the byte log is incomplete from here on")

    def close(self) -> None:
        if self._file is not None:
            os.close(self._file)
            self._file = None


class LoggedLine(ForwardingLine):
    """A line whose bytes are logged, after they went out or came in."""

    def __init__(self, line: Line, log: ByteLog) -> None:
        super().__init__(line)
        self.log = log

    def write(self, data: bytes) -> None:
        try:
            super().write(data)
        except BaseException as error:
            self.log.event("tx failed", hex=data.hex(" "), error=str(error))
            raise
        self.log.event("tx", hex=data.hex(" "))

    def read(self, most: int, deadline: float) -> bytes:
        return self._received(super().read(most, deadline))

    def drain(self) -> bytes:
        return self._received(super().drain())

    def _received(self, data: bytes) -> bytes:
        if data:
            self.log.event("rx", hex=data.hex(" "))
        return data

    def close(self) -> None:
        super().close()
        self.log.event("closed")
