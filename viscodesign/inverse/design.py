"""The design of an actuator whose tip follows a path: `design`."""

from __future__ import annotations

import time as clock
from dataclasses import replace

import numpy as np

from viscodesign.checks.written_numbers import written
from viscodesign.errors import Fault, SolveError, SpecError, UsageError
from viscodesign.interrupt import gentle_interrupt
from viscodesign.inverse.alternatives import alternatives, with_modes_of
from viscodesign.inverse.beyond_reach import beyond_reach
from viscodesign.inverse.confirmation import Confirmation, confirm
from viscodesign.inverse.free_choice import free_choice
from viscodesign.inverse.graph_search import search_designs
from viscodesign.inverse.limiting import limiting_reason
from viscodesign.inverse.loop_sense import wrong_sense
from viscodesign.inverse.number_search import NumberDesign
from viscodesign.inverse.posed_scene import posed_scene
from viscodesign.inverse.search_task import Progress, SearchLog, SearchTask
from viscodesign.inverse.target_spec import ReadTarget, read_target
from viscodesign.inverse.wanted_path import WantedPath, wanted_path
from viscodesign.loading import load
from viscodesign.results.path_design import PathDesign, without_design
from viscodesign.scene.reading.read import Overrides
from viscodesign.scene.reading.sources import SpecSource
from viscodesign.scene.reading.write import resolved_yaml
from viscodesign.scene.scene import Scene
from viscodesign.studies.parallel_rows import available_cores

CONFIRM_SHARE = 0.85
"""Part of the budget that the search may take: the rest confirms."""
MAX_CONFIRMATIONS = 3


def design(
    target: SpecSource,
    overrides: Overrides = (),
    *,
    budget: float | None = None,
    seed: int = 0,
    workers: int | None = None,
    progress: Progress | None = None,
) -> PathDesign:
    """Find the free numbers, the graph and the input that make the tip follow a path.

    ``target``: a `TARGET.yaml` as `load` takes a spec; ``overrides`` of keys of its spec;
    ``budget`` [s] instead of its own. Least squares from several starts, by ``seed``, with exact
    derivatives of the scene's own model; the result is simulated with the effects that it calls
    for. Graphs are tried in ``workers`` processes, by default one a core. ``progress`` is called
    with the part of the budget that is spent and the best distance so far [m].

    The budget plans how many graphs are tried, and the same task, budget and seed give the same
    design for any number of workers, unless the budget ends the search: the answer then says so.

    Ctrl-C raises nothing: the best so far is confirmed and returned, and says so. Raises
    `SpecError` for a task that makes no sense; one that cannot be met is an answer.
    """
    began = clock.perf_counter()
    read = read_target(target)
    scene = load_spec(read, overrides)
    wanted, choice = wanted_path(read), free_choice(read, scene)
    _refuse_loose(read, wanted)
    if choice.harmonics is not None:
        scene = choice.harmonics.placed(scene)
    try:
        scene = posed_scene(scene, wanted, read.spec.tolerance)
    except SpecError as error:
        raise SpecError([_at_target(fault, read) for fault in error.faults]) from None
    seconds = read.spec.budget if budget is None else budget
    if not seconds > 0.0:
        raise UsageError(f"budget: must be a time above 0 s; got {seconds:g}")
    if workers is not None and workers < 1:
        raise UsageError(f"workers: must be 1 or more; got {workers}")
    with gentle_interrupt(second_raises=True) as stop:
        task = SearchTask(
            wanted=wanted,
            choice=choice,
            tolerance_m=read.spec.tolerance,
            until=began + CONFIRM_SHARE * seconds,
            budget_s=seconds,
            stop=stop,
            log=SearchLog(began),
            seed=seed,
            progress=progress,
            workers=workers or available_cores(),
        )
        return _refused(task, scene) or _designed(task, scene)


def _refuse_loose(read: ReadTarget, wanted: WantedPath) -> None:
    """Raise a fault for a tolerance as large as the path, which a tip at rest would meet."""
    size = float(np.linalg.norm(np.ptp(wanted.points, axis=0)))
    if read.spec.tolerance >= size:
        file, line = read.document.place(("tolerance",))
        message = (
            f"{written(read.spec.tolerance, 'm')} is no less than the whole path, "
            f"{written(size, 'm')}: a tip at rest would meet it. Write a smaller one with its "
            "unit, such as 0.15 mm"
        )
        raise SpecError([Fault(message, "tolerance", file, line)])


def _at_target(fault: Fault, read: ReadTarget) -> Fault:
    """A fault of the target with its line."""
    if fault.key != "target":
        return fault
    file, line = read.document.place(("target",))
    return replace(fault, file=file, line=line)


def _refused(task: SearchTask, scene: Scene) -> PathDesign | None:
    """The answer to a path that no numbers can follow; None where some may."""
    far = beyond_reach(task.wanted, task.choice, scene, task.tolerance_m)
    found = None if far else wrong_sense(task.wanted, task.choice, scene)
    if far is not None:
        reason, hint = far
    elif found is not None:
        reason, hint = found.reason, found.hint
    else:
        return None
    return without_design(
        scene.name,
        "refused",
        reason,
        tolerance_m=task.tolerance_m,
        wanted=task.wanted.way,
        closed=task.wanted.closed,
        hint=hint,
        spec_text=resolved_yaml(found.mirrored) if found else "",
        wall_s=clock.perf_counter() - task.log.began,
    )


def load_spec(read: ReadTarget, overrides: Overrides) -> Scene:
    """The scene of a task's spec, whose name is relative to the task."""
    path = read.folder / read.spec.spec
    if not path.exists():
        file, line = read.document.place(("spec",))
        raise SpecError([Fault(f"no such file; looked for {path}", "spec", file, line)])
    return load(path, overrides)


def _designed(task: SearchTask, scene: Scene) -> PathDesign:
    """Search, confirm, and go on with the effects of the run where the search lacked some."""
    effects = scene.effects
    posed = scene
    for _ in range(MAX_CONFIRMATIONS):
        try:
            designs = search_designs(task, posed)
        except KeyboardInterrupt:
            why = "interrupted" if task.stop.asked else "the search ran out of time"
            return _without_solution(task, scene, f"{why} before a first solution")
        except SolveError as error:
            return _without_solution(task, scene, f"no start has a solution: {error}")
        found = with_modes_of(effects, designs[0].scene)
        if task.stop.asked:
            return _finished(task, scene, designs, found, None)
        try:
            confirmed = confirm(task.wanted, found, task.tolerance_m)
        except (SolveError, KeyboardInterrupt):
            return _finished(task, scene, designs, found, None)
        allowed = task.tolerance_m
        missed = designs[0].distance.meets(allowed) and not confirmed.distance.meets(allowed)
        pinned = found.effects.with_modes(dict.fromkeys(confirmed.effects, "on"))
        if not missed or not task.choice.ranges or task.is_over:
            break
        posed = found.replace({"effects": pinned})
    return _finished(task, scene, designs, found, confirmed)


def _finished(
    task: SearchTask,
    scene: Scene,
    designs: list[NumberDesign],
    found: Scene,
    confirmed: Confirmation | None,
) -> PathDesign:
    best = designs[0]
    is_met = confirmed is not None and confirmed.distance.meets(task.tolerance_m)
    return PathDesign(
        name=scene.name,
        status="met" if is_met else "not_met",
        reason="" if is_met else limiting_reason(task, best, confirmed),
        tolerance_m=task.tolerance_m,
        wanted=task.wanted.way,
        found=np.zeros((0, 2)) if confirmed is None else confirmed.tip,
        band=best.band,
        closed=task.wanted.closed,
        rms_m=best.distance.rms_m,
        worst_m=best.distance.worst_m,
        confirmed_rms_m=None if confirmed is None else confirmed.distance.rms_m,
        confirmed_worst_m=None if confirmed is None else confirmed.distance.worst_m,
        excess_m=(best if confirmed is None else confirmed).distance.excess_m,
        stated_error_m=None if confirmed is None else confirmed.run.accuracy.estimated_tip_error_m,
        parameters=best.parameters,
        units=dict(zip(best.names, best.units, strict=True)),
        graph=tuple(tube.name for tube in found.graph.tubes),
        at_bounds=best.at_bounds,
        effects=() if confirmed is None else confirmed.effects,
        spec_text=resolved_yaml(found),
        alternatives=alternatives(designs, scene.effects),
        history=tuple(task.log.rows),
        evaluations=task.log.evaluations,
        wall_s=clock.perf_counter() - task.log.began,
        interrupted=task.stop.asked,
        ended_by_budget=task.log.is_cut,
        lost_graphs=task.log.lost_graphs,
        violations=() if confirmed is None else confirmed.run.violations,
    )


def _without_solution(task: SearchTask, scene: Scene, reason: str) -> PathDesign:
    """What is left of a search that found nothing."""
    return without_design(
        scene.name,
        "not_met",
        reason,
        tolerance_m=task.tolerance_m,
        wanted=task.wanted.way,
        closed=task.wanted.closed,
        evaluations=task.log.evaluations,
        wall_s=clock.perf_counter() - task.log.began,
        interrupted=task.stop.asked,
    )
