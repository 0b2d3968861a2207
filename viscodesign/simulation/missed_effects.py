"""Effects that a run calls for after all: a sketch had not seen that they matter.

A sketch is linear, with means over the motion. The run itself knows better: where it left
its branch of equilibria, and what its flows would lose by a term that was left out.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from viscodesign.effects.base import Effect
from viscodesign.effects.select import SHARE_OF_ACCURACY, Selection
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.rod_equations import RodForm
from viscodesign.postprocess.motion import Motion
from viscodesign.results.findings import RetryAttempt
from viscodesign.simulation.solve_once import Run
from viscodesign.storage.disk_arrays import blocks

BRANCH_ENDS = ("equilibrium", "motion")
"""What fails at a fold: the equilibrium itself, or an integrator that follows its fluid."""
IN_MOTION = "inertia and damping taken in, from the start"


@dataclass(frozen=True)
class Reselection:
    """A larger set of effects, with which the whole run is to be done again."""

    selection: Selection
    tried: str
    reason: str
    time_s: float
    """Where the run asked for it [s]."""

    def rung(self, solved: bool) -> RetryAttempt:
        """What is told of it once the run was done again."""
        return RetryAttempt(self.time_s, self.tried, solved, self.reason)


def reselected(quantities: SceneQuantities, selection: Selection, run: Run) -> Reselection | None:
    """What a run calls for beyond what was taken; None where it calls for nothing.

    Nothing is called for that the spec forbids. Each answer is larger than ``selection``.
    """
    if run.solution.asked_to_stop:
        return None
    return _in_motion(selection, run) or _with_losses(quantities, selection, run)


def _in_motion(selection: Selection, run: Run) -> Reselection | None:
    """Inertia, where a static rod came to the end of its branch of equilibria.

    The whole run is done again: a rod that has snapped remembers how it moved.
    """
    failure = run.motion.failure
    static = run.problem.equations.rod_form is RodForm.STATIC
    if not (static and failure and failure.quantity in BRANCH_ENDS):
        return None
    moving = selection.grown("inertia", failure.short)
    if moving is None:
        return None
    return Reselection(moving, IN_MOTION, failure.short, failure.time_s or 0.0)


def _with_losses(quantities: SceneQuantities, selection: Selection, run: Run) -> Reselection | None:
    """What takes pressure of the flows, where that could move the tip by more than is granted."""
    granted = SHARE_OF_ACCURACY * quantities.accuracy * quantities.body.length
    for effect in selection.spared:
        found = _largest_loss(effect, run.motion)
        if found is None:
            continue
        # As a part of the pressure, of which the tip's whole way is made.
        moved = min(found.pressure / quantities.swing, 1.0) * _way(
            run.motion, quantities.body.length
        )
        if moved <= granted:
            continue
        reason = (
            f"the flows that were found would lose {found.pressure:.3g} Pa by it, "
            f"{found.pressure / quantities.swing:.2g} of the largest pressure"
        )
        grown = selection.grown(effect.name, reason)
        if grown is not None:
            tried = f"{effect.name} taken in, from the start"
            return Reselection(grown, tried, reason, found.time_s)
    return None


@dataclass(frozen=True)
class _Loss:
    """The largest loss of pressure along all tubes together."""

    pressure: float
    time_s: float


def _largest_loss(effect: Effect, motion: Motion) -> _Loss | None:
    """Over all outputs behind the first, at which no flow has had time to lose anything."""
    worst: _Loss | None = None
    for rows in blocks(len(motion.time), motion.time, motion.flow):
        lost = effect.lost_pressure(motion.flow[rows])
        if lost is None:
            return None
        along = lost.sum(axis=1) * (motion.time[rows] > motion.time[0])
        row = int(np.argmax(along))
        if worst is None or along[row] > worst.pressure:
            worst = _Loss(float(along[row]), float(motion.time[rows][row]))
    return worst


def _way(motion: Motion, length: float) -> float:
    """How far the tip goes from that of a straight rod [m]."""
    parts = (motion.tip[rows, :2] for rows in blocks(len(motion.tip), motion.tip))
    return max(float(np.max(np.hypot(tip[:, 0], tip[:, 1] - length))) for tip in parts)
