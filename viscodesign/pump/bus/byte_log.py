"""Every byte and event of a session, as JSON lines."""

from __future__ import annotations

import json
import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from viscodesign.errors import UsageError
from viscodesign.pump.bus.line import Line


class ByteLog:
    """One JSON object a line, each whole in the file before the next thing is done.

    A log that cannot be written must not keep a pump from being stopped: that is told once,
    and the work goes on.
    """

    def __init__(self, path: Path | None, tell: Callable[[str], None]) -> None:
        self._path = path
        self._tell = tell
        self._torn = False
        """Whether the last line is not whole."""
        self._told = False
        self._file: int | None = None
        if path is not None:
            try:
                self._file = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o644)
            except OSError as error:
                raise UsageError(
                    f"{path}: {error.strerror}; the log cannot be written there"
                ) from None

    def tx(self, data: bytes) -> None:
        self.event("tx", hex=data.hex(" "))

    def rx(self, data: bytes) -> None:
        if data:
            self.event("rx", hex=data.hex(" "))

    def event(self, kind: str, **fields: Any) -> None:
        """Anything else: a set-point, a reading, a note. Units go into the fields' names."""
        if self._file is None:
            return
        entry = {"wall_s": time.time(), "monotonic_s": time.monotonic(), "kind": kind, **fields}
        line = json.dumps(entry, default=str) + "\n"
        self._write(self._file, ("\n" * self._torn + line).encode())

    def _write(self, file: int, line: bytes) -> None:
        try:
            whole = os.write(file, line) == len(line)
            reason: str | None = "the disk is full"
        except OSError as error:
            whole, reason = False, error.strerror
        self._torn = not whole
        if not whole and not self._told:
            self._told = True
            self._tell(f"{self._path}: {reason}; the byte log is incomplete from here on")

    def close(self) -> None:
        if self._file is not None:
            os.close(self._file)
            self._file = None


class LoggedLine(Line):
    """A line whose bytes are logged, after they went out or came in."""

    def __init__(self, line: Line, log: ByteLog) -> None:
        self.line = line
        self.log = log
        self.clock = line.clock

    def write(self, data: bytes) -> None:
        try:
            self.line.write(data)
        except BaseException as error:
            self.log.event("tx failed", hex=data.hex(" "), error=str(error))
            raise
        self.log.tx(data)

    def read(self, most: int, deadline: float) -> bytes:
        data = self.line.read(most, deadline)
        self.log.rx(data)
        return data

    def drain(self) -> bytes:
        data = self.line.drain()
        self.log.rx(data)
        return data

    def close(self) -> None:
        self.line.close()
        self.log.event("closed")
