"""The whole coupled problem: the published leg, rod and network acting on each other.

Sixteen bellows filled through one chain of tubes bend and stretch a rod with inertia and
material damping; the rod's forces and moments change the bellows' volumes in turn. The
scene is configs/leg_16_straight_air.yaml as it is, 8 s with an output every 20 ms; what
is compared is the path of the tip, its largest error over the actuator's length.

Nobody else publishes a solver of this problem. What stands against viscodesign is the
script that somebody who needs it today would write, with SciPy: coupled_scipy.py.

The reference is viscodesign's at 16 edges a section and a tolerance of 1e-8. It is held
against the script, which shares no line with it and discretises the rod in another way:
both come to the same tip, as make_coupled_reference.py shows and its file keeps.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from race import Case

SCENE = Path(__file__).parents[2] / "configs" / "leg_16_straight_air.yaml"
DATA = Path(__file__).parent / "data" / "coupled.npz"
LENGTH = 0.109
"""Of the actuator [m]."""
DURATION, INTERVAL = 8.0, 0.02
"""[s]"""
TIMES = np.linspace(0.0, DURATION, round(DURATION / INTERVAL) + 1)


@dataclass(frozen=True)
class CoupledCase(Case):
    """A case whose reference is stored by its name."""

    def reference(self) -> np.ndarray:
        """Position x, z of the tip (T, 2) [m]."""
        with np.load(DATA) as stored:
            return np.asarray(stored[self.name])


CASES = [
    CoupledCase(
        name="leg_8s",
        title="Sixteen-bellow leg, air, network and rod coupled both ways, 8 s",
        times=TIMES,
        quantity="position of the tip [m]",
        scale=LENGTH,
        reference_error=1e-6,
        norm="euclid",
        contestants=[
            "coupled_viscodesign:Idas",
            "coupled_viscodesign:Rosenbrock",
            "coupled_viscodesign:Called",
            "coupled_scipy:Bdf",
            "coupled_scipy:Radau",
            "coupled_scipy:Lsoda",
        ],
    )
]
