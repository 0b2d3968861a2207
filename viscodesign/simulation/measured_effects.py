"""Every effect switched, solved again, and the tips compared: what an estimate is worth."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from viscodesign.effects.select import Selection
from viscodesign.errors import ViscodesignError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.results.findings import EffectAblation, Verdict
from viscodesign.simulation.build_problem import Settings
from viscodesign.simulation.solve_once import Run, Workspace, solve, tip_difference

FINER = 20
"""By how much the tolerance is cut, so that small changes stand out from the steps' noise."""


def measure_effects(
    quantities: SceneQuantities,
    selection: Selection,
    settings: Settings,
    progress: Callable[[float], None] | None = None,
    workspace: Workspace | None = None,
) -> tuple[EffectAblation, ...]:
    """Switch each effect that a scene has, one at a time, and measure the tip's move.

    A scene that cannot be solved with the effect switched says so in the note; an
    interrupt ends the list. Raises `SolveError` where the scene itself cannot start.
    """
    finer = replace(settings, tolerance=settings.tolerance / FINER)
    workspace = workspace or Workspace()
    base = solve(quantities, selection.effects, finer, workspace=workspace)
    if base.solution.interrupted:
        return ()
    verdicts = [v for v in selection.verdicts if v.name in selection.provable]
    ablations: list[EffectAblation] = []
    for k, verdict in enumerate(verdicts):
        ablation, run = _switched(quantities, selection, finer, base, verdict, workspace)
        if run is not None and run.solution.interrupted:
            break
        ablations.append(ablation)
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
    told = (verdict.name, verdict.taken, verdict.contribution_m)
    try:
        run = solve(quantities, selection.switched(verdict.name), settings, workspace=workspace)
    except ViscodesignError as error:
        return EffectAblation(*told, None, 0.0, str(error).splitlines()[0]), None
    measured = tip_difference(base.motion, run.motion)
    note = ""
    if not run.is_complete:
        note = f"compared up to t = {run.motion.time[-1]:.4g} s, where it ended"
    return EffectAblation(*told, measured, run.spent_s, note), run
