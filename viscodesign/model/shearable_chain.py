"""The shearable chain with numbers: what its cross sections' angles add to shapes and steps."""

from __future__ import annotations

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.arc_shape import arc_nodes
from viscodesign.model.chain import Chain, TurningSteps
from viscodesign.model.rod import RodParameters, Values
from viscodesign.model.shearable_chain_symbols import ShearableChainSymbols
from viscodesign.model.step_geometry import StepGeometry


@dataclass(frozen=True)
class ShearableChain(Chain):
    """The chain whose edges have an angle of their cross sections each."""

    def symbols(self, parameters: RodParameters) -> ShearableChainSymbols:
        return ShearableChainSymbols(self.body, self.edges_per_section, parameters)

    def unloaded_coordinates(self, curvature: np.ndarray, stretch: np.ndarray) -> np.ndarray:
        positions = super().unloaded_coordinates(curvature, stretch)
        length = self.body.section_length / self.edges_per_section
        _, ends = arc_nodes(
            curvature[None, :], stretch[None, :], self.body.section_length, self.edges_per_section
        )
        middles = ends[0] - np.repeat(curvature, self.edges_per_section) * length / 2
        return np.concatenate([positions, middles])

    def tangent_angles(self, values: Values) -> np.ndarray:
        shear = values["shear_angle"]
        between = (shear[:, 1:] + shear[:, :-1]) / 2
        at_nodes = np.concatenate([shear[:, :1], between, shear[:, -1:]], axis=1)
        return np.asarray(super().tangent_angles(values) + at_nodes)

    def elimination_order(self) -> tuple[np.ndarray, np.ndarray]:
        """First the axial strains, then from the clamp to the tip: each angle after the two
        curvatures that it affects, each position after the angle of its edge.
        """
        edges = self.edges
        after = np.minimum(np.arange(edges) + 1, edges - 1)
        rank = np.concatenate(
            [np.arange(edges), np.full(edges, -1), np.repeat(after, 2) + 0.5, after + 0.25]
        )
        order = np.argsort(rank, kind="stable")
        return order, order < 2 * edges

    def step_geometry(self, coordinates: slice) -> StepGeometry:
        return TurningSteps(slice(coordinates.start, coordinates.start + 2 * self.edges))
