"""Numbers that data cannot tell apart, and the products of their powers that they can.

The covariance of logarithms has the answer. In the numbers that are not known by themselves, the
directions of small variance are products of powers that are. A basis of them in echelon form has
few factors in each, and simple powers where physics has such: the resistance of a tube is known as
viscosity * length / radius^4.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from viscodesign.lazy_dataclass import dataclass

FAR_BETTER = 0.1
"""Standard deviation of a product, relative to that of its best known factor, up to which its
factors count as impossible to tell apart."""
WELL_KNOWN_PRODUCT = 0.13
"""Standard deviation of a logarithm up to which a product is worth telling: 25 % either way."""
NEGLIGIBLE = 0.05
"""Power, over the largest of a product, that counts as none."""
DENOMINATORS = 4
"""Largest denominator of a power."""


@dataclass(frozen=True)
class KnownProduct:
    """A product of powers of numbers that is known better than any of them."""

    factors: tuple[int, ...]
    """Places of the numbers."""
    powers: tuple[Fraction, ...]
    deviation: float
    """Standard deviation of its logarithm."""


def known_products(covariance: np.ndarray, unsure: Sequence[int]) -> list[KnownProduct]:
    """Find products of powers that are known although none of their factors is.

    ``covariance`` (u, u) of logarithms, ``unsure``: places of the numbers that are not known by
    themselves.
    """
    places = list(unsure)
    if len(places) < 2:
        return []
    own = covariance[np.ix_(places, places)]
    deviations = np.sqrt(np.diag(own))
    # In units of each one's own deviation, so that none hides behind another's.
    variances, directions = np.linalg.eigh(own / np.outer(deviations, deviations))
    known = variances < FAR_BETTER**2
    rows = _echelon((directions[:, known] / deviations[:, None]).T)
    found = [_product(row, places, covariance) for row in rows]
    return [own for own in found if own is not None]


def _echelon(rows: np.ndarray) -> np.ndarray:
    """Reduced row echelon form, with the largest pivots first."""
    rows = rows.copy()
    for k in range(len(rows)):
        left = np.abs(rows[k:])
        i, j = (int(place) for place in np.unravel_index(np.argmax(left), left.shape))
        rows[[k, k + i]] = rows[[k + i, k]]
        rows[k] /= rows[k, j]
        for other in range(len(rows)):
            if other != k:
                rows[other] -= rows[other, j] * rows[k]
    return rows


def _product(row: np.ndarray, places: Sequence[int], covariance: np.ndarray) -> KnownProduct | None:
    """The product with simple powers next to a direction, if it is known as well."""
    largest = np.abs(row).max()
    factors = [k for k in range(len(row)) if abs(row[k]) > NEGLIGIBLE * largest]
    first = row[factors[0]]
    powers = [Fraction(row[k] / first).limit_denominator(DENOMINATORS) for k in factors]
    own = [places[k] for k in factors]
    weights = np.array([float(power) for power in powers])
    block = covariance[np.ix_(own, own)]
    deviation = float(np.sqrt(max(weights @ block @ weights, 0.0)))
    least = float(np.sqrt(np.diag(block)).min())
    if len(own) < 2 or deviation > min(FAR_BETTER * least, WELL_KNOWN_PRODUCT):
        return None
    whole = math.lcm(*(power.denominator for power in powers))
    return KnownProduct(tuple(own), tuple(power * whole for power in powers), deviation * whole)
