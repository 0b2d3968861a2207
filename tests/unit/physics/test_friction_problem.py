"""Contacts with friction: closed forms, and the conditions in random problems."""

from __future__ import annotations

import math

import numpy as np
import pytest

from viscodesign.physics.friction_problem import ContactError, ContactState, FrictionProblem

GRAVITY = 9.81


def steps(
    mass: np.ndarray,
    pull: np.ndarray,
    rows: np.ndarray,
    gap: float,
    friction: float,
    count: int,
    step: float,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Place, velocity and last forces of a body with one contact after steps of implicit Euler.

    ``rows``: derivatives of gap and slip by the coordinates.
    """
    place, speed, forces = np.zeros(len(mass)), np.zeros(len(mass)), np.zeros(2)
    compliance = step**2 * rows @ (rows / mass).T
    for _ in range(count):
        free_speed = speed + step * pull / mass
        free = rows @ (step * free_speed)
        free[0] += gap + rows[0] @ place
        forces, _ = FrictionProblem(compliance, free, (friction,)).solve()
        speed = free_speed + step * rows.T @ forces / mass
        place = place + step * speed
    return place, speed, forces


def on_slope(slope: float) -> np.ndarray:
    """Gravity of a unit mass along a slope and into it."""
    return GRAVITY * np.array([math.sin(slope), -math.cos(slope)])


BLOCK = np.array([[0.0, 1.0], [1.0, 0.0]])
"""Gap and slip of a point mass at (x, height)."""


@pytest.mark.parametrize("friction", [0.3, 0.7])
def test_a_block_sticks_below_the_friction_angle_and_slides_above(friction: float) -> None:
    for slope in (math.atan(friction) - 1e-3, math.atan(friction) + 1e-3, 0.9):
        place, speed, forces = steps(np.ones(2), on_slope(slope), BLOCK, 0.0, friction, 50, 0.01)
        weight = GRAVITY * math.cos(slope)
        pull = max(GRAVITY * math.sin(slope) - friction * weight, 0.0)
        assert speed[0] == pytest.approx(0.5 * pull, rel=1e-9, abs=1e-12)
        assert forces[0] == pytest.approx(weight, rel=1e-12)
        assert place[1] == 0.0


@pytest.mark.parametrize("slope", [0.2, 1.2])
def test_a_disc_rolls_until_the_slope_is_too_steep(slope: float) -> None:
    """A disc of radius R rolls by 2/3 g sin(a) where tan(a) <= 3 mu, or else slides."""
    radius, friction = 0.05, 0.4
    mass = np.array([1.0, 1.0, radius**2 / 2])
    rows = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, radius]])
    _, speed, _ = steps(mass, np.append(on_slope(slope), 0.0), rows, 0.0, friction, 50, 0.01)
    rolls = math.tan(slope) <= 3 * friction
    pull = math.sin(slope) - friction * math.cos(slope)
    expected = 2 / 3 * GRAVITY * math.sin(slope) if rolls else GRAVITY * pull
    assert speed[0] == pytest.approx(0.5 * expected, rel=1e-9)
    assert (abs(speed[0] + radius * speed[2]) < 1e-12) == rolls


def test_a_mass_that_lands_stays_on_the_ground() -> None:
    place, speed, forces = steps(np.full(2, 2.0), 2 * on_slope(0.0), BLOCK, 0.3, 0.5, 60, 0.01)
    assert place[1] == pytest.approx(-0.3, abs=1e-15)
    assert speed[1] == pytest.approx(0.0, abs=1e-12)
    assert forces[0] == pytest.approx(2 * GRAVITY, rel=1e-12)
    falling, _, none = steps(np.full(2, 2.0), 2 * on_slope(0.0), BLOCK, 0.3, 0.5, 24, 0.01)
    assert falling[1] == pytest.approx(-GRAVITY * 0.01**2 * 24 * 25 / 2)
    assert not none.any()


@pytest.mark.parametrize("seed", range(25))
def test_conditions_hold_in_random_problems(seed: int) -> None:
    draw = np.random.default_rng(seed)
    count = int(draw.integers(1, 7))
    shape = draw.normal(size=(2 * count, 2 * count))
    problem = FrictionProblem(
        shape @ shape.T / count + 0.02 * np.eye(2 * count),
        draw.normal(size=2 * count),
        draw.uniform(0, 1.2, count).tolist(),
    )
    forces, states = problem.solve()
    motion = problem.compliance @ forces + problem.free
    (normal, along), (gap, slip) = forces.reshape(2, -1), motion.reshape(2, -1)
    size = np.max(np.abs(forces)) or 1.0
    assert np.min(gap) > -1e-9
    assert np.min(normal) > -1e-9 * size
    assert np.max(np.abs(gap * normal)) < 1e-9 * size
    assert np.max(np.abs(along) - problem.friction * normal) < 1e-9 * size
    assert np.max(along * slip) < 1e-9 * size  # friction does no work
    assert np.max(np.abs(slip[np.equal(states, ContactState.STICK)]), initial=0.0) < 1e-9


def test_a_guess_changes_the_way_and_not_the_answer() -> None:
    shape = np.random.default_rng(7).normal(size=(8, 8))
    problem = FrictionProblem(shape @ shape.T + np.eye(8), -np.ones(8), [0.5] * 4)
    forces, states = problem.solve()
    for guess in (states, [ContactState.BACKWARD] * 4, [ContactState.STICK] * 4):
        again, same = problem.solve(guess)
        np.testing.assert_allclose(again, forces, atol=1e-12)
        assert list(same) == list(states)


def test_an_impossible_problem_is_refused() -> None:
    with pytest.raises(ContactError, match="Signorini"):
        FrictionProblem(np.diag([-1.0, 1.0]), np.array([-1.0, 0.0]), (0.5,)).solve()
