"""The rod alone: a planar cantilever that nothing damps, driven or released.

Everyone solves the same rod: clamped at the origin, straight along +z at rest, free to
stretch, not to shear, its mass on its axis (no rotary inertia, no damping). What a tool
cannot leave out (shear, rotary inertia) or cannot have (stretch) is told in its file.
Compared is the position x, z of the tip.

- `cycle_fast`: uniform intrinsic curvature 12 (1 - cos(2 pi t / 0.5 s))/2 1/m for 1 s,
  outputs every 10 ms. The tip goes 62 mm to the side; inertia matters.
- `cycle_slow`: the same with a period of 8 s for 8 s, outputs every 50 ms. All but
  quasi-static: whoever can take long steps is at an advantage.
- `release`: no curvature; 1 g acts along +x at once on the straight rod, 1 s, outputs
  every 5 ms. It swings by 2.1 mm, so errors are over the largest
  displacement of the tip, not over the length.
- `release_heavy`: the same with 100 g, large deflection; errors are over the length.

The references come from make_references.py, a spectral method of its own.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from race import Case

DATA = Path(__file__).parent / "data" / "rod.npz"
LENGTH = 0.109
"""[m]"""
BENDING_STIFFNESS = 0.04455
"""EI [N m2]"""
EXTENSION_STIFFNESS = 572.4
"""EA [N]"""
MASS_PER_LENGTH = 0.269
"""[kg/m]"""
CURVATURE = 12.0
"""Largest intrinsic curvature of the cycles [1/m]."""
GRAVITY = 9.80665
"""[m/s2]"""


@dataclass(frozen=True)
class RodCase(Case):
    """One motion of the rod; its reference is stored by its name."""

    period: float = math.inf
    """Of the intrinsic curvature; infinite: there is none [s]."""
    gravity: float = 0.0
    """Along +x from t = 0 on [m/s2]."""

    @property
    def duration(self) -> float:
        """Simulated time [s]."""
        return float(self.times[-1])

    def curvature(self, t: float) -> float:
        """Intrinsic curvature of the whole rod [1/m] at time t [s]."""
        return CURVATURE * (1 - math.cos(2 * math.pi * t / self.period)) / 2

    def reference(self) -> np.ndarray:
        """Position x, z of the tip (T, 2) [m]."""
        with np.load(DATA) as stored:
            return np.asarray(stored[self.name])


CONTESTANTS = [
    "rod_viscodesign:Idas",
    "rod_viscodesign:Rosenbrock",
    "rod_viscodesign:Called",
    "rod_exudyn:Cables",
    "rod_exudyn:Beams",
    "rod_mujoco:ChainImplicit",
    "rod_mujoco:ChainRungeKutta",
    "rod_pyelastica:Verlet",
    "rod_soromox:Explicit",
    "rod_soromox:Implicit",
    "rod_scipy:Radau",
    "rod_scipy:Bdf",
]

RIGID = ("rod_mujoco", "rod_pyelastica")
"""Not in the heavy release: one cannot stretch, the other does not come near in any time."""


def _times(duration: float, interval: float) -> np.ndarray:
    return np.linspace(0.0, duration, round(duration / interval) + 1)


CASES = [
    RodCase(
        name="cycle_fast",
        title="Rod, intrinsic curvature of 12/m in a cycle of 0.5 s, 1 s",
        times=_times(1.0, 0.01),
        quantity="position of the tip, over the length",
        scale=LENGTH,
        reference_error=1e-7,
        norm="euclid",
        contestants=CONTESTANTS,
        period=0.5,
    ),
    RodCase(
        name="cycle_slow",
        title="Rod, intrinsic curvature of 12/m in a cycle of 8 s, 8 s",
        times=_times(8.0, 0.05),
        quantity="position of the tip, over the length",
        scale=LENGTH,
        reference_error=1e-7,
        norm="euclid",
        contestants=CONTESTANTS,
        period=8.0,
    ),
    RodCase(
        name="release",
        title="Rod, 1 g at once across it, 1 s",
        times=_times(1.0, 0.005),
        quantity="position of the tip, over its largest displacement",
        scale=2.117e-3,
        reference_error=1e-5,
        norm="euclid",
        contestants=CONTESTANTS,
        gravity=GRAVITY,
    ),
    RodCase(
        name="release_heavy",
        title="Rod, 100 g at once across it, 1 s",
        times=_times(1.0, 0.005),
        quantity="position of the tip, over the length",
        scale=LENGTH,
        reference_error=4.3e-5,
        norm="euclid",
        contestants=[c for c in CONTESTANTS if not c.startswith(RIGID)],
        gravity=100 * GRAVITY,
    ),
]
