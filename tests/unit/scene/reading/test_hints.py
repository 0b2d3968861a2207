"""Hints follow the key: its own example, its percent sign, and names that others give to it."""

from __future__ import annotations

import pytest

from tests.scenes import leg
from viscodesign.errors import SpecError


@pytest.mark.parametrize(
    ("override", "words"),
    [
        ("actuator.solid_fraction=much", "such as '47 %'"),
        ("actuator.length=mm", "such as '109 mm'"),
        ("actuator.bending_factor=[1]", "such as '0.55'"),
        ("bellows.angle_per_pressure=fast", "such as '10.266 rad'"),
        ("bellows.extension_per_pressure=5 kg", "such as '47 mm'"),
        ("bellows.collapse_fraction=x", "such as '10 %'"),
        ("network.tube_radius=thin", "such as '0.325 mm'"),
        ("ambient_pressure=high", "such as '101.325 kPa'"),
        ("accuracy=0.5", "a percentage needs its sign, as in '0.5 %'"),
        ("accuracy=5", "as in '5 %'"),
        ("actuator.solid_fraction=47", "as in '47 %'"),
        ("bellows.collapse_fraction=10", "as in '10 %'"),
        ("network.tube_diameter=0.65 mm", "did you mean 'tube_radius', half of the diameter?"),
        ("tube_diameter=0.65 mm", "did you mean 'network.tube_radius', half of the diameter?"),
        ("youngs_modulus=1 MPa", "did you mean 'actuator.youngs_modulus'?"),
        ("network.diameter=0.65 mm", "did you mean 'tube_radius', half of the diameter?"),
        ("network.feed_line={length: 1 m, diameter: 2 mm}", "did you mean 'radius', half of"),
        ("pump={syringe_radius: 17 mm}", "did you mean 'syringe_diameter', twice the radius?"),
        ("input={kind: sine, amplitude: 1 kPa, period: 1 s}", "'frequency', one over the period?"),
        ("actuator.E=1.8 MPa", "did you mean 'youngs_modulus'?"),
        ("actuator.rho=950", "did you mean 'density'?"),
        ("run.dt=1 ms", "did you mean 'output_interval'?"),
        ("fluid.mu=1e-3", "did you mean 'viscosity'?"),
        ("fluid.kinematic_viscosity=20 cSt", "the kinematic viscosity times the density?"),
        ("bellows.pairs=8", "did you mean 'count', twice the number of pairs?"),
        ("fluid={name: oil, viscosity: 20 cSt, density: 950}", "20 mPa*s at 1000 kg/m^3"),
        ("temperature=20 C", "did you mean '20 degC'?"),
        ("temperature=20 ℃", "did you mean '20 degC'?"),
        ("temperature=20 ºC", "did you mean '20 degC'?"),
        ("temperature=20 ˚C", "did you mean '20 degC'?"),
        ("temperature=20 oC", "did you mean '20 degC'?"),
        ("temperature=68 ℉", "did you mean '68 degF'?"),
        ("temperature=528 R", "did you mean '528 degR'?"),
        ("actuator.length=109 ㎜", "did you mean '109 mm'?"),
        ("actuator.length='4.25\"'", "did you mean '4.25 inch'?"),
        ("actuator.length=4.25 in.", "did you mean '4.25 in'?"),
        ("run.duration=8 s.", "did you mean '8 s'?"),
        ("gauge_pressure=30 Torr", "did you mean '30 torr'?"),
        ("fluid.viscosity=1 Poise", "did you mean '1 poise'?"),
        ("actuator.youngs_modulus=1.8 \u041c\u0420a", "contains cyrillic capital letter em (U+041C)"),
        ("gauge_pressure=2 KPa", "did you mean '2 kPa'?"),
        ("actuator.youngs_modulus=1.8 Mpa", "did you mean '1.8 MPa'?"),
        ("actuator.youngs_modulus=1.8 mpa", "did you mean '1.8 MPa'?"),
        ("actuator.youngs_modulus=1 800 kPa", "thousands are written without separators: '1800 kPa'"),
    ],
)  # fmt: skip
def test_a_hint_for_a_slip(override: str, words: str) -> None:
    with pytest.raises(SpecError) as caught:
        leg(override)
    assert words in str(caught.value)
