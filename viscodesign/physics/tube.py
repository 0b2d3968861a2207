"""Flow through slender tubes."""

from __future__ import annotations

import math

import numpy as np


def hydraulic_resistance(viscosity: float, length: float, radius: float) -> float:
    r"""Resistance of a slender tube to slow flow [Pa s/m3].

    .. math:: R = \Delta p / Q = 8 \mu l / (\pi r^4)

    Fully developed laminar flow of a Newtonian fluid, Re r/l << 1, rigid wall.
    ``viscosity`` mu [Pa s], ``length`` l [m], ``radius`` r [m].
    Source: Hagen-Poiseuille law; the lubrication limit of the paper, section 2.1.
    """
    return 8 * viscosity * length / (math.pi * radius**4)


def reynolds_number(
    flow: np.ndarray, density: float, viscosity: float, radius: np.ndarray
) -> np.ndarray:
    r"""Reynolds number of the mean flow on the tube's diameter [1].

    .. math:: Re = 2 \rho |Q| / (\pi \mu r)

    ``flow`` Q [m3/s]. Pipe flow stays laminar below about 2300.
    """
    return np.asarray(2 * density * np.abs(flow) / (math.pi * viscosity * radius))


def mean_speed(flow: np.ndarray, radius: np.ndarray) -> np.ndarray:
    """Mean speed of the flow over the tube's cross section [m/s]."""
    return np.asarray(np.abs(flow) / (math.pi * radius**2))
