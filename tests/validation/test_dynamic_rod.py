"""The rod in motion, alone and coupled, against closed forms and independent solutions."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import (
    LEG_EI,
    LEG_LENGTH,
    LEG_MASS_PER_LENGTH,
    STILL,
    chain_order,
    in_order,
    leg,
    reference,
)
from viscodesign import simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.postprocess.motion import read_motion
from viscodesign.postprocess.stability import eigenvalues
from viscodesign.simulation.build_problem import Settings, build
from viscodesign.solve.initial_guess import unloaded
from viscodesign.solve.problem import Problem
from viscodesign.solve.statics import from_statics, rest
from viscodesign.solve.transient import integrate

UNDAMPED = "effects={inertia: on, others: off}"
REFERENCE_DENSITY = 0.269 / (0.03 * 0.02 * 0.47)
"""The references use 0.269 kg/m, the paper's rounded mass per length."""


def problem_of(edges_per_section: int, *overrides: str) -> Problem:
    quantities = SceneQuantities(leg(*overrides))
    effects = select_effects(quantities).effects
    return build(quantities, effects, Settings(edges_per_section, 1e-8))


def linear_modes(problem: Problem) -> np.ndarray:
    """Eigenvalues of the motion linearised about the straight rod at rest [1/s]."""
    return eigenvalues(problem, rest(problem, problem.schedule.initial_piece))


def bending_frequencies(problem: Problem) -> np.ndarray:
    """Angular frequencies, ascending [rad/s]; axial modes of the leg lie between them."""
    values = linear_modes(problem)
    return np.unique(np.round(values.imag[values.imag > 1.0], 6))


def test_first_natural_frequencies() -> None:
    """A rod so stiff along its axis that its axial modes are far higher."""
    problem = problem_of(
        4,
        STILL,
        UNDAMPED,
        f"actuator.density={REFERENCE_DENSITY!r}",
        "actuator.extension_factor=1e3",
    )
    exact = np.array(reference("rod_static")["frequencies"]["paper_omega_rad_s"][:3], dtype=float)
    found = bending_frequencies(problem)[:3]
    assert found == pytest.approx(exact, rel=2e-4)


def test_axial_frequencies() -> None:
    problem = problem_of(4, STILL, UNDAMPED, f"actuator.density={REFERENCE_DENSITY!r}")
    exact = 2 * np.pi * float(reference("rod_static")["frequencies"]["axial_f_Hz"][0])
    found = bending_frequencies(problem)
    assert np.min(np.abs(found / exact - 1)) <= 1e-3


@pytest.mark.parametrize("damping_time", [1e-4, 1e-3])
def test_small_vibration_decays_as_a_damped_mode(damping_time: float) -> None:
    """Kelvin-Voigt: the ratio of a mode of angular frequency w is damping_time w / 2."""
    problem = problem_of(
        4,
        STILL,
        "effects={inertia: on, damping: on, others: off}",
        f"actuator.damping_time={damping_time}",
    )
    modes = linear_modes(problem)
    oscillating = modes[modes.imag > 1.0]
    first = oscillating[np.argmin(np.abs(oscillating))]
    ratio = damping_time * abs(first) / 2
    assert -first.real / abs(first) == pytest.approx(ratio, rel=2e-3)
    omega = 3.516015268500151 * np.sqrt(LEG_EI / LEG_MASS_PER_LENGTH) / LEG_LENGTH**2
    assert abs(first) == pytest.approx(omega, rel=1e-3)


def test_released_damped_rod_follows_its_closed_form() -> None:
    """A small side load applied suddenly: the first mode rings down about the deflection.

    The load's share of mode n is known, so the sum of the first modes is the exact
    linear answer; the tip is followed through four periods.
    """
    force, damping_time = 0.05, 1e-3  # bends the tip by 0.4 % of the length
    times = np.linspace(0.01, 0.2, 39)
    found = simulate(
        leg(
            STILL,
            f"loads.tip_force.x={force}",
            "effects={inertia: on, damping: on, others: off}",
            f"actuator.damping_time={damping_time}",
            f"run={{duration: 0.2 s, start: rest, output_times: {times.tolist()}}}",
            "accuracy=0.001 %",
        ),
    )
    beta = np.array(reference("rod_static")["frequencies"]["betaL"], dtype=float)
    omega = beta**2 * np.sqrt(LEG_EI / LEG_MASS_PER_LENGTH) / LEG_LENGTH**2
    # Unit-mass modes have the tip value 2, whatever n.
    stiffness = LEG_MASS_PER_LENGTH * LEG_LENGTH * omega**2 / 4
    ratio = damping_time * omega / 2
    decay = np.exp(-np.outer(times, ratio * omega))
    damped = omega * np.sqrt(np.maximum(1 - ratio**2, 1e-12))
    ring = np.cos(np.outer(times, damped)) + ratio * omega / damped * np.sin(
        np.outer(times, damped)
    )
    exact = (force / stiffness * (1 - np.where(ratio < 1, decay * ring, 0.0))).sum(axis=1)
    assert np.max(np.abs(found.tip[:, 0] - exact)) <= 2e-5 * LEG_LENGTH


def test_two_way_coupled_leg_hanging_in_gravity() -> None:
    """The whole core at once: network, feedback, inertia, gravity, large deflection; undamped."""
    case = reference("rod_dynamic")["coupled_leg_straight_two_way_hanging_in_gravity"]
    problem = problem_of(
        2,
        "fluid={name: thin air, viscosity: 2e-5, density: 1.2}",
        f"actuator.density={REFERENCE_DENSITY!r}",
        "loads.gravity=on",
        "effects={inertia: on, feedback: on, pressure_distribution: on, gravity: on, others: off}",
        f"run={{duration: 2 s, output_times: {case['times']}}}",
    )
    # The reference starts in equilibrium without weight; gravity then acts suddenly.
    piece = problem.schedule.initial_piece
    start = from_statics(problem, unloaded(problem, 0.0, piece), 0.0, piece)
    motion = read_motion(problem, integrate(problem, start, 1e-7))
    tip, pressure = np.array(case["tip"]), np.array(case["p"])
    assert np.max(np.abs(motion.tip[:, :2] - tip[:, :2])) <= 1e-5 * LEG_LENGTH
    assert np.max(np.abs(motion.tip[:, 2] - tip[:, 2])) <= 5e-4
    found = in_order(motion.pressure, problem.bellows, chain_order(8))
    assert np.max(np.abs(found - pressure)) <= 2e-5 * np.ptp(pressure)
    assert motion.invariants.volume_imbalance_rel is not None
    assert motion.invariants.volume_imbalance_rel <= 1e-8
