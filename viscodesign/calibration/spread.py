"""How surely numbers are known near the best fit: covariances of their steps."""

from __future__ import annotations

import numpy as np

from viscodesign.calibration.misfit import Misfit
from viscodesign.lazy_dataclass import dataclass

UNKNOWN_DEVIATION = 10.0
"""Standard deviation of a step that stands for infinite: e^10 is a ratio of 22,000."""


@dataclass(frozen=True)
class Spread:
    """Covariances of steps: of the logarithm of a number, or of it relative to its size."""

    values: np.ndarray
    """(u,) The numbers at the best fit."""
    sizes: np.ndarray
    """(u,) Change of a number by a unit step."""
    jacobian: np.ndarray
    """(n + f, u) Derivatives of all residuals with respect to steps: the data, then the pulls."""
    pulls: int
    by_data: np.ndarray
    """(u, u) Covariance by the data alone; what they do not determine at all has a standard
    deviation of `UNKNOWN_DEVIATION`."""

    @property
    def deviations(self) -> np.ndarray:
        """(u,) Standard deviations of steps, by the data alone."""
        return np.asarray(np.sqrt(np.diag(self.by_data)))

    @property
    def data_rows(self) -> np.ndarray:
        """(n, u) Derivatives of the data's residuals."""
        return self.jacobian[: len(self.jacobian) - self.pulls]

    def of_others_pulled(self, number: int) -> np.ndarray:
        """(u, u) Covariance with the pulls of all numbers but one."""
        rows = self.jacobian.copy()
        rows[len(rows) - self.pulls :][:, number] = 0.0
        return covariance_of(rows)

    def logarithmic(self, unknown: np.ndarray) -> np.ndarray:
        """The covariance of the logarithms of some numbers, by the data alone."""
        scale = self.sizes[unknown] / self.values[unknown]
        return np.asarray(self.by_data[np.ix_(unknown, unknown)] * np.outer(scale, scale))

    def moved_by(self, change: np.ndarray) -> np.ndarray:
        """(u,) Steps by which a change (n,) of the data's residuals moves the best fit."""
        return np.asarray(-covariance_of(self.jacobian) @ (self.data_rows.T @ change))


def spread_of(misfit: Misfit, values: np.ndarray) -> Spread:
    """The spread at a best fit."""
    sizes, pulls = misfit.sizes(values), len(misfit.pulled)
    jacobian = misfit.jacobian(values) * sizes
    by_data = covariance_of(jacobian[: len(jacobian) - pulls])
    return Spread(values, sizes, jacobian, pulls, by_data)


def covariance_of(jacobian: np.ndarray) -> np.ndarray:
    """(u, u) Covariance by derivatives (n, u) of residuals with unit variance."""
    information = jacobian.T @ jacobian + np.eye(jacobian.shape[1]) / UNKNOWN_DEVIATION**2
    # Some numbers are known to 1e-5, others not at all: with a unit diagonal, all digits count.
    scale = 1 / np.sqrt(np.diag(information))
    inverse = np.linalg.inv(information * scale[:, None] * scale)
    return np.asarray(inverse * scale[:, None] * scale)
