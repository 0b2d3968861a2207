"""Work spread over processes, any of which may die of what it works on."""

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
"""Bytes of addresses that a worker may take; more is a finding, not the end of the machine."""
DEADLINE = 1200.0
"""Wall seconds after which a worker is ended that no alarm could reach."""
TASKS_PER_WORKER = 500
"""After which a worker is replaced, so that nothing piles up."""

Task = Callable[[Any, int], Any]
"""Of a seed and a number; lives in a module, since workers import it."""

Answer = tuple[int, Any, float]


@dataclass(frozen=True)
class Died:
    """What is left of a task whose worker did not come back."""

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


def answers(task: Task, seed: object, numbers: Iterable[int], jobs: int) -> Iterator[Answer]:
    """Number, answer (or `Died`) and seconds of a processor of every task, as they come."""
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
    """What a worker came to, with its seconds; `Died` alone; None while it works."""
    if worker.pipe.poll():
        try:
            return worker.pipe.recv()
        except EOFError:
            pass
    elif worker.process.is_alive() and time.monotonic() - worker.began < DEADLINE:
        return None
    if worker.process.is_alive() and time.monotonic() - worker.began >= DEADLINE:
        return Died(f"no answer after {DEADLINE:g} s")
    worker.process.join()
    return Died(f"the interpreter ended with {worker.process.exitcode}")


def _next(
    worker: _Worker, answer: Any, task: Task, seed: object, waiting: Iterator[int]
) -> _Worker:
    """The worker with its next number, or a fresh one; without a number at the end."""
    worker.done += 1
    if isinstance(answer, Died) or worker.done >= TASKS_PER_WORKER:
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
    """A new process at work on the next number; None where there is none left."""
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
            answer = Died(f"{type(error).__name__} in the trial itself: {error}"[:300])
        pipe.send((answer, time.process_time() - began))
