"""Every effect switched and solved again, to measure what the estimates only guess."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from viscodesign.effects.select import Selection
from viscodesign.errors import ViscodesignError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.results.findings import EffectAblation, Verdict
from viscodesign.simulation.build_problem import Settings
from viscodesign.simulation.solve_once import Run, Workspace, solve, tip_difference

TOLERANCE_REDUCTION = 20
"""Factor on the tolerance, so that small changes stand out from the error of the steps."""


def measure_effects(
    quantities: SceneQuantities,
    selection: Selection,
    settings: Settings,
    progress: Callable[[float], None] | None = None,
    workspace: Workspace | None = None,
) -> tuple[EffectAblation, ...]:
    """Switch each effect that a scene has, one at a time, and measure the displacement of the tip.

    Where the scene cannot be solved with the effect switched, the note says why; an interrupt
    ends the list. Raises `SolveError` where the scene itself cannot start.
    """
    finer = replace(settings, tolerance=settings.tolerance / TOLERANCE_REDUCTION)
    workspace = workspace or Workspace()
    try:
        base = solve(quantities, selection.effects, finer, workspace=workspace)
    except KeyboardInterrupt:  # before the first step
        return ()
    if base.solution.asked_to_stop:
        return ()
    verdicts = [v for v in selection.verdicts if v.name in selection.measurable]
    ablations: list[EffectAblation] = []
    for k, verdict in enumerate(verdicts):
        try:
            ablation, run = _switched(quantities, selection, finer, base, verdict, workspace)
        except KeyboardInterrupt:  # before the first step
            break
        if run is not None and run.solution.interrupted:
            break
        ablations.append(ablation)
        if run is not None and run.solution.asked_to_stop:
            break
        if progress is not None:
            progress((k + 1) / len(verdicts))
    return tuple(ablations)


def _switched(
    quantities: SceneQuantities,
    selection: Selection,
    settings: Settings,
    base: Run,
    verdict: Verdict,
    workspace: Workspace,
) -> tuple[EffectAblation, Run | None]:
    known = (verdict.name, verdict.taken, selection.switched_m(verdict.name))
    try:
        run = solve(quantities, selection.with_flipped(verdict.name), settings, workspace=workspace)
    except ViscodesignError as error:
        return EffectAblation(*known, None, 0.0, str(error).splitlines()[0]), None
    measured = tip_difference(base.motion, run.motion)
    note = ""
    if not run.is_complete:
        note = f"compared up to t = {run.motion.time[-1]:.4g} s, where that run ended"
    return EffectAblation(*known, measured, run.spent_s, note), run
