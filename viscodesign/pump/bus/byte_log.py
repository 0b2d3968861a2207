"""Every byte and event of a session, as JSON lines."""

from __future__ import annotations

import json
import os
import time
from pathlib import Path
from typing import Any

from viscodesign.errors import UsageError
from viscodesign.pump.bus.line import Line
from viscodesign.pump.consent import Tell, ignore


class ByteLog:
    """One JSON object a line, each whole in the file before the next thing is done.

    A log that cannot be written must not keep a pump from being stopped: that is reported once,
    and the work goes on.
    """

    def __init__(self, path: Path | None, tell: Tell) -> None:
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

    def bytes(self, kind: str, data: bytes, **fields: Any) -> None:
        """Log bytes that went out or came in."""
        self.event(kind, hex=data.hex(" "), **fields)

    def close(self) -> None:
        if self._file is not None:
            os.close(self._file)
            self._file = None


class SentBytes(ByteLog):
    """Keeps in memory all that is sent, and nothing else."""

    def __init__(self) -> None:
        super().__init__(None, ignore)
        self.sent: list[bytes] = []

    def bytes(self, kind: str, data: bytes, **fields: Any) -> None:
        if kind == "tx":
            self.sent.append(data)


class LoggedLine(Line):
    """A line whose bytes are logged, after they went out or came in."""

    def __init__(self, line: Line, log: ByteLog) -> None:
        self.line = line
        self.clock = line.clock
        self.log = log

    def write(self, data: bytes) -> None:
        try:
            self.line.write(data)
        except BaseException as error:
            self.log.bytes("tx failed", data, error=str(error))
            raise
        self.log.bytes("tx", data)

    def read(self, most: int, deadline: float) -> bytes:
        return self._received(self.line.read(most, deadline))

    def drain(self) -> bytes:
        return self._received(self.line.drain())

    def _received(self, data: bytes) -> bytes:
        if data:
            self.log.bytes("rx", data)
        return data

    def close(self) -> None:
        self.line.close()
        self.log.event("closed")
