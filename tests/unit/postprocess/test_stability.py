"""Eigenvalues about a start: frequencies, decay, and reported growth."""

from __future__ import annotations

import re

import numpy as np
import pytest

from tests.scenes import LEG_EA, LEG_EI, LEG_LENGTH, STILL, leg
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.postprocess import stability
from viscodesign.postprocess.stability import eigenvalues, growth_notices
from viscodesign.simulation.build_problem import Settings, build
from viscodesign.solve.problem import Problem
from viscodesign.solve.statics import Start, equilibrium

MASS = 0.269
"""Of the references [kg/m]."""
DENSITY = f"actuator.density={MASS / (0.03 * 0.02 * 0.47)!r}"
AIR = "fluid={name: thin air, viscosity: 2e-5, density: 1.2}"
COUPLED = "effects={pressure_distribution: on, inertia: on, feedback: on, others: off}"
ROOTS = np.array([1.8751040687, 4.6940911330, 7.8547574382])
"""Of cos(b) cosh(b) = -1: a clamped-free beam."""


def start(*overrides: str, edges: int = 4) -> tuple[Problem, Start]:
    quantities = SceneQuantities(leg(STILL, DENSITY, *overrides))
    effects = select_effects(quantities).effects
    problem = build(quantities, effects, Settings(edges, 1e-6))
    return problem, equilibrium(problem, 0.0, problem.schedule.initial_piece)


def nearest(values: np.ndarray, frequencies: np.ndarray) -> np.ndarray:
    """The eigenvalue nearest to each frequency."""
    apart = np.abs(values.imag[None, :] - np.atleast_1d(frequencies)[:, None])
    return np.asarray(values[np.argmin(apart, axis=1)])


def test_frequencies_of_an_undamped_rod_are_those_of_a_beam() -> None:
    values = eigenvalues(*start("effects={inertia: on, others: off}"))
    bending = ROOTS**2 * np.sqrt(LEG_EI / MASS) / LEG_LENGTH**2
    along = np.pi / 2 * np.sqrt(LEG_EA / MASS) / LEG_LENGTH
    expected = np.append(bending, along)
    found = nearest(values, expected)
    assert found.imag == pytest.approx(expected, rel=1e-3)
    assert np.max(np.abs(values.real)) <= 1e-6 * expected[0]


def test_damping_is_that_of_kelvin_voigt() -> None:
    """Kelvin and Voigt: lambda^2 + omega^2 tau lambda + omega^2 = 0."""
    time = 1e-3
    values = eigenvalues(
        *start("effects={inertia: on, damping: on, others: off}", f"actuator.damping_time={time}")
    )
    free = ROOTS[0] ** 2 * np.sqrt(LEG_EI / MASS) / LEG_LENGTH**2
    (found,) = nearest(values, free)
    assert found.real == pytest.approx(-(free**2) * time / 2, rel=1e-3)
    assert found.imag == pytest.approx(free * np.sqrt(1 - (free * time / 2) ** 2), rel=1e-4)


def test_two_way_coupling_damps_the_first_mode() -> None:
    """-0.111938 +- 121.16722i, by a spectral code of the same coupled equations."""
    values = eigenvalues(*start(COUPLED, AIR, "loads.gravity=off", edges=8))
    (found,) = nearest(values, 121.0)
    assert found.real == pytest.approx(-0.111938, rel=2e-3)
    assert found.imag == pytest.approx(121.16722, rel=1e-4)


def test_instability_is_reported_with_rate_and_frequency() -> None:
    """0.1639 1/s at 594.65 rad/s under (10, -5) N, by the same code."""
    forced = "loads.tip_force={x: 10 N, z: -5 N}"
    (notice,) = growth_notices(*start(COUPLED, AIR, forced, edges=6))
    assert notice.code == "self_excited"
    said = re.search(r"at (\S+) 1/s and (\S+) rad/s", notice.message)
    assert said is not None
    assert [float(n) for n in said.groups()] == pytest.approx([0.1639, 594.65], rel=0.02)


def test_stable_and_undamped_modes_are_not_reported() -> None:
    assert growth_notices(*start("effects={inertia: on, others: off}")) == []
    assert (
        growth_notices(*start(COUPLED.replace("inertia: on", "inertia: on, damping: on"), AIR))
        == []
    )


def test_a_rod_without_inertia_has_no_stability_notice() -> None:
    assert growth_notices(*start("effects={gravity: on, others: off}")) == []


def test_large_systems_are_not_analysed(monkeypatch: pytest.MonkeyPatch) -> None:
    problem, here = start("effects={inertia: on, others: off}")
    monkeypatch.setattr(stability, "MAX_STATES", problem.equations.states.count - 1)
    monkeypatch.setattr(stability, "eigenvalues", lambda *_: pytest.fail("it was computed"))
    assert growth_notices(problem, here) == []


@pytest.mark.parametrize(
    ("values", "told"),
    [
        ([1e-3, 100j, -100j], True),
        ([1e-5, 100j, -100j], False),
        ([0.5, -1.0], True),
        ([1e-7, -1.0], False),
    ],
)
def test_round_off_is_not_growth(
    values: list[complex], told: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Growth is relative to the slowest frequency, or the fastest decay."""
    problem, here = start("effects={inertia: on, others: off}")
    monkeypatch.setattr(stability, "eigenvalues", lambda *_: np.array(values, dtype=complex))
    assert bool(growth_notices(problem, here)) is told
