"""Linear laws of a bellow, and the meeting of its walls under vacuum."""

from __future__ import annotations

import math
from typing import Any

import numpy as np


def rest_volume(height: float, width: float, length: float) -> float:
    """Volume of a bellow at zero gauge pressure, V_0 = h_b w_b l_b [m^3], from its sides [m]."""
    return height * width * length


def compliance(length: float, area_per_pressure: float) -> float:
    r"""Compliance of a free bellow, its volume per pressure [m^3/Pa].

    .. math:: C = l_b \, \partial a / \partial p

    ``length`` l_b along the flow [m], ``area_per_pressure`` [m^2/Pa]. Small strains.
    Source: the paper, equation (1), integrated along one bellow.
    """
    return length * area_per_pressure


def curvature_per_pressure(
    angle_per_pressure: float, youngs_modulus: float, section_length: float
) -> float:
    r"""Intrinsic curvature per pressure difference (left - right) [1/(m Pa)].

    .. math:: \kappa_p = \frac{\partial\psi}{\partial(p'/E)} \frac{p_L - p_R}{E} \frac{S}{l}

    ``angle_per_pressure`` dpsi/d(p'/E) [rad], ``youngs_modulus`` E [Pa], ``section_length``
    l/S [m]. Source: the paper, equation (10).
    """
    return angle_per_pressure / (youngs_modulus * section_length)


def stretch_per_pressure(
    extension_per_pressure: float, youngs_modulus: float, section_length: float
) -> float:
    r"""Intrinsic stretch per pressure sum (left + right) [1/Pa].

    .. math:: \lambda_p = \frac{\partial\zeta}{\partial(\bar p/E)} \frac{p_L + p_R}{E} \frac{S}{l}

    ``extension_per_pressure`` dzeta/d(pbar/E) [m], ``youngs_modulus`` E [Pa],
    ``section_length`` l/S [m]. Source: the paper, equation (9).
    """
    return extension_per_pressure / (youngs_modulus * section_length)


def blocked_compliance(
    compliance: float, volume_per_resultant: float, strain_per_pressure: float, stiffness: float
) -> float:
    r"""Compliance of a bellow in a section whose strain is held [m^3/Pa].

    .. math:: C_b = C - 2 b k \, EA \quad (\text{or } EI)

    With the strain held, a pressure changes the resultant by -stiffness times the intrinsic
    strain, which in turn reduces the volume. The two bellows act together (extension) or against
    each other (bending). A negative value means an ill-posed model: the pressure of a held
    section grows without bound. ``compliance`` C [m^3/Pa], ``volume_per_resultant`` b [m^3/N or
    m^3/(N m)], ``strain_per_pressure`` k [1/Pa or 1/(m Pa)], ``stiffness`` [N or N m^2].
    """
    return compliance - 2 * volume_per_resultant * strain_per_pressure * stiffness


FADE_WITHOUT_FLOOR = 0.05
"""Volume range, relative to the rest volume, in which walls meet if the minimum volume is 0."""
RESIDUAL_COMPLIANCE = 0.01
"""Compliance of a bellow whose walls have met, relative to that of the free bellow."""


def collapse_pressures(
    rest_volume: float, compliance: float, collapse_fraction: float, ambient: float
) -> tuple[float, float]:
    """Gauge pressure at which the walls have met, and the range above it in which they meet [Pa].

    There the linear law leaves slightly more than ``collapse_fraction`` of the rest volume, so
    that the residual compliance does not reach that minimum before a vacuum, which is ``ambient``
    [Pa] below zero gauge. ``rest_volume`` [m^3], ``compliance`` [m^3/Pa].
    """
    floor, fade = _plain_floor(rest_volume, compliance, collapse_fraction)
    give = residual_compliance(rest_volume, compliance, collapse_fraction, ambient)
    return floor + give / (1 - give) * np.maximum(ambient + floor, 0.0), fade


def residual_compliance(
    rest_volume: float, compliance: float, collapse_fraction: float, ambient: float
) -> float:
    """Compliance of a bellow whose walls have met, relative to that of the free bellow [1].

    `RESIDUAL_COMPLIANCE`; less in a soft bellow, so that down to a vacuum the walls yield by no
    more than half of the pressure range in which they meet.
    """
    floor, fade = _plain_floor(rest_volume, compliance, collapse_fraction)
    if not ambient + floor > 0.0:
        return RESIDUAL_COMPLIANCE
    # numpy's minimum serves numbers that carry formulas as well.
    return np.minimum(RESIDUAL_COMPLIANCE, fade / (2 * (ambient + floor)))  # type: ignore[no-any-return]


def _plain_floor(
    rest_volume: float, compliance: float, collapse_fraction: float
) -> tuple[float, float]:
    """Pressure at which the linear law reaches the minimum volume, and the range above it [Pa]."""
    empty = rest_volume / compliance
    share = np.minimum(collapse_fraction or FADE_WITHOUT_FLOOR, (1 - collapse_fraction) / 2)
    return -(1 - collapse_fraction) * empty, share * empty


def effective_pressure(
    pressure: Any, floor: Any, fade: Any, functions: Any, give: Any = RESIDUAL_COMPLIANCE
) -> Any:
    r"""Effective pressure of a bellow whose walls meet, to be put into the linear law [Pa].

    .. math:: p_e = p \;(u \le 0), \quad
              p_f + \frac{c}{1 + u + u^2} - \epsilon c \frac{u^3}{1 + u + u^2} \;(u > 0),
              \quad u = (c - (p - p_f))/c

    ``pressure`` p, ``floor`` p_f and ``fade`` c [Pa], ``give`` epsilon [1]. The identity above
    p_f + c, then decreasing towards p_f; twice continuously differentiable. Walls that have met
    keep the fraction epsilon of the compliance, since a rigid floor would leave volumes without a
    pressure. An assumption of this model: the paper has no collapse. ``functions`` is numpy or
    casadi.
    """
    u = functions.fmax(1 - (pressure - floor) / fade, 0.0)
    above = functions.fmax(pressure, floor + fade)
    # Equal to the formula, but exact to the last digit where it is the identity.
    return above - fade * (u + u * u + give * u**3) / (1 + u + u * u)


def effective_pressure_integral(
    pressure: Any, floor: Any, fade: Any, functions: Any, give: Any = RESIDUAL_COMPLIANCE
) -> Any:
    """Integral of the effective pressure from floor + fade to ``pressure`` [Pa^2]."""
    start = floor + fade
    u = functions.fmax(1 - (pressure - floor) / fade, 0.0)
    above = functions.fmax(pressure, start)
    root = math.sqrt(3)
    # The integral of 1/(1 + u + u^2); note u^3/(1 + u + u^2) = u - 1 + 1/(1 + u + u^2).
    arc = 2 / root * (functions.arctan((2 * u + 1) / root) - math.atan(1 / root))
    given = give * (u * u / 2 - u + arc)
    return (above**2 - start**2) / 2 - fade * (floor * u + fade * (arc - given))
