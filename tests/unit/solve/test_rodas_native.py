"""Steps in native code against the same steps in CasADi's virtual machine."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg, problem_of
from viscodesign import simulate
from viscodesign.native.unavailable import NativeUnavailable
from viscodesign.solve.problem import Problem
from viscodesign.solve.solvers import rosenbrock
from viscodesign.solve.solvers.rodas_formulas import FormulaSteps
from viscodesign.solve.solvers.rodas_native import NativeSteps
from viscodesign.solve.statics import equilibrium
from viscodesign.solve.transient import Solution, integrate

TOLERANCE = 1e-4
SHORT = "run.duration=1 s"
SCENES = {
    "linear": leg(SHORT),
    "all effects of gas": leg(SHORT, config="leg_16_straight_air_auto"),
    "a snapping curve": leg(SHORT, config="measured_bellow"),
    "pumps at both ends": leg(SHORT, config="antagonistic_two_inlets"),
    "a payload": leg(SHORT, config="horizontal_payload"),
}
BESIDE_A_FLUID = "effects={pressure_distribution: on, others: off}"
WEIGHED = "effects={gravity: on, pressure_distribution: on, others: off}"
STATIC = {
    "a payload": leg(SHORT, "effects={inertia: off, others: auto}", config="horizontal_payload"),
    "hanging": leg(SHORT, WEIGHED, "loads.gravity=on"),
    "hanging, pulled aside": leg(
        SHORT, WEIGHED, "loads.gravity=on", "loads.tip_force.x=1 N", "loads.tip_force.z=-3 N"
    ),
    "pulled aside": leg(SHORT, BESIDE_A_FLUID, "loads.tip_force.x=2 N", config="leg_4_air"),
    "stretched": leg(SHORT, BESIDE_A_FLUID, "loads.tip_force.z=80 N", config="leg_4_air"),
    "very stiff axis": leg(SHORT, WEIGHED, "loads.gravity=on", "actuator.extension_factor=1e6"),
}
ROUND_OFF = 1e-9
"""Scaled unknowns whose equations are the same up to the order of sums."""
STATED = 0.05
"""Of the tolerance: sums that are unknowns are taken along to the order of the method."""


def solve(problem: Problem, steps: type, monkeypatch: pytest.MonkeyPatch) -> Solution:
    monkeypatch.setattr(rosenbrock, "_steps", steps)
    start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    found = integrate(problem, start, TOLERANCE, solver="rosenbrock")
    assert found.failure is None
    return found


@pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES)
def test_both_take_the_same_steps(scene: object, monkeypatch: pytest.MonkeyPatch) -> None:
    problem = problem_of(scene)  # type: ignore[arg-type]
    native = solve(problem, NativeSteps, monkeypatch)
    formulas = solve(problem, FormulaSteps, monkeypatch)
    assert native.work.native
    assert not formulas.work.native
    assert native.work.steps == formulas.work.steps
    assert native.work.residual_calls <= formulas.work.residual_calls
    for one, other in (
        (native.states, formulas.states),
        (native.integrals, formulas.integrals),
    ):
        assert np.max(np.abs(one - other)) <= STATED * TOLERANCE


@pytest.mark.parametrize("scene", STATIC.values(), ids=STATIC)
def test_a_rod_without_inertia_follows_its_loads_in_native_code(
    scene: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    problem = problem_of(scene)  # type: ignore[arg-type]
    assert problem.equations.algebraics.branch_span is not None
    native = solve(problem, NativeSteps, monkeypatch)
    formulas = solve(problem, FormulaSteps, monkeypatch)
    assert native.work.native
    assert native.attempts == formulas.attempts == ()
    assert native.work.steps == formulas.work.steps
    assert np.max(np.abs(native.states - formulas.states)) <= ROUND_OFF
    assert np.max(np.abs(native.algebraics - formulas.algebraics)) <= ROUND_OFF
    assert np.max(np.abs(native.integrals - formulas.integrals)) <= ROUND_OFF


def test_a_syringe_beside_a_rod_without_inertia_is_stepped_as_another_solver_finds() -> None:
    problem = problem_of(leg("run.duration=6 s", config="syringe_water"))
    start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    native, exact = (
        integrate(problem, start, tolerance, solver=solver)
        for tolerance, solver in ((1e-6, "rosenbrock"), (1e-9, "idas"))
    )
    assert native.failure is exact.failure is None
    assert native.work.native
    assert np.max(np.abs(native.states - exact.states)) <= 1e-5
    assert np.max(np.abs(native.algebraics - exact.algebraics)) <= 1e-5


def test_linear_laws_agree_to_round_off(monkeypatch: pytest.MonkeyPatch) -> None:
    problem = problem_of(SCENES["linear"])
    native = solve(problem, NativeSteps, monkeypatch)
    formulas = solve(problem, FormulaSteps, monkeypatch)
    assert np.max(np.abs(native.states - formulas.states)) <= ROUND_OFF
    assert np.max(np.abs(native.algebraics - formulas.algebraics)) <= ROUND_OFF


def test_without_native_code_the_virtual_machine_answers_the_same(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    scene = leg(SHORT, config="leg_4_air")
    native = simulate(scene)
    monkeypatch.setenv("VISCODESIGN_NATIVE", "off")
    found = simulate(scene)
    assert native.settings["native_code"]
    assert not found.settings["native_code"]
    allowed = native.accuracy.estimated_tip_error_m + found.accuracy.estimated_tip_error_m
    assert np.max(np.abs(found.tip[:, :2] - native.tip[:, :2])) <= allowed


def test_equations_that_are_no_local_sums_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    problem = problem_of(SCENES["linear"])
    monkeypatch.setattr(type(problem.equations), "local", property(lambda self: None))
    with pytest.raises(NativeUnavailable, match="local"):
        NativeSteps(problem, TOLERANCE)


@pytest.mark.parametrize("force", [-80, 80])
def test_an_axial_force_on_a_straight_rod_costs_no_retry(force: int) -> None:
    scene = leg(
        "run.duration=0.3 s",
        f"loads.tip_force.z={force} N",
        "effects={pressure_distribution: on, others: off}",
        config="leg_4_air",
    )
    problem = problem_of(scene)
    start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    found, other = (integrate(problem, start, 1e-7, solver=s) for s in ("rosenbrock", "idas"))
    assert found.failure is other.failure is None
    assert found.attempts == ()
    assert found.work.native
    assert np.max(np.abs(found.states - other.states)) < 1e-5
    assert np.max(np.abs(found.algebraics - other.algebraics)) < 1e-5
