"""A barotropic gas: density follows pressure alone, (rho/rho_0)^n = P/P_0."""

from __future__ import annotations

from typing import Any

import numpy as np

VACUUM = 1e-3
"""Absolute over ambient pressure below which a gas thins no further.

No pump comes there; an input that asks for less than a vacuum finds a thin gas that
still has a density, and a warning is given.
"""


def density_ratio(pressure: Any, ambient: Any, exponent: float, functions: Any = np) -> Any:
    r"""Density over that at ambient pressure [1].

    .. math:: \rho/\rho_0 = (P/P_0)^{1/n}, \quad P = P_0 + p

    ``pressure`` p gauge [Pa], ``ambient`` P_0 absolute [Pa]; ``exponent`` n is 1 for a
    gas that keeps its temperature, the ratio of heat capacities for one that exchanges
    no heat. ``functions`` offers `fmax`, `log` and `expm1` (numpy or CasADi).
    """
    ratio = functions.fmax(1 + pressure / ambient, VACUUM)
    return ratio if exponent == 1.0 else ratio ** (1 / exponent)


def density_integral(pressure: Any, ambient: Any, exponent: float, functions: Any = np) -> Any:
    r"""What drives a mass flow through a laminar tube [Pa].

    .. math:: \Phi(p) = \int_0^p \rho/\rho_0 \, dp

    With constant viscosity the mass flow over rho_0 is (Phi_a - Phi_b)/R: the law of
    Hagen-Poiseuille for each slice of the tube, integrated along it.
    """
    ratio = functions.fmax(1 + pressure / ambient, VACUUM)
    power = 1 + 1 / exponent
    raised = ratio * ratio if exponent == 1.0 else ratio**power
    beyond = 1 + pressure / ambient - ratio
    thin = density_ratio(pressure, ambient, exponent, functions)
    return ambient * ((raised - 1) / power + beyond * thin)


def specific_work(pressure: Any, ambient: Any, exponent: float, functions: Any = np) -> Any:
    r"""Work that a unit of gas, measured as volume at ambient density, can do [Pa].

    .. math:: h(p) = \int_0^p \rho_0/\rho \, dp

    For small pressures it is the pressure itself.
    """
    ratio = functions.fmax(1 + pressure / ambient, VACUUM)
    power = 1 - 1 / exponent
    logarithm = functions.log(ratio)
    # Not ratio**power - 1: beside 1, a power near 0 would lose its digits.
    done = logarithm if exponent == 1.0 else functions.expm1(power * logarithm) / power
    beyond = 1 + pressure / ambient - ratio
    return ambient * (done + beyond / density_ratio(pressure, ambient, exponent, functions))


def gas_compliance(volume: float, absolute_pressure: float, exponent: float) -> float:
    r"""Volume at its own density that a gas takes up per pressure [m3/Pa].

    .. math:: C_g = V / (n P)
    """
    return volume / (exponent * absolute_pressure)
