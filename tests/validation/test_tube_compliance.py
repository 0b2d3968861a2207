"""Compliant tubes and a feed line: an RC network, by the matrix exponential."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import chain_order, in_order, leg
from tests.validation.rc_network import (
    COMPLIANCE,
    RADIUS,
    TUBE,
    only,
    outputs,
    resistance,
    step_response,
)
from viscodesign import simulate

VISCOSITY, STEP = 1e-3, 1e4
LIQUID = f"fluid={{name: plain liquid, viscosity: {VISCOSITY}, density: 1000}}"
SOFT = only("tube_compliance")
FINE = "accuracy=1e-6"
YOUNG, POISSON, THICKNESS = 2e4, 0.4, 0.5e-3
"""A gel so soft that its storage is clearly visible [Pa, 1, m]."""
WALL = (
    f"network.tube_wall={{youngs_modulus: {YOUNG}, thickness: {THICKNESS}, "
    f"poissons_ratio: {POISSON}}}"
)
FEED_LENGTH, FEED_RADIUS = 0.4, 1e-3
FEED = f"network.feed_line={{length: {FEED_LENGTH}, radius: {FEED_RADIUS}}}"


def storage(length: float, radius: float, thickness: float = THICKNESS) -> float:
    """Storage per inner pressure of a tube of fixed length [m3/Pa].

    Plane strain: u = A r + B/r satisfies equilibrium; A and B by the radial stress,
    -1 inside and 0 outside.
    """
    lame = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
    shear = YOUNG / (2 * (1 + POISSON))
    radii = np.array([radius, radius + thickness])
    # sigma_r = 2 (lame + shear) A - 2 shear B / r^2
    lines = np.column_stack([np.full(2, 2 * (lame + shear)), -2 * shear / radii**2])
    a, b = np.linalg.solve(lines, [-1.0, 0.0])
    return float(2 * np.pi * radius * (a * radius + b / radius) * length)


Tubes = list[tuple[int, int, float, float]]
"""Start, end (-1: inlet), length and radius [m]."""


def exact(tubes: Tubes, bellows: int, times: np.ndarray, *, soft: bool = True) -> np.ndarray:
    """Pressures (T, bellows) after a step; half of a tube's storage is at each of its ends.

    Bellows are the first nodes. A node without any storage is not provided for.
    """
    count = 1 + max(max(start, end) for start, end, _, _ in tubes)
    capacity = np.append(np.full(bellows, COMPLIANCE), np.zeros(count - bellows))
    laplacian, inlet = np.zeros((count, count)), np.zeros(count)
    for start, end, length, radius in tubes:
        conductance = 1 / resistance(VISCOSITY, length, radius)
        for one, other in ((start, end), (end, start)):
            if one < 0:
                continue
            laplacian[one, one] += conductance
            if other < 0:
                inlet[one] += conductance * STEP
            else:
                laplacian[one, other] -= conductance
            capacity[one] += soft * storage(length, radius) / 2
    found = step_response(-laplacian / capacity[:, None], inlet / capacity, times)
    return found[:, :bellows]


def run(count: int, times: np.ndarray, *overrides: str) -> np.ndarray:
    source = f"input={{kind: step, value: {STEP}}}"
    scene = leg(
        f"bellows.count={count}", *overrides, source, LIQUID, outputs(times, "rest"), SOFT, FINE
    )
    found = simulate(scene, verify=False)
    assert found.status == "complete", found.failure
    assert found.invariants.volume_imbalance_rel is not None
    assert found.invariants.volume_imbalance_rel <= 1e-8
    return in_order(found.pressure, found.bellows, chain_order(count // 2))


def test_reference_for_a_thin_wall_is_barlows_formula() -> None:
    """dA/dp = 2 pi r^3 (1 - nu^2) / (E t) for t << r."""
    thin = 1e-3 * RADIUS
    expected = 2 * np.pi * RADIUS**3 * (1 - POISSON**2) / (YOUNG * thin) * TUBE
    assert storage(TUBE, RADIUS, thin) == pytest.approx(expected, rel=2e-3)


def test_reference_for_a_hole_in_an_infinite_body() -> None:
    """u/r = (1 + nu) p / E around a small hole."""
    expected = 2 * np.pi * RADIUS**2 * (1 + POISSON) / YOUNG * TUBE
    assert storage(TUBE, RADIUS, 1e3 * RADIUS) == pytest.approx(expected, rel=1e-5)


def test_chain_of_compliant_tubes() -> None:
    times = np.linspace(0.05, 5.0, 50)
    tubes: Tubes = [(k - 1, k, TUBE, RADIUS) for k in range(4)]
    expected = exact(tubes, 4, times)
    assert np.max(np.abs(run(4, times, WALL) - expected)) <= 1e-5 * STEP
    # The effect of the walls is far larger than that.
    assert np.max(np.abs(exact(tubes, 4, times, soft=False) - expected)) >= 1e-3 * STEP


def test_compliant_feed_line_delays_the_network() -> None:
    """The junction behind the line has half of its storage, and is a node."""
    times = np.linspace(0.05, 5.0, 50)
    line = (-1, 4, FEED_LENGTH, FEED_RADIUS)
    rest: Tubes = [(4, 0, TUBE, RADIUS), *((k - 1, k, TUBE, RADIUS) for k in range(1, 4))]
    expected = exact([line, *rest], 4, times)
    found = run(4, times, FEED, WALL)
    assert np.max(np.abs(found - expected)) <= 1e-5 * STEP
    plain: Tubes = [(k - 1, k, TUBE, RADIUS) for k in range(4)]
    assert np.max(np.abs(exact(plain, 4, times) - expected)) >= 1e-2 * STEP


def test_stiff_feed_line_adds_its_resistance() -> None:
    """With rigid walls, the line and the first tube are resistances in series."""
    times = np.linspace(0.05, 5.0, 50)
    more = resistance(VISCOSITY, FEED_LENGTH, FEED_RADIUS) / resistance(VISCOSITY, 1.0, RADIUS)
    tubes: Tubes = [(k - 1, k, TUBE + (0.0 if k else more), RADIUS) for k in range(4)]
    expected = exact(tubes, 4, times, soft=False)
    assert np.max(np.abs(run(4, times, FEED) - expected)) <= 1e-5 * STEP


def test_junctions_of_compliant_tubes_are_nodes() -> None:
    """A tree whose two forks store fluid; slender tubes of three lengths."""
    times = np.linspace(0.1, 6.0, 50)
    names = ["R1", "R2", "L2", "L1", "j1", "j2"]
    tubes: Tubes = [
        (-1, 4, 0.06, RADIUS),
        (4, 0, 0.02, RADIUS),
        (4, 5, 0.04, 2 * RADIUS),
        (5, 1, 0.01, RADIUS),
        (5, 3, 0.055, RADIUS),
        (1, 2, 0.0375, RADIUS),
    ]
    listed = ", ".join(
        f"{{from: {'inlet' if a < 0 else names[a]}, to: {names[b]}, length: {length}, radius: {r}}}"
        for a, b, length, r in tubes
    )
    found = run(4, times, f"network={{layout: custom, tubes: [{listed}]}}", WALL)
    assert np.max(np.abs(found - exact(tubes, 4, times))) <= 1e-5 * STEP
