"""A robot's leg against `simulate`, and the derivatives of its equations."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.robots import hexapod
from tests.scenes import leg
from viscodesign import simulate
from viscodesign.robot.leg_design import leg_design
from viscodesign.robot.leg_equations import LegFunctions, leg_functions, matrices
from viscodesign.robot.robot_model import LegGroup

STATIC = "effects={tip_load: on, gas_compressibility: on, others: off}"


def hanging(functions: LegFunctions, force: np.ndarray, gauge: float) -> np.ndarray:
    """Tip (3,) of a leg with a force at its tip and no moment there."""
    nodes, load = len(functions.design.nodes), np.zeros((1, 3))
    strains = np.zeros((1, 6 * len(functions.design.free_sections)))
    load[0, :2] = force
    for _ in range(20):
        tip, by_load, _, _ = functions.hanging.rows(
            [load, np.full((1, nodes), gauge), strains, np.zeros((1, 2))], 1
        )
        flexibility = matrices(by_load, 3)[0]
        moment = load[0, 2] - force[0] * tip[0, 1] + force[1] * tip[0, 0]
        slope = 1 - force[0] * flexibility[1, 2] + force[1] * flexibility[0, 2]
        load[0, 2] -= moment / slope
    return np.asarray(tip[0])


@pytest.mark.parametrize(
    ("force", "gauge", "pillars"),
    [
        ((0.0, 0.0), 38.7e3, ()),
        ((0.0, -2.4), 38.7e3, ()),
        ((0.4, -1.2), 30e3, ()),
        ((-0.8, 1.0), 0.0, ()),
        ((0.4, -1.2), 30e3, ("sections={1-2: {blocked: on}}",)),
    ],
)
def test_a_legs_tip_equals_that_of_the_single_actuator(
    force: tuple[float, float], gauge: float, pillars: tuple[str, ...]
) -> None:
    scene = leg(
        STATIC, "input={kind: constant, value: 0}", f"gauge_pressure={gauge}", "accuracy=1e-5",
        f"loads={{gravity: off, tip_force: {{x: {force[0]}, z: {force[1]}}}}}",
        "run={duration: 0.1, output_interval: 0.1}", *pillars,
    )  # fmt: skip
    expected = simulate(scene).tip[-1]
    found = hanging(leg_functions(leg_design(scene)), np.array(force), gauge)
    assert np.hypot(*(found[:2] - expected[:2])) < 1e-6
    assert found[2] == pytest.approx(expected[2], abs=2e-5)


def test_derivatives_equal_differences() -> None:
    functions = leg_functions(leg_design(hexapod().leg_scene("leg")))
    draw, nodes = np.random.default_rng(3), len(functions.design.nodes)
    given = [
        np.array([[1e-3, -0.13, 0.02, 0.01, 0.09, -0.016, 0.03]]),
        np.array([[0.3, -1.2, 0.02]]),
        4e4 + 3e3 * draw.normal(size=(1, nodes)),
        np.array([[0.09, 0.06, -0.01, 0.087, 0.02]]),
        0.01 * draw.normal(size=(1, 48)),
        np.full((1, nodes), 3e-6),
        np.full((1, 1), 4.5e4),
        np.array([[2e-3, 5.0]]),
    ]
    rows = functions.unknowns + 7
    _, _, by_unknown, by_place = functions.linearised.rows(given, 1)
    for place, column, size, table in [
        *((1, k, 1e-5, by_unknown) for k in range(3)),
        *((2, k, 10.0, by_unknown) for k in (0, 7, nodes - 1)),
        *((0, k, 1e-6, by_place) for k in range(7)),
    ]:
        offset = column + (3 if place == 2 else 0)
        sides = []
        for sign in (1, -1):
            moved = [values.copy() for values in given]
            moved[place][0, column] += sign * size
            sides.append(np.concatenate(functions.plain.rows(moved, 1), axis=1)[0])
        difference = (sides[0] - sides[1]) / (2 * size)
        own = matrices(table, rows)[0][:, offset]
        np.testing.assert_allclose(own, difference, rtol=1e-5, atol=1e-6 * np.max(np.abs(own)))


def test_a_stiff_section_neither_bends_nor_stretches() -> None:
    free, pillars = (
        leg_functions(leg_design(hexapod(f"robot.stiff_sections={stiff}").leg_scene("leg")))
        for stiff in ([], [1, 2])
    )
    rest = [hanging(own, np.zeros(2), 0.0)[1] for own in (free, pillars)]
    full = [hanging(own, np.zeros(2), 38.7e3)[1] for own in (free, pillars)]
    assert rest == pytest.approx([0.109, 0.109])
    grown = np.subtract(full, rest)
    assert grown[1] == pytest.approx(0.75 * grown[0])
    assert leg_functions(leg_design(hexapod().leg_scene("leg"))) is pillars


def test_groups_know_where_their_legs_stand() -> None:
    functions = leg_functions(leg_design(hexapod().leg_scene("leg")))
    group = LegGroup(functions, np.array([0, 2]), np.zeros((2, 5)), np.zeros(2, dtype=int))
    assert group.places.tolist() == [[0, 1, 2, 3, 4, 5, 6], [0, 1, 2, 3, 10, 11, 12]]
    assert replace(group, legs=np.array([1])).strain_numbers == 48
