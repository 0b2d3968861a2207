"""The linear laws of a bellow: volume, angle and extension against pressure."""

from __future__ import annotations


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
