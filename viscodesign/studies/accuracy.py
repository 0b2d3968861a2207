"""What accuracy costs in time: every sensible setting, measured against a reference."""

from __future__ import annotations

import math
from dataclasses import replace

from viscodesign._version import __version__
from viscodesign.checks.refusals import refuse_beyond_numbers, refuse_unsolvable
from viscodesign.effects.select import Selection, select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.interrupt import gentle_interrupt
from viscodesign.model.rod import MINIMUM_EDGES
from viscodesign.results.accuracy_study import AccuracyStudy, Model, Point, with_dominated
from viscodesign.scene.scene import Scene
from viscodesign.simulation.build_problem import suggest_settings
from viscodesign.simulation.solve_once import Progress
from viscodesign.studies.bench import Bench, StudyInterruptedError
from viscodesign.studies.explorer import Explorer
from viscodesign.studies.models import models_of
from viscodesign.studies.reference import make_reference

USUAL_LIMIT_S = 60.0


def accuracy(
    scene: Scene, *, limit: float = USUAL_LIMIT_S, progress: Progress | None = None
) -> AccuracyStudy:
    """Measure what accuracy costs in time.

    ``limit``: wall time of the whole study [s]. ``progress`` is told the part of it
    that is over. An interrupt is no exception: the study ends there, labelled. Raises
    `SpecError` for a scene without a bounded solution, `SolveError` where it cannot be
    solved with all the effects that it allows, or not within the limit.
    """
    quantities = SceneQuantities(scene)
    with gentle_interrupt() as interrupt:
        refuse_beyond_numbers(quantities)
        selection = select_effects(quantities)
        refuse_unsolvable(quantities, selection.taken)
        bench = Bench(quantities, selection, limit, interrupt, progress)
        return _studied(bench)


def _studied(bench: Bench) -> AccuracyStudy:
    quantities, selection = bench.quantities, bench.selection
    models, notes = models_of(selection)
    study = _empty(bench, models, notes)
    smallest = min(study.errors)
    least = math.ceil(MINIMUM_EDGES / quantities.body.sections)
    try:
        gauge = make_reference(bench, least, smallest)
    except (StudyInterruptedError, KeyboardInterrupt):
        return replace(study, status="interrupted", spent_s=bench.spent_s)
    explorer = Explorer(bench, gauge, least, smallest)
    study = replace(study, reference=gauge.reference)
    start: Point | None = None
    try:
        suggested = suggest_settings(quantities, selection.effects)
        start = explorer.try_one(_taken(models), suggested)
        explorer.explore(models)
    except (StudyInterruptedError, KeyboardInterrupt):
        study = replace(study, status="interrupted")
    points = with_dominated(explorer.points)
    return replace(
        study,
        points=points,
        start=None if start is None else points[explorer.points.index(start)],
        notes=(*notes, *_reference_notes(study), *explorer.notes, *explorer.skipped_notes()),
        spent_s=bench.spent_s,
    )


def _empty(bench: Bench, models: tuple[Model, ...], notes: tuple[str, ...]) -> AccuracyStudy:
    scene, body = bench.quantities.scene, bench.quantities.body
    return AccuracyStudy(
        name=scene.name,
        version=__version__,
        spec_sha256=scene.source.sha256,
        status="complete",
        length=body.length,
        requested_rel=bench.quantities.accuracy,
        models=models,
        taken=_names(bench.selection),
        reference=None,
        points=(),
        start=None,
        notes=notes,
        limit_s=bench.limit_s,
        spent_s=bench.spent_s,
    )


def _names(selection: Selection) -> tuple[str, ...]:
    return tuple(effect.name for effect in selection.effects)


def _taken(models: tuple[Model, ...]) -> Model:
    """What the spec's `effects` take."""
    return next(model for model in models if "auto" in (model.name, *model.also))


def _reference_notes(study: AccuracyStudy) -> tuple[str, ...]:
    found = study.reference
    if found is None or found.is_converged:
        return ()
    return (
        f"the reference stands still only to {found.convergence_rel:.1e} of the length within "
        f"this time; errors below {found.smallest_error_m / study.length:.1e} are told as at "
        "most that. A larger --limit makes it finer",
    )
