"""Contact with a rigid ground: exact solutions, conditions that must hold, and friction's work."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_bvp

from tests import thorough
from tests.scenes import LEG_EA, LEG_EI, LEG_LENGTH, LEG_MASS_PER_LENGTH, leg
from viscodesign import Trajectory, simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.postprocess.motion import Motion
from viscodesign.simulation.build_problem import Settings
from viscodesign.simulation.solve_once import solve

WALL, NEAR_WALL = 6e-3, 0.3e-3
SMALL = (
    "bellows.count=4",
    "actuator.length=27.25 mm",
    "network.tubes=[{from: right, to: R1, length: 37.5 mm}, {from: R1, to: R2, length: 37.5 mm}, {from: left, to: L1, length: 37.5 mm}, {from: L1, to: L2, length: 37.5 mm}]",
)  # fmt: skip
SMALL_LENGTH = 27.25e-3
INSTANT = "effects={others: off}"
STATIC_ROD = "effects={pressure_distribution: on, others: off}"
MOVING_ROD = "effects={pressure_distribution: on, inertia: on, damping: on, others: off}"
PRESSED = (
    "inputs={left: {kind: sine, amplitude: 20 kPa, frequency: 0.25 Hz}, right: {kind: constant, value: 0}}",
    "run={duration: 1 s, output_interval: 50 ms}",
)
CYCLE = (
    *SMALL,
    "inputs={left: {kind: sine, amplitude: 10 kPa, frequency: 1 Hz}, right: {kind: sine, amplitude: 10 kPa, frequency: 1 Hz, phase: 90 deg}}",
    "run={duration: 0.9 s, output_interval: 30 ms}",
    "actuator.damping_time=10 ms",
)  # fmt: skip


def wall(friction: float, x: float = NEAR_WALL, **more: str) -> str:
    """A wall on the right of the hanging actuator."""
    extra = "".join(f", {key}: {value}" for key, value in more.items())
    return f"loads.ground={{kind: line, point: {{x: {x}}}, normal: -90 deg, friction: {friction}{extra}}}"


@cache
def moved(*overrides: str, edges: int = 2, tolerance: float = 1e-5) -> Motion:
    """One solution of the actuator with two inlets."""
    quantities = SceneQuantities(leg(*overrides, config="antagonistic_two_inlets"))
    effects = select_effects(quantities).effects
    run = solve(quantities, effects, Settings(edges, tolerance))
    assert run.is_complete
    return run.motion


def pressed_elastica(curvature: float, stretch: float, friction: float) -> tuple[float, float]:
    """Force on the wall [N] and height of the tip [m] of a rod bent against it, by SciPy.

    ``friction``: tangential over normal force, positive away from the clamp.
    """

    def forces(force: float, angle: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        x, z = -force, friction * force
        return x * np.sin(angle) + z * np.cos(angle), x * np.cos(angle) - z * np.sin(angle)

    def slopes(_: np.ndarray, y: np.ndarray, p: np.ndarray) -> np.ndarray:
        along, across = forces(p[0], y[2])
        length = 1 + stretch + along / LEG_EA
        turn = curvature + y[3] / LEG_EI
        return np.array([length * np.sin(y[2]), length * np.cos(y[2]), turn, -length * across])

    def ends(a: np.ndarray, b: np.ndarray, _: np.ndarray) -> np.ndarray:
        return np.array([a[0], a[1], a[2], b[3], b[0] - WALL])

    arc = np.linspace(0.0, LEG_LENGTH, 50)
    guess = np.array([curvature * arc**2 / 4, arc, curvature * arc / 2, 0 * arc])
    found = solve_bvp(slopes, ends, arc, guess, p=[1.0], tol=1e-9)
    assert found.success
    return float(found.p[0]), float(found.y[1, -1])


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_a_pressed_elastica_equals_a_boundary_value_problem(friction: float) -> None:
    """Bent against a wall, it slides along it all the way, and friction opposes that."""
    motion = moved(*PRESSED, INSTANT, wall(friction, WALL), edges=4)
    normal, tangential = motion["contact_normal"][-1, 0], motion["contact_tangential"][-1, 0]
    sliding = motion["contact_normal"][:, 0] > 0
    assert np.count_nonzero(sliding) >= 10
    assert abs(tangential) == pytest.approx(friction * normal, rel=1e-9, abs=1e-12)
    law = SceneQuantities(leg(config="antagonistic_two_inlets")).bellow
    force, height = pressed_elastica(
        20e3 * law.curvature_per_pressure, 20e3 * law.stretch_per_pressure, tangential / normal
    )
    assert normal == pytest.approx(force, rel=2e-3)
    assert motion.tip[-1, 1] == pytest.approx(height, abs=1e-5)
    assert motion.tip[-1, 0] == pytest.approx(WALL, abs=1e-9)


@pytest.mark.parametrize(
    ("rod", "ground"),
    [
        (STATIC_ROD, wall(0.3)),
        (MOVING_ROD, wall(0.3, foot_radius="0.1 mm")),
        (STATIC_ROD, wall(0.3, touches="sections")),
        (
            MOVING_ROD,
            "loads.ground={kind: circle, centre: {x: 5.2 mm, z: 28 mm}, radius: 4 mm, friction: 0.3, foot_radius: 1 mm}",
        ),
    ],
    ids=["point", "round foot", "sections", "circle"],
)
def test_the_laws_of_contact_hold(rod: str, ground: str) -> None:
    motion = moved(*CYCLE, rod, ground)
    normal, gap = motion["contact_normal"], motion["contact_gap"]
    assert np.count_nonzero(normal) >= 5
    assert np.count_nonzero(normal == 0) >= 5
    assert normal.min() >= 0.0
    assert gap.min() >= -1e-7
    assert np.max(np.abs(gap * normal)) <= 1e-9
    assert np.max(np.abs(motion["contact_tangential"]) - 0.3 * normal) <= 1e-9


def test_friction_only_takes() -> None:
    """Where the tip slides, friction opposes it; where friction is less, the tip sticks."""
    motion = moved(*CYCLE, STATIC_ROD, wall(0.3))
    both = (motion["contact_normal"][1:, 0] > 0) & (motion["contact_normal"][:-1, 0] > 0)
    slip = np.diff(motion.tip[:, 1])[both]
    force, normal = motion["contact_tangential"][1:, 0][both], motion["contact_normal"][1:, 0][both]
    assert np.max(force * slip) <= 1e-15
    is_sticking = np.abs(force) < 0.299 * normal
    assert np.max(np.abs(slip[is_sticking]), initial=0.0) <= 1e-9
    assert np.min(force * slip) < -1e-7


def test_a_round_foot_rolls() -> None:
    """On a rough wall its tip moves by as much as it unrolls."""
    motion = moved(*CYCLE, MOVING_ROD, wall(50.0, foot_radius="0.1 mm"))
    # When it lifts off, the last of its weight lets it slide even there.
    is_held = 49 * motion["contact_normal"][:, 0] > np.abs(motion["contact_tangential"][:, 0])
    both = is_held[1:] & is_held[:-1]
    assert np.count_nonzero(both) >= 5
    rolled = 0.1e-3 * np.diff(motion.tip[:, 2])[both]
    assert np.max(np.abs(rolled)) > 3e-7
    assert np.diff(motion.tip[:, 1])[both] == pytest.approx(rolled, abs=1e-9)


def test_the_moment_on_a_round_foot_is_in_the_balance_of_energy() -> None:
    """Without what it stores in the last edge, the balance is off by a hundredth."""
    foot = wall(0.3, 2e-3 + NEAR_WALL, foot_radius="2 mm")
    motion = moved(*CYCLE, STATIC_ROD, foot, tolerance=1e-4)
    assert np.mean(motion["contact_normal"] > 0) > 0.3
    assert motion.invariants.energy_imbalance_rel is not None
    assert motion.invariants.energy_imbalance_rel < 5e-4


def test_a_large_circle_is_a_wall() -> None:
    radius = 1e3
    circle = f"loads.ground={{kind: circle, centre: {{x: {NEAR_WALL + radius}, z: {SMALL_LENGTH}}}, radius: {radius}, friction: 0.3}}"
    flat, curved = moved(*CYCLE, STATIC_ROD, wall(0.3)), moved(*CYCLE, STATIC_ROD, circle)
    assert np.max(np.abs(flat.tip - curved.tip)) <= 1e-6
    assert curved["contact_tangential"] == pytest.approx(flat["contact_tangential"], abs=1e-4)


FALLING = (
    "input={kind: constant, value: 0}",
    "loads={gravity: {tilt: 90 deg}, ground: {kind: line, point: {x: 0.8 mm}, normal: -90 deg, friction: 0.2}}",
    "effects={inertia: on, damping: on, gravity: on, others: off}",
)


@cache
def landed(*overrides: str) -> Trajectory:
    return simulate(leg(*FALLING, *overrides))


def test_a_cantilever_that_lands_rests_on_its_beam_reaction() -> None:
    """Held horizontally and let go, it falls on a stop and comes to rest there."""
    run = landed(
        "actuator.damping_time=5 ms", "run={duration: 0.4 s, output_interval: 10 ms, start: rest}"
    )
    weight = LEG_MASS_PER_LENGTH * 9.80665
    free = weight * LEG_LENGTH**4 / (8 * LEG_EI)
    reaction = 3 * LEG_EI / LEG_LENGTH**3 * (free - 0.8e-3)
    assert run.status == "complete"
    assert run["contact_normal"][-1, 0] == pytest.approx(reaction, rel=2e-2)
    assert run.tip[-1, 0] == pytest.approx(0.8e-3, abs=1e-9)
    assert run.invariants.energy_imbalance_rel is not None
    assert run.invariants.energy_imbalance_rel <= 2e-4


@pytest.mark.parametrize("finer", [4, 16] if thorough.ALL else [4])
def test_the_stated_error_holds_through_impacts(finer: int) -> None:
    """Of an actuator that bounces as its own waves return: against far smaller tolerances."""
    short = "run={duration: 30 ms, output_interval: 2 ms, start: rest}"
    run = landed("actuator.damping_time=1 ms", short)
    assert np.count_nonzero(np.diff(run["contact_normal"][:, 0] > 0)) >= 3
    stated = run.accuracy.estimated_tip_error_m
    assert stated is not None
    settings = run.settings
    quantities = SceneQuantities(leg(*FALLING, "actuator.damping_time=1 ms", short))
    fine = solve(
        quantities,
        select_effects(quantities).effects,
        Settings(settings["edges_per_section"], settings["tolerance"] / finer**2),
    )
    # Steps with impacts are of order 1 to 2: this divides them by at least the factor.
    assert np.max(np.abs(run.tip[:, :2] - fine.motion.tip[:, :2])) <= stated
