"""Chunks of rows computed on an existing Dask cluster; needs the extra `cluster`."""

from __future__ import annotations

import functools
import math
import pickle
from collections.abc import Iterator
from typing import Any, cast

from viscodesign.errors import UsageError
from viscodesign.interrupt import StopRequest
from viscodesign.results.sweep_table import DesignResult
from viscodesign.studies.design_solver import DesignSolver, Row
from viscodesign.studies.parallel_rows import LOOK_S, Chunk

CLUSTER_CHUNK = 100
"""Rows of a task at least: the scheduler takes milliseconds for each task."""
CONNECT_S = 10.0
"""How long to wait for a scheduler [s]."""


def compute_on_cluster(
    address: str, solver: DesignSolver, chunks: list[list[Row]], stop: StopRequest
) -> Iterator[Chunk[Row, DesignResult]]:
    """Results of chunks as they come, until the user asks to stop.

    A chunk whose workers died comes back without results. Raises `UsageError` where there is no
    such cluster.
    """
    client = _client(address)
    try:
        packed = pickle.dumps(solver)
        tasks = {client.submit(_compute, packed, rows, pure=False): rows for rows in chunks}
        while tasks and not stop.asked:
            for task in [task for task in tasks if task.done()]:
                rows = tasks.pop(task)
                failed = task.status != "finished"
                yield Chunk(rows, [] if failed else task.result())
            if tasks:
                _wait(list(tasks))
        client.cancel(list(tasks))
    finally:
        client.close()


def _client(address: str) -> Any:
    try:
        from distributed import Client
    except ImportError as error:
        raise UsageError(
            "--cluster needs Dask: install it with pip install 'viscodesign[cluster]'"
        ) from error
    try:
        return Client(address, timeout=CONNECT_S)
    except (OSError, ValueError, TypeError) as error:
        reason = str(error).partition("\n")[0] or type(error).__name__
        raise UsageError(
            f"--cluster {address}: no Dask scheduler answers there ({reason}). Start one with "
            "'dask scheduler', and give its address, such as tcp://192.168.0.1:8786"
        ) from error


def _wait(tasks: list[Any]) -> None:
    """Until one is done, or a moment has passed."""
    from distributed import TimeoutError, wait

    try:
        wait(tasks, timeout=LOOK_S, return_when="FIRST_COMPLETED")
    except TimeoutError:
        return


# -- on a worker ------------------------------------------------------------------


def _compute(packed: bytes, rows: list[Row]) -> list[DesignResult]:
    return _solver(packed).solve(rows, math.inf)


@functools.lru_cache(maxsize=2)
def _solver(packed: bytes) -> DesignSolver:
    """The solver of a sweep, made once in each process."""
    return cast(DesignSolver, pickle.loads(packed))
