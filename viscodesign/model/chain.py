"""The chain of nodes with numbers: its meshes, its shapes, and the steps that suit it."""

from __future__ import annotations

import math
from typing import Self

import numpy as np

from viscodesign.errors import UsageError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.arc_shape import arc_nodes
from viscodesign.model.chain_symbols import ChainSymbols
from viscodesign.model.node_masses import MIN_EDGES
from viscodesign.model.rod import MINIMUM_EDGES, Body, RodDiscretisation, RodParameters, Values
from viscodesign.model.step_geometry import StepGeometry


@dataclass(frozen=True)
class MeshRule:
    """How fine a mesh must be for an accuracy.

    Eight edges leave about a thousandth of the length at moderate loads; the error falls with
    the third power of the edge length or faster (measured against elliptic integrals).
    """

    coarse_edges: int = 8
    coarse_accuracy: float = 1e-3
    order: int = 3
    max_turn_per_edge: float = 1.0
    """Intrinsic turn of one edge [rad] up to which the chord relations hold well."""


MESH = MeshRule()


@dataclass(frozen=True)
class Chain(RodDiscretisation):
    """The chain with numbers: shapes, strains and steps.

    Raises `UsageError` where it would have fewer edges than its masses are integrated over.
    """

    def __post_init__(self) -> None:
        if self.edges < MIN_EDGES:
            least = math.ceil(MIN_EDGES / self.body.sections)
            raise UsageError(
                f"edges_per_section: {self.edges_per_section} in each of {self.body.sections} "
                f"sections makes {self.edges} edges, and a rod needs at least {MIN_EDGES}; "
                f"use {least} or more"
            )

    @classmethod
    def suggested(cls, body: Body, accuracy: float, largest_turn: float) -> Self:
        refinement = max(1.0, MESH.coarse_accuracy / accuracy) ** (1 / MESH.order)
        edges = max(MINIMUM_EDGES, MESH.coarse_edges * refinement)
        per_section = max(
            math.ceil(edges / body.sections - 1e-9),
            math.ceil(largest_turn / MESH.max_turn_per_edge),
            1,
        )
        return cls(body, per_section)

    @property
    def edges(self) -> int:
        """Edges of the whole chain."""
        return self.body.sections * self.edges_per_section

    def shearable(self) -> Chain:
        from viscodesign.model.shearable_chain import ShearableChain

        return ShearableChain(self.body, self.edges_per_section)

    def symbols(self, parameters: RodParameters) -> ChainSymbols:
        return ChainSymbols(self.body, self.edges_per_section, parameters)

    def unloaded_coordinates(self, curvature: np.ndarray, stretch: np.ndarray) -> np.ndarray:
        positions, _ = arc_nodes(
            curvature[None, :], stretch[None, :], self.body.section_length, self.edges_per_section
        )
        return np.asarray(positions[0].ravel() / self.body.length)

    def section_strains(self, values: Values) -> tuple[np.ndarray, np.ndarray]:
        times, sections = len(values["stretch"]), self.body.sections
        stretch = values["stretch"].reshape(times, sections, -1).min(axis=2)
        ends = values["angle"].reshape(times, sections, -1)[:, :, -1]
        return stretch, np.diff(ends, axis=1, prepend=0.0)

    def axis(self, values: Values, points: int) -> tuple[np.ndarray, np.ndarray]:
        """The nodes, with points between them on cubics that meet the tangents there."""
        times, edges = len(values["angle"]), self.edges
        position = values["position"].reshape(times, edges, 2)
        per_edge = max(1, -(-points // edges))
        angle = self.tangent_angles(values)
        nodes = np.concatenate([np.zeros((times, 1, 2)), position], axis=1)
        tangent = np.stack((np.sin(angle), np.cos(angle)), axis=-1)
        chord = np.diff(nodes, axis=1)
        length = np.hypot(chord[..., 0], chord[..., 1])[:, :, None]
        slopes = length * tangent[:, :-1], length * tangent[:, 1:]
        between = [
            _hermite(nodes[:, :-1], nodes[:, 1:], *slopes, s)
            for s in np.arange(1, per_edge + 1) / per_edge
        ]
        return np.stack(between, axis=2).reshape(times, edges * per_edge, 2), values["angle"][:, -1]

    def tangent_angles(self, values: Values) -> np.ndarray:
        """Angle of the axis at the clamp and all nodes (T, edges + 1) [rad]."""
        return np.concatenate([np.zeros((len(values["angle"]), 1)), values["angle"]], axis=1)

    def angle_jump(self, values: Values) -> tuple[int, int] | None:
        """A node's turn that changes by more than half a revolution between two rows."""
        turn = np.diff(values["angle"], axis=1, prepend=0.0)
        jumps = np.abs(np.diff(turn, axis=0)) > np.pi
        rows = jumps.any(axis=1)
        if not rows.any():
            return None
        before = int(np.argmax(rows))
        return before + 1, int(np.argmax(jumps[before])) * self.body.sections // turn.shape[1]

    def elimination_order(self) -> tuple[np.ndarray, np.ndarray]:
        """First the axial strains, then from the clamp to the tip, each position after the three
        curvatures that it affects.

        No pivot is near zero then unless the stiffness is near singular.
        """
        edges = self.edges
        # A node's position turns the chords at itself and at both neighbours.
        after = np.minimum(np.arange(edges) + 2, edges - 1)
        rank = np.concatenate([np.arange(edges), np.full(edges, -1), np.repeat(after, 2) + 0.5])
        order = np.argsort(rank, kind="stable")
        return order, order < 2 * edges

    def step_geometry(self, coordinates: slice) -> StepGeometry:
        return TurningSteps(coordinates)


class TurningSteps(StepGeometry):
    """Steps that turn and stretch the chords between nodes; other unknowns go straight.

    A straight step of nodes that turn about each other lengthens the chords in the second
    order, and an axis that hardly stretches lets only the tiniest of such steps pass.
    """

    def __init__(self, positions: slice) -> None:
        self.positions = positions

    def step(self, y: np.ndarray, step: np.ndarray) -> np.ndarray:
        after, chords = np.asarray(y + step), self._chords(y)
        # Equal to the straight step in the first order. A step that overflows is rejected by
        # the caller, who then takes a smaller one.
        with np.errstate(over="ignore", invalid="ignore"):
            after[self.positions] = _nodes(chords * np.exp(self._chords(step) / chords))
        return after

    def extrapolate(self, before: np.ndarray, now: np.ndarray, ratio: float) -> np.ndarray:
        after, chords = np.asarray(now + ratio * (now - before)), self._chords(now)
        turns = np.log(chords / self._chords(before))
        after[self.positions] = _nodes(chords * np.exp(ratio * turns))
        return after

    def _chords(self, y: np.ndarray) -> np.ndarray:
        """From node to node, z + i x (edges,)."""
        x, z = y[self.positions].reshape(-1, 2).T
        return np.asarray(np.diff(z + 1j * x, prepend=0.0))


def _nodes(chords: np.ndarray) -> np.ndarray:
    """x and z of all nodes in turn (2 edges,)."""
    places = np.cumsum(chords)
    return np.column_stack((places.imag, places.real)).ravel()


def _hermite(
    a: np.ndarray, b: np.ndarray, slope_a: np.ndarray, slope_b: np.ndarray, s: float
) -> np.ndarray:
    if s == 1.0:
        return b
    return np.asarray(
        (1 + 2 * s) * (1 - s) ** 2 * a
        + s**2 * (3 - 2 * s) * b
        + s * (1 - s) ** 2 * slope_a
        + s**2 * (s - 1) * slope_b
    )
