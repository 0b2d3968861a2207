"""Flow through slender tubes, and the compliance of their walls."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

LAMINAR_REYNOLDS = 2300.0
"""Reynolds number up to which slow laminar flow is trusted."""


def hydraulic_resistance(viscosity: float, length: float, radius: float) -> float:
    r"""Resistance of a slender tube to slow flow [Pa s/m^3].

    .. math:: R = \Delta p / Q = 8 \mu l / (\pi r^4)

    Fully developed laminar flow of a Newtonian fluid, Re r/l << 1, rigid wall.
    ``viscosity`` mu [Pa s], ``length`` l [m], ``radius`` r [m].
    Source: Hagen-Poiseuille law; the lubrication limit of the paper, section 2.1.
    """
    return 8 * viscosity * length / (math.pi * radius**4)


def reynolds_number(
    flow: Any, density: Any, viscosity: Any, radius: Any, functions: Any = np
) -> Any:
    r"""Reynolds number of the mean flow, based on the tube's diameter [1].

    .. math:: Re = 2 \rho |Q| / (\pi \mu r)

    ``flow`` Q [m^3/s], ``density`` rho [kg/m^3], ``viscosity`` mu [Pa s], ``radius`` r [m].
    Pipe flow is laminar below about 2300. ``functions`` is numpy or casadi.
    """
    return 2 * density * functions.fabs(flow) / (math.pi * viscosity * radius)


def mean_speed(flow: np.ndarray, radius: np.ndarray) -> np.ndarray:
    """Speed averaged over the cross section [m/s] of ``flow`` [m^3/s] at ``radius`` [m]."""
    return np.asarray(np.abs(flow) / (math.pi * radius**2))


def friction_multiplier(reynolds: Any, functions: Any = np) -> Any:
    r"""Friction relative to laminar flow, f Re/64, at any Reynolds number [1].

    .. math:: f = 8 \left[ (8/Re)^{12} + (A + B)^{-3/2} \right]^{1/12}, \quad
              A = \left(2.457 \ln (Re/7)^{0.9}\right)^{16}, \quad B = (37530/Re)^{16}

    f is the Darcy friction factor of a smooth tube. ``reynolds`` Re, based on the diameter;
    ``functions`` is numpy or casadi. Within a few percent of the laminar law and of turbulent
    data. Source: S. W. Churchill, Friction-factor
    equation spans all fluid-flow regimes, Chemical Engineering 84 (24), 1977, 91-92.
    """
    # Below Re = 1 the turbulent part is negligible, and its terms would overflow.
    re = functions.fmax(reynolds, 1.0)
    a = (2.457 * 0.9 * functions.log(re / 7)) ** 16
    b = (37530 / re) ** 16
    return (1 + (re / 8) ** 12 / (a + b) ** 1.5) ** (1 / 12)


def local_loss_coefficient(density: float, loss: float, radius: float) -> float:
    r"""Pressure drop at a tube's ends per flow squared [Pa s^2/m^6].

    .. math:: \Delta p = K \rho q^2 / (2 A^2), \quad A = \pi r^2

    ``density`` rho [kg/m^3], ``radius`` r [m]; ``loss`` K [1] of entrance and exit together:
    about 0.5 for a sharp entrance and 1 for an exit into a wide bellow, where the jet dissipates.
    """
    return loss * density / (2 * (math.pi * radius**2) ** 2)


def fluid_inertance(density: float, length: float, radius: float) -> float:
    r"""Inertance of the fluid in a tube, pressure per rate of change of flow [kg/m^4].

    .. math:: I = \frac{4}{3} \frac{\rho L}{\pi r^2}

    ``density`` rho [kg/m^3], ``length`` L [m], ``radius`` r [m]. The factor 4/3 is that of the
    parabolic velocity profile of slow laminar flow; a flat profile has 1.
    """
    return 4 / 3 * density * length / (math.pi * radius**2)


def inner_volume(length: float, radius: float) -> float:
    """Volume inside a tube of ``length`` and ``radius`` [m], pi r^2 L [m^3]."""
    return math.pi * radius**2 * length


def wall_compliance(
    youngs_modulus: float, poissons_ratio: float, thickness: float, length: float, radius: float
) -> float:
    r"""Compliance of an elastic tube of fixed length, volume per inner pressure [m^3/Pa].

    .. math:: C_t = \frac{2 \pi r^2 L (1 + \nu)}{E}
              \frac{b^2 + (1 - 2\nu) r^2}{b^2 - r^2}, \quad b = r + \text{thickness}

    ``youngs_modulus`` E [Pa], ``poissons_ratio`` nu [1], ``thickness``, ``length`` L and inner
    ``radius`` r [m]. Thick-walled tube in plane strain, small strains; a thin wall has
    2 pi r^3 L (1 - nu^2)/(E thickness). Source: Lame's solution, for example
    Timoshenko and Goodier, Theory of Elasticity.
    """
    outer = radius + thickness
    shape = (outer**2 + (1 - 2 * poissons_ratio) * radius**2) / (
        thickness * (2 * radius + thickness)
    )
    return 2 * math.pi * radius**2 * length * (1 + poissons_ratio) / youngs_modulus * shape
