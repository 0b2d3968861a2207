"""What a spec may say of its pump, and how it comes back."""

from __future__ import annotations

import pytest

from tests.scenes import leg
from viscodesign.errors import SpecError
from viscodesign.scene.dump import resolved_yaml
from viscodesign.scene.load import parse_scene
from viscodesign.scene.pump import Pump


def pump(words: str, *others: str) -> Pump:
    found = leg(f"pump={{syringe_diameter: 34.9 mm, {words}}}", *others).pump
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("given", "gauge"),
    [
        ("25 kPa", 25e3),
        ("25 kPa gauge", 25e3),
        ("20000", 20e3),
        ("140 kPa gauge", 140e3),
        ("140 kPa abs", 38675.0),
        ("1.4 bar absolute", 38675.0),
        ("101.325 kPa", 101325.0),
    ],
)
def test_a_cap_is_gauge_once_it_is_read(given: str, gauge: float) -> None:
    assert pump(f"max_pressure: {given}").max_pressure == pytest.approx(gauge)


@pytest.mark.parametrize("given", ["140 kPa", "140000", "1.4 bar"])
def test_a_cap_above_the_ambient_says_from_where_it_counts(given: str) -> None:
    with pytest.raises(SpecError) as refused:
        pump(f"max_pressure: {given}")
    (fault,) = refused.value.faults
    assert fault.key == "pump.max_pressure"
    assert "'140 kPa gauge'" in fault.message
    assert "'140 kPa abs' (38.67 kPa gauge)" in fault.message


def test_what_is_ambiguous_depends_on_the_scenes_ambient() -> None:
    assert pump("max_pressure: 140 kPa", "ambient_pressure=150 kPa").max_pressure == 140e3
    with pytest.raises(SpecError, match="could be meant either way"):
        pump("max_pressure: 70 kPa", "ambient_pressure=60 kPa")


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ("20 kPa abs", "not above the ambient"),
        ("-3 kPa", "not above 0 kPa gauge"),
        ("25 mm", "is a length; a pressure is wanted"),
        ("gauge", "has no number"),
    ],
)
def test_faults_of_a_cap(given: str, words: str) -> None:
    with pytest.raises(SpecError, match=words):
        pump(f"max_pressure: {given}")


def test_a_faulty_ambient_is_told_and_hides_no_other_fault() -> None:
    with pytest.raises(SpecError) as refused:
        leg(
            "ambient_pressure=-1",
            "pump={syringe_diameter: 34.9 mm, max_pressure: 140 kPa, home: x}",
        )
    assert {fault.key for fault in refused.value.faults} == {"ambient_pressure", "pump.home"}


@pytest.mark.parametrize("given", ["120 kPa gauge", "140 kPa abs", "25 kPa"])
def test_a_pump_comes_back_from_the_resolved_spec(given: str) -> None:
    words = f"max_pressure: {given}, battery_capacity: 450 mAh, plunger_friction: 3 N"
    scene = leg(f"pump={{syringe_diameter: 34.9 mm, {words}}}")
    text = resolved_yaml(scene)
    assert "Pa gauge" in text
    assert parse_scene(text.encode()).pump == scene.pump
    assert scene.pump is not None
    assert scene.pump.battery_capacity == pytest.approx(1620.0)
