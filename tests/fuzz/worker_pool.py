"""A pool of worker processes, any of which may crash on its task."""

from __future__ import annotations

import multiprocessing
import resource
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from typing import Any

MEMORY = 6 << 30
"""Address space of a worker in bytes; exceeding it is a finding."""
DEADLINE = 1200.0
"""Wall seconds after which a worker is killed that its CPU limit did not end."""
TASKS_PER_WORKER = 500
"""Tasks after which a worker is replaced, so that leaks do not accumulate."""

Task = Callable[[Any, int], Any]
"""A function of seed and number at module level, since workers import it."""

Answer = tuple[int, Any, float]


@dataclass(frozen=True)
class WorkerDeath:
    """Result of a task whose worker crashed."""

    how: str


@dataclass
class _Worker:
    process: SpawnProcess
    pipe: Connection
    number: int = -1
    began: float = 0.0
    done: int = 0

    def give(self, number: int) -> None:
        self.number, self.began = number, time.monotonic()
        self.pipe.send(number)

    def end(self) -> None:
        self.process.kill()
        self.process.join()
        self.pipe.close()


def run_tasks(task: Task, seed: object, numbers: Iterable[int], jobs: int) -> Iterator[Answer]:
    """Number, answer (or `WorkerDeath`) and CPU seconds of every task, as they finish."""
    waiting = iter(numbers)
    workers = [w for _ in range(jobs) if (w := _started(task, seed, waiting)) is not None]
    try:
        while workers:
            wait([w.pipe for w in workers] + [w.process.sentinel for w in workers], timeout=5.0)
            for k, worker in enumerate(list(workers)):
                answer = _answer(worker)
                if answer is None:
                    continue
                found, seconds = answer if isinstance(answer, tuple) else (answer, DEADLINE)
                yield worker.number, found, seconds
                workers[k] = _next(worker, answer, task, seed, waiting)
            workers = [w for w in workers if w.number >= 0]
    finally:
        for worker in workers:
            worker.end()


def _answer(worker: _Worker) -> Any:
    """The answer of a worker with its seconds, or `WorkerDeath`; None while it works."""
    if worker.pipe.poll():
        try:
            return worker.pipe.recv()
        except EOFError:
            pass
    elif worker.process.is_alive() and time.monotonic() - worker.began < DEADLINE:
        return None
    if worker.process.is_alive() and time.monotonic() - worker.began >= DEADLINE:
        return WorkerDeath(f"no answer after {DEADLINE:g} s")
    worker.process.join()
    return WorkerDeath(f"the interpreter ended with {worker.process.exitcode}")


def _next(
    worker: _Worker, answer: Any, task: Task, seed: object, waiting: Iterator[int]
) -> _Worker:
    """The worker with its next number, or a new worker; None at the end."""
    worker.done += 1
    if isinstance(answer, WorkerDeath) or worker.done >= TASKS_PER_WORKER:
        worker.end()
        fresh = _started(task, seed, waiting)
        return fresh if fresh is not None else _Worker(worker.process, worker.pipe)
    number = next(waiting, None)
    if number is None:
        worker.end()
        return _Worker(worker.process, worker.pipe)
    worker.give(number)
    return worker


def _started(task: Task, seed: object, waiting: Iterator[int]) -> _Worker | None:
    """A new worker on the next number; None if there is none left."""
    number = next(waiting, None)
    if number is None:
        return None
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=_work, args=(task, seed, theirs), daemon=True)
    process.start()
    theirs.close()
    worker = _Worker(process, ours)
    worker.give(number)
    return worker


def _work(task: Task, seed: object, pipe: Connection) -> None:
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    while True:
        try:
            number = pipe.recv()
        except EOFError:
            return
        began = time.process_time()
        try:
            answer = task(seed, number)
        except Exception as error:  # of the judge itself: told, not lost
            answer = WorkerDeath(f"{type(error).__name__} in the trial itself: {error}"[:300])
        pipe.send((answer, time.process_time() - began))
