"""Stiffness, mass and characteristic time of the body as a slender beam."""

from __future__ import annotations

import math

import numpy as np


def extension_stiffness(youngs_modulus: float, height: float, width: float, factor: float) -> float:
    r"""Extension stiffness of the cross section [N].

    .. math:: EA = E h_s w_s f_e

    ``youngs_modulus`` E [Pa], ``height`` h_s and ``width`` w_s [m]; ``factor`` f_e [1] corrects
    the solid rectangle for the real section. Linear elasticity, small strains.
    Source: the paper, section 2.1 (force scale N_e) and Experimental Section.
    """
    return youngs_modulus * height * width * factor


def bending_stiffness(youngs_modulus: float, height: float, width: float, factor: float) -> float:
    r"""Bending stiffness of the cross section [N m^2].

    .. math:: EI = E f_i w_s h_s^3 / 12

    ``youngs_modulus`` E [Pa], ``height`` h_s in the bending plane and ``width`` w_s [m]; ``factor``
    f_i [1] corrects the solid rectangle for the real section. Linear elasticity, slender beam.
    Source: the paper, section 2.1 (force scale V_e) and Experimental Section.
    """
    return youngs_modulus * width * height**3 / 12 * factor


SHEAR_CORRECTION = 5 / 6
"""Shear correction factor kappa of a solid rectangle [1]: its shear stress is a parabola across
the height."""
SHEAR_MODULUS_RATIO = 1 / 3
"""G/E of an incompressible material [1]."""


def shear_stiffness(youngs_modulus: float, height: float, width: float, factor: float) -> float:
    r"""Shear stiffness of the cross section [N].

    .. math:: \kappa G A = \tfrac{5}{6} \tfrac{E}{3} h_s w_s f_s

    ``youngs_modulus`` E [Pa], ``height`` h_s and ``width`` w_s [m]; ``factor`` f_s [1] corrects
    the solid rectangle for the real section. An incompressible material, G = E/3.
    Source: Timoshenko's beam, with the correction that equal energies of a parabolic and of an
    even stress give (Reissner).
    """
    modulus = SHEAR_MODULUS_RATIO * youngs_modulus
    return SHEAR_CORRECTION * modulus * height * width * factor


def mass_per_length(density: float, height: float, width: float, solid_fraction: float) -> float:
    r"""Mass per length of the undeformed body [kg/m].

    .. math:: m = \rho_s h_s w_s f_m

    ``density`` rho_s [kg/m^3], ``height`` h_s and ``width`` w_s [m];
    ``solid_fraction`` f_m [1] of the cross section.
    Source: the paper, Experimental Section (0.269 kg/m).
    """
    return density * height * width * solid_fraction


def elastic_inertial_time(mass_per_length: float, length: float, bending_stiffness: float) -> float:
    r"""Elastic-inertial time of the body [s].

    .. math:: t_s = \sqrt{m l^4 / (E I)}

    ``mass_per_length`` m [kg/m], ``length`` l [m], ``bending_stiffness`` EI [N m^2]. The first
    bending mode of a uniform cantilever has the angular frequency 3.516/t_s.
    Source: the paper, section 2.1 (0.029 s for its leg).
    """
    return math.sqrt(mass_per_length * length**4 / bending_stiffness)


def inner_fibre_stretch(
    length: np.ndarray, height: float | np.ndarray, turn: np.ndarray
) -> np.ndarray:
    r"""Length of the inner side of a bent section relative to that of its axis [1].

    .. math:: \lambda_i = 1 - |\theta| h / (2 l)

    ``length`` l of the axis [m] (n,), ``height`` h in the bending plane [m], ``turn`` theta [rad]
    (n,). A section bent to a circular arc; at or below zero, neighbouring sections touch.
    """
    return np.asarray(1.0 - np.abs(turn) * height / 2 / np.maximum(length, 1e-300))
