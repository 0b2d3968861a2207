"""Collapsing bellows, against the stated law and an independent integrator.

Above p_f + c a bellow follows its pressure p, below p_f + c (1 - e u^3)/(1 + u + u^2) with
u = (c - (p - p_f))/c, e = 0.01; c = k V_0/C for a collapse fraction k, and p_f is the floor
-(1 - k) V_0/C raised by e/(1 - e) times its distance to the vacuum.
"""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import LEG_LENGTH, chain_order, in_order, leg
from tests.validation.rc_network import (
    COMPLIANCE,
    MODULUS,
    REST_VOLUME,
    Network,
    arc_tip,
    chain,
    only,
    outputs,
    resistance,
    two_columns,
    worst,
)
from viscodesign import simulate

EMPTY = REST_VOLUME / COMPLIANCE
"""Suction at which the volume of the linear law is zero [Pa]."""
AMBIENT = 101325.0
GIVE = 0.01
FINE = "accuracy=1e-6"
COLLAPSE = only("collapse")
VISCOSITY = 4e-4
FLUID = f"fluid={{name: thin liquid, viscosity: {VISCOSITY}, density: 1000}}"
TIMES = np.linspace(0.05, 8.0, 160)


def bounds(fraction: float) -> tuple[float, float]:
    """Pressure at the floor, and range above it over which the compliance fades [Pa]."""
    floor = -(1 - fraction) * EMPTY
    return floor + GIVE / (1 - GIVE) * (AMBIENT + floor), (fraction or 0.05) * EMPTY


def followed(pressure: np.ndarray, fraction: float) -> np.ndarray:
    """The effective pressure [Pa]."""
    floor, fade = bounds(fraction)
    u = (fade - (pressure - floor)) / fade
    with np.errstate(over="ignore"):
        return np.where(u > 0, floor + fade * (1 - GIVE * u**3) / (1 + u + u * u), pressure)


def followed_slope(pressure: np.ndarray, fraction: float) -> np.ndarray:
    floor, fade = bounds(fraction)
    u = np.maximum((fade - (pressure - floor)) / fade, 0.0)
    above, below = 1 - GIVE * u**3, 1 + u + u * u
    return np.asarray((3 * GIVE * u**2 * below + above * (1 + 2 * u)) / below**2)


def pulse(t: float) -> float:
    """The paper's, with its sigmoids written as exponentials [Pa]."""
    rate = 2 * 6 / 0.875
    fall, rise = (1 / (1 + np.exp(-rate * (t - centre))) for centre in (0.5, 4.0))
    return float(40410 - 141300 * fall + 141300 * rise)


def test_law_is_smooth_and_falls_to_its_floor() -> None:
    floor, fade = bounds(0.1)
    for p in (floor + fade, floor, floor - 1e4):
        step = 1e-2
        ends = followed(np.array([p - step, p + step]), 0.1)
        slope = np.diff(ends)[0] / (2 * step)
        assert slope == pytest.approx(float(followed_slope(np.array(p), 0.1)), rel=1e-5)
    vacuum = REST_VOLUME + COMPLIANCE * followed(np.array(-AMBIENT), 0.1)
    assert 0.1 * REST_VOLUME < vacuum < 0.11 * REST_VOLUME


@pytest.mark.parametrize("fraction", [0.0, 0.1, 0.3])
@pytest.mark.parametrize("pressures", [(-2e4, -3.1e4), (-9e4, 1e4), (-3.3e4, -1e5), (2e4, -5e3)])
def test_volume_angle_and_extension(fraction: float, pressures: tuple[float, float]) -> None:
    left, right = pressures
    scene = leg(
        *two_columns(4, left, right), f"bellows.collapse_fraction={fraction}", COLLAPSE, FINE
    )
    found = simulate(scene, verify=False)
    felt = followed(np.array([right, left]), fraction)
    names = list(found.bellows)
    for name, own in zip(("R1", "L1"), felt, strict=True):
        volume = found.volume[-1, names.index(name)]
        assert volume == pytest.approx(REST_VOLUME + COMPLIANCE * own, rel=1e-9)
        assert volume > fraction * REST_VOLUME
    angle = 2 * 10.266 / MODULUS * (felt[1] - felt[0])
    length = LEG_LENGTH + 2 * 0.047 / MODULUS * felt.sum()
    assert found.tip[-1] == pytest.approx(arc_tip(angle, length), abs=1e-8)


@pytest.mark.parametrize("fraction", [0.1, 0.3])
def test_published_pulse_empties_no_bellow_below_its_floor(fraction: float) -> None:
    scene = leg(
        "bellows.count=4",
        FLUID,
        f"bellows.collapse_fraction={fraction}",
        outputs(TIMES),
        COLLAPSE,
        FINE,
    )
    found = simulate(scene, verify=False)
    assert found.status == "complete", found.failure
    network = Network(
        chain(4),
        lambda p: COMPLIANCE * followed_slope(p, fraction),
        lambda before, after: (before - after) / resistance(VISCOSITY),
    )
    expected = network.follow(pulse, np.full(4, pulse(0.0)), TIMES)
    pressure = in_order(found.pressure, found.bellows, chain_order(2))
    assert worst(pressure, expected) <= 1e-5
    volume = REST_VOLUME + COMPLIANCE * followed(expected, fraction)
    assert worst(in_order(found.volume, found.bellows, chain_order(2)), volume) <= 1e-5
    assert found.volume.min() > fraction * REST_VOLUME
    assert expected.min() < -9e4  # deep below the floor, and yet


@pytest.mark.parametrize("pressures", [(3e4, -2.7e4), (-1e4, 2e4)])
def test_far_from_the_floor_nothing_changes(pressures: tuple[float, float]) -> None:
    common = (*two_columns(4, *pressures), FINE)
    with_, without = (simulate(leg(*common, e), verify=False) for e in (COLLAPSE, only()))
    assert with_.volume == pytest.approx(without.volume, rel=1e-13)
    assert with_.tip == pytest.approx(without.tip, abs=1e-13)


def test_far_from_the_floor_nothing_changes_in_motion() -> None:
    """Except for the integrator's steps, which round-off may change."""
    words = "input={kind: sine, mean: 5 kPa, amplitude: 25 kPa, frequency: 1 Hz}"
    common = ("bellows.count=4", FLUID, words, "run={duration: 2 s}", "accuracy=1e-7")
    with_, without = (simulate(leg(*common, e), verify=False) for e in (COLLAPSE, only()))
    assert worst(with_.pressure, without.pressure) <= 3e-7
    assert np.max(np.abs(with_.tip - without.tip)) <= 1e-7
