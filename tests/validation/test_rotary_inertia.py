"""A thick vibrating leg: Rayleigh's beam."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import eigh

from tests.scenes import LEG_LENGTH, STILL, leg
from tests.validation.rc_network import outputs
from tests.validation.ringing import fitted_frequencies, rayleigh_frequencies
from viscodesign import simulate

MODULUS, DENSITY, WIDTH, BENDING, SOLID = 1.8e6, 950.0, 0.02, 0.55, 0.47


def test_reference_of_a_slender_beam() -> None:
    """Euler and Bernoulli: squares of the roots of cos x cosh x = -1."""
    roots = np.array([1.875104068711961, 4.694091132974175, 7.854757438237613])
    assert rayleigh_frequencies(1e-7, 3) == pytest.approx(roots**2, rel=1e-9)


@pytest.mark.parametrize("slenderness", [0.05, 0.2])
def test_reference_of_a_thick_beam(slenderness: float) -> None:
    """Ritz: powers of x from the second on, energies integrated exactly."""
    power = np.arange(2, 13)
    both = power[:, None] + power[None, :]
    product = power[:, None] * power[None, :]
    bending = product * ((power - 1)[:, None] * (power - 1)[None, :]) / (both - 3)
    inertia = 1 / (both + 1) + slenderness**2 * product / (both - 1)
    exact = np.sqrt(eigh(bending, inertia, eigvals_only=True)[:2])
    assert rayleigh_frequencies(slenderness, 2) == pytest.approx(exact, rel=1e-6)


def ring(height: float, guess: np.ndarray, accuracy: float, *effects: str) -> np.ndarray:
    """Frequencies of the tip after a tiny sudden force, over sqrt(EI/(m l^4)) [1]."""
    stiffness = MODULUS * WIDTH * height**3 / 12 * BENDING
    mass = DENSITY * height * WIDTH * SOLID
    unit = np.sqrt(stiffness / mass) / LEG_LENGTH**2
    times = np.linspace(0.0, 3 * 2 * np.pi / guess[0] / unit, 301)[1:]
    force = 1e-3 * stiffness / LEG_LENGTH**2
    found = simulate(
        leg(
            STILL,
            "bellows.count=2",
            f"actuator.height={height!r}",
            "actuator.damping_time=0",
            f"loads.tip_force.x={force!r}",
            outputs(times, "rest"),
            f"effects={{inertia: on, {''.join(f'{e}: on, ' for e in effects)}others: off}}",
            f"accuracy={accuracy!r}",
        ),
        verify=False,
        tolerance=1e-9,  # what is measured is the mesh; of so small a motion, to many digits
    )
    assert found.status == "complete", found.failure
    return fitted_frequencies(times, found.tip[:, 0], guess * unit) / unit


@pytest.mark.parametrize("height", [0.03, 0.06])
def test_leg_vibrates_like_a_rayleigh_beam(height: float) -> None:
    """Edges turn rigidly, so higher modes, which bend within an edge, feel the mesh first."""
    exact = rayleigh_frequencies(height / np.sqrt(12) / LEG_LENGTH, 4)
    found = ring(height, exact, 1e-5, "rotary_inertia")
    assert found[0] == pytest.approx(exact[0], rel=2e-5)
    assert found[1] == pytest.approx(exact[1], rel=3e-4)
    slender = rayleigh_frequencies(1e-7, 1)
    assert slender[0] / exact[0] - 1 >= 1e-2  # what is measured is the effect


def test_error_converges_at_second_order_or_faster() -> None:
    exact = rayleigh_frequencies(0.06 / np.sqrt(12) / LEG_LENGTH, 4)
    # The number of edges follows the cube root of the accuracy: it doubles.
    coarse, fine = (
        ring(0.06, exact, accuracy, "rotary_inertia")[:3] / exact[:3] - 1
        for accuracy in (1.6e-4, 2e-5)
    )
    assert np.all(np.abs(fine) <= np.array([2e-5, 4e-4, 2e-3]))
    assert np.all(np.abs(coarse) >= 3.5 * np.abs(fine))


def test_without_it_the_leg_vibrates_like_a_slender_beam() -> None:
    exact = rayleigh_frequencies(1e-7, 4)
    assert ring(0.06, exact, 5e-5)[:2] == pytest.approx(exact[:2], rel=1e-5)
