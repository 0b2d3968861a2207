"""A found design simulated with the effects that it calls for, and its error stated."""

from __future__ import annotations

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.inverse.tip_residuals import PathDistance, distance
from viscodesign.inverse.wanted_path import WantedPath
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.scene import Scene
from viscodesign.simulation.simulate import simulate


@dataclass(frozen=True, eq=False)
class Confirmation:
    """What `simulate` says of a design."""

    run: Trajectory
    tip: np.ndarray
    """(T, 2) [m]"""
    distance: PathDistance

    @property
    def effects(self) -> tuple[str, ...]:
        """Those that the run included."""
        return tuple(verdict.name for verdict in self.run.effects if verdict.taken)


def confirm(wanted: WantedPath, scene: Scene, tolerance_m: float) -> Confirmation:
    """Simulate a design. Raises `SolveError` where the run does not reach its end."""
    run = simulate(scene)
    tip = tip_of(wanted, scene, run)
    return Confirmation(run, tip, distance(wanted, tip, tolerance_m))


def tip_of(wanted: WantedPath, scene: Scene, run: Trajectory) -> np.ndarray:
    """(T, 2) The path of a run's tip [m]; of a loop without its end, which is its beginning."""
    tip = np.asarray(run.tip)[:, :2]
    if len(tip) < len(scene.run.output_times_array()):
        raise SolveError(
            f"the run ended early: {run.failure or run.status}",
            quantity="tip",
            where="rod",
            time_s=float(run.time[-1]) if len(run.time) else 0.0,
        )
    return tip[:-1] if wanted.is_free_loop else tip
