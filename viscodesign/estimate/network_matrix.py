"""Conductances of a network as a matrix, and its slowest time constant."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from viscodesign.model.graph import Component
from viscodesign.model.scene_number import Numbers
from viscodesign.physics import timescales


def laplacian(component: Component, resistances: Mapping[str, float]) -> np.ndarray:
    """Conductance matrix of a component's bellows, then junctions; inlets held [m3/(Pa s)]."""
    index = {n: k for k, n in enumerate((*component.bellows, *component.junctions))}
    matrix = np.zeros((len(index), len(index)))
    for t in component.tubes:
        conductance = 1 / resistances[t.name]
        ends = [index[end] for end in (t.start, t.end) if end in index]
        for end in ends:
            matrix[end, end] += conductance
        if len(ends) == 2:
            matrix[ends[0], ends[1]] -= conductance
            matrix[ends[1], ends[0]] -= conductance
    return matrix


def settling_time(
    component: Component, resistances: Mapping[str, float], compliance: Numbers
) -> float:
    """Slowest time constant of a component's bellows, junctions eliminated [s].

    ``compliance``: one for all bellows, or of each of the component's (B,) [m3/Pa].
    """
    matrix = laplacian(component, resistances)
    bellows, junctions = len(component.bellows), len(component.junctions)
    own, rest = matrix[:bellows, :bellows], matrix[bellows:, bellows:]
    if junctions:
        own = own - matrix[:bellows, bellows:] @ np.linalg.solve(rest, matrix[bellows:, :bellows])
    stored = np.full(bellows, compliance)
    return timescales.slowest_network_time(own, stored, sealed=not component.fed)
