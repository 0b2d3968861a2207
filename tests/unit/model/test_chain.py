"""Meshes that a rod cannot have."""

from __future__ import annotations

import pytest

from tests.scenes import leg
from viscodesign.effects.select import select_effects
from viscodesign.errors import UsageError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.chain import Chain
from viscodesign.model.node_masses import MIN_EDGES
from viscodesign.model.rod import Body
from viscodesign.simulation.build_problem import Settings, build


@pytest.mark.parametrize(("sections", "edges", "least"), [(2, 1, 2), (1, 2, 3), (2, 0, 2)])
def test_a_mesh_of_too_few_edges_is_refused_with_the_least_one(
    sections: int, edges: int, least: int
) -> None:
    body = Body(0.1, sections, 1.0, 1e3, 0.1)
    words = rf"edges_per_section: {edges} in each of {sections} .*at least 3; use {least} or more"
    with pytest.raises(UsageError, match=words):
        Chain(body, edges)
    assert Chain(body, least).edges >= MIN_EDGES


def test_settings_too_coarse_for_a_short_actuator_are_refused() -> None:
    quantities = SceneQuantities(leg(config="leg_4_air"))
    effects = select_effects(quantities).effects
    with pytest.raises(UsageError, match="1 in each of 2 sections makes 2 edges"):
        build(quantities, effects, Settings(1, 1e-4))
    assert build(quantities, effects, Settings(2, 1e-4)).rod.edges_per_section == 2
