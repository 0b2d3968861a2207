"""What the coefficients of two specs leave open of the distance between their tips."""

from __future__ import annotations

import numpy as np

from viscodesign.results.coefficient_band import COVERAGE_FACTOR, CoefficientBand
from viscodesign.results.run_comparison import ComparedMotion


def band_along(
    first: ComparedMotion, other: ComparedMotion, time: np.ndarray, apart: np.ndarray
) -> np.ndarray | None:
    """Half of the 95 % interval (n,) of the distance along ``apart`` (n, 2) [m].

    Variances of both add up, as of independent actuators; between output times they are linear.
    None where no motion has a band, or the first and the other are of the same numbers, whose
    deviations would move both.
    """
    bands = [motion.band for motion in (first, other) if motion.band is not None]
    if not bands or (len(bands) == 2 and _share_numbers(*bands)):
        return None
    length = np.hypot(*apart.T)
    x, z = (apart / np.where(length > 0.0, length, 1.0)[:, None]).T
    xx, zz, xz = np.sum([_covariance_at(band, time) for band in bands], axis=0)
    variance = xx * x**2 + zz * z**2 + 2 * xz * x * z
    return np.asarray(COVERAGE_FACTOR * np.sqrt(np.maximum(variance, 0.0)))


def _share_numbers(one: CoefficientBand, other: CoefficientBand) -> bool:
    """Whether both depend on the same number, of one actuator in two runs."""
    known = {(number.key, number.value) for number in one.numbers}
    return any((number.key, number.value) in known for number in other.numbers)


def _covariance_at(band: CoefficientBand, time: np.ndarray) -> np.ndarray:
    """(3, n) Variances of x and z, and their covariance [m2]."""
    return np.array([np.interp(time, band.time, own) for own in band.covariance.T])
