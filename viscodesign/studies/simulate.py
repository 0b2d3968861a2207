"""From a scene to a trajectory with both of its errors: that of the numbers, and of what is known.

A run of `viscodesign.simulation` has the first one. Studies, which solve many scenes, take that.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from viscodesign.results.findings import Notice
from viscodesign.results.trajectory import RunInterruptedError, Trajectory
from viscodesign.scene.scene import Scene
from viscodesign.simulation.simulate import simulate as simulate_once
from viscodesign.simulation.solve_once import Progress

if TYPE_CHECKING:
    from viscodesign.studies.stated_uncertainty import StatedDeviation


def simulate(
    scene: Scene,
    *,
    verify: bool = True,
    prove: bool = False,
    uncertainty: bool = True,
    tolerance: float | None = None,
    progress: Progress | None = None,
    scratch: Path | None = None,
) -> Trajectory:
    """Compute the motion of a scene.

    With ``verify`` the scene is solved again with a smaller tolerance and on a finer mesh
    until the estimated error is below the requested accuracy; the finest solution is
    returned. With ``prove`` every effect is switched, solved again, and the displacement of the
    tip measured. With ``uncertainty``, and where the spec says how well its numbers are known, one
    more solution with its derivatives tells how uncertain they make the tip. ``tolerance`` is that
    of the integrator, where it is not to follow from the accuracy. ``progress`` is called with the
    fraction done. ``scratch`` is a folder for the arrays of a long run, by default that of the
    system; nothing remains there.

    A failure on the way raises nothing: the trajectory ends there, and says so. Ctrl-C raises
    `RunInterruptedError`, a `KeyboardInterrupt` that holds the trajectory as far as it came; a
    second one while it is being read raises at once.

    Raises `SpecError` for a scene without a bounded solution, `SolveError` where not even an
    initial equilibrium exists.
    """
    stated: dict[str, StatedDeviation] = {}
    if uncertainty and isinstance(scene, Scene) and scene.uncertainty is not None:
        from viscodesign.studies.stated_uncertainty import stated_deviations

        stated = stated_deviations(scene)
    run = simulate_once(
        scene,
        verify=verify,
        prove=prove,
        tolerance=tolerance,
        progress=progress,
        scratch=scratch,
    )
    try:
        return _with_band(scene, run, stated) if stated else run
    except KeyboardInterrupt:
        raise RunInterruptedError(run) from None


def _with_band(scene: Scene, run: Trajectory, stated: dict[str, StatedDeviation]) -> Trajectory:
    """The run with the band of its coefficients, or a warning that says why it has none."""
    from viscodesign.studies.coefficient_band import coefficient_band, width_notices

    found = coefficient_band(scene, run, stated)
    if isinstance(found, Notice):
        return replace(run, warnings=(*run.warnings, found))
    if found is not None:
        run = replace(run, warnings=(*run.warnings, *width_notices(found, run)))
    spent = run.cost.verify_s + (found.wall_s if found else 0.0)
    return replace(run.with_time(verify_s=spent), uncertainty=found)
