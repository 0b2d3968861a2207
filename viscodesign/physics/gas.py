"""A barotropic (polytropic) gas: (rho/rho_0)^n = P/P_0."""

from __future__ import annotations

from typing import Any

import numpy as np

MIN_PRESSURE_RATIO = 1e-3
"""Absolute over ambient pressure below which the density is constant.

No pump reaches it; an input below a vacuum finds a thin gas that still has a density, and a
warning is given.
"""


def density_ratio(pressure: Any, ambient: Any, exponent: float, functions: Any = np) -> Any:
    r"""Density relative to that at ambient pressure [1].

    .. math:: \rho/\rho_0 = (P/P_0)^{1/n}, \quad P = P_0 + p

    ``pressure`` p gauge [Pa], ``ambient`` P_0 absolute [Pa]; ``exponent`` n is 1 for an isothermal
    and the ratio of heat capacities for an adiabatic ideal gas. ``functions`` is numpy or casadi.
    """
    ratio = functions.fmax(1 + pressure / ambient, MIN_PRESSURE_RATIO)
    return ratio if exponent == 1.0 else ratio ** (1 / exponent)


def density_integral(pressure: Any, ambient: Any, exponent: float, functions: Any = np) -> Any:
    r"""Integral of the density ratio, the potential of laminar mass flow [Pa].

    .. math:: \Phi(p) = \int_0^p \rho/\rho_0 \, dp

    The mass flow from a to b over rho_0 is (Phi_a - Phi_b)/R, with R the resistance of the tube:
    the Hagen-Poiseuille law of each slice, integrated along the tube. Constant viscosity, Mach
    number well below 1. Arguments as of `density_ratio`.
    """
    ratio = functions.fmax(1 + pressure / ambient, MIN_PRESSURE_RATIO)
    power = 1 + 1 / exponent
    raised = ratio * ratio if exponent == 1.0 else ratio**power
    beyond = 1 + pressure / ambient - ratio
    thin = density_ratio(pressure, ambient, exponent, functions)
    return ambient * ((raised - 1) / power + beyond * thin)


def specific_work(pressure: Any, ambient: Any, exponent: float, functions: Any = np) -> Any:
    r"""Work per volume at ambient density that the gas can do [Pa].

    .. math:: h(p) = \int_0^p \rho_0/\rho \, dp

    Equal to the gauge pressure if that is small. Arguments as of `density_ratio`.
    """
    ratio = functions.fmax(1 + pressure / ambient, MIN_PRESSURE_RATIO)
    power = 1 - 1 / exponent
    logarithm = functions.log(ratio)
    # expm1 instead of ratio**power - 1, which loses digits if the power is near 0.
    done = logarithm if exponent == 1.0 else functions.expm1(power * logarithm) / power
    beyond = 1 + pressure / ambient - ratio
    return ambient * (done + beyond / density_ratio(pressure, ambient, exponent, functions))


def gas_compliance(volume: float, absolute_pressure: float, exponent: float) -> float:
    r"""Compliance of an enclosed gas, volume at its own density per pressure [m^3/Pa].

    .. math:: C_g = V / (n P)

    ``volume`` V [m^3], ``absolute_pressure`` P [Pa], polytropic ``exponent`` n [1].
    """
    return volume / (exponent * absolute_pressure)
