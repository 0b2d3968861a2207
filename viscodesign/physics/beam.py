"""Stiffness, mass and times of the solid, seen as a slender beam."""

from __future__ import annotations

import math

import numpy as np


def extension_stiffness(youngs_modulus: float, height: float, width: float, factor: float) -> float:
    r"""Extension stiffness of the cross section [N].

    .. math:: EA = E h_s w_s f_e

    ``factor`` f_e corrects a full rectangle for the real section.
    Source: the paper, section 2.1 (force scale N_e) and Experimental Section.
    """
    return youngs_modulus * height * width * factor


def bending_stiffness(youngs_modulus: float, height: float, width: float, factor: float) -> float:
    r"""Bending stiffness of the cross section [N m2].

    .. math:: EI = E f_i w_s h_s^3 / 12

    ``height`` h_s is the size in the plane of bending.
    Source: the paper, section 2.1 (force scale V_e) and Experimental Section.
    """
    return youngs_modulus * width * height**3 / 12 * factor


def mass_per_length(density: float, height: float, width: float, solid_fraction: float) -> float:
    r"""Mass per reference length [kg/m].

    .. math:: m = \rho_s h_s w_s f_m

    Source: the paper, Experimental Section (0.269 kg/m).
    """
    return density * height * width * solid_fraction


def elastic_inertial_time(mass_per_length: float, length: float, bending_stiffness: float) -> float:
    r"""Elastic-inertial time of the solid [s].

    .. math:: t_s = \sqrt{m l^4 / (E I)}

    The first bending mode of a clamped-free beam swings with the angular
    frequency 3.516/t_s. Source: the paper, section 2.1 (0.029 s for its leg).
    """
    return math.sqrt(mass_per_length * length**4 / bending_stiffness)


def inner_fibre_stretch(length: np.ndarray, height: float, turn: np.ndarray) -> np.ndarray:
    """Length of the inner side of a bent section, over the length of its axis [1].

    ``length`` of the axis [m], ``height`` in the plane of bending [m], ``turn``
    [rad]. At or below zero the neighbouring sections touch.
    """
    return np.asarray(1.0 - np.abs(turn) * height / 2 / np.maximum(length, 1e-300))
