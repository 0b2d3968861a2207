"""The coupled problem by viscodesign: the published scene as it is.

`prepare` reads the scene and solves it once, as whoever works with it does; measured is
a whole further solution with the equations at hand: the equilibrium at the start, the
steps through time, and reading all outputs and balances.
"""

from __future__ import annotations

from abc import ABC
from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np
from coupled import SCENE, CoupledCase

LADDER = [(1, 1e-3), (1, 1e-4), (2, 1e-4), (2, 1e-5), (4, 1e-6), (8, 1e-7)]
"""Edges per section and tolerance, refined together."""


class Viscodesign(ABC):
    """One of its solvers."""

    name: ClassVar[str]
    solver: ClassVar[str]

    def __init__(self, case: CoupledCase) -> None:
        del case  # there is one

    def settings(self) -> list[dict[str, Any]]:
        """Meshes and tolerances, coarse to fine."""
        return [{"edges_per_section": edges, "tolerance": tol} for edges, tol in LADDER]

    def prepare(self, setting: dict[str, Any]) -> Callable[[], np.ndarray]:
        """Read, choose, and solve once."""
        from viscodesign import load
        from viscodesign.build import Settings
        from viscodesign.effects.conditions import Conditions
        from viscodesign.effects.select import select_effects
        from viscodesign.solving import solve

        conditions = Conditions(load(SCENE))
        effects = select_effects(conditions).effects
        settings = Settings(setting["edges_per_section"], setting["tolerance"], solver=self.solver)

        def run() -> np.ndarray:
            found = solve(conditions, effects, settings)
            if not found.is_complete:
                raise RuntimeError(str(found.motion.failure))
            return found.motion.tip[:, :2]

        run()
        return run


class Idas(Viscodesign):
    """BDF of IDAS."""

    name = "viscodesign (IDAS)"
    solver = "idas"


class Rosenbrock(Viscodesign):
    """Rodas5P."""

    name = "viscodesign (Rodas5P)"
    solver = "rosenbrock"
