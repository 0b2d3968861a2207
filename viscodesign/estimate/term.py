"""What one term of the balances adds to an estimate of the motion."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.scene_number import Numbers

WallLaw = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray, np.ndarray]]
"""Gauge pressures [Pa] -> volume beyond rest [m3], curvature [1/m] and stretch [1] of each."""
LossLaw = Callable[[np.ndarray], np.ndarray]
"""Flows (T, Q) [m3/s] -> pressure loss over that of slow laminar flow (T, Q) [1]."""
ModalMass = Callable[[float, bool], float]
"""(length [m], whether the rod is damped) -> mass added to the first bending mode, relative [1]."""


class CompressibleFluid(Protocol):
    """A fluid whose density follows pressure, and which therefore stores volume of its own."""

    def density(self, pressure: np.ndarray, ambient: float) -> np.ndarray:
        """Density over that at ambient pressure [1]; ``pressure`` gauge, ``ambient`` absolute."""

    def compliance(self, volume: np.ndarray, absolute: np.ndarray) -> np.ndarray:
        """Volume per pressure [m3/Pa] of an amount [m3] at an absolute pressure [Pa]."""


@dataclass(frozen=True, kw_only=True)
class EstimateTerm:
    """Contributions to the sums of an estimate; what is not given contributes nothing.

    Numbers add up over the terms; of laws that replace one another, the last one counts.
    """

    distributed: bool = False
    """Whether pressures differ along a network; without, every network has one pressure."""
    storage: tuple[tuple[str, float], ...] = ()
    """Volume per pressure that a node stores besides its bellow: (node, [m3/Pa])."""
    flow_loss: LossLaw | None = None
    inertance: tuple[float, ...] = ()
    """Pressure per rate of flow of every tube (Q,) [kg/m4]."""
    wall: WallLaw | None = None
    """In place of the linear law of a bellow."""
    fluid: CompressibleFluid | None = None
    """In place of an incompressible fluid."""
    acceleration: tuple[float, float] = (0.0, 0.0)
    """Force per mass on all masses (x, z) [m/s2]."""
    tip_force: tuple[float, float] = (0.0, 0.0)
    """Dead force at the tip (x, z) [N]."""
    tip_mass: float = 0.0
    """[kg]"""
    held_density: float = 0.0
    """Density at which what the bellows hold counts as a mass [kg/m3]."""
    resists_acceleration: bool = False
    """Whether masses have inertia; without, the rod is quasi-static."""
    modal_mass: ModalMass | None = None
    shear_compliance: float = 0.0
    """Shear angle of the axis per transverse force [1/N]."""
    damping_time: float = 0.0
    """Retardation time of the rod's strains [s]."""
    volume_per_force: Numbers = 0.0
    """Volume that a bellow takes up per normal force in its section, one or (B,) [m3/N]."""
    volume_per_moment: Numbers = 0.0
    """The same per moment, with opposite signs left and right [m3/(N m)]."""
