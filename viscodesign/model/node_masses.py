"""Masses of a rod lumped at its nodes, of the fourth order in the length of an edge."""

from __future__ import annotations

import casadi as ca
import numpy as np

SX = ca.SX

GREGORY_END_WEIGHTS = (3 / 8, 7 / 6, 23 / 24)
"""End weights of the fourth-order Gregory rule [1], from the end inwards.

Source: Abramowitz and Stegun, Handbook of Mathematical Functions, 25.4 (end
corrections of the trapezoidal rule).
"""
MIN_EDGES = len(GREGORY_END_WEIGHTS)
"""Edges that the rule needs."""


def node_weights(edges: int) -> np.ndarray:
    """Quadrature weights of nodes 1..edges, in edge lengths (edges,) [1].

    The clamped end needs no correction: what is integrated there vanishes with
    its first derivative.
    """
    weights = np.ones(edges)
    weights[: -len(GREGORY_END_WEIGHTS) - 1 : -1] = GREGORY_END_WEIGHTS
    return weights


LARGEST_MASS_RATIO = 4.0
"""Mass of an edge over that of a neighbour up to which it is spread in the fourth order."""


def node_masses(per_edge: list[SX]) -> list[SX]:
    """Masses of nodes 1..edges, from those of edges that may jump from edge to edge [kg].

    Every edge is integrated by the cubic through the four nodes about it, at the tip by the
    parabola through the last three; for equal edges these are the weights of `node_weights`.
    Beside a far lighter edge less of this correction is made, so that no mass is negative.
    """
    edges = len(per_edge)
    found = {i: SX(0) for i in range(-1, edges + 2)}
    for e, mass in enumerate(per_edge):  # from node e to node e + 1
        near = [per_edge[k] for k in (e - 1, e + 1) if 0 <= k < edges]
        moved = SX(mass)
        for other in near:
            moved = ca.fmin(moved, LARGEST_MASS_RATIO * other)
        for node in (e, e + 1):
            found[node] += mass / 2
        weights = (-2, 4, -2, 0) if e == edges - 1 else (-1, 1, 1, -1)
        for node, weight in zip(range(e - 1, e + 3), weights, strict=True):
            # The clamp mirrors.
            found[abs(node)] += weight * moved / 24
    return [found[i] for i in range(1, edges + 1)]
