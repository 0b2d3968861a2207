"""Characteristic times of the fluid in its network."""

from __future__ import annotations

import math

import numpy as np

LARGEST_TIME_RATIO = 1e14
"""Ratio of two times that double precision still carries."""


def viscous_elastic_time(
    viscosity: float, area_per_pressure: float, tube_radius: float, total_tube_length: float
) -> float:
    r"""Viscous-elastic time of the fluid [s].

    .. math:: t_f = \frac{\mu \, \partial a/\partial p}{a_0 \epsilon_1^2},
              \quad a_0 = \pi r_c^2, \quad \epsilon_1 = 2 r_c / l

    ``viscosity`` mu [Pa s], ``area_per_pressure`` da/dp [m^2/Pa], ``tube_radius`` r_c [m],
    ``total_tube_length`` l of all tubes together [m]. Order of magnitude of a chain of bellows.
    Source: the paper, section 2.1 (0.157 s for its leg, which is the value of air).
    """
    a_0 = math.pi * tube_radius**2
    epsilon_1 = 2 * tube_radius / total_tube_length
    return viscosity * area_per_pressure / (a_0 * epsilon_1**2)


def slowest_network_time(conductance: np.ndarray, compliance: np.ndarray, *, sealed: bool) -> float:
    """Slowest time constant of one connected resistor-capacitor network [s].

    ``conductance`` (B, B): symmetric, of the nodes with volume, fixed pressures and junctions
    eliminated [m^3/(Pa s)]; ``compliance`` (B,) [m^3/Pa]. The inverse of the smallest generalized
    eigenvalue of conductance and compliance; the zero eigenvalue of a sealed network, its mean
    pressure, is left out. An eigenvalue below the rounding error of the largest one is replaced by
    it, and the time is then a lower bound.
    """
    root = 1.0 / np.sqrt(compliance)
    rates = np.linalg.eigvalsh(root[:, None] * conductance * root[None, :])
    settling = rates[1:] if sealed else rates
    if not settling.size:
        return 0.0
    least = len(rates) * np.finfo(float).eps * rates[-1]
    return float(1.0 / max(settling[0], least))


def cutoff_frequency(viscous_elastic_time: float) -> float:
    """Frequency above which the actuator filters the input, 10/t_f [Hz].

    Order of magnitude only. Source: the paper, section 3.2.
    """
    return 10.0 / viscous_elastic_time
