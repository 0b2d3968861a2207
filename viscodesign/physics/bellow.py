"""The linear laws of a bellow: volume, angle and extension against pressure."""

from __future__ import annotations

import math
from typing import Any


def rest_volume(height: float, width: float, length: float) -> float:
    """Volume of a bellow at zero gauge pressure, V_0 = h_b w_b l_b [m3]."""
    return height * width * length


def compliance(length: float, area_per_pressure: float) -> float:
    r"""Volume per pressure of a free bellow [m3/Pa].

    .. math:: C = l_b \, \partial a / \partial p

    Source: the paper, equation (1), integrated along one bladder.
    """
    return length * area_per_pressure


def curvature_per_pressure(
    angle_per_pressure: float, youngs_modulus: float, section_length: float
) -> float:
    r"""Intrinsic curvature per pressure difference (left - right) [1/(m Pa)].

    .. math:: \kappa_p = \frac{\partial\psi}{\partial(p'/E)} \frac{p_L - p_R}{E} \frac{S}{l}

    Source: the paper, equation (10).
    """
    return angle_per_pressure / (youngs_modulus * section_length)


def stretch_per_pressure(
    extension_per_pressure: float, youngs_modulus: float, section_length: float
) -> float:
    r"""Intrinsic stretch per pressure sum (left + right) [1/Pa].

    .. math:: \lambda_p = \frac{\partial\zeta}{\partial(\bar p/E)} \frac{p_L + p_R}{E} \frac{S}{l}

    Source: the paper, equation (9).
    """
    return extension_per_pressure / (youngs_modulus * section_length)


def blocked_compliance(
    compliance: float, volume_per_resultant: float, strain_per_pressure: float, stiffness: float
) -> float:
    r"""Compliance left when the section's strain is held [m3/Pa].

    .. math:: C_b = C - 2 b k \, EA \quad (\text{or } EI)

    With the strain held, a pressure raises the resultant by -stiffness times the
    intrinsic strain, and the resultant takes volume back. Two equal bellows act
    together (extension) or against each other (bending). Negative: the pressure
    of a held section runs away, the model is ill posed.
    ``volume_per_resultant`` b [m3/N or m3/(N m)], ``strain_per_pressure`` k
    [1/Pa or 1/(m Pa)], ``stiffness`` [N or N m2].
    """
    return compliance - 2 * volume_per_resultant * strain_per_pressure * stiffness


SMALLEST_FADE = 0.05
"""Part of the rest volume over which a bellow without a stated floor fades."""
GIVE = 0.01
"""Part of a bellow's compliance that is left when its walls have met."""


def collapse_pressures(
    rest_volume: float, compliance: float, collapse_fraction: float, ambient: float
) -> tuple[float, float]:
    """Gauge pressure at which the walls have met, and the range above it in which they do [Pa].

    The linear law has ``collapse_fraction`` of the rest volume left there, and a little
    more: so much that what the walls still give way does not reach that floor before
    the vacuum, at ``ambient`` below zero gauge [Pa]. At rest they do not touch.
    """
    floor, fade = _plain_floor(rest_volume, compliance, collapse_fraction)
    give = wall_give(rest_volume, compliance, collapse_fraction, ambient)
    return floor + give / (1 - give) * max(ambient + floor, 0.0), fade


def wall_give(
    rest_volume: float, compliance: float, collapse_fraction: float, ambient: float
) -> float:
    """Part of the compliance that walls which have met still have [1].

    A hundredth; less in a soft bellow, whose walls may give way by no more than half of
    the range in which they meet, down to the vacuum.
    """
    floor, fade = _plain_floor(rest_volume, compliance, collapse_fraction)
    suction = max(ambient + floor, 0.0)
    return min(GIVE, fade / (2 * suction)) if suction > 0.0 else GIVE


def _plain_floor(
    rest_volume: float, compliance: float, collapse_fraction: float
) -> tuple[float, float]:
    """Pressure at which the linear law comes to the floor, and range of meeting above it [Pa]."""
    empty = rest_volume / compliance
    share = min(collapse_fraction or SMALLEST_FADE, (1 - collapse_fraction) / 2)
    return -(1 - collapse_fraction) * empty, share * empty


def effective_pressure(
    pressure: Any, floor: Any, fade: Any, functions: Any, give: Any = GIVE
) -> Any:
    r"""Pressure that a bellow with meeting walls still follows [Pa].

    .. math:: p_e = p \;(u \le 0), \quad
              p_f + \frac{c}{1 + u + u^2} - \epsilon c \frac{u^3}{1 + u + u^2} \;(u > 0),
              \quad u = (c - (p - p_f))/c

    The identity above floor + fade (p_f + c), then falling towards the floor; twice
    continuously differentiable. Walls that have met give way by a part (epsilon,
    ``give``) of what they did: a stiff floor would leave volumes without a pressure. A choice of
    this model: the paper has no collapse. ``functions`` offers `fmax` (numpy or CasADi).
    """
    u = functions.fmax(1 - (pressure - floor) / fade, 0.0)
    above = functions.fmax(pressure, floor + fade)
    # The same as the formula, but the identity keeps its last digit.
    return above - fade * (u + u * u + give * u**3) / (1 + u + u * u)


def effective_pressure_integral(
    pressure: Any, floor: Any, fade: Any, functions: Any, give: Any = GIVE
) -> Any:
    """Integral of the effective pressure from floor + fade to ``pressure`` [Pa2]."""
    start = floor + fade
    u = functions.fmax(1 - (pressure - floor) / fade, 0.0)
    above = functions.fmax(pressure, start)
    root = math.sqrt(3)
    # The integral of 1/(1 + u + u^2); u^3 over the same is u - 1 + 1/(1 + u + u^2).
    arc = 2 / root * (functions.arctan((2 * u + 1) / root) - math.atan(1 / root))
    given = give * (u * u / 2 - u + arc)
    return (above**2 - start**2) / 2 - fade * (floor * u + fade * (arc - given))
