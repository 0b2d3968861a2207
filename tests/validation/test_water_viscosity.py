"""Water's viscosity against the release of the International Association, evaluated here."""

from __future__ import annotations

import math

import numpy as np
import pytest

from viscodesign.scene.fluids.water import Water

CRITICAL_TEMPERATURE, CRITICAL_DENSITY = 647.096, 322.0
"""[K], [kg/m3]"""
DILUTE = (1.67752, 2.20462, 0.6366564, -0.241605)
"""H_i of the release's table 1."""
DENSE = {
    (0, 0): 5.20094e-1, (1, 0): 8.50895e-2, (2, 0): -1.08374, (3, 0): -2.89555e-1,
    (0, 1): 2.22531e-1, (1, 1): 9.99115e-1, (2, 1): 1.88797, (3, 1): 1.26613,
    (5, 1): 1.20573e-1, (0, 2): -2.81378e-1, (1, 2): -9.06851e-1, (2, 2): -7.72479e-1,
    (3, 2): -4.89837e-1, (4, 2): -2.57040e-1, (0, 3): 1.61913e-1, (1, 3): 2.57399e-1,
    (0, 4): -3.25372e-2, (3, 4): 6.98452e-2, (4, 5): 8.72102e-3, (3, 6): -4.35673e-3,
    (5, 6): -5.93264e-4,
}  # fmt: skip
"""H_ij of the release's table 2."""


def release(temperature: float, density: float) -> float:
    """IAPWS R12-08, equations 10 to 12, without the term near the critical point [Pa s]."""
    t, d = temperature / CRITICAL_TEMPERATURE, density / CRITICAL_DENSITY
    dilute = 100 * math.sqrt(t) / sum(h / t**i for i, h in enumerate(DILUTE))
    dense = sum(h * (1 / t - 1) ** i * (d - 1) ** j for (i, j), h in DENSE.items())
    return 1e-6 * dilute * math.exp(d * dense)


@pytest.mark.parametrize(
    ("temperature", "density", "micro"),
    [(298.15, 998.0, 889.735100), (298.15, 1200.0, 1437.649467), (373.15, 1000.0, 307.883622)],
)
def test_the_release_is_evaluated_as_it_says(
    temperature: float, density: float, micro: float
) -> None:
    """The release's own values for checking, table 4, to all of their digits."""
    assert 1e6 * release(temperature, density) == pytest.approx(micro, abs=5e-7)


@pytest.mark.parametrize("celsius", [0.01, 20.0, 40.0, 60.0, 80.0])
def test_water_is_as_viscous_as_the_release_says(celsius: float) -> None:
    found = Water.properties(273.15 + celsius, 101325.0, 0.0)
    assert found.viscosity == pytest.approx(release(273.15 + celsius, found.density), rel=1e-7)


def test_water_at_twenty_degrees() -> None:
    """1.0016 mPa s is the reference point of viscometry (ISO/TR 3666), uncertain by 0.17 %."""
    temperatures = 273.15 + np.array([0.01, 20.0, 40.0, 60.0, 80.0])
    found = [1e3 * Water.properties(t, 101325.0, 0.0).viscosity for t in temperatures]
    assert found == pytest.approx([1.7911, 1.0016, 0.6527, 0.4660, 0.3540], rel=5e-4)
