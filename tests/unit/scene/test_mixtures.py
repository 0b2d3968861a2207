"""Mass fractions, polytropic exponents, and glycerol in water against published tables."""

from __future__ import annotations

import sys

import pytest

from tests.scenes import leg
from tests.unit.scene.round_trip import comes_back
from viscodesign.errors import SpecError

OWN_GAS = "fluid={{name: mine, viscosity: 1e-5, density: 1, gas_constant: 287{}}}"


def glycerol(percent: float, celsius: float = 20.0) -> tuple[float, float]:
    """Viscosity [Pa s] and density [kg/m3]."""
    words = f"fluid={{name: glycerol-water, fraction: {percent} %}}"
    fluid = leg(words, f"temperature={celsius} degC").fluid
    return fluid.viscosity, fluid.density


@pytest.mark.parametrize(
    ("percent", "viscosity", "density"),
    [
        (10, 1.31e-3, 1022.1),  # Segur and Oberstar 1951; Bosart and Snoddy 1928: 20 degC
        (20, 1.76e-3, 1046.9),
        (30, 2.50e-3, 1072.7),
        (40, 3.72e-3, 1099.3),
        (50, 6.00e-3, 1126.3),
        (60, 10.8e-3, 1153.8),
    ],
)
def test_glycerol_in_water_at_20_degrees(percent: float, viscosity: float, density: float) -> None:
    found = glycerol(percent)
    assert found[0] == pytest.approx(viscosity, rel=0.03)
    assert found[1] == pytest.approx(density, rel=1e-3)


CELSIUS = (0, 10, 20, 30, 40, 50, 60, 70, 80)
SEGUR_OBERSTAR = {
    0: (1.792, 1.308, 1.005, 0.8007, 0.6560, 0.5494, 0.4688, 0.4061, 0.3565),
    10: (2.44, 1.74, 1.31, 1.03, 0.826, 0.680, 0.575, 0.500),
    20: (3.44, 2.41, 1.76, 1.35, 1.07, 0.879, 0.731, 0.635),
    30: (5.14, 3.49, 2.50, 1.87, 1.46, 1.16, 0.956, 0.816, 0.690),
    40: (8.25, 5.37, 3.72, 2.72, 2.07, 1.62, 1.30, 1.09, 0.918),
    50: (14.6, 9.01, 6.00, 4.21, 3.10, 2.37, 1.86, 1.53, 1.25),
    60: (29.9, 17.4, 10.8, 7.19, 5.08, 3.76, 2.85, 2.29, 1.84),
    70: (76.0, 38.8, 22.5, 14.1, 9.40, 6.61, 4.86, 3.78, 2.90),
    80: (255, 116, 60.1, 33.9, 20.8, 13.6, 9.42, 6.94, 5.13),
    90: (1310, 498, 219, 109, 60.0, 35.5, 22.5, 15.5, 11.0),
    100: (12070, 3900, 1410, 612, 284, 142, 81.3, 50.6, 31.9),
}
"""Viscosity [mPa s] by per cent of glycerol and temperature: Segur and Oberstar, Viscosity of
glycerol and its aqueous solutions, Industrial and Engineering Chemistry 43, 1951, 2117-2120."""
BOSART_SNODDY = {
    20: (998.23, 1022.1, 1046.9, 1072.7, 1099.3, 1126.3, 1153.8, 1181.25, 1208.5, 1235.1, 1261.08),
    30: (995.68, 1019.05, 1043.5, 1068.55, 1094.75, 1121.1, 1148.3, 1175.65, 1202.4, 1228.9, 1254.95),
}  # fmt: skip
"""Density [kg/m3] at 0, 10 ... 100 % of glycerol, by temperature: Bosart and Snoddy (1927)."""


@pytest.mark.parametrize("percent", SEGUR_OBERSTAR)
def test_glycerol_in_water_from_cold_to_hot(percent: int) -> None:
    allowed = 0.03 if percent <= 60 else 0.04
    for celsius, viscosity in zip(CELSIUS, SEGUR_OBERSTAR[percent], strict=False):
        found, _ = glycerol(percent, celsius)
        assert found == pytest.approx(1e-3 * viscosity, rel=allowed)


@pytest.mark.parametrize("celsius", BOSART_SNODDY)
def test_density_of_glycerol_in_water(celsius: int) -> None:
    for tenths, density in enumerate(BOSART_SNODDY[celsius]):
        assert glycerol(10 * tenths, celsius)[1] == pytest.approx(density, rel=1e-3)


def test_pure_glycerol() -> None:
    for celsius, viscosity in zip(CELSIUS, SEGUR_OBERSTAR[100], strict=True):
        fluid = leg("fluid=glycerol", f"temperature={celsius} degC").fluid
        assert fluid.viscosity == pytest.approx(1e-3 * viscosity, rel=0.04)
        assert (fluid.viscosity, fluid.density) == glycerol(100, celsius)


def test_above_freezing_a_solution_needs_no_slow_library(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "CoolProp", None)
    monkeypatch.setitem(sys.modules, "CoolProp.CoolProp", None)
    assert glycerol(50)[0] > 0
    with pytest.raises(SpecError, match=r"below 0 degC needs the library CoolProp"):
        glycerol(50, -5)


def test_a_solution_without_glycerol_is_nearly_water() -> None:
    water = leg("fluid=water", "temperature=20 degC").fluid
    viscosity, density = glycerol(0.0)
    assert viscosity == pytest.approx(water.viscosity, rel=0.05)
    assert density == pytest.approx(water.density, rel=3e-3)


def test_viscosity_falls_with_temperature() -> None:
    several = [glycerol(50, celsius) for celsius in (0.0, 10.0, 20.0, 30.0, 40.0)]
    assert several == sorted(several, reverse=True)


def test_a_mixture_is_a_liquid_of_unknown_stiffness() -> None:
    fluid = leg("fluid={name: glycerol-water, fraction: 0.5}", "temperature=20 degC").fluid
    assert not fluid.is_gas
    assert fluid.bulk_modulus is None
    assert fluid.speed_of_sound is None


@pytest.mark.parametrize(
    ("overrides", "words"),
    [
        (["fluid={name: glycerol-water}"], "fluid.fraction: missing; glycerol-water needs a mass fraction, such as '50 %'"),
        (["fluid=glycerol-water"], "needs a mass fraction"),
        (["fluid={name: glycerol-water, fraction: 61 %}", "temperature=-5 degC"], "fluid.fraction: must be at most 60 % glycerol by mass below 0 degC, the range of known properties; got 61 %"),
        (["fluid={name: glycerol-water, fraction: 110 %}"], "fluid.fraction"),
        (["fluid={name: glycerol-water, fraction: -1 %}"], "fluid.fraction"),
        (["fluid={name: glycerol-water, fraction: 50}"], "a percentage needs its sign"),
        (["fluid={name: glycerol-water, fraction: 50 %}", "temperature=105 degC"], "must be from 253.15 K to 373.15 K, where the properties of glycerol-water are known"),
        (["fluid={name: water, fraction: 10 %}"], "fluid.fraction: given, but water is not a mixture"),
        (["fluid={name: air, fraction: 10 %}"], "given, but air is not a mixture"),
        (["fluid={name: honey, viscosity: 10, density: 1400, fraction: 10 %}"], "given, but the fluid is not a named mixture"),
        (["fluid={name: water, polytropic_exponent: 1.4}"], "fluid.polytropic_exponent: given, but water is not a gas"),
        (["fluid={name: honey, viscosity: 10, density: 1400, polytropic_exponent: 1.2}"], "given, but honey is not a gas"),
        (["fluid={name: air, polytropic_exponent: 0.9}"], "fluid.polytropic_exponent"),
        (["fluid={name: air, polytropic_exponent: 1.7}"], "fluid.polytropic_exponent"),
        (["fluid={name: water, bulk_modulus: 1 GPa}"], "give viscosity and density as well"),
    ],
)  # fmt: skip
def test_faults(overrides: list[str], words: str) -> None:
    with pytest.raises(SpecError) as caught:
        leg(*overrides)
    assert words in str(caught.value)
    assert len(caught.value.faults) == 1


def test_a_frozen_solution_is_reported() -> None:
    pytest.importorskip("CoolProp")
    with pytest.raises(SpecError, match="it may be frozen"):
        leg("fluid={name: glycerol-water, fraction: 10 %}", "temperature=-15 degC")


def test_a_syringe_needs_a_given_stiffness_of_a_mixture() -> None:
    push = "input={kind: syringe, diameter: 2 cm, start: 4 cm, rows: [[0, 0], [1, 1 mm]]}"
    with pytest.raises(SpecError, match=r"input: a syringe needs the stiffness of glycerol-water"):
        leg(push, "fluid={name: glycerol-water, fraction: 50 %}", "temperature=20 degC")
    stated = "fluid={name: glycerol-water, viscosity: 6e-3, density: 1126, bulk_modulus: 3 GPa}"
    assert leg(push, stated).fluid.bulk_modulus == 3e9


@pytest.mark.parametrize("exponent", [1.0, 1.2, 5 / 3])
def test_gases_accept_a_polytropic_exponent(exponent: float) -> None:
    for words in (
        f"fluid={{name: air, polytropic_exponent: {exponent!r}}}",
        OWN_GAS.format(f", polytropic_exponent: {exponent!r}"),
    ):
        scene = leg(words)
        assert scene.fluid.polytropic_exponent == exponent
        comes_back(scene)


def test_a_gas_is_isothermal_by_default() -> None:
    assert leg("fluid=air").fluid.polytropic_exponent == 1.0
    scene = leg(OWN_GAS.format(""))
    assert scene.fluid.polytropic_exponent == 1.0
    assert "polytropic_exponent" not in comes_back(scene)


def test_a_mixture_survives_a_round_trip() -> None:
    scene = leg("fluid={name: glycerol-water, fraction: 37.5 %}", "temperature=20 degC")
    assert scene.fluid_choice.fraction == 0.375
    assert "fraction: 0.375" in comes_back(scene)
