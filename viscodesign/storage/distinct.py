"""Values in ascending order, each once."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike


def distinct(values: ArrayLike) -> np.ndarray:
    """Ascending values (n,), each once: `numpy.unique` without importing masked arrays."""
    ordered = np.sort(np.asarray(values).ravel())
    return np.asarray(ordered[np.append(True, ordered[1:] != ordered[:-1])[: len(ordered)]])
