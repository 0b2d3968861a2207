"""What a solver gives the balances."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from viscodesign.lazy_dataclass import dataclass

Rows = Mapping[str, np.ndarray]


@dataclass(frozen=True)
class SolvedEdges:
    """Consecutive solved edges: scaled unknowns (n, m), integrals (nq, m), named outputs (m, n)."""

    first: int
    """Number of the first edge."""
    states: np.ndarray
    algebraics: np.ndarray
    integrals: np.ndarray
    rows: Rows
