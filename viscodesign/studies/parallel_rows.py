"""Chunks of rows computed in several processes, each of which may die without the others."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
import warnings
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from typing import Any, Generic, Self, TypeVar

from viscodesign.interrupt import STOP_SIGNALS, StopRequest
from viscodesign.lazy_dataclass import dataclass

Row = TypeVar("Row")
Result = TypeVar("Result")

CHUNK_S = 2.0
"""Time after which a process hands over what it has of a chunk [s]; the rest follows."""
ALONE_S = 0.2
"""The same without processes of their own: so long may Ctrl-C take, but for one row [s]."""
LOOK_S = 0.2
"""Time between two looks at whether the user has asked to stop [s]."""
START_METHOD = "fork" if sys.platform == "linux" else "spawn"
"""Forked processes have what was compiled before, and ask nothing of the user's script; elsewhere
than on Linux, libraries of the system do not survive it."""


@dataclass(frozen=True)
class Chunk(Generic[Row, Result]):
    """Rows, and what was computed of them."""

    rows: list[Row]
    results: list[Result]
    """Results of the first rows, in order: all of them unless the process died."""

    @property
    def lost(self) -> list[Row]:
        """Rows whose process died."""
        return self.rows[len(self.results) :]


Work = Callable[[list[Row], float], list[Result]]
"""Results of rows in order, the first at least, and as many as begin within a time [s]."""


def available_cores() -> int:
    """Cores that this process may use."""
    if sys.platform == "linux":
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def compute_alone(
    work: Work[Row, Result], chunks: Iterable[list[Row]], stop: StopRequest
) -> Iterator[Chunk[Row, Result]]:
    """Results of chunks in this process, until the user asks to stop."""
    for chunk in chunks:
        rows = chunk
        while rows:
            if stop.asked:
                return
            try:
                found = work(rows, ALONE_S)
            except KeyboardInterrupt:
                return
            yield Chunk(rows[: len(found)], found)
            rows = rows[len(found) :]


def compute_in_processes(
    work: Work[Row, Result], chunks: Iterable[list[Row]], workers: int, stop: StopRequest
) -> Iterator[Chunk[Row, Result]]:
    """Results of chunks in so many processes, as they come, until the user asks to stop.

    A process that dies costs its chunk, which comes back without results; another takes its
    place.
    """
    with RowProcesses(work, workers) as processes:
        yield from processes.compute(chunks, stop)


class RowProcesses(Generic[Row, Result]):
    """Processes that compute chunks, in one round or in several."""

    def __init__(self, work: Work[Row, Result], workers: int) -> None:
        self._work = work
        self._pools = [_pool(work) for _ in range(workers)]

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        for pool in self._pools:
            pool.shutdown(wait=True, cancel_futures=True)

    def compute(
        self, chunks: Iterable[list[Row]], stop: StopRequest
    ) -> Iterator[Chunk[Row, Result]]:
        """Results of chunks as they come, as `compute_in_processes` has them."""
        waiting, free = deque(chunks), list(range(len(self._pools)))
        running: dict[Future[list[Result]], tuple[int, list[Row]]] = {}
        while waiting or running:
            while waiting and free and not stop.asked:
                place, rows = free.pop(), waiting.popleft()
                running[_submit(self._pools[place], rows)] = place, rows
            if not running:
                return
            done, _ = wait(running, LOOK_S, FIRST_COMPLETED)
            for future in done:
                place, rows = running.pop(future)
                free.append(place)
                found = self._found(future, place)
                if found is not None and len(found) < len(rows):
                    waiting.appendleft(rows[len(found) :])
                    rows = rows[: len(found)]
                yield Chunk(rows, found or [])

    def _found(self, future: Future[list[Result]], place: int) -> list[Result] | None:
        """Results of a chunk; None where its process died, whose place another takes."""
        try:
            return future.result()
        except BrokenProcessPool:
            self._pools[place].shutdown(wait=False)
            self._pools[place] = _pool(self._work)
            return None


def _pool(work: Work[Row, Result]) -> ProcessPoolExecutor:
    """One process: should it die, the others go on."""
    context = multiprocessing.get_context(START_METHOD)
    return ProcessPoolExecutor(1, context, initializer=_begin, initargs=(work,))


def _submit(pool: ProcessPoolExecutor, rows: list[Row]) -> Future[list[Any]]:
    with warnings.catch_warnings():
        # The threads of other pools wait for results, and hold no lock that a process needs.
        warnings.filterwarnings("ignore", ".*multi-threaded.*fork", DeprecationWarning)
        return pool.submit(_compute, rows)


# -- in a process of its own ------------------------------------------------------


class _Process:
    """What a process computes with."""

    work: Work[Any, Any]


def _begin(work: Work[Any, Any]) -> None:
    """Leave Ctrl-C to the parent, which asks no more then, and end with it."""
    for number in STOP_SIGNALS:
        signal.signal(number, signal.SIG_IGN if number == signal.SIGINT else signal.SIG_DFL)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    _Process.work = work


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _compute(rows: list[Any]) -> list[Any]:
    return _Process.work(rows, CHUNK_S)
