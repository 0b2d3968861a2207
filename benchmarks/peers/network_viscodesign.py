"""The network by viscodesign: a scene of which only the network is asked for."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import network
from ours import Ours

if TYPE_CHECKING:
    import numpy as np

    from viscodesign.results.motion_arrays import MotionArrays
    from viscodesign.scene.scene import Scene

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


class Viscodesign(Ours):
    """One of its solvers, down a ladder of tolerances."""

    def __init__(self, case: network.NetworkCase) -> None:
        self.fluid = case.fluid

    def ladder(self) -> list[dict[str, Any]]:
        return [{"tolerance": tolerance} for tolerance in TOLERANCES]

    def scene(self, *more: str) -> Scene:
        from viscodesign import load

        return load(SCENE, [*overrides(self.fluid), *more])

    def values(self, motion: MotionArrays) -> np.ndarray:
        return motion.pressure[:, ALONG_CHAIN]


class Idas(Viscodesign):
    """BDF of IDAS."""

    name = "viscodesign (IDAS)"
    solver = "idas"


class Rosenbrock(Viscodesign):
    """Rodas5P."""

    name = "viscodesign (Rodas5P)"
    solver = "rosenbrock"


class Modes(Viscodesign):
    """The network's modes, which no tolerance changes."""

    name = "viscodesign (modes)"
    solver = "modes"

    def ladder(self) -> list[dict[str, Any]]:
        return [{"tolerance": TOLERANCES[-1]}]


class Called(Viscodesign):
    """Asked for an accuracy; effects, tolerance and solver are the program's choice."""

    name = "viscodesign (by accuracy)"
    solver = None
