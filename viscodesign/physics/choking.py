"""Gas that accelerates along a tube, up to the speed at which the flow chokes."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from viscodesign.physics import gas

CHOKING_MACH = 0.8
"""Mach number near which a gas in a tube goes no faster, whatever drives it."""
MIN_MACH = 1e-7
"""Mach number at ambient density below which the pressure of choking is constant: a root must
have a slope at rest. That pressure is then no more than 0.1 Pa."""


def momentum_coefficient(density: float, radius: float) -> float:
    r"""Momentum flux per area of a flow, over the flow squared [Pa s^2/m^6].

    .. math:: b = \rho_0 / A^2, \quad A = \pi r^2

    At the density rho_0 [kg/m^3]; ``radius`` r [m]. Flat profile, as in turbulent flow.
    """
    return density / (math.pi * radius**2) ** 2


def mach_squared(flow: Any, ratio: Any, ambient: Any, exponent: float, coefficient: Any) -> Any:
    r"""Speed over that at which the gas chokes, squared [1].

    .. math:: M^2 = v^2 \rho / (n P)
                  = \frac{b q^2}{n P_0} \left(\frac{P}{P_0}\right)^{-(n + 1)/n}

    ``flow`` q at ambient density [m^3/s], ``ratio`` P/P_0 absolute over ``ambient`` [1],
    ``exponent`` n of the gas: for an isothermal gas the unit is the isothermal speed of sound,
    and 1 is a Mach number of 1/sqrt(gamma). ``coefficient`` b is `momentum_coefficient`.
    """
    return coefficient * flow**2 / (exponent * ambient) * ratio ** (-1 - 1 / exponent)


def choking_ratio(
    flow: Any, ambient: Any, exponent: float, coefficient: Any, functions: Any = np
) -> Any:
    r"""Absolute pressure at a tube's exit where it chokes, over ambient [1].

    .. math:: P^*/P_0 = \left(b q^2 / (n P_0)\right)^{n/(n + 1)}

    Where `mach_squared` is one; no gas leaves a tube at a lower pressure. Arguments as there.
    """
    squared = coefficient * flow**2 / (exponent * ambient) + MIN_MACH**2
    if exponent == 1.0:
        return functions.sqrt(squared)
    return squared ** (exponent / (exponent + 1))


def acceleration_drop(
    flow: Any,
    start: Any,
    end: Any,
    ambient: Any,
    exponent: float,
    coefficient: Any,
    functions: Any = np,
) -> Any:
    r"""Driving pressure that the gas's own change of speed takes up [Pa], choking included.

    .. math:: \Phi_a - \Phi(\hat P_a) - \Phi_b + \Phi(\hat P_b)
              + \frac{b q^2}{n} \ln \frac{\hat P_a}{\hat P_b}, \quad
              \hat P = \max(P, P^*(q))

    To be added to what friction takes up, so that with Phi of `gas.density_integral` the sum
    is the momentum balance of the tube, integrated from its start to its exit:

    .. math:: \frac{\rho}{\rho_0} \, dP = b q^2 \frac{d\rho}{\rho} - \text{friction}

    The exit has the pressure of the node behind it, or that of choking if this is higher; then
    nothing behind the exit acts on the flow. As the balance has its extreme there, flow and
    pressures are related by a function with continuous slopes, also where the flow reverses.
    Relative to friction the term is the Mach number squared: 1e-12 at Mach 1e-6.

    ``flow`` q from start to end at ambient density [m^3/s]; ``start``, ``end`` gauge pressures
    of the nodes [Pa]; the rest as of `mach_squared`. ``functions`` is numpy or casadi.
    Source: A. H. Shapiro, The Dynamics and Thermodynamics of Compressible Fluid Flow, vol. 1,
    1953, chapter 6; with K of the ends counted as friction, Crane TP 410, equation 1-6.
    """
    choking = choking_ratio(flow, ambient, exponent, coefficient, functions)
    limit = ambient * (choking - 1)

    def beyond(pressure: Any) -> Any:
        """What a pressure below that of choking does not drive [Pa]."""
        met = functions.fmax(pressure, limit)
        integral = gas.density_integral(pressure, ambient, exponent, functions)
        return integral - gas.density_integral(met, ambient, exponent, functions)

    before, behind = (functions.fmax(1 + p / ambient, choking) for p in (start, end))
    momentum = coefficient * flow**2 / exponent
    return beyond(start) - beyond(end) + momentum * functions.log(before / behind)
