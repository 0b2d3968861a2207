"""Formulas are made once per structure and never reused for another."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from casadi import SX

from tests.scenes import CONFIGS, leg
from viscodesign import load_several
from viscodesign.effects.base import Effect
from viscodesign.effects.catalogue import catalogue
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model import formulation
from viscodesign.model.chain import Chain
from viscodesign.model.chain_symbols import ChainSymbols
from viscodesign.model.rod import Body, RodParameters
from viscodesign.model.system import System
from viscodesign.simulation.build_problem import Settings, build
from viscodesign.simulation.solve_once import Run, solve
from viscodesign.solve.problem import evaluate
from viscodesign.solve.transient import DEFAULT_SOLVER

EFFECTS = "effects={pressure_distribution: on, inertia: on, damping: on, feedback: on, others: off}"
SHORT = "run={duration: 0.3 s, output_interval: 0.05 s}"
STILL = "input={kind: constant, value: 0}"
SIDEWAYS = "loads.gravity={tilt: 90 deg}"
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


def solved(*overrides: str, solver: str = DEFAULT_SOLVER) -> Run:
    quantities = SceneQuantities(leg(SHORT, EFFECTS, *overrides))
    return solve(quantities, select_effects(quantities).effects, Settings(1, 1e-6, solver))


@pytest.fixture(autouse=True)
def _nothing_kept() -> None:
    formulation._kept.clear()


PULSES = [
    ("input.start=30 kPa", "input.fall_time=0.2 s", "input.transition=0.3 s"),
    (
        "input={kind: sine, amplitude: 10 kPa, frequency: 1}",
        "input={kind: sine, amplitude: 9 kPa, frequency: 2, phase: 1, mean: 1 kPa}",
    ),
    (
        "input={kind: table, rows: [[0, 0], [0.1, 9e3]]}",
        "input={kind: table, rows: [[0, 1e3], [0.1, 5e3], [0.2, 2e3]]}",
    ),
    ("input={kind: step, value: 9e3}", "input={kind: constant, value: 1e3}"),
]


@pytest.mark.parametrize("changes", PULSES)
def test_inputs_that_differ_in_numbers_share_formulas(changes: tuple[str, ...]) -> None:
    found = [solved(change).problem.equations.formulas for change in changes]
    assert all(formulas is found[0] for formulas in found)


def test_other_output_times_compile_nothing_but_an_integrator() -> None:
    first = solved().problem.equations
    before = len(first.shared._compiled)
    solved("run={duration: 0.29 s, output_interval: 0.01 s}")
    assert len(first.shared._compiled) == before


@pytest.mark.parametrize("change", SAME)
def test_scenes_that_differ_in_numbers_share_formulas(change: str) -> None:
    first = solved().problem.equations
    second = solved(change)
    assert second.problem.equations.function is first.function
    formulation._kept.clear()
    fresh = solved(change)
    assert fresh.problem.equations.function is not first.function
    assert np.array_equal(second.motion.tip, fresh.motion.tip)
    assert np.array_equal(second.motion.pressure, fresh.motion.pressure)


@pytest.mark.parametrize("change", OTHER)
def test_another_structure_has_its_own_formulas(change: str) -> None:
    first = solved().problem.equations
    assert (
        solved(
            change, *(["effects.gravity=on"] if "gravity" in change else [])
        ).problem.equations.function
        is not first.function
    )


def test_a_second_simulation_reuses_the_integrator() -> None:
    solved(solver="idas")
    again = solved("actuator.damping_time=2 ms", solver="idas")
    assert again.solution.work.compile_s <= 1e-3


@pytest.mark.parametrize("name", list(catalogue()))
def test_every_effect_changes_the_structure(name: str) -> None:
    """The structures with and without it differ."""
    from tests.contract.test_effects import LOADED

    quantities = SceneQuantities(leg(*LOADED))
    effect = catalogue()[name].of(quantities)
    if not effect.present(quantities):
        pytest.skip("the scene has nothing for it")
    base = [
        catalogue()["pressure_distribution"].of(quantities),
        catalogue()["gravity"].of(quantities),
    ]
    base += [catalogue()["inertia"].of(quantities)]
    without = [e for e in base if e.name != name]
    order = list(catalogue())
    joined = sorted([*without, effect], key=lambda e: order.index(e.name))
    settings = Settings(1, 1e-4)
    one = build(quantities, joined, settings).equations
    other = build(quantities, without, settings).equations
    assert one.function is not other.function


def test_old_structures_are_dropped() -> None:
    for count in range(2, 2 * (formulation.MAX_STRUCTURES + 3), 2):
        quantities = SceneQuantities(leg(SHORT, f"bellows.count={count}", "effects={others: off}"))
        build(quantities, select_effects(quantities).effects, Settings(4, 1e-4))
    assert len(formulation._kept) == formulation.MAX_STRUCTURES


class _Stiffer(Effect):
    """A rod four times as stiff: one line that changes the elastic energy."""

    name = "stiffer"
    formula = "4"

    @classmethod
    def of(cls, quantities: SceneQuantities) -> _Stiffer:
        return cls()

    def weight(self, quantities: SceneQuantities) -> float:
        return 4.0

    def reason(self, quantities: SceneQuantities) -> str:
        return "four times as stiff"

    def join(self, system: System) -> None:
        system.scale_stiffness(bending=4.0)


def test_an_effect_on_the_rods_stiffness_does_not_depend_on_earlier_runs() -> None:
    quantities = SceneQuantities(leg(SHORT, STILL, "effects={gravity: on, others: off}", SIDEWAYS))
    plain = select_effects(quantities).effects
    first = solve(quantities, plain, Settings(1, 1e-6)).motion.tip
    stiff = solve(quantities, [_Stiffer(), *plain], Settings(1, 1e-6)).motion.tip
    formulation._kept.clear()
    alone = solve(quantities, [_Stiffer(), *plain], Settings(1, 1e-6)).motion.tip
    assert np.array_equal(stiff, alone)
    assert stiff[0, 0] / first[0, 0] == pytest.approx(0.25, rel=0.02)


def test_every_one_of_joined_rods_is_stiffer() -> None:
    loads = (f"actuators.{name}.loads={{tip_force: {{x: 5 mN}}}}" for name in ("long", "short"))
    spec = load_several(CONFIGS / "two_legs.yaml", [SHORT, *loads])
    (scene,) = spec.joined
    quantities = SceneQuantities(scene)
    plain = [e for e in select_effects(quantities).effects if e.name == "tip_load"]
    soft, stiff = (
        solve(quantities, effects, Settings(1, 1e-6)).motion.tips(slice(0, 1))
        for effects in (plain, [_Stiffer(), *plain])
    )
    assert stiff[0, :, 0] / soft[0, :, 0] == pytest.approx(0.25, rel=0.1)


def test_the_rods_law_cannot_change_once_something_was_said_of_it() -> None:
    quantities = SceneQuantities(leg(SHORT, STILL, "effects={gravity: on, others: off}", SIDEWAYS))
    plain = select_effects(quantities).effects
    with pytest.raises(ValueError, match="`order` below 5"):
        solve(quantities, [*plain, _Stiffer()], Settings(1, 1e-6))


def test_a_stiffness_is_not_set_by_hand() -> None:
    """Of several rods none would notice."""
    rod = Chain(Body(0.1, 2, 0.1, 600.0, 0.3), 2).symbols(
        RodParameters(*(SX.sym(name) for name in ("EI", "EA", "h", "m", "l")))
    )
    with pytest.raises(AttributeError):
        rod.bending_stiffness = 4 * rod.bending_stiffness  # type: ignore[misc]


def test_scene_numbers_cannot_enter_formulas_as_constants(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Formulas are shared by scenes with other numbers, for which a constant would be wrong."""

    def careless(self: ChainSymbols) -> list[SX]:
        stiffness = SX(self.body.bending_stiffness)
        return [stiffness * ca.dot(self.elastic_curvature, self.elastic_turns)]

    monkeypatch.setattr(ChainSymbols, "elastic_energies", careless)
    quantities = SceneQuantities(leg(SHORT, "effects={gravity: on, others: off}", SIDEWAYS))
    effects = select_effects(quantities).effects
    problem = build(quantities, effects, Settings(1, 1e-6))
    values = evaluate(
        problem.equations.static_function,
        np.zeros(problem.equations.statics.count),
        *problem.tail(0.0, problem.schedule.initial_piece),
    )
    assert np.isnan(np.array(values[0])).any()


@pytest.mark.parametrize("name", ["length", "compliance"])
def test_a_parameter_has_one_value(name: str) -> None:
    class Careless(_Stiffer):
        def join(self, system: System) -> None:
            system.parameter(name, 123.0)

    quantities = SceneQuantities(leg(SHORT, EFFECTS))
    with pytest.raises(ValueError, match=f"parameter '{name}' is .* already"):
        build(quantities, [*select_effects(quantities).effects, Careless()], Settings(1, 1e-6))
