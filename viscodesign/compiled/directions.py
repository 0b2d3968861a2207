"""Directions that others add up to: many numbers of a spec move few of its equations' numbers.

The viscosity, and the length of all tubes where they store nothing, both move their resistances.
Derivatives along one of them are those along the other, but for a factor.
"""

from __future__ import annotations

import numpy as np

from viscodesign.compiled.scene_numbers import ProblemNumbers

MOST = 64
"""Directions beyond which none is compared with the others."""
SAME = 1e-12
"""Length, in that of a direction, below which nothing is left of it beside the others."""


def independent(
    dots: ProblemNumbers, numbers: ProblemNumbers
) -> tuple[np.ndarray, np.ndarray | None]:
    """Which of d directions (r,) all others are sums of, and their parts in each (d, r).

    ``dots``: rates of the ``numbers``, with one more axis in front. The parts are None where none
    is a sum of others.
    """
    count = len(dots.parameters)
    if not 1 < count <= MOST:
        return np.arange(count), None
    rates, lengths = _unit_rows(dots, np.abs(numbers.flat()))
    left, chosen = rates.copy(), list[int]()
    for _ in range(count):
        sizes = np.linalg.norm(left, axis=1)
        k = int(np.argmax(sizes))
        if sizes[k] <= SAME:
            break
        chosen.append(k)
        along = left[k] / sizes[k]
        left -= np.outer(left @ along, along)
        left -= np.outer(left @ along, along)  # what rounding has left
    if len(chosen) == count:
        return np.arange(count), None
    chosen = sorted(chosen) or [0]
    parts = np.linalg.lstsq(rates[chosen].T, rates.T, rcond=None)[0].T
    return np.array(chosen, dtype=int), parts * lengths[:, None] / lengths[chosen]


def _unit_rows(dots: ProblemNumbers, sizes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Directions (d, n) of length one in numbers of any unit, and what they are divided by (d,).

    Numbers count in their ``sizes`` (n,), those that are zero in their largest rate.
    """
    rates = np.concatenate([part.reshape(len(part), -1) for part in dots], axis=1)
    known = sizes > 0.0
    rates[:, known] /= sizes[known]
    first = _or_one(np.linalg.norm(rates[:, known], axis=1))
    rates /= first[:, None]
    rates[:, ~known] /= _or_one(np.max(np.abs(rates[:, ~known]), axis=0, initial=0.0))
    second = _or_one(np.linalg.norm(rates, axis=1))
    return rates / second[:, None], first * second


def _or_one(lengths: np.ndarray) -> np.ndarray:
    return np.where(lengths > 0.0, lengths, 1.0)
