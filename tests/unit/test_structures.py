"""Formulas are made once for every structure, and never taken for those of another."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign.effects.select import catalogue, select_effects
from viscodesign.estimate.scene_quantities import Conditions
from viscodesign.model import formulation
from viscodesign.simulation.build_problem import Settings, build
from viscodesign.simulation.solve_once import Run, solve

EFFECTS = "effects={pressure_distribution: on, inertia: on, damping: on, feedback: on, others: off}"
SHORT = "run={duration: 0.3 s, output_interval: 0.05 s}"
SAME = [
    "fluid=water",
    "actuator.length=150 mm",
    "actuator.youngs_modulus=2.5 MPa",
    "bellows.area_per_pressure=4e-9 m^2/Pa",
    "network.tube_length=50 mm",
    "gauge_pressure=3 kPa",
    "actuator.damping_time=3 ms",
]
OTHER = [
    "network.layout=crossed",
    "bellows.count=8",
    "input={kind: sine, amplitude: 10 kPa, frequency: 1}",
    "effects.damping=off",
    "loads.gravity=on",
]


def solved(*overrides: str) -> Run:
    conditions = Conditions(leg(SHORT, EFFECTS, *overrides))
    return solve(conditions, select_effects(conditions).effects, Settings(1, 1e-6))


@pytest.fixture(autouse=True)
def _nothing_kept() -> None:
    formulation._kept.clear()


@pytest.mark.parametrize("change", SAME)
def test_other_numbers_take_the_formulas_over(change: str) -> None:
    first = solved().problem.equations
    second = solved(change)
    assert second.problem.equations.function is first.function
    formulation._kept.clear()
    fresh = solved(change)
    assert fresh.problem.equations.function is not first.function
    assert np.array_equal(second.motion.tip, fresh.motion.tip)
    assert np.array_equal(second.motion.pressure, fresh.motion.pressure)


@pytest.mark.parametrize("change", OTHER)
def test_another_structure_has_formulas_of_its_own(change: str) -> None:
    first = solved().problem.equations
    assert (
        solved(
            change, *(["effects.gravity=on"] if "gravity" in change else [])
        ).problem.equations.function
        is not first.function
    )


def test_a_second_simulation_makes_no_integrator() -> None:
    solved()
    again = solved("actuator.damping_time=2 ms")
    assert again.solution.work.compile_s <= 1e-3


@pytest.mark.parametrize("name", list(catalogue()))
def test_no_effect_is_lost_on_the_way(name: str) -> None:
    """With and without it, the structures differ: nothing that joins escapes the comparison."""
    from tests.contract.test_effects import LOADED

    conditions = Conditions(leg(*LOADED))
    effect = catalogue()[name].of(conditions)
    if not effect.present(conditions):
        pytest.skip("the scene has nothing for it")
    base = [
        catalogue()["pressure_distribution"].of(conditions),
        catalogue()["gravity"].of(conditions),
    ]
    base += [catalogue()["inertia"].of(conditions)]
    without = [e for e in base if e.name != name]
    order = list(catalogue())
    joined = sorted([*without, effect], key=lambda e: order.index(e.name))
    settings = Settings(1, 1e-4)
    one = build(conditions, joined, settings).equations
    other = build(conditions, without, settings).equations
    assert one.function is not other.function


def test_old_structures_make_room() -> None:
    for count in range(2, 2 * (formulation.MOST_KEPT + 3), 2):
        conditions = Conditions(leg(SHORT, f"bellows.count={count}", "effects={others: off}"))
        build(conditions, select_effects(conditions).effects, Settings(4, 1e-4))
    assert len(formulation._kept) == formulation.MOST_KEPT
