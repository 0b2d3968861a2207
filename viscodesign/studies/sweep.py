"""Many designs of one scene in one table: `sweep`."""

from __future__ import annotations

import contextlib
import math
import time as clock
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from viscodesign.errors import UsageError
from viscodesign.interrupt import StopRequest, gentle_interrupt
from viscodesign.report.folder import prepare_folder
from viscodesign.results.sweep_table import (
    DesignResult,
    Sweep,
    SweepStatus,
    VerifiedRow,
)
from viscodesign.scene.scene import Scene
from viscodesign.studies import journal
from viscodesign.studies.design_solver import DesignSolver, Row
from viscodesign.studies.parallel_rows import (
    Chunk,
    available_cores,
    compute_alone,
    compute_in_processes,
)
from viscodesign.studies.sweep_plan import SweepPlan
from viscodesign.studies.verified_rows import verified_rows

COMPILED_CHUNK, SIMULATED_CHUNK = 100, 8
"""Rows that a process takes at once."""
VERIFIED_ROWS = 2
"""Rows that are simulated again by default."""
FEW_COMPILED, FEW_SIMULATED = 200, 8
"""Rows below which other processes would take longer to start than they save."""

Progress = Callable[[float], None]


def sweep(
    scene: Scene,
    over: Mapping[str, Any] | Sequence[str] | str,
    *,
    sample: int | None = None,
    seed: int = 0,
    workers: int | None = None,
    cluster: str | None = None,
    verify: int = VERIFIED_ROWS,
    folder: str | Path | None = None,
    force: bool = False,
    progress: Progress | None = None,
) -> Sweep:
    """Solve many designs of a scene and put their metrics in a table.

    ``over``: what each key takes: ``{"network.tube_radius": "0.2 mm..1 mm:9", "fluid": ["air",
    "water"]}``, or texts ``KEY=VALUES`` as on the command line; numbers are SI. Without ``sample``
    every combination, else so many designs of a Latin hypercube by ``seed``. Keys with ``[*]``
    stand for one number each.

    Numbers of the equations are solved by a compiled function, settings that make other equations
    by `simulate`; both at the scene's accuracy. A compiled function has all effects
    that the spec allows, `simulate` those that a design calls for. A design that fails is named in
    the table, and the others go on.

    ``verify``: so many rows, those with the largest and smallest loops first, are simulated again
    at the end, with their error stated and their validity judged.

    ``workers``: processes, by default one a core where there is enough to do; ``cluster``: address
    of a Dask scheduler instead. With a ``folder`` every row is kept there at once, and the same
    call goes on where another ended; ``force`` replaces another sweep there. ``progress`` is called
    with the fraction done. Ctrl-C raises nothing: the table is returned as far as it came.

    Raises `SpecError` for keys that cannot vary and for values that are none, `UsageError` where
    the folder holds another sweep.
    """
    began = clock.perf_counter()
    plan = SweepPlan.of(scene, over, sample, seed)
    if workers is not None and workers < 1:
        raise UsageError(f"workers: must be at least 1; got {workers}")
    if verify < 0:
        raise UsageError(f"verify: must be a number of rows, 0 for none; got {verify}")
    kept: contextlib.AbstractContextManager[journal.Journal | None] = contextlib.nullcontext()
    if folder is not None:
        place = prepare_folder(folder, force=force)
        kept = journal.opened(place, plan.digest, plan.words, replace=force)
    with gentle_interrupt(second_raises=True) as stop, kept as own:
        run = SweepRun(plan, {} if own is None else own.found, own, progress)
        run.compute(workers, cluster, stop)
        verified = () if stop.asked else run.verified(verify, stop)
    return replace(
        plan.table(),
        status=run.status(stop),
        results=run.results,
        verified=verified,
        wall_s=clock.perf_counter() - began,
        computed=run.computed,
        workers=run.workers,
    )


class SweepRun:
    """The rows of a plan, as they are computed."""

    def __init__(
        self,
        plan: SweepPlan,
        known: dict[int, DesignResult],
        kept: journal.Journal | None,
        progress: Progress | None,
    ) -> None:
        self.plan = plan
        self.results = dict(known)
        self.computed = 0
        self.workers = 1
        self._kept, self._progress = kept, progress
        self._solver = DesignSolver.of(plan.scene, plan.keys, plan.designs)

    def compute(self, workers: int | None, cluster: str | None, stop: StopRequest) -> None:
        """Compute all rows that are not there, until the user asks to stop."""
        plan = self.plan
        rows = [(k, d) for k, d in enumerate(plan.designs) if k not in self.results]
        self._report_progress()
        if not rows:
            return
        for chunk in self._chunks(rows, workers, cluster, stop):
            self._take(chunk)

    def verified(self, count: int, stop: StopRequest) -> tuple[VerifiedRow, ...]:
        """Some rows simulated again with their error stated."""
        rows = [found for _, found in sorted(self.results.items())]
        return verified_rows(self._solver, self.plan.designs, rows, count, stop)

    def _chunks(
        self,
        rows: list[Row],
        workers: int | None,
        cluster: str | None,
        stop: StopRequest,
    ) -> Iterator[Chunk[Row, DesignResult]]:
        solver = self._solver
        if cluster is not None:
            from viscodesign.studies.cluster_rows import CLUSTER_CHUNK, compute_on_cluster

            chunks = chunks_of(rows, lambda _: "", lambda _: CLUSTER_CHUNK)
            return compute_on_cluster(cluster, solver, chunks, stop)
        self.workers = workers or _suitable_workers(solver, rows)
        share = math.ceil(len(rows) / (2 * self.workers))

        def size(row: Row) -> int:
            is_compiled = solver.is_compiled(solver.settings_of(row[1]))
            return min(share, COMPILED_CHUNK if is_compiled else SIMULATED_CHUNK)

        chunks = chunks_of(rows, lambda row: solver.settings_of(row[1]), size)
        self.workers = min(self.workers, len(chunks))
        if self.workers == 1:
            return compute_alone(solver.solve, chunks, stop)
        solver.prepare()
        return compute_in_processes(solver.solve, chunks, self.workers, stop)

    def status(self, stop: StopRequest) -> SweepStatus:
        """Whether all rows are there, and why not."""
        if len(self.results) == len(self.plan.designs):
            return "complete"
        return "interrupted" if stop.asked else "incomplete"

    def _take(self, chunk: Chunk[Row, DesignResult]) -> None:
        if self._kept is not None:
            self._kept.add(chunk.results)
        self.results |= {found.row: found for found in chunk.results}
        self.computed += len(chunk.results)
        self._report_progress()

    def _report_progress(self) -> None:
        if self._progress is not None:
            self._progress(len(self.results) / len(self.plan.designs))


def chunks_of(
    rows: Sequence[Row], settings: Callable[[Row], Any], size: Callable[[Row], int]
) -> list[list[Row]]:
    """Rows with the same settings together, in chunks of a size."""
    groups: dict[Any, list[Row]] = {}
    for row in rows:
        groups.setdefault(settings(row), []).append(row)
    return [
        own[k : k + size(own[0])]
        for own in groups.values()
        for k in range(0, len(own), size(own[0]))
    ]


def _suitable_workers(solver: DesignSolver, rows: Sequence[Row]) -> int:
    few = FEW_COMPILED if solver.is_compiled(solver.settings_of(rows[0][1])) else FEW_SIMULATED
    return 1 if len(rows) < few else available_cores()
