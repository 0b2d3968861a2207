"""The network by viscodesign: a scene of which only the network is asked for.

`prepare` reads the scene and solves it once, as whoever works with it does; measured is
a whole further solution with the equations at hand: the equilibrium at the start, the
steps through time, and reading all outputs and balances.
"""

from __future__ import annotations

from abc import ABC
from collections.abc import Callable
from pathlib import Path
from typing import Any, ClassVar

import network
import numpy as np

SCENE = Path(__file__).parents[2] / "configs" / "leg_16_straight_water.yaml"
ALONG_CHAIN = [
    *range(network.BELLOWS // 2),
    *reversed(range(network.BELLOWS // 2, network.BELLOWS)),
]
"""Places of R1..R8, L8..L1 among R1..R8, L1..L8."""
TOLERANCES = [3e-3, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8]


def overrides(fluid: str) -> list[str]:
    """What turns the published leg with water into its network alone, with any fluid."""
    return [
        f"fluid={{name: {fluid}, viscosity: {network.VISCOSITIES[fluid]!r}, density: 1000}}",
        "effects={pressure_distribution: on, others: off}",
        f"run={{duration: {network.DURATION}, output_interval: {network.INTERVAL}}}",
    ]


class Viscodesign(ABC):
    """One of its solvers, down a ladder of tolerances."""

    name: ClassVar[str]
    solver: ClassVar[str]

    def __init__(self, case: network.NetworkCase) -> None:
        self.fluid = case.fluid

    def settings(self) -> list[dict[str, Any]]:
        """Tolerances, coarse to fine."""
        return [{"tolerance": tolerance} for tolerance in TOLERANCES]

    def prepare(self, setting: dict[str, Any]) -> Callable[[], np.ndarray]:
        """Read, choose, and solve once."""
        from viscodesign import load
        from viscodesign.build import Settings
        from viscodesign.effects.conditions import Conditions
        from viscodesign.effects.select import select_effects
        from viscodesign.solving import solve

        conditions = Conditions(load(SCENE, overrides(self.fluid)))
        effects = select_effects(conditions).effects
        settings = Settings(1, setting["tolerance"], solver=self.solver)

        def run() -> np.ndarray:
            found = solve(conditions, effects, settings)
            if not found.is_complete:
                raise RuntimeError(str(found.motion.failure))
            return found.motion.pressure[:, ALONG_CHAIN]

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
