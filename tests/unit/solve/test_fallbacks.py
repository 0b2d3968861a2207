"""Where a solver fails, others try; but not where nothing is left to solve."""

from __future__ import annotations

from tests.scenes import leg
from viscodesign import simulate

FEW_STEPS = 2_000


def test_a_section_pressed_to_nothing_ends_the_run_at_once() -> None:
    scene = leg("input.drop=300 kPa", config="leg_4_air")
    found = simulate(scene, verify=False)
    assert found.status == "failed"
    assert found.failure is not None
    assert "section 1 is compressed to" in found.failure
    assert found.ladder == ()
    assert found.cost.steps < FEW_STEPS
