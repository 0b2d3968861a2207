"""Many designs of one scene in one table: `sweep`."""

from __future__ import annotations

import contextlib
import hashlib
import math
import time as clock
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from viscodesign._version import __version__
from viscodesign.checks.plausibility import plausibility_notices
from viscodesign.errors import SpecError, UsageError
from viscodesign.exploration import journal
from viscodesign.exploration.design_solver import DesignSolver, Row
from viscodesign.exploration.designs import Design, grid, latin_hypercube
from viscodesign.exploration.key_values import choices_of
from viscodesign.exploration.parallel_rows import (
    Chunk,
    available_cores,
    compute_alone,
    compute_in_processes,
)
from viscodesign.exploration.swept_keys import SweptKey, changed, swept_keys
from viscodesign.interrupt import StopRequest, gentle_interrupt
from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.folder import prepare_folder
from viscodesign.results.findings import Notice
from viscodesign.results.sweep_table import DesignResult, Sweep, SweepStatus, SweptColumn
from viscodesign.scene.scene import Scene

COMPILED_CHUNK, SIMULATED_CHUNK = 100, 8
"""Rows that a process takes at once."""
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
    by `simulate`; both at the scene's accuracy, not verified. A compiled function has all effects
    that the spec allows, `simulate` those that a design calls for. A design that fails is named in
    the table, and the others go on.

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
    kept: contextlib.AbstractContextManager[journal.Journal | None] = contextlib.nullcontext()
    if folder is not None:
        place = prepare_folder(folder, force=force)
        kept = journal.opened(place, plan.digest, plan.words, replace=force)
    with gentle_interrupt(second_raises=True) as stop, kept as own:
        run = SweepRun(plan, {} if own is None else own.found, own, progress)
        run.compute(workers, cluster, stop)
    return replace(
        plan.table(),
        status=run.status(stop),
        results=run.results,
        wall_s=clock.perf_counter() - began,
        computed=run.computed,
        workers=run.workers,
    )


@dataclass(frozen=True)
class SweepPlan:
    """What a sweep is to compute."""

    scene: Scene
    keys: tuple[SweptKey, ...]
    designs: tuple[Design, ...]
    sample: int | None
    seed: int | None

    @classmethod
    def of(
        cls,
        scene: Scene,
        over: Mapping[str, Any] | Sequence[str] | str,
        sample: int | None,
        seed: int,
    ) -> SweepPlan:
        """From what each key takes."""
        if not isinstance(scene, Scene):
            raise SpecError.plain(f"scene: needs a scene, such as load({scene!r}); got {scene!r}")
        keys = swept_keys(scene, choices_of(over))
        if sample is None:
            return cls(scene, tuple(keys), tuple(grid(keys)), None, None)
        designs = latin_hypercube(keys, sample, seed)
        return cls(scene, tuple(keys), tuple(designs), sample, seed)

    @property
    def words(self) -> str:
        """What it is, in words."""
        names = ", ".join(key.name for key in self.keys[:4])
        more = len(self.keys) - 4
        names += f" and {more} more" if more > 0 else ""
        drawn = "" if self.sample is None else f", drawn with seed {self.seed}"
        version = f"viscodesign {__version__}"
        return f"{self.scene.name} over {names}, {len(self.designs)} rows{drawn} ({version})"

    @property
    def digest(self) -> str:
        """Equal for sweeps with the same rows of the same scene, by the same version."""
        content = __version__, [key.name for key in self.keys], self.designs
        return hashlib.sha256(self.scene.digest + repr(content).encode()).hexdigest()

    def table(self) -> Sweep:
        """Its table without results."""
        return Sweep(
            name=self.scene.name,
            version=__version__,
            spec_sha256=self.scene.source.sha256,
            status="incomplete",
            columns=tuple(self._column(key) for key in self.keys),
            designs=self.designs,
            results={},
            requested_m=self.scene.accuracy * self.scene.actuator.length,
            sample=self.sample,
            seed=self.seed,
            warnings=tuple(self._notices()),
        )

    def _column(self, key: SweptKey) -> SweptColumn:
        own = key.values
        if self.sample is None or own.listed:
            return SweptColumn(key.name, own.unit, own.grid())
        return SweptColumn(
            key.name, own.unit, None, own.low, own.high, "log" if own.is_log else "linear"
        )

    def _notices(self) -> Iterator[Notice]:
        """Values of keys that are hardly meant, once each."""
        usual = {notice.where for notice in plausibility_notices(self.scene)}
        for key in self.keys:
            own = key.values
            ends = (min(own.listed), max(own.listed)) if own.listed else (own.low, own.high)
            for value in dict.fromkeys(ends) if own.unit is not None else ():
                try:
                    other = changed(self.scene, {key: value})
                except SpecError:  # a tube by its name, or a value that its rows will refuse
                    continue
                for notice in plausibility_notices(other):
                    if notice.where == key.name and notice.where not in usual:
                        usual.add(notice.where)
                        yield notice


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

    def compute(self, workers: int | None, cluster: str | None, stop: StopRequest) -> None:
        """Compute all rows that are not there, until the user asks to stop."""
        plan = self.plan
        rows = [(k, d) for k, d in enumerate(plan.designs) if k not in self.results]
        self._tell()
        if not rows:
            return
        solver = DesignSolver.of(plan.scene, plan.keys, plan.designs)
        for chunk in self._chunks(solver, rows, workers, cluster, stop):
            self._take(chunk)

    def _chunks(
        self,
        solver: DesignSolver,
        rows: list[Row],
        workers: int | None,
        cluster: str | None,
        stop: StopRequest,
    ) -> Iterator[Chunk[Row, DesignResult]]:
        if cluster is not None:
            from viscodesign.exploration.cluster_rows import CLUSTER_CHUNK, compute_on_cluster

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
        self._tell()

    def _tell(self) -> None:
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
