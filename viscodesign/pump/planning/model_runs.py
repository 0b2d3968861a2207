"""A scene run for a plan: for its inlets alone, or as a simulation with its error."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from viscodesign.effects.catalogue import catalogue
from viscodesign.errors import SolveError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.interrupt import gentle_interrupt
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.scene import Scene
from viscodesign.simulation.build_problem import suggest_settings
from viscodesign.simulation.simulate import simulate
from viscodesign.simulation.solve_once import Progress, solve


@dataclass(frozen=True)
class InletHistory:
    """What happens at P inlets at T times."""

    time: np.ndarray
    """(T,) [s]"""
    pressure: np.ndarray
    """(T, P) gauge [Pa]."""
    given: np.ndarray
    """(T, P) to the network since it was filled [m3 at ambient density]."""

    @classmethod
    def of(cls, run: Trajectory) -> InletHistory:
        """That of a run."""
        return cls(run.time, run["inlet_pressure"], run["inflow"])


def active_effects(run: Trajectory) -> frozenset[str]:
    """Names of the effects that a run took in."""
    return frozenset(v.name for v in run.effects if v.taken)


def run_model(scene: Scene, active: frozenset[str]) -> InletHistory:
    """The inlets of a scene with just these effects; `SolveError` where the run breaks off."""
    quantities = SceneQuantities(scene)
    effects = [kind.of(quantities) for name, kind in catalogue().items() if name in active]
    run = solve(quantities, effects, suggest_settings(quantities, effects))
    if run.solution.asked_to_stop:
        # Even where it had just been solved: a plan has more to do.
        raise KeyboardInterrupt
    if run.motion.failure is not None:
        raise _broken_off(str(run.motion.failure), run.motion.time)
    return InletHistory(run.motion.time, run.motion["inlet_pressure"], run.motion["inflow"])


def run_verified(scene: Scene, progress: Progress | None) -> Trajectory:
    """A whole run with its error; `SolveError` in its own words where it broke off."""
    with gentle_interrupt() as interrupt:
        run = simulate(scene, progress=progress)
    if interrupt.asked or run.status == "interrupted":
        raise KeyboardInterrupt
    if run.status == "failed" and run.accuracy.estimated_tip_error_m is None:
        raise _broken_off(run.failure or "no reason given", run.time)
    return run


def _broken_off(reason: str, times: np.ndarray) -> SolveError:
    return SolveError(
        f"the plan's simulation failed: {reason}",
        quantity="motion",
        where="plan",
        time_s=float(times[-1]) if times.size else 0.0,
    )
