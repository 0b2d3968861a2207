"""Time integration: pulses, restarts, work budgets, partial results."""

from __future__ import annotations

import itertools
import threading

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import Trajectory, simulate
from viscodesign.effects.select import select_effects
from viscodesign.errors import SolveError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.simulation.build_problem import Settings, build, schedule
from viscodesign.solve import transient
from viscodesign.solve.problem import Problem
from viscodesign.solve.statics import equilibrium
from viscodesign.solve.transient import integrate, solver_catalogue

ONE_WAY = "effects={pressure_distribution: on, others: off}"
DYNAMIC = "effects={pressure_distribution: on, inertia: on, damping: on, feedback: on, others: off}"
TINY = "fluid={name: thin, viscosity: 1e-10, density: 1}"


@pytest.mark.parametrize("effects", [ONE_WAY, DYNAMIC])
@pytest.mark.parametrize(
    "pulse",
    [
        "{kind: table, rows: [[0, 0], [41.0003, 0], [41.0003, 5e3], [41.0013, 5e3], [41.0013, 0], [60, 0]]}",
        "{kind: double_sigmoid, start: 0, drop: -5 kPa, fall_time: 41 s, rise_time: 41.001 s, transition: 0.1 ms}",
    ],
)  # fmt: skip
def test_a_millisecond_pulse_in_a_minute_is_not_stepped_over(pulse: str, effects: str) -> None:
    """With so thin a fluid the pulse reaches the first bellow undamped, visible at its middle."""
    found = simulate(
        leg(
            f"input={pulse}", effects, TINY, "run={duration: 60 s, output_times: [40, 41.0008, 60]}"
        )
    )
    assert found.status == "complete"
    first = found.pressure[:, found.bellows.index("R1")]
    assert first[1] == pytest.approx(5e3, rel=0.02)
    assert abs(first[2]) <= 50


def test_output_times_do_not_change_the_answer() -> None:
    every = simulate(leg("run={duration: 2 s, output_interval: 0.01 s}"), verify=False)
    few = simulate(leg("run={duration: 2 s, output_times: [0.5, 1.23, 2]}"), verify=False)
    at = [round(t / 0.01) for t in (0.5, 1.23, 2)]
    assert np.max(np.abs(every.tip[at] - few.tip)) <= 0.005


def test_swapping_columns_mirrors_the_motion() -> None:
    def network(a: str, b: str) -> str:
        nodes = ["inlet", *(f"{a}{j}" for j in range(1, 9)), *(f"{b}{j}" for j in range(8, 0, -1))]
        tubes = ", ".join(
            f"{{from: {m}, to: {n}, length: 37.5 mm, radius: 0.325 mm}}"
            for m, n in itertools.pairwise(nodes)
        )
        return f"network={{layout: custom, tubes: [{tubes}]}}"

    right, left = (simulate(leg(network(*ab)), verify=False) for ab in (("R", "L"), ("L", "R")))
    mirrored = left.tip * (-1, 1, -1)
    assert np.max(np.abs(right.tip - mirrored)) <= 1e-12


def test_work_budget_of_the_leg() -> None:
    """Counts for the paper's leg with all effects, independent of any clock."""
    found = simulate(leg("loads.gravity=on", "effects={others: on}"), verify=False)
    assert found.status == "complete"
    assert found.cost.steps <= 900
    assert found.cost.residual_calls <= 1800
    assert found.cost.jacobian_calls <= 200
    assert found.settings["states"] <= 70


def test_work_budget_of_the_quasi_static_leg() -> None:
    """Linear equations take no steps: a response for every output, and no residual at all."""
    found = simulate(leg(ONE_WAY), verify=False)
    assert found.settings["solver"] == "modes"
    assert found.cost.steps <= len(found.time) + 1
    assert found.cost.residual_calls == 0
    assert found.settings["states"] == 17


def test_a_vanishing_section_ends_the_run() -> None:
    found = simulate(
        leg(
            "input={kind: table, rows: [[0, 0], [1, 0], [3, -400 kPa], [8, -400 kPa]]}",
            "effects={others: off}",
        )
    )
    assert found.status == "failed"
    assert found.failure is not None
    assert "section 1" in found.failure
    assert "t = " in found.failure
    assert 1.0 < found.time[-1] < 3.0
    assert np.all(np.isfinite(found.tip))


def test_a_start_with_a_vanished_section_is_refused() -> None:
    with pytest.raises(SolveError, match="section"):
        simulate(leg("input={kind: constant, value: -400 kPa}", "effects={others: off}"))


def test_a_negative_blocked_compliance_is_refused_with_its_number() -> None:
    from viscodesign.errors import SpecError

    reciprocal = 10.266 / 1.8e6 / 0.018
    with pytest.raises(SpecError, match=r"-1\.51\d*e-10"):
        simulate(leg(f"bellows.area_per_moment={reciprocal!r}"))


CRITICAL_LOAD = 2.5086267 * 0.04455 / 0.109**2  # N, of the extensible column (exact root)


def column(load: float, imperfection: float) -> Trajectory:
    return simulate(
        leg(
            "input={kind: constant, value: 0}",
            f"loads.tip_force={{x: {imperfection!r} N, z: {-load * CRITICAL_LOAD!r} N}}",
            "effects={others: off}",
            "run={duration: 0.1 s, output_interval: 0.1 s}",
        )
    )


def test_a_compressed_column_buckles_to_the_side_of_its_imperfection() -> None:
    """Not onto the straight branch, whose equilibria are unstable."""
    found = column(1.1, 1e-3 * 0.04455 / 0.109**2)
    assert found.status == "complete"
    assert found.tip[-1, 0] == pytest.approx(0.5 * 0.109, rel=0.05)
    assert abs(column(0.9, 1e-6).tip[-1, 0]) < 1e-3 * 0.109


def test_a_perfect_column_above_its_critical_load_is_refused() -> None:
    with pytest.raises(SolveError, match=r"no stable equilibrium.* ends at 9\d"):
        column(1.05, 0.0)


def _limited(monkeypatch: pytest.MonkeyPatch, limit: float) -> None:
    """Make IDAS fail after a time."""
    import casadi as ca

    real = ca.integrator

    def limited(
        name: str, plugin: str, dae: object, t0: float, grid: np.ndarray, options: object
    ) -> object:
        if grid[-1] > limit:
            raise RuntimeError("IDASolve returned IDA_ERR_FAIL")
        return real(name, plugin, dae, t0, grid, options)

    monkeypatch.setattr(ca, "integrator", limited)


def _one_way() -> Problem:
    quantities = SceneQuantities(leg(ONE_WAY, "run={duration: 4 s, output_interval: 0.1 s}"))
    effects = select_effects(quantities).effects
    return build(quantities, effects, Settings(1, 1e-4))


def test_results_before_a_failure_are_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    """Bisection finds the last edge before an integrator fails."""
    problem = _one_way()
    edges = problem.schedule.edges
    last = int(np.searchsorted(edges, 2.45)) - 1
    _limited(monkeypatch, 2.45)
    for other in set(solver_catalogue()) - {"idas"}:
        monkeypatch.setattr(solver_catalogue()[other], "fits", lambda problem: False)
    start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    solution = integrate(problem, start, 1e-4, solver="idas")
    assert solution.failure is not None
    assert solution.failure.time_s == pytest.approx(edges[last])
    assert solution.reached == last + 1
    assert solution.states.shape[1] == solution.integrals.shape[1] == last + 1
    assert [attempt.solved for attempt in solution.attempts] == [False] * len(solution.attempts)
    assert solution.attempts[0].time_s == pytest.approx(edges[last])
    assert "IDA_ERR_FAIL" in solution.attempts[0].reason


def test_another_solver_takes_over_where_one_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    problem = _one_way()
    start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    _limited(monkeypatch, 2.45)
    solution = integrate(problem, start, 1e-4, solver="idas")
    monkeypatch.undo()
    whole = integrate(problem, start, 1e-4, solver="idas")
    assert solution.failure is None
    assert solution.reached == whole.reached
    assert [attempt.tried for attempt in solution.attempts if attempt.solved] == [
        "Rodas5P instead"
    ] * 2
    assert np.max(np.abs(solution.states - whole.states)) <= 0.02
    assert np.max(np.abs(solution.integrals - whole.integrals)) <= 2e-3 * np.max(
        np.abs(whole.integrals)
    )


def test_schedule_has_outputs_and_corners_without_duplicates() -> None:
    scene = leg(
        "input={kind: square, high: 1 kPa, low: 0, frequency: 4 Hz}",
        "run={duration: 1 s, output_interval: 0.1 s}",
    )
    made = schedule(scene)
    assert np.all(np.diff(made.edges) > 0)
    assert made.edges[made.outputs] == pytest.approx(np.linspace(0, 1, 11))
    assert set(np.round([0.125, 0.25, 0.375], 9)) <= set(np.round(made.edges, 9))
    assert len(made.pieces) == len(made.edges) - 1


def test_solving_outside_the_main_thread() -> None:
    results: list[str] = []
    thread = threading.Thread(
        target=lambda: results.append(simulate(leg(ONE_WAY), verify=False).status)
    )
    thread.start()
    thread.join()
    assert results == ["complete"]


@pytest.mark.parametrize("start", ["rest", "equilibrium"])
@pytest.mark.parametrize("inertia", ["on", "off"])
@pytest.mark.parametrize("distribution", ["on", "off"])
def test_every_combination_of_start_and_forms_runs(
    start: str, inertia: str, distribution: str
) -> None:
    found = simulate(
        leg(
            "gauge_pressure=1 kPa",
            "loads.gravity.tilt=40 deg",
            "input={kind: sine, amplitude: 3 kPa, frequency: 1 Hz}",
            f"effects={{inertia: {inertia}, damping: {inertia}, gravity: on, feedback: on, "
            f"pressure_distribution: {distribution}}}",
            f"run={{duration: 1 s, start: {start}}}",
        )
    )
    assert found.status == "complete", found.failure
    assert np.all(np.isfinite(found.tip))
    assert found.invariants.volume_imbalance_rel is not None
    assert found.invariants.volume_imbalance_rel <= 1e-8
    energy = found.invariants.energy_imbalance_rel
    assert energy is None or energy <= 2e-3


def test_sealed_parts_conserve_their_fluid() -> None:
    tubes = "{from: inlet, to: R1, length: 4 cm}, {from: L1, to: L2, length: 4 cm}"
    found = simulate(
        leg(
            "bellows.count=4",
            f"network={{layout: custom, tube_radius: 0.3 mm, tubes: [{tubes}]}}",
            "gauge_pressure=2 kPa",
            "effects={inertia: on, damping: on, feedback: on, pressure_distribution: on, others: off}",
            "loads.tip_force.x=0.2 N",
        )
    )
    assert found.status == "complete"
    island = [found.bellows.index(b) for b in ("L1", "L2")]
    held = found.volume[:, island].sum(axis=1)
    assert np.max(np.abs(held - held[0])) <= 1e-12 * held[0]
    alone = found.volume[:, found.bellows.index("R2")]
    assert np.max(np.abs(alone - alone[0])) <= 1e-12 * alone[0]
    assert {w.code for w in found.warnings} >= {"sealed_island"}


@pytest.mark.parametrize("pace", [1e-9, 10.0])
def test_results_of_a_long_run_do_not_depend_on_wall_time(
    monkeypatch: pytest.MonkeyPatch, pace: float
) -> None:
    scene = leg(
        "input={kind: sine, amplitude: 20 kPa, frequency: 0.5 Hz}",
        "run={duration: 100 s, output_interval: 10 ms}",
        ONE_WAY,
    )
    once = simulate(scene, verify=False)
    told = itertools.count()
    monkeypatch.setattr(transient.clock, "perf_counter", lambda: pace * next(told))
    again = simulate(scene, verify=False)
    assert again.cost.steps == once.cost.steps
    assert np.array_equal(again.tip, once.tip)
