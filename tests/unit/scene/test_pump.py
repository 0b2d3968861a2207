"""What a spec may say of its pump, and how it comes back."""

from __future__ import annotations

import jsonschema
import pytest
import yaml

from tests.scenes import CONFIGS, leg
from viscodesign.errors import SpecError
from viscodesign.loading import schema
from viscodesign.scene.per_inlet import each
from viscodesign.scene.pumps.servo import ServoPumpSpec
from viscodesign.scene.reading.read import parse_scene
from viscodesign.scene.reading.write import resolved_yaml


def pump(words: str, *others: str) -> ServoPumpSpec:
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
def test_a_pressure_limit_is_converted_to_gauge(given: str, gauge: float) -> None:
    assert pump(f"max_pressure: {given}").max_pressure == pytest.approx(gauge)


@pytest.mark.parametrize("given", ["140 kPa", "140000", "1.4 bar"])
def test_a_pressure_limit_above_ambient_needs_a_reference(given: str) -> None:
    with pytest.raises(SpecError) as refused:
        pump(f"max_pressure: {given}")
    (fault,) = refused.value.faults
    assert fault.key == "pump.max_pressure"
    assert "'140 kPa gauge'" in fault.message
    assert "'140 kPa abs' (38.67 kPa gauge)" in fault.message


def test_ambiguity_depends_on_the_ambient_pressure() -> None:
    assert pump("max_pressure: 140 kPa", "ambient_pressure=150 kPa").max_pressure == 140e3
    with pytest.raises(SpecError, match="may be gauge or absolute"):
        pump("max_pressure: 70 kPa", "ambient_pressure=60 kPa")


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ("20 kPa abs", "must be above the ambient"),
        ("-3 kPa", "must be above 0 kPa gauge"),
        ("25 mm", "is a length; expected a pressure"),
        ("gauge", "has no number"),
    ],
)
def test_faults_of_a_pressure_limit(given: str, words: str) -> None:
    with pytest.raises(SpecError, match=words):
        pump(f"max_pressure: {given}")


def test_an_invalid_ambient_pressure_hides_no_other_fault() -> None:
    with pytest.raises(SpecError) as refused:
        leg(
            "ambient_pressure=-1",
            "pump={syringe_diameter: 34.9 mm, max_pressure: 140 kPa, home: x}",
        )
    assert {fault.key for fault in refused.value.faults} == {"ambient_pressure", "pump.home"}


@pytest.mark.parametrize("given", ["120 kPa gauge", "140 kPa abs", "25 kPa"])
def test_a_pump_survives_a_round_trip(given: str) -> None:
    words = f"max_pressure: {given}, battery_capacity: 450 mAh, plunger_friction: 3 N"
    scene = leg(f"pump={{syringe_diameter: 34.9 mm, {words}}}")
    text = resolved_yaml(scene)
    assert "Pa gauge" in text
    assert parse_scene(text.encode()).pump == scene.pump
    assert scene.pump is not None
    assert scene.pump.battery_capacity == pytest.approx(1620.0)


# -- several inlets -------------------------------------------------------------------------


def two_inlets(words: str) -> ServoPumpSpec:
    ids = "servo_id: {right: 2, left: 1}"
    found = leg(
        f"pump={{syringe_diameter: 34.9 mm, {ids}, {words}}}", config="antagonistic_two_inlets"
    ).pump
    assert found is not None
    return found


BOTH = (
    "sensor: {right: {channel: 1}, left: {channel: 0}}, "
    "limit_switches: {right: {low: D3, high: D4, normally: open}, left: {low: D1, high: D2}}"
)


def test_parts_per_inlet_are_in_the_order_of_the_inlets() -> None:
    found = two_inlets(BOTH)
    for part in (found.servo_id, found.sensor, found.limit_switches):
        assert isinstance(part, dict)
        assert list(part) == ["left", "right"]
    assert [s.channel for s in each(found.sensor, 2) if s is not None] == [0, 1]


def test_a_single_part_belongs_to_the_first_inlet() -> None:
    found = two_inlets("sensor: {channel: 3}, limit_switches: {low: D1, high: D2}")
    first, second = each(found.sensor, 2)
    assert first is not None
    assert (first.channel, second) == (3, None)
    assert each(found.limit_switches, 2)[1] is None
    assert each(two_inlets("home: 300").sensor, 2) == (None, None)


def test_parts_per_inlet_survive_a_round_trip_and_fit_the_schema() -> None:
    words = f"pump={{syringe_diameter: 34.9 mm, servo_id: {{left: 1, right: 2}}, {BOTH}}}"
    scene = leg(words, config="antagonistic_two_inlets")
    text = resolved_yaml(scene)
    assert parse_scene(text.encode()).pump == scene.pump
    jsonschema.Draft202012Validator(schema()).validate(yaml.safe_load(text))


@pytest.mark.parametrize(
    ("words", "key", "told"),
    [
        ("sensor: {left: {channel: 0}}", "sensor", "the inlet 'right' has no pressure sensor"),
        (
            "sensor: {left: {channel: 0}, right: {channel: 1}, rigt: {channel: 2}}",
            "sensor.rigt",
            "did you mean 'right'",
        ),
        (
            "sensor: {left: {channel: 0}, right: {channel: 0}}",
            "sensor.right.channel",
            "channel 0 is already used by the inlet 'left'",
        ),
        (
            "sensor: {left: {channel: 0, on: board}, right: {channel: 0}}",
            "sensor.right.channel",
            "channel 0 is already used by the inlet 'left'",
        ),
        ("sensor: {left: {channel: 0}, right: {channel: 9}}", "sensor.right.channel", "at most 7"),
        ("sensor: {left: {channel: 0}, right: 3}", "sensor.right", "expected a mapping"),
        ("sensor: {}", "sensor.channel", "missing"),
        ("sensor: 3", "sensor", "expected a mapping"),
        ("sensor: {left: {channel: 0}, right: {chanel: 1}}", "sensor.right.chanel", "'channel'"),
        (
            "limit_switches: {left: {low: D1, high: D2}}",
            "limit_switches",
            "the inlet 'right' has no limit switches",
        ),
        (
            "limit_switches: {left: {low: D1, high: D2}, right: {low: D02, high: D4}}",
            "limit_switches.right.low",
            "already used by left.high",
        ),
        ("limit_switches: {low: D1, high: D1}", "limit_switches.high", "already used by low"),
        (
            "limit_switches: {left: {low: D1, high: D2}, right: {low: D3}}",
            "limit_switches.right.high",
            "missing",
        ),
    ],
)
def test_faults_of_parts_per_inlet(words: str, key: str, told: str) -> None:
    with pytest.raises(SpecError) as refused:
        two_inlets(words)
    faults = {fault.key: fault.message for fault in refused.value.faults}
    assert told in faults[f"pump.{key}"]


def test_a_fault_of_a_part_per_inlet_has_its_line() -> None:
    text = (CONFIGS / "antagonistic_two_inlets.yaml").read_text()
    lines = [
        *text.splitlines(),
        "pump:",
        "  syringe_diameter: 34.9 mm",
        "  servo_id: {left: 1, right: 2}",
        "  sensor:",
        "    left: {channel: 0}",
        "    right: {channel: 0}",
    ]
    with pytest.raises(SpecError) as refused:
        parse_scene("\n".join(lines).encode(), "two.yaml")
    (fault,) = refused.value.faults
    assert (fault.file, fault.line) == ("two.yaml", len(lines))


def test_equal_channels_of_two_boards_are_different() -> None:
    found = two_inlets("sensor: {left: {channel: 0, on: board}, right: {channel: 0, on: phidget}}")
    assert isinstance(found.sensor, dict)
