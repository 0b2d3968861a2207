"""Properties of named fluids against published tables."""

from __future__ import annotations

import subprocess
import sys

import pytest

from tests.scenes import ROOT, leg
from tests.unit.scene.round_trip import comes_back
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


def oil(grade: float, celsius: float) -> tuple[float, float]:
    """Kinematic viscosity [mm2/s] and density [kg/m3]."""
    fluid = leg(f"fluid=silicone oil {grade:g} cSt", f"temperature={celsius} degC").fluid
    return 1e6 * fluid.viscosity / fluid.density, fluid.density


@pytest.mark.parametrize("grade", [20, 100, 350, 1000, 12500, 100000])
def test_silicone_oils_are_graded_at_25_degrees(grade: float) -> None:
    viscosity, density = oil(grade, 25)
    assert viscosity == pytest.approx(grade, rel=1e-12)
    assert 945 <= density <= 980


@pytest.mark.parametrize("grade", [50, 100, 350, 1000])
def test_silicone_oils_lose_as_much_with_heat_as_makers_say(grade: float) -> None:
    """The viscosity-temperature coefficient 1 - nu(210 degF)/nu(100 degF) is 0.59 to 0.61."""
    lost = 1 - oil(grade, 98.89)[0] / oil(grade, 37.78)[0]
    assert lost == pytest.approx(0.60, abs=0.015)


def test_a_cold_silicone_is_as_thick_as_a_rheometer_says() -> None:
    """Polisil P10, 1180 mPa s at 25 degC and 3730 at -25 degC: Monteiro et al., The Journal of
    Plastination, Influence of the temperature on the viscosity of different types of silicone."""
    ratio = oil(1000, -25)[0] / oil(1000, 25)[0]
    assert ratio * oil(1000, -25)[1] / oil(1000, 25)[1] == pytest.approx(3730 / 1180, rel=0.12)


def test_densities_of_silicone_oils() -> None:
    """Typical of makers' tables at 25 degC."""
    for grade, density in ((50, 960), (100, 965), (1000, 971), (12500, 974)):
        assert oil(grade, 25)[1] == pytest.approx(density, rel=2e-3)
    assert oil(100, 35)[1] / oil(100, 25)[1] == pytest.approx(1 - 9.6e-3, abs=2e-4)


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("silicone oil", "state its viscosity at 25 degC, as in 'silicone oil 1000 cSt'"),
        ("PDMS", "as in 'silicone oil 1000 cSt'"),
        ("Silicone oil 50 cst", "as in 'silicone oil 1000 cSt'"),
        ("pure glycerol", "did you mean 'glycerol'"),
        ("glycerine", "did you mean 'glycerol'"),
        ("watr", "did you mean 'water'"),
        ("silicone oil 5 cSt", "silicone oils are known from 20 to 100000 cSt; got 5 cSt"),
    ],
)
def test_names_that_were_meant(name: str, hint: str) -> None:
    with pytest.raises(SpecError) as caught:
        leg(f"fluid={name}", "temperature=20 degC")
    assert hint in str(caught.value)


def test_a_grade_survives_a_round_trip() -> None:
    scene = leg("fluid=silicone oil 350 cSt", "temperature=20 degC")
    assert scene.fluid.name == "silicone oil 350 cSt"
    assert "silicone oil 350 cSt" in comes_back(scene)


def test_an_own_fluid_may_be_called_like_a_grade() -> None:
    own = leg("fluid={name: silicone oil 350 cSt, viscosity: 1, density: 900}").fluid
    assert own.viscosity == 1


@pytest.mark.parametrize("name", ["water", "air", "{name: glycerol-water, fraction: 50 %}"])
@pytest.mark.parametrize("pressure", [1.01e9, 1e30, 4.58e286])
def test_beyond_the_pressures_of_its_formulas_a_fluid_is_refused(
    name: str, pressure: float
) -> None:
    told = r"ambient_pressure: must be at most 1e\+09 Pa, up to which the properties of "
    with pytest.raises(SpecError, match=told):
        leg(f"fluid={name}", f"ambient_pressure={pressure} Pa")
    leg(f"fluid={name}", "ambient_pressure=0.99 GPa")


TWO_AT_ONCE = """
import sys, threading
from concurrent.futures import ThreadPoolExecutor
from viscodesign.scene.fluids.air import Air
from viscodesign.scene.fluids.water import Water

sys.setswitchinterval(1e-5)
together = threading.Barrier(2)

def density(fluid):
    together.wait()
    return fluid.properties(293.15, 101325.0, 0.0).density

with ThreadPoolExecutor(2) as threads:
    print(*threads.map(density, [Air, Water]))
"""


def test_two_threads_may_ask_for_their_first_fluids_at_once() -> None:
    """Their libraries are parts of one package, whose modules import each other."""
    done = subprocess.run(
        [sys.executable, "-c", TWO_AT_ONCE], cwd=ROOT, check=True, capture_output=True, text=True
    )
    air, water = map(float, done.stdout.split())
    assert (air, water) == pytest.approx((1.204, 998.2), rel=1e-3)
