"""Chunks of rows in processes: all of them come back, whatever becomes of a process."""

from __future__ import annotations

import os
import signal
import time

import pytest

from viscodesign.interrupt import StopRequest
from viscodesign.studies import parallel_rows
from viscodesign.studies.parallel_rows import compute_alone, compute_in_processes

DEADLY = 13


def squares(rows: list[int], within_s: float) -> list[int]:
    """Squares; one number ends the process."""
    del within_s
    if DEADLY in rows:
        os.kill(os.getpid(), signal.SIGKILL)
    return [row**2 for row in rows]


def one_at_a_time(rows: list[int], within_s: float) -> list[int]:
    """The first alone: the rest of the chunk has to follow."""
    return squares(rows[:1], within_s)


@pytest.mark.parametrize("work", [squares, one_at_a_time])
def test_all_rows_come_back(work: parallel_rows.Work[int, int]) -> None:
    chunks = [[1, 2, 3], [4, 5], [6]]
    alone = list(compute_alone(work, chunks, StopRequest()))
    parallel = list(compute_in_processes(work, chunks, 2, StopRequest()))
    for found in (alone, parallel):
        pairs = sorted((row, r) for c in found for row, r in zip(c.rows, c.results, strict=True))
        assert pairs == [(row, row**2) for row in range(1, 7)]


def test_a_process_that_dies_costs_its_chunk_alone() -> None:
    chunks = [[1, 2], [DEADLY, 3], [4, 5], [6, 7], [8, 9]]
    found = list(compute_in_processes(squares, chunks, 2, StopRequest()))
    assert sorted(c.rows for c in found) == sorted(chunks)
    assert [c.lost for c in found if c.lost] == [[DEADLY, 3]]


def test_nothing_begins_after_a_request_to_stop() -> None:
    stop, found = StopRequest(), []
    for chunk in compute_in_processes(squares, [[k] for k in range(14, 40)], 1, stop):
        found.append(chunk)
        stop.ask()
    assert len(found) <= 2


def test_processes_end_with_their_parent() -> None:
    """A parent that is killed cannot tell them to."""
    read, write = os.pipe()
    parent = os.fork()
    if not parent:

        def report(rows: list[int], within_s: float) -> list[int]:
            del within_s
            os.write(write, b"begun")
            time.sleep(60)
            return rows

        list(compute_in_processes(report, [[1]], 1, StopRequest()))
        os._exit(0)
    os.close(write)
    assert os.read(read, 5) == b"begun"
    os.kill(parent, signal.SIGKILL)
    os.waitpid(parent, 0)
    assert os.read(read, 5) == b""  # its other end is closed once the last process is gone
    os.close(read)
