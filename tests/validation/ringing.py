"""Natural frequencies: of beams from the characteristic equation, of a motion by a fit."""

from __future__ import annotations

import numpy as np
from scipy.optimize import brentq, least_squares


def rayleigh_frequencies(slenderness: float, count: int) -> np.ndarray:
    """The first of a clamped-free beam of rotary inertia, times sqrt(m l^4/EI) [1].

    EI w'''' + m w_tt - m k^2 w''_tt = 0 with k the radius of gyration: w = W cos(omega t)
    has sin and cos of a x, sinh and cosh of b x, a^2 - b^2 = m k^2 omega^2/EI,
    a^2 b^2 = m omega^2/EI. At the free end W'' = 0 and EI W''' + m k^2 omega^2 W' = 0.
    ``slenderness`` is k/l. Source: Rayleigh, The Theory of Sound, chapter VIII.
    """

    def determinant(omega: float) -> float:
        turned = (slenderness * omega) ** 2
        root = np.sqrt(turned**2 + 4 * omega**2)
        a, b = np.sqrt((root + turned) / 2), np.sqrt((root - turned) / 2)
        sin, cos, sinh, cosh = np.sin(a), np.cos(a), np.sinh(b), np.cosh(b)
        # Shapes cos a x - cosh b x and sin a x / a - sinh b x / b: clamped both.
        bent = -(a**2) * cos - b**2 * cosh, -a * sin - b * sinh
        sheared = (
            a**3 * sin - b**3 * sinh + turned * (-a * sin - b * sinh),
            -(a**2) * cos - b**2 * cosh + turned * (cos - cosh),
        )
        return float((bent[0] * sheared[1] - bent[1] * sheared[0]) / cosh)

    found: list[float] = []
    low, step = 0.5, 0.25
    while len(found) < count:
        if determinant(low) * determinant(low + step) < 0:
            found.append(float(brentq(determinant, low, low + step, xtol=1e-13)))
        low += step
    return np.array(found)


def fitted_frequencies(time: np.ndarray, motion: np.ndarray, guess: np.ndarray) -> np.ndarray:
    """Angular frequencies whose cosines, with a constant, make up a released motion.

    Amplitudes follow by least squares for every trial of the frequencies.
    """

    def residual(omega: np.ndarray) -> np.ndarray:
        waves = np.column_stack([np.ones(len(time)), np.cos(np.outer(time, omega))])
        share, *_ = np.linalg.lstsq(waves, motion, rcond=None)
        return np.asarray((waves @ share - motion) / np.ptp(motion))

    fit = least_squares(residual, guess, x_scale=guess, xtol=1e-14, ftol=1e-14, gtol=1e-14)
    return np.sort(fit.x)
