"""Steps of Rodas5P over one smooth stretch of the inputs, in native code."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from viscodesign.native.sparse_lu import SparseLU
from viscodesign.native.tables import Assembly


class MarchStatus(IntEnum):
    """How a march ended."""

    FINISHED = 0
    STEP_LIMIT = 1
    """All steps allowed were taken; the same call again continues."""
    STEP_TOO_SMALL = 2


@dataclass(frozen=True)
class MarchSettings:
    """Numbers that steer the steps."""

    tolerance: float
    motion_time: float
    """An error of a rate counts by (h/motion_time)^power [s]."""
    powers: np.ndarray
    """(unknowns without integrals,): power of each; infinite: not tested."""
    largest: float
    """Largest step [s]."""
    smallest: float
    """Smallest step [s]; below it the march ends."""
    safety: float = 0.9
    max_factor: float = 5.0
    min_factor: float = 0.2
    memory: float = 0.08


@dataclass
class MarchState:
    """Where a march is; it is moved on in place."""

    y: np.ndarray
    """(n,): unknowns, then integrals, whose rows have mass 1 and of which nothing depends."""
    time: float
    size: float
    """Size of the next step [s]."""
    before: float = 1.0
    """Error of the step before, over what is allowed; 1 at the start of a stretch."""
    edge: int = 0
    """Edges passed so far."""
    steps: int = 0
    rejected: int = 0
    residuals: int = 0
    jacobians: int = 0


def march(
    assembly: Assembly,
    lu: SparseLU,
    mass: np.ndarray,
    rest: np.ndarray,
    state: MarchState,
    edges: np.ndarray,
    settings: MarchSettings,
    max_steps: int,
) -> tuple[MarchStatus, np.ndarray]:
    """March from state.time to edges[-1]; returns unknowns (m, n) at the edges passed by it.

    ``mass`` (n,): 0 for algebraic rows; ``rest``: coefficients of the inputs and constants, the
    end of Y; ``edges`` (ne,): times after the start [s], the last one ends the stretch;
    ``max_steps``: tried in this call, accepted or not. What is returned are those of
    edges[state.edge:] (as it was before the call) that were passed.
    """
    raise NotImplementedError
