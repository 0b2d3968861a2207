"""Curves of a bellow whose pressure falls as it swells."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator

from viscodesign.physics.snapping import SnapCurves

AREA = np.array([-60, -30, 5, 20, 40, 60, 90, 130, 180, 240, 320]) * 1e-6
PRESSURE = np.array([-30, -14, 0, 12, 20, 23, 19, 14, 16, 26, 45]) * 1e3
LENGTH, SECTION = 0.018, 0.0136
ROWS = np.column_stack((PRESSURE, AREA, 300 * AREA, AREA))
CURVES = SnapCurves.through(ROWS, LENGTH, SECTION, 15e3)
LAW = PchipInterpolator(LENGTH * (AREA - 5e-6), PRESSURE)


def test_the_curve_is_pchip_of_the_swelling() -> None:
    swelling = np.linspace(*CURVES.range, 301)
    assert CURVES.pressure(swelling) == pytest.approx(LAW(swelling), abs=1e-6)
    assert CURVES.curvature(swelling) == pytest.approx(300 * swelling / LENGTH / SECTION, abs=1e-9)
    assert CURVES.stretch(swelling) == pytest.approx(swelling / LENGTH / SECTION, abs=1e-12)


def test_the_swelling_is_zero_at_zero_gauge() -> None:
    found = [float(curve(0.0)) for curve in (CURVES.pressure, CURVES.curvature, CURVES.stretch)]
    assert found == pytest.approx([0.0, 0.0, 0.0], abs=1e-9)


@pytest.mark.parametrize("pressure", [-60e3, -20e3, -1e3, 0.0, 5e3, 22.9e3, 24e3, 44e3, 90e3])
def test_an_increasing_pressure_reaches_the_first_possible_swelling(pressure: float) -> None:
    swelling, curvature, stretch = CURVES.loaded(np.array([pressure]))
    assert CURVES.pressure(swelling[0]) == pytest.approx(pressure, abs=30.0)
    snapped = swelling[0] > LENGTH * 100e-6
    assert snapped == (pressure > 23e3)
    assert curvature == pytest.approx(CURVES.curvature(swelling))
    assert stretch == pytest.approx(CURVES.stretch(swelling))


def test_a_sealed_part_is_filled_on_the_first_branch() -> None:
    assert CURVES.pressure(CURVES.filled) == pytest.approx(15e3, abs=1e-8)
    assert 0.0 < CURVES.filled < LENGTH * 55e-6


@pytest.mark.parametrize("zero", [0, 1])
def test_rest_may_be_the_first_or_last_row(zero: int) -> None:
    """The first row itself, or a place between the first rows."""
    rows = ROWS[2:].copy() if zero == 0 else ROWS[1:].copy()
    found = SnapCurves.through(rows, LENGTH, SECTION, 0.0)
    assert found.filled == pytest.approx(0.0, abs=1e-18)
    assert float(found.pressure(0.0)) == pytest.approx(0.0, abs=1e-9)
