"""Shear: Timoshenko's beam in small motions, Reissner's rod in large ones."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import LEG_EA, LEG_EI, LEG_LENGTH, STILL, leg
from tests.validation.ringing import rayleigh_frequencies
from tests.validation.timoshenko import bent_tip, critical_load, timoshenko_frequencies
from viscodesign import Trajectory, check, simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.rod_equations import COORDINATES, SECTION_ANGLES
from viscodesign.postprocess.stability import eigenvalues
from viscodesign.simulation.build_problem import Settings, build
from viscodesign.solve.problem import Problem
from viscodesign.solve.statics import equilibrium

MODULUS, DENSITY, SOLID = 1.8e6, 950.0, 0.47
HEIGHT, WIDTH, BENDING, EXTENSION = 0.03, 0.02, 0.55, 0.53
SHEAR_STIFFNESS = 5 / 6 * MODULUS / 3 * HEIGHT * WIDTH * EXTENSION
SOFTNESS = LEG_EI / (SHEAR_STIFFNESS * LEG_LENGTH**2)
ETA = LEG_EA * LEG_LENGTH**2 / LEG_EI
FORCE = LEG_EI / LEG_LENGTH**2
ONLY = "effects={shear: on, others: off}"
ONCE = "run={duration: 1 s, output_interval: 1 s}"


def problem_of(edges: int, *overrides: str) -> Problem:
    quantities = SceneQuantities(leg(STILL, ONCE, *overrides))
    return build(quantities, select_effects(quantities).effects, Settings(edges, 1e-6))


def tip_of(edges: int, *overrides: str) -> np.ndarray:
    """x, z and angle of the last edge, at rest, with so many edges in a section (3,)."""
    problem = problem_of(edges, *overrides)
    start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    unknowns = problem.equations.algebraics
    places = unknowns.physical(COORDINATES, start.algebraics)
    angles = unknowns.physical(SECTION_ANGLES, start.algebraics)
    return np.array([places[-2], places[-1], angles[-1]])


# -- at rest ------------------------------------------------------------------


def test_a_tip_load_deflects_by_bending_and_shear() -> None:
    force = 1e-4
    found = simulate(leg(STILL, ONLY, ONCE, f"loads.tip_force.x={force}"))
    bending = force * LEG_LENGTH**3 / (3 * LEG_EI)
    shear = force * LEG_LENGTH / SHEAR_STIFFNESS
    assert shear / bending > 0.05
    assert found.tip[-1, 0] == pytest.approx(bending + shear, rel=1e-8)
    assert found.tip[-1, 2] == pytest.approx(force * LEG_LENGTH**2 / (2 * LEG_EI), rel=1e-6)
    # Sheared at once at the clamp, where cross sections cannot turn.
    first = found.shape[-1, 1] / found.shape[-1, 1, 1]
    assert first[0] >= force / SHEAR_STIFFNESS


def test_an_even_load_deflects_by_bending_and_shear() -> None:
    """By extrapolation to infinitely many edges; the weight is the share of shear."""
    acceleration = 1e-4
    load = f"loads.gravity={{acceleration: {acceleration}, tilt: 90 deg}}"
    words = (load, "effects={shear: on, gravity: on, others: off}")
    coarse, fine = (tip_of(n, *words)[0] for n in (1, 2))
    even = DENSITY * HEIGHT * WIDTH * SOLID * acceleration
    bending = even * LEG_LENGTH**4 / (8 * LEG_EI)
    shear = even * LEG_LENGTH**2 / (2 * SHEAR_STIFFNESS)
    assert (4 * fine - coarse) / 3 == pytest.approx(bending + shear, rel=1e-6)
    weight = {v.name: v for v in check(leg(*words)).effects}["shear"].weight
    assert weight == pytest.approx(shear / bending, rel=1e-12)


@pytest.mark.parametrize(
    ("changes", "weight"),
    [
        ((), 1.2 * (30 / 109) ** 2 * BENDING / EXTENSION),
        (("actuator.bending_factor=1", "actuator.shear_factor=1"), 1.2 * (30 / 109) ** 2),
        (("actuator.shear_factor=0.265",), 2 * 1.2 * (30 / 109) ** 2 * BENDING / EXTENSION),
    ],
)
def test_the_weight_is_that_of_a_solid_rectangle_and_follows_its_factor(
    changes: tuple[str, ...], weight: float
) -> None:
    found = {v.name: v for v in check(leg("effects.shear=auto", *changes)).effects}["shear"]
    assert found.weight == pytest.approx(weight, rel=1e-12)


def test_large_deflections_are_those_of_reissners_rod() -> None:
    aside, along = 2.0, -1.0
    exact = bent_tip(aside, along, SOFTNESS, ETA)
    loads = f"loads.tip_force={{x: {aside * FORCE!r}, z: {along * FORCE!r}}}"
    tips = [tip_of(n, ONLY, loads)[:2] / LEG_LENGTH for n in (2, 4, 8)]
    errors = [float(np.linalg.norm(tip - exact[:2])) for tip in tips]
    rates = np.log2(np.array(errors[:-1]) / errors[1:])
    assert rates == pytest.approx([2, 2], abs=0.1)
    assert (4 * tips[2] - tips[1]) / 3 == pytest.approx(exact[:2], abs=1e-6)
    unshearable = bent_tip(aside, along, 0.0, ETA)
    assert np.linalg.norm(exact - unshearable) > 1e-2  # what is measured is the effect


def test_a_column_buckles_earlier_than_one_that_does_not_shear() -> None:
    critical = critical_load(SOFTNESS, ETA)

    def aside(load: float) -> float:
        pull = f"loads.tip_force={{x: {1e-7 * FORCE!r}, z: {-load * FORCE!r}}}"
        return float(tip_of(4, ONLY, pull)[0] / LEG_LENGTH)

    assert 0.0 < aside(0.999 * critical) < 1e-3
    assert aside(1.001 * critical) > 1e-2
    assert 1.001 * critical < 0.96 * critical_load(0.0, ETA)


# -- in motion ----------------------------------------------------------------


def frequencies(edges: int, height: float, *effects: str) -> np.ndarray:
    """Of the straight undamped leg, over sqrt(EI/(m l^4)), ascending [1]."""
    taken = "".join(f"{name}: on, " for name in ("inertia", *effects))
    problem = problem_of(
        edges,
        "bellows.count=2",
        f"actuator.height={height}",
        "actuator.damping_time=0",
        "loads={gravity: off}",
        f"effects={{{taken}others: off}}",
    )
    body = problem.body
    unit = np.sqrt(body.bending_stiffness / body.mass_per_length) / body.length**2
    values = eigenvalues(problem, equilibrium(problem, 0.0, problem.schedule.initial_piece))
    assert np.max(np.abs(values.real)) <= 1e-6 * np.max(np.abs(values.imag))
    return np.sort(values.imag[values.imag > 0.0]) / unit


def nearest(found: np.ndarray, exact: np.ndarray) -> np.ndarray:
    """Relative departure of the frequency nearest to each exact one."""
    return np.array([found[np.argmin(np.abs(found - one))] / one - 1 for one in exact])


def thickness(height: float) -> tuple[float, float]:
    """Slenderness and softness of a leg of this height."""
    softness = height**2 / 12 * BENDING / (5 / 18 * EXTENSION * LEG_LENGTH**2)
    return height / np.sqrt(12) / LEG_LENGTH, softness


def test_references_agree() -> None:
    assert timoshenko_frequencies(0.1, 1e-12, 3) == pytest.approx(
        rayleigh_frequencies(0.1, 3), rel=1e-8
    )


@pytest.mark.parametrize("height", [0.03, 0.06])
def test_the_leg_vibrates_like_timoshenkos_beam(height: float) -> None:
    exact = timoshenko_frequencies(*thickness(height), 2)
    errors = [nearest(frequencies(n, height, "shear", "rotary_inertia"), exact) for n in (32, 64)]
    assert np.abs(errors[1][0]) <= 2e-6
    assert errors[0] / errors[1] == pytest.approx([4, 4], rel=0.1)
    assert (4 * errors[1] - errors[0]) / 3 == pytest.approx([0, 0], abs=1e-6)
    assert rayleigh_frequencies(thickness(height)[0], 1)[0] / exact[0] - 1 > 0.02


def test_shear_alone_keeps_the_fourth_order_of_the_chain() -> None:
    slender, soft = thickness(0.03)
    exact = timoshenko_frequencies(1e-9 * slender, soft, 2)
    errors = [np.abs(nearest(frequencies(n, 0.03, "shear"), exact)) for n in (8, 16, 32)]
    assert errors[2][0] <= 1e-6
    assert np.all(errors[1] / errors[2] >= 12)


SWINGING = (
    "bellows.count=4",
    "loads.payload=20 g",
    "loads.gravity={tilt: 90 deg}",
    "run={duration: 0.5 s, output_interval: 5 ms, start: rest}",
)


def swing(*effects: str, side: str = "") -> Trajectory:
    taken = "".join(f"{name}: on, " for name in ("inertia", "gravity", *effects))
    words = [*SWINGING, f"effects={{{taken}others: off}}", "accuracy=0.1 %"]
    found = simulate(leg(STILL, *words, *([side] if side else [])))
    assert found.status == "complete", found.failure
    return found


@pytest.mark.parametrize(
    "effects",
    [(), ("damping",), ("rotary_inertia",), ("rotary_inertia", "damping")],
    ids=lambda names: " and ".join(names) or "alone",
)
def test_energy_is_conserved_with_and_without_inertia_of_sections(
    effects: tuple[str, ...],
) -> None:
    found = swing("shear", *effects)
    assert found.invariants.energy_imbalance_rel is not None
    assert found.invariants.energy_imbalance_rel <= 1e-3
    estimate = found.accuracy.estimated_tip_error_m
    assert estimate is not None
    assert estimate <= 1e-3 * LEG_LENGTH


def test_a_mirrored_load_mirrors_the_motion() -> None:
    other = "loads.gravity={tilt: -90 deg}"
    one, mirrored = swing("shear", "damping"), swing("shear", "damping", side=other)
    assert mirrored.tip == pytest.approx(one.tip * [-1, 1, -1], abs=1e-9)


def test_a_stiff_section_moves_like_one_that_does_not_shear() -> None:
    stiff = swing("shear", "damping", side="actuator.shear_factor=1e4")
    plain = swing("damping")
    assert np.max(np.abs(stiff.tip - plain.tip)[:, :2]) <= 2e-3 * LEG_LENGTH
    stiffest = swing("shear", "damping", side="actuator.shear_factor=1e9")
    assert stiffest.cost.steps <= 4 * plain.cost.steps  # no stiffer than the accuracy can tell
    soft = swing("shear", "damping")
    assert np.max(np.abs(soft.tip - plain.tip)[:, :2]) > 1e-2 * LEG_LENGTH


def test_an_unloaded_leg_does_not_shear() -> None:
    """Under pressure alone the axis stays on its arcs, sheared or not."""
    steady = ("run={duration: 0.1 s, output_interval: 0.05 s}", "loads={gravity: off}")
    taken = "effects={damping: on, inertia: on, pressure_distribution: on"
    push = "input={kind: constant, value: 9 kPa}"
    plain, sheared = (
        simulate(leg(push, *steady, f"{taken}{more}, others: off}}"), verify=False)
        for more in ("", ", shear: on")
    )
    assert sheared.tip == pytest.approx(plain.tip, abs=1e-9)


def test_without_it_the_rod_has_no_angles() -> None:
    unknowns = problem_of(1, "loads.tip_force.x=0.1 N", "effects={others: off}").equations
    assert SECTION_ANGLES not in unknowns.statics.blocks | unknowns.algebraics.blocks
