"""The accuracy study: error and time of a grid of settings, measured against a reference."""

from __future__ import annotations

import math
from dataclasses import replace

from viscodesign._version import __version__
from viscodesign.checks.contact import refuse_contact
from viscodesign.checks.refusals import refuse_beyond_numbers, refuse_unsolvable
from viscodesign.effects.select import Selection, select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.interrupt import gentle_interrupt
from viscodesign.model.rod import MINIMUM_EDGES
from viscodesign.results.accuracy_points import Model, Point, with_dominated
from viscodesign.results.accuracy_study import AccuracyInterruptedError, AccuracyStudy
from viscodesign.scene.reading.write import resolved_sha256
from viscodesign.scene.scene import Scene
from viscodesign.simulation.build_problem import suggest_settings
from viscodesign.simulation.solve_once import Progress
from viscodesign.studies.grid import AccuracyGrid
from viscodesign.studies.models import allowed_models
from viscodesign.studies.reference import solve_reference
from viscodesign.studies.timed_runs import StudyInterruptedError, TimedRuns

DEFAULT_LIMIT_S = 60.0


def accuracy(
    scene: Scene, *, limit: float = DEFAULT_LIMIT_S, progress: Progress | None = None
) -> AccuracyStudy:
    """Measure what accuracy costs in time.

    ``limit``: wall time of the whole study [s]. ``progress`` is called with the fraction of it
    that has passed. Ctrl-C raises `AccuracyInterruptedError`, a `KeyboardInterrupt` that holds
    the study as far as it got. Raises `SpecError` for a scene without a bounded solution,
    `SolveError` if it cannot be solved with all its effects, or not within the limit.
    """
    quantities = SceneQuantities(scene)
    with gentle_interrupt(second_raises=True) as interrupt:
        refuse_beyond_numbers(quantities)
        selection = select_effects(quantities)
        refuse_unsolvable(quantities, selection.active)
        refuse_contact(quantities, "a comparison of solvers")
        runs = TimedRuns(quantities, selection, limit, interrupt, progress)
        study = _study(runs)
    if interrupt.asked or study.status == "interrupted":
        raise AccuracyInterruptedError(replace(study, status="interrupted"))
    return study


def _study(runs: TimedRuns) -> AccuracyStudy:
    quantities, selection = runs.quantities, runs.selection
    models, notes = allowed_models(selection)
    study = _empty(runs, models, notes)
    smallest = min(study.errors)
    least = math.ceil(MINIMUM_EDGES / quantities.body.sections)
    try:
        reference = solve_reference(runs, least, smallest)
    except (StudyInterruptedError, KeyboardInterrupt):
        return replace(study, status="interrupted", spent_s=runs.spent_s)
    grid = AccuracyGrid(runs, reference, least, smallest)
    study = replace(study, reference=reference.reference)
    start: Point | None = None
    try:
        suggested = suggest_settings(quantities, selection.effects)
        start = grid.measure_one(_auto_model(models), suggested)
        grid.measure(models)
    except (StudyInterruptedError, KeyboardInterrupt):
        study = replace(study, status="interrupted")
    points = with_dominated(grid.points)
    return replace(
        study,
        points=points,
        start=None if start is None else points[grid.points.index(start)],
        notes=(*notes, *_reference_notes(study), *grid.notes),
        spent_s=runs.spent_s,
    )


def _empty(runs: TimedRuns, models: tuple[Model, ...], notes: tuple[str, ...]) -> AccuracyStudy:
    scene, body = runs.quantities.scene, runs.quantities.body
    return AccuracyStudy(
        name=scene.name,
        version=__version__,
        spec_sha256=scene.source.sha256,
        status="complete",
        length=body.length,
        requested_rel=runs.quantities.accuracy,
        models=models,
        taken=_names(runs.selection),
        reference=None,
        points=(),
        start=None,
        notes=notes,
        limit_s=runs.limit_s,
        spent_s=runs.spent_s,
        resolved_sha256=resolved_sha256(scene),
    )


def _names(selection: Selection) -> tuple[str, ...]:
    return tuple(effect.name for effect in selection.effects)


def _auto_model(models: tuple[Model, ...]) -> Model:
    """The model with the effects that the spec's `effects` include."""
    return next(model for model in models if "auto" in (model.name, *model.also))


def _reference_notes(study: AccuracyStudy) -> tuple[str, ...]:
    found = study.reference
    if found is None or found.is_converged:
        return ()
    return (
        f"the reference has converged to {found.convergence_rel:.1e} of the length only; errors "
        f"below {found.smallest_error_m / study.length:.1e} are upper bounds. Increase --limit "
        "for a finer reference",
    )
