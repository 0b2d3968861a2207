"""Marks of dataclass fields whose values are not part of a structure; see `structure`."""

from __future__ import annotations

from typing import Any

import numpy as np

Numbers = float | np.ndarray
"""One number for all sections or bellows of an actuator, or an array with one for each."""

SCENE_NUMBER = {"scene number": "may decide what is formulated by being None, zero or infinite"}
"""Metadata of a dataclass field whose value enters formulas as a parameter, never as a constant."""
PARAMETER_VALUE = {"scene number": "decides nothing"}
"""The same of a field that nothing but a solver ever reads."""


def mean_of(values: Numbers, weights: np.ndarray | None = None) -> Any:
    """The mean of an array, with weights that add up to one; one number is its own."""
    if not isinstance(values, np.ndarray):
        return values
    return np.sum(values) / len(values) if weights is None else np.sum(values * weights)
