"""Flows that follow from others at junctions without storage."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.scenes import leg, problem_of
from viscodesign import simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.tube_flows import reduce_incidence
from viscodesign.simulation.build_problem import Settings, build
from viscodesign.solve.numerics.symbolic_lu import has_whole_diagonal
from viscodesign.solve.problem import Problem

FAST = "effects={pressure_distribution: on, flow_regime: on, fluid_inertance: on, others: off}"
IMPLICIT = "effects={pressure_distribution: on, flow_regime: on, fluid_inertance: off, others: off}"
SHORT = ("fluid=water", "input={kind: sine, amplitude: 3 kPa, frequency: 2 Hz}",
         "run={duration: 0.3 s, output_interval: 0.05 s}", "bellows.count=4")  # fmt: skip
NETWORKS = {
    "a star": "{from: inlet, to: T}, {from: T, to: R1}, {from: L1, to: T}, {from: T, to: R2}, {from: L1, to: L2}",
    "two in a row": "{from: inlet, to: T}, {from: T, to: S}, {from: S, to: R1}, {from: S, to: L1}, {from: T, to: R2}, {from: R2, to: L2}",
    "a loop": "{from: inlet, to: T}, {from: T, to: S}, {from: S, to: T}, {from: S, to: R1}, {from: U, to: T}, {from: S, to: U}, {from: R1, to: R2}, {from: R2, to: L2}, {from: L2, to: L1}",
    "a dead end": "{from: inlet, to: R1}, {from: R1, to: T}, {from: R1, to: R2}, {from: R2, to: L2}, {from: L2, to: L1}",
}  # fmt: skip


def network(name: str) -> str:
    tubes = NETWORKS[name]
    return f"network={{layout: custom, tube_radius: 1 mm, tube_length: 4 cm, tubes: [{tubes}]}}"


def problem(*overrides: str) -> Problem:
    quantities = SceneQuantities(leg(*SHORT, *overrides))
    return build(quantities, select_effects(quantities).effects, Settings(4, 1e-4))


@given(nodes=st.integers(2, 8), more=st.integers(0, 6), seed=st.integers(0, 10_000))
@settings(max_examples=60, deadline=None)
def test_reduced_incidence_matrix_has_the_same_row_space(nodes: int, more: int, seed: int) -> None:
    """Entries stay 0 and +-1, and every row has a unit column."""
    random = np.random.default_rng(seed)
    ends = [(int(random.integers(0, k)), k) for k in range(1, nodes)]
    ends += [tuple(random.choice(nodes, 2, replace=False)) for _ in range(more)]
    matrix = np.zeros((nodes, len(ends)))
    for k, (a, b) in enumerate(ends):
        matrix[a, k], matrix[b, k] = -1.0, 1.0
    rows = random.permutation(nodes)[: int(random.integers(1, nodes))]
    before = matrix[rows]
    after = before.copy()
    pivots = reduce_incidence(after)
    assert set(np.unique(after)) <= {-1.0, 0.0, 1.0}
    assert np.array_equal(after[:, pivots], np.eye(len(rows)))
    # What satisfies the one satisfies the other.
    together = np.linalg.matrix_rank(np.vstack([before, after]))
    assert together == len(rows) == np.linalg.matrix_rank(before)


def test_an_empty_incidence_matrix_has_no_pivots() -> None:
    assert reduce_incidence(np.zeros((0, 3))) == []


@given(seed=st.integers(0, 10_000), effects=st.sampled_from([FAST, IMPLICIT]))
@settings(max_examples=10, deadline=None)
def test_every_equation_has_its_own_unknown(seed: int, effects: str) -> None:
    """Nodes joined at random, in trees and loops, by tubes in any order and direction."""
    random = np.random.default_rng(seed)
    nodes = ["R1", "L1", "R2", "L2", *[f"J{k}" for k in range(random.integers(1, 5))]]
    random.shuffle(nodes)
    tubes = [(n, random.choice(["inlet", *nodes[:k]])) for k, n in enumerate(nodes)]
    tubes += [tuple(random.choice(nodes, 2, replace=False)) for _ in range(random.integers(0, 4))]
    random.shuffle(tubes)
    listed = ", ".join(f"{{from: {a}, to: {b}}}" for a, b in tubes)
    form = f"network={{layout: custom, tube_radius: 1 mm, tube_length: 4 cm, tubes: [{listed}]}}"
    equations = problem(form, effects).equations
    assert has_whole_diagonal(equations.algebraic_function.sparsity_out(1))


def test_a_junction_beside_a_syringe_has_its_own_unknown_in_its_equation() -> None:
    equations = problem_of(leg(config="syringe_water")).equations
    assert has_whole_diagonal(equations.algebraic_function.sparsity_out(1))


@pytest.mark.parametrize("effects", [FAST, IMPLICIT])
@pytest.mark.parametrize("name", NETWORKS)
def test_flows_at_bare_junctions_balance_to_round_off(name: str, effects: str) -> None:
    scene = leg(*SHORT, network(name), effects)
    found = simulate(scene, verify=False)
    assert found.status == "complete", found.failure
    size = np.max(np.abs(found.flow))
    assert size > 0.0
    for junction in scene.graph.junctions:
        total = sum(
            found.flow[:, k] * ((t.end == junction) - (t.start == junction))
            for k, t in enumerate(scene.graph.tubes)
        )
        assert np.max(np.abs(total)) <= 1e-13 * size
    assert found.invariants.volume_imbalance_rel is not None
    assert found.invariants.volume_imbalance_rel <= 1e-8


def test_no_flow_into_a_dead_end() -> None:
    scene = leg(*SHORT, network("a dead end"), FAST)
    found = simulate(scene, verify=False)
    end = [t.name for t in scene.graph.tubes].index("R1-T")
    assert np.all(found.flow[:, end] == 0.0)


@pytest.mark.parametrize(
    ("name", "junctions"), [("a star", 1), ("two in a row", 2), ("a loop", 3), ("a dead end", 1)]
)
def test_every_bare_junction_eliminates_one_flow(name: str, junctions: int) -> None:
    tubes = NETWORKS[name].count("from")
    states = problem(network(name), FAST).equations.states
    assert len(range(*states.blocks["flow"].span.indices(states.count))) == tubes - junctions


def test_laminar_flows_need_no_unknown() -> None:
    plain = problem(network("a star"), "effects={pressure_distribution: on, others: off}")
    assert "flow" not in plain.equations.states.blocks
    assert "flow" not in plain.equations.algebraics.blocks


def test_storing_junctions_eliminate_no_flow() -> None:
    soft = "network.tube_wall={youngs_modulus: 1 MPa, thickness: 0.3 mm}"
    words = FAST.replace("others", "tube_compliance: on, others")
    states = problem(network("a star"), soft, words).equations.states
    assert len(range(*states.blocks["flow"].span.indices(states.count))) == 5
    assert len(range(*states.blocks["node_volume"].span.indices(states.count))) == 1
