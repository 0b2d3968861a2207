"""A static rod stays on its branch of stable equilibria, whatever integrates its fluid."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import casadi as ca
import numpy as np
import pytest
from scipy.optimize import brentq

from tests.scenes import leg
from tests.validation.rc_network import COMPLIANCE, columns, resistance
from viscodesign import Trajectory, simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.chain import TurningSteps
from viscodesign.model.rod_equations import COORDINATES, INTERNAL, RodForm
from viscodesign.model.step_geometry import STRAIGHT
from viscodesign.native.machine import SWITCH
from viscodesign.simulation.build_problem import Settings, build
from viscodesign.solve import branch_jumps
from viscodesign.solve.branch_following import OperatingPoint, constraints, follow_branch
from viscodesign.solve.numerics.newton import newton
from viscodesign.solve.problem import Problem, evaluate
from viscodesign.solve.solvers.base import Work
from viscodesign.solve.solvers.idas import Idas
from viscodesign.solve.statics import Start, consistent, equilibrium

BESIDE_A_FLUID = "effects={gravity: on, pressure_distribution: on, others: off}"


def made(*overrides: str, edges: int = 2) -> tuple[Problem, Start]:
    quantities = SceneQuantities(leg(*overrides))
    effects = select_effects(quantities).effects
    problem = build(quantities, effects, Settings(edges, 1e-5))
    start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    return problem, consistent(problem, start, 0.0, problem.schedule.pieces[0])


def snapping(interval: float) -> tuple[str, ...]:
    """A compressed column that its fluid bends to the other side."""
    tables = [
        f"{{kind: table, rows: [[0 s, {side * 22e3}], [4 s, {-side * 22e3}]]}}" for side in (1, -1)
    ]
    return (
        *columns(16, *tables),
        "loads.tip_force.z=-14 N",
        "fluid={name: own, viscosity: 1e-3, density: 1.2}",
        f"run={{duration: 4 s, output_interval: {interval}}}",
        BESIDE_A_FLUID,
    )


COLUMN = (
    "input={kind: constant, value: 0}",
    "loads.tip_force.z=-1 N",
    "effects={gravity: on, others: off}",
    "run={duration: 1 s}",
)
"""Perfectly straight; it buckles within the loads below."""
LOADS = np.linspace(0.5, 15.0, 30)


def jacobians(problem: Problem, here: Start) -> Iterator[ca.DM]:
    """Of the straight column's constraints, from below to above its critical load."""
    moment = OperatingPoint(here.states, 0.0, problem.schedule.pieces[0])
    for load in LOADS:
        straight = newton(partial(constraints, problem, moment, load=load), here.algebraics)
        yield constraints(problem, moment, straight, load)[1]


def reduced_stiffness(problem: Problem, matrix: np.ndarray) -> np.ndarray:
    """In the coordinates alone, scaled (n, n)."""
    unknowns = problem.equations.algebraics
    inner, place = (unknowns.blocks[n].span for n in (INTERNAL, COORDINATES))
    follow = np.linalg.solve(matrix[inner, inner], matrix[inner, place])
    full = matrix[place, inner] @ follow - matrix[place, place]
    return np.asarray((full + full.T) / 2)


@pytest.mark.parametrize("native", ["on", "off"])
def test_stability_test_agrees_with_the_smallest_eigenvalue(
    native: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Along a perfect column, from below to above its critical load."""
    monkeypatch.setenv(SWITCH, native)
    problem, here = made(*COLUMN)
    test = problem.stability
    assert test is not None
    entries, expected = [], []
    for jacobian in jacobians(problem, here):
        entries.append(np.array(jacobian.nonzeros()))
        expected.append(np.linalg.eigvalsh(reduced_stiffness(problem, jacobian.full()))[0] > 0)
    assert [test.is_stable(one) for one in entries] == expected
    assert test.are_stable(np.array(entries)).tolist() == expected
    assert expected[0]
    assert not expected[-1]


@pytest.mark.parametrize("native", ["on", "off"])
def test_singular_equations_are_not_stable_and_leave_others_so(
    native: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(SWITCH, native)
    problem, here = made(*COLUMN)
    assert problem.stability is not None
    stable = np.array(next(jacobians(problem, here)).nonzeros())
    among = np.array([stable, 0 * stable, stable])
    assert problem.stability.are_stable(among).tolist() == [True, False, True]
    assert problem.stability.are_stable(among[:0]).shape == (0,)


@pytest.mark.parametrize("edges", [1, 4])
def test_pivots_have_the_signs_of_the_eigenvalues_and_are_not_small(edges: int) -> None:
    problem, here = made(*COLUMN, edges=edges)
    unknowns = problem.equations.algebraics
    rows = np.arange(unknowns.count)
    own = np.concatenate([rows[unknowns.blocks[n].span] for n in (INTERNAL, COORDINATES)])
    order, internal = problem.rod.elimination_order()
    signs = np.where(internal, 1.0, -1.0)[:, None]
    for jacobian in jacobians(problem, here):
        matrix = jacobian.full()
        pivots = pivots_without_exchange(signs * matrix[np.ix_(own[order], own[order])])
        eigenvalues = np.linalg.eigvalsh(reduced_stiffness(problem, matrix))
        assert np.all(pivots[internal] < -0.3)
        assert np.sum(pivots[~internal] < 0) == np.sum(eigenvalues < 0)
        assert np.min(np.abs(pivots[~internal])) >= 0.1 * np.min(np.abs(eigenvalues))


def pivots_without_exchange(matrix: np.ndarray) -> np.ndarray:
    """Of Gauss' elimination row by row (n,)."""
    left = matrix.copy()
    for k in range(len(left)):
        left[k + 1 :] -= np.outer(left[k + 1 :, k] / left[k, k], left[k])
    return np.diag(left)


@pytest.mark.parametrize("interval", [0.05, 0.4])
def test_a_fold_is_located_under_an_integrator(interval: float) -> None:
    """At its place without a fluid, later by the lag of the fluid behind its ramp."""
    without = simulate(leg(*snapping(0.05), "effects={gravity: on, others: off}"), verify=False)
    ramp = _fold_time(without)
    lag = resistance(1e-3) * COMPLIANCE
    expected = brentq(lambda t: t - lag * (1 - np.exp(-t / lag)) - ramp, ramp, ramp + lag)
    run = simulate(leg(*snapping(interval)), verify=False)
    assert run.settings["rod"] == RodForm.STATIC.value
    fold = _fold_time(run)
    assert fold == pytest.approx(expected, abs=2e-3)
    assert run.time[-1] <= fold <= run.time[-1] + interval


def _fold_time(run: Trajectory) -> float:
    assert run.status == "failed"
    assert run.failure is not None
    assert "limit point" in run.failure
    return float(run.failure.split("t = ")[1].split(" s")[0])


def test_a_jump_of_the_solver_is_detected() -> None:
    """The mirrored shape is an equilibrium, too."""
    problem, here = made(*snapping(0.1))
    (states, algebraics, _), failure = Idas(problem, 1e-5)(here, 0, 3, Work())
    assert failure is None
    detector = branch_jumps.BranchJumpDetector(problem, 1e-5)
    along = np.column_stack((here.states, states))
    assert detector.first_jump(here.algebraics, 0, along, algebraics) == (3, None)
    unknowns = problem.equations.algebraics
    mirrored = algebraics.copy()
    span = unknowns.blocks[COORDINATES].span
    mirrored[span.start : span.stop : 2, 1] *= -1
    internal = unknowns.blocks[INTERNAL]
    # Curvatures, which change their sign; the axial strains after them do not.
    mirrored[internal.start : internal.start + internal.count // 2, 1] *= -1
    kept, left = detector.first_jump(here.algebraics, 0, along, mirrored)
    assert kept == 1
    assert left is not None
    assert left.quantity == "motion"
    assert "another equilibrium branch" in str(left)


def test_stability_is_looked_at_where_something_changes() -> None:
    """Ends of a slow ramp with a rest and a turn, against all of them where one is unstable."""
    problem, here = made(*snapping(0.1))
    detector = branch_jumps.BranchJumpDetector(problem, 1e-5)
    count = 1000
    load = np.interp(np.arange(count), [0, 300, 600, 699, 800, 999], [0, 0.5, 0.5, 1, 0.9, 0.9])
    states = load * np.ones((len(here.states), 1))
    every = np.repeat(here.algebraics[:, None], count, axis=1)
    looks = detector._looks(states, every, np.zeros(count - 1, dtype=bool))
    assert len(looks) < 2 * branch_jumps.JUMP.looks_per_range
    part = 1 / branch_jumps.JUMP.looks_per_range
    assert np.max(np.abs(np.diff(load[looks], prepend=0.0))) < part + np.max(np.abs(np.diff(load)))
    assert {699, 999} <= set(looks.tolist())
    assert not np.any((looks > 310) & (looks < 590))
    is_far = np.zeros(count - 1, dtype=bool)
    is_far[450] = True
    assert {450, 451} <= set(detector._looks(states, every, is_far).tolist())

    asked: list[int] = []

    class Rates:
        def __init__(self) -> None:
            self.count = count

        def jacobians(self, ends: np.ndarray) -> np.ndarray:
            asked.extend(ends.tolist())
            return load[ends][:, None]

    class UpToALoad:
        def are_stable(self, entries: np.ndarray) -> np.ndarray:
            return np.asarray(entries[:, 0] < 0.951)

    detector.stability = UpToALoad()  # type: ignore[assignment]
    found = detector._stable_ends(Rates(), looks)  # type: ignore[arg-type]
    assert np.array_equal(found, load < 0.951)
    assert len(asked) == len(set(asked)) < 300


@pytest.mark.parametrize("interval", [0.01, 0.4])
def test_few_looks_find_the_same_fold(interval: float, monkeypatch: pytest.MonkeyPatch) -> None:
    run = simulate(leg(*snapping(interval)), verify=False)
    monkeypatch.setattr(
        branch_jumps.BranchJumpDetector,
        "_looks",
        lambda self, states, every, is_far: np.arange(every.shape[1]),
    )
    full = simulate(leg(*snapping(interval)), verify=False)
    assert run.failure == full.failure
    assert "limit point" in (run.failure or "")
    assert np.array_equal(run.tip, full.tip)


def test_only_a_static_rod_beside_a_fluid_has_branches() -> None:
    arcs, _ = made("effects={pressure_distribution: on, others: off}", "run={duration: 1 s}")
    assert not branch_jumps.has_branches(arcs)
    beside, _ = made(BESIDE_A_FLUID, "run={duration: 1 s}", "loads.gravity=on")
    assert branch_jumps.has_branches(beside)


def test_following_a_branch_ends_at_a_solution() -> None:
    problem, here = made(*snapping(0.1))
    piece = problem.schedule.pieces[0]
    rates, _ = evaluate(
        problem.equations.function, here.states, here.algebraics, *problem.tail(0.0, piece)
    )
    before = OperatingPoint(here.states, 0.0, piece)
    after = OperatingPoint(here.states + 0.1 * np.array(rates).ravel(), 0.1, piece)
    found = follow_branch(problem, here.algebraics, before, after)
    residual, _ = constraints(problem, after, found)
    assert np.max(np.abs(residual)) <= 1e-9
    assert before.towards(after, 0.25).time == pytest.approx(0.025)


def test_turning_steps_preserve_lengths_to_second_order() -> None:
    chords = np.array([[0.0, 1.0], [0.3, 0.9], [0.5, 0.7]])
    y = np.append(np.cumsum(chords, axis=0).ravel(), 7.0)
    turn = np.append(np.cumsum(np.column_stack((chords[:, 1], -chords[:, 0])), axis=0).ravel(), 1.0)
    geometry = TurningSteps(slice(0, 6))
    for angle in (1e-4, 0.3):
        after = geometry.step(y, angle * turn)
        lengths = np.hypot(*np.diff(after[:6].reshape(-1, 2), axis=0, prepend=0.0).T)
        assert lengths == pytest.approx(np.hypot(*chords.T), rel=1e-12)
        assert after[6] == pytest.approx(7.0 + angle)
    small = 1e-6 * turn
    assert geometry.step(y, small) == pytest.approx(STRAIGHT.step(y, small), abs=1e-11)


def test_extrapolation_repeats_the_turn() -> None:
    geometry = TurningSteps(slice(0, 2))
    points = [np.array([np.sin(a), np.cos(a)]) for a in (0.1, 0.4, 1.0)]
    assert geometry.extrapolate(points[0], points[1], 2.0) == pytest.approx(points[2])
    assert STRAIGHT.extrapolate(np.zeros(2), np.ones(2), 0.5) == pytest.approx(np.full(2, 1.5))
