"""The network alone: sixteen bellows in a chain, driven by the published pulse.

Every contestant solves the same linear equations, sixteen tanks behind sixteen tubes:

    C dp_i/dt = (p_{i-1} - p_i)/R + (p_{i+1} - p_i)/R,    p_0 = inlet, nothing after p_16

All bellows start at the inlet's first pressure. What is compared are the sixteen gauge
pressures every 50 ms over 6 s, the largest error anywhere over the swing of the inlet.

- `network_water`: mu = 1 mPa s, RC = 0.526 s a tube. Stiff, the far end hardly moves.
- `network_air`: mu = 20 uPa s, RC = 10.5 ms a tube. The same with a fluid fifty times
  thinner; its compressibility is left out, so that everyone solves the same model.

References are integrals of the modes by quadrature, good to 1e-9 of the swing:
make_network_references.py.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from race import Case

DATA = Path(__file__).parent / "data" / "network.npz"
BELLOWS = 16
COMPLIANCE = 6.1434e-11
"""Of a bellow [m3/Pa]."""
REST_VOLUME = 2.16e-6
"""Of a bellow [m3]."""
TUBE_LENGTH, TUBE_RADIUS = 0.0375, 3.25e-4
"""Of each of the sixteen tubes, the inlet's included [m]."""
START, DROP = 40_410.0, 141_300.0
"""Of the pulse, gauge [Pa]."""
FALL_TIME, RISE_TIME, TRANSITION = 0.5, 4.0, 0.875
"""Centres and length of the pulse's sigmoids [s]."""
DURATION, INTERVAL = 6.0, 0.05
"""[s]"""
TIMES = np.linspace(0.0, DURATION, round(DURATION / INTERVAL) + 1)
VISCOSITIES = {"water": 1e-3, "air": 2e-5}
"""[Pa s]"""


def inlet_pressure(t: float) -> float:
    """Gauge pressure of the inlet [Pa] at time t [s]: two sigmoids, as tanh."""
    rate = 6 / TRANSITION
    fall, rise = math.tanh(rate * (t - FALL_TIME)), math.tanh(rate * (t - RISE_TIME))
    return START + DROP / 2 * (rise - fall)


def resistance(fluid: str) -> float:
    """Of each tube [Pa s/m3], Hagen-Poiseuille."""
    return 8 * VISCOSITIES[fluid] * TUBE_LENGTH / (math.pi * TUBE_RADIUS**4)


def rate_matrix(fluid: str) -> tuple[np.ndarray, np.ndarray]:
    """A (16, 16) and b (16,) of dp/dt = A p + b p_inlet [1/s]."""
    ones = np.ones(BELLOWS - 1)
    a = np.diag(np.full(BELLOWS, -2.0)) + np.diag(ones, 1) + np.diag(ones, -1)
    a[-1, -1] = -1.0
    b = np.eye(BELLOWS)[0]
    return a / (resistance(fluid) * COMPLIANCE), b / (resistance(fluid) * COMPLIANCE)


@dataclass(frozen=True)
class NetworkCase(Case):
    """A case whose reference is stored by its name."""

    fluid: str = "water"

    def reference(self) -> np.ndarray:
        """Pressures of all bellows (T, 16) [Pa]."""
        with np.load(DATA) as stored:
            return np.asarray(stored[self.name])


CONTESTANTS = [
    "network_viscodesign:Modes",
    "network_viscodesign:Called",
    "network_viscodesign:Idas",
    "network_viscodesign:Rosenbrock",
    "network_scipy:Bdf",
    "network_scipy:Lsoda",
    "network_scipy:Radau",
    "network_fonsim:FixedStep",
    "network_fonsim:AdaptiveStep",
    "network_ngspice:Trapezoidal",
    "network_ngspice:Gear",
]

CASES = [
    NetworkCase(
        name=f"network_{fluid}",
        title=f"Sixteen bellows in a chain, {fluid}, the published pulse, 6 s",
        times=TIMES,
        quantity="pressures of all bellows [Pa]",
        scale=DROP,
        reference_error=1e-9,
        norm="max",
        contestants=CONTESTANTS,
        fluid=fluid,
    )
    for fluid in VISCOSITIES
]
