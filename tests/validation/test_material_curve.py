"""Measured curves of a bellow instead of its coefficients, against SciPy's PCHIP."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

from tests.scenes import LEG_LENGTH, chain_order, in_order, leg
from tests.validation.rc_network import (
    LENGTH,
    MODULUS,
    REST_VOLUME,
    Network,
    arc_tip,
    chain,
    only,
    outputs,
    resistance,
    sine,
    two_columns,
    worst,
)
from viscodesign import simulate

CURVE = only("material_curve")
FINE = "accuracy=1e-6"
VISCOSITY = 1e-3
FLUID = f"fluid={{name: plain liquid, viscosity: {VISCOSITY}, density: 1000}}"

PRESSURE = np.array([-4e4, -2.5e4, -1e4, 0.0, 1.2e4, 3e4, 5e4])
STRAIGHT = np.column_stack(
    [PRESSURE, 3.413e-9 * PRESSURE, 10.266 * PRESSURE / MODULUS, 0.047 * PRESSURE / MODULUS]
)
CURVED = np.column_stack(
    [
        PRESSURE,
        1.2e-4 * np.tanh(PRESSURE / 3e4) + 1.1e-9 * PRESSURE,
        0.2 * np.sinh(PRESSURE / 6e4),
        1e-3 * np.arctan(PRESSURE / 2e4),
    ]
)
"""A bellow that stiffens in volume, softens in angle, and stops extending."""


def rows(table: np.ndarray) -> str:
    return f"bellows.curve={{rows: {table.tolist()}}}"


@pytest.mark.parametrize("pressures", [(4.9e4, -3.9e4), (-1.3e4, 2e4)])
def test_a_straight_curve_equals_the_coefficients(pressures: tuple[float, float]) -> None:
    common = (*two_columns(4, *pressures), FINE)
    measured = simulate(leg(*common, rows(STRAIGHT), CURVE), verify=False)
    plain = simulate(leg(*common, only()), verify=False)
    assert measured.volume == pytest.approx(plain.volume, rel=1e-12)
    assert measured.tip == pytest.approx(plain.tip, abs=1e-12)


def test_a_straight_curve_equals_the_coefficients_in_motion() -> None:
    """Except for the integrator's steps, which round-off may change."""
    words, _ = sine(5e3, 4e4, 1.0)
    common = ("bellows.count=4", FLUID, words, "run={duration: 2 s}", "accuracy=1e-7")
    measured = simulate(leg(*common, rows(STRAIGHT), CURVE), verify=False)
    plain = simulate(leg(*common, only()), verify=False)
    assert worst(measured.pressure, plain.pressure) <= 3e-7
    assert worst(measured.volume, plain.volume) <= 3e-7
    assert np.max(np.abs(measured.tip - plain.tip)) <= 1e-7


@pytest.mark.parametrize("count", [2, 8])
@pytest.mark.parametrize("pressures", [(1.9e4, -7e3), (-3.3e4, 4.4e4), (3e4, 3e4), (0.0, -1.7e4)])
def test_steady_shape_follows_the_curves(count: int, pressures: tuple[float, float]) -> None:
    left, right = pressures
    found = simulate(leg(*two_columns(count, left, right), rows(CURVED), CURVE, FINE), verify=False)
    area, angle, extension = (PchipInterpolator(PRESSURE, CURVED[:, k]) for k in (1, 2, 3))
    sections = count // 2
    turned = sections * float(angle(left) - angle(right))
    length = LEG_LENGTH + sections * float(extension(left) + extension(right))
    assert found.tip[-1] == pytest.approx(arc_tip(turned, length), abs=1e-8)
    names = list(found.bellows)
    for name, own in (("L1", left), ("R1", right)):
        volume = REST_VOLUME + LENGTH * float(area(own) - area(0.0))
        assert found.volume[-1, names.index(name)] == pytest.approx(volume, rel=1e-9)


def test_transient_follows_the_reference(tmp_path: Path) -> None:
    """The curve comes from a file; its slope is the compliance at each pressure."""
    file = tmp_path / "curve.csv"
    header = "pressure_pa,area_m2,angle_rad,extension_m"
    text = [",".join(repr(float(v)) for v in row) for row in CURVED]
    file.write_text("\n".join([header, *text]) + "\n")
    words, inlet = sine(5e3, 4e4, 0.2)
    times = np.linspace(0.1, 5.0, 50)
    scene = leg(
        "bellows.count=4",
        words,
        FLUID,
        f"bellows.curve={{file: {file}}}",
        outputs(times),
        CURVE,
        FINE,
    )
    found = simulate(scene, verify=False)
    assert found.status == "complete", found.failure
    slope = PchipInterpolator(PRESSURE, CURVED[:, 1]).derivative()
    network = Network(
        chain(4),
        lambda p: LENGTH * slope(p),
        lambda before, after: (before - after) / resistance(VISCOSITY),
    )
    expected = network.follow(inlet, np.full(4, inlet(0.0)), times)
    pressure = in_order(found.pressure, found.bellows, chain_order(2))
    assert worst(pressure, expected) <= 1e-5
    plain = simulate(
        leg("bellows.count=4", words, FLUID, outputs(times), only(), FINE), verify=False
    )
    assert worst(in_order(plain.pressure, plain.bellows, chain_order(2)), expected) >= 1e-2
    # The tip of two sections with different arcs.
    angle, extension = (PchipInterpolator(PRESSURE, CURVED[:, k]) for k in (2, 3))
    left, right = found.pressure[:, [2, 3]], found.pressure[:, [0, 1]]
    assert found.bellows == ("R1", "R2", "L1", "L2")
    assert found.tip[:, 2] == pytest.approx((angle(left) - angle(right)).sum(axis=1), abs=1e-8)
    tips = [
        _two_arcs(angle(a) - angle(b), LEG_LENGTH / 2 + extension(a) + extension(b))
        for a, b in zip(left, right, strict=True)
    ]
    assert found.tip[:, :2] == pytest.approx(np.array(tips), abs=1e-8)


def _two_arcs(angles: np.ndarray, lengths: np.ndarray) -> tuple[float, float]:
    """Where the second of two arcs ends, the first clamped along +z."""
    x, z, heading = arc_tip(float(angles[0]), float(lengths[0]))
    across, along, _ = arc_tip(float(angles[1]), float(lengths[1]))
    cos, sin = np.cos(heading), np.sin(heading)
    return float(x + along * sin + across * cos), float(z + along * cos - across * sin)
