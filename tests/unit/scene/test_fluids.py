"""Properties of named fluids against published tables."""

from __future__ import annotations

import pytest

from tests.scenes import leg
from viscodesign.errors import SpecError


def test_water_at_20_degrees() -> None:
    water = leg("fluid=water", "temperature=20 degC").fluid
    assert water.viscosity == pytest.approx(1.0016e-3, rel=1e-3)  # IAPWS 2008, 1.0016 mPa s
    assert water.density == pytest.approx(998.2, rel=1e-4)
    assert water.vapour_pressure == pytest.approx(2339, abs=1)
    assert water.bulk_modulus == pytest.approx(2.18e9, rel=0.01)
    assert water.speed_of_sound == pytest.approx(1482, rel=0.01)
    assert not water.is_gas


def test_air_at_20_degrees() -> None:
    air = leg("fluid=air", "temperature=20 degC").fluid
    assert air.viscosity == pytest.approx(1.82e-5, rel=5e-3)  # Lemmon and Jacobsen 2004
    assert air.density == pytest.approx(1.204, rel=1e-3)
    assert air.gas_constant == pytest.approx(287, rel=2e-3)
    assert air.speed_of_sound == pytest.approx(343.2, rel=2e-3)
    assert air.is_gas


@pytest.mark.parametrize(
    ("overrides", "words"),
    [
        (["fluid=honey"], "unknown fluid"),
        (["fluid={name: honey, viscosity: 10}"], "needs both viscosity and density"),
        (["fluid=water", "temperature=-5 degC"], "properties of .* are known; got"),
        (["fluid=water", "temperature=120 degC"], "water boils"),
        (["fluid={name: x, viscosity: 1, density: 1, gas_constant: 1, bulk_modulus: 1}"], "either a gas or a liquid"),
    ],
)  # fmt: skip
def test_refusals(overrides: list[str], words: str) -> None:
    with pytest.raises(SpecError, match=words):
        leg(*overrides)
