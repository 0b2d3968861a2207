"""Another discretisation of the rod is a file of its own and one line where it is chosen."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.chain import Chain
from viscodesign.model.chain_symbols import ChainSymbols
from viscodesign.model.rod import Body, RodDiscretisation, RodParameters
from viscodesign.simulation import build_problem
from viscodesign.simulation.build_problem import Settings
from viscodesign.simulation.solve_once import solve

SX = ca.SX
SIDEWAYS = "loads.tip_force.x=0.3 N"
SCENES = {
    "static": (SIDEWAYS, "effects={gravity: on, others: off}"),
    "dynamic": (SIDEWAYS, "effects={inertia: on, damping: on, gravity: on, others: off}"),
    "beside a fluid": (
        SIDEWAYS,
        "effects={pressure_distribution: on, gravity: on, others: off}",
    ),
}
SHORT = "run={duration: 0.2 s, output_interval: 0.05 s}"


class SpringSymbols(ChainSymbols):
    """Links joined by torsion springs: no internal unknowns, second-order accurate."""

    def __init__(self, body: Body, edges_per_section: int, parameters: RodParameters) -> None:
        super().__init__(body, edges_per_section, parameters)
        self.internal = SX(0, 1)

    def _curvature(self) -> SX:
        return self.elastic_turns / self.tributary_lengths

    def elastic_energies(self) -> list[SX]:
        bending = self.bending_stiffness * self.tributary_lengths * self._curvature() ** 2 / 2
        return ca.vertsplit(
            bending + self.extension_stiffness * self.h * self.elastic_stretch**2 / 2
        )

    def stored_energies(self) -> list[SX]:
        return self.elastic_energies()

    def node_angles(self) -> SX:
        after = ca.vertcat(self.turns[1:], self.turns[-1])
        return ca.cumsum(self.turns) + after / 2


@dataclass(frozen=True)
class SpringChain(Chain):
    """The same with numbers."""

    def symbols(self, parameters: RodParameters) -> SpringSymbols:
        return SpringSymbols(self.body, self.edges_per_section, parameters)

    def elimination_order(self) -> tuple[np.ndarray, np.ndarray]:
        count = 2 * self.edges
        return np.arange(count), np.zeros(count, dtype=bool)


def tip(*words: str, edges: int) -> np.ndarray:
    quantities = SceneQuantities(leg(SHORT, *words))
    effects = select_effects(quantities).effects
    run = solve(quantities, effects, Settings(edges, 1e-8))
    assert run.motion.failure is None
    return run.motion.tip[:, :2]


@pytest.mark.parametrize("name", SCENES)
def test_another_discretisation_converges_to_the_same_motion(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    exact = tip(*SCENES[name], edges=4)
    monkeypatch.setattr(build_problem, "Chain", SpringChain)
    coarse, fine = (np.max(np.abs(tip(*SCENES[name], edges=n) - exact)) for n in (1, 2))
    assert coarse > 1e-9
    assert coarse / fine == pytest.approx(4.0, rel=0.25)


def test_it_serves_a_whole_simulation(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = leg(SHORT, "effects={gravity: on, others: off}")
    expected = simulate(scene)
    monkeypatch.setattr(build_problem, "Chain", SpringChain)
    found = simulate(scene)
    assert found.status == "complete"
    error = expected.accuracy.requested_m
    assert np.max(np.abs(found.tip[:, :2] - expected.tip[:, :2])) <= 2 * error


def test_the_chain_keeps_the_contract() -> None:
    rod: RodDiscretisation = Chain(Body(0.5, 2, 1.0, 1e3, 0.1), 4)
    order, internal = rod.elimination_order()
    assert sorted(order) == list(range(4 * 8))
    assert np.array_equal(internal, order < 2 * 8)
    coordinates = rod.unloaded_coordinates(np.zeros(2), np.ones(2)).reshape(-1, 2)
    assert coordinates[:, 0] == pytest.approx(0.0)
    assert coordinates[:, 1] == pytest.approx(np.arange(1, 9) / 8)
