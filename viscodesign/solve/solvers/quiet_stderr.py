"""Suppress what a library writes to standard error below Python."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager


class _Sink:
    """Where standard error goes meanwhile: one for all threads, since a process has but one."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._users = 0
        self._kept: int | None = None

    def enter(self) -> None:
        """Turn standard error away, unless another thread has done so."""
        with self._lock:
            self._users += 1
            if self._users > 1:
                return
            if sys.stderr is not None:  # closed by whoever started the process
                sys.stderr.flush()
            try:
                self._kept = os.dup(2)
            except OSError:  # no standard error at all
                return
            sink = os.open(os.devnull, os.O_WRONLY)
            os.dup2(sink, 2)
            os.close(sink)

    def leave(self) -> None:
        """Restore it, unless another caller still needs it redirected."""
        with self._lock:
            self._users -= 1
            if self._users or self._kept is None:
                return
            os.dup2(self._kept, 2)
            os.close(self._kept)
            self._kept = None


_SINK = _Sink()


@contextmanager
def quiet_stderr() -> Iterator[None]:
    """Let nothing reach standard error inside the block, from any thread.

    SUNDIALS reports every failed step there, also those that succeed at the second try;
    what really failed is raised and reported in our own words.
    """
    _SINK.enter()
    try:
        yield
    finally:
        _SINK.leave()
