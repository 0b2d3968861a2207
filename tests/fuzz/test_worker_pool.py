"""A worker that dies takes nothing along but its own task."""

from __future__ import annotations

import os
import signal

from tests.fuzz import worker_pool


def work(seed: object, number: int) -> int:
    """Ten times the number; the fourth task is one that kills its interpreter."""
    if number == 3:
        os.kill(os.getpid(), signal.SIGSEGV)
    return 10 * number


def test_a_crash_is_an_answer() -> None:
    found = {
        number: answer for number, answer, _ in worker_pool.run_tasks(work, "any", range(6), 2)
    }
    died = found.pop(3)
    assert isinstance(died, worker_pool.WorkerDeath)
    assert f"{-signal.SIGSEGV}" in died.how
    assert found == {k: 10 * k for k in (0, 1, 2, 4, 5)}
