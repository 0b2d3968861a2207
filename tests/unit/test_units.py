"""Numbers with units."""

from __future__ import annotations

import math
import subprocess
import sys

import pint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import TypeAdapter, ValidationError

from tests.scenes import CONFIGS, ROOT
from viscodesign import units
from viscodesign.units import QuantityKind, all_units_registry, common_units_registry
from viscodesign.values.common_units import definitions, value_in_si
from viscodesign.values.grammar import GrammarError, parse_value_text

LENGTH = TypeAdapter(units.Length)


@pytest.mark.parametrize(
    ("kind", "text", "expected"),
    [
        (units.Length, "18 mm", 0.018),
        (units.Length, "0.325 mm", 0.000325),
        (units.Length, 0.5, 0.5),
        (units.Length, "0.5", 0.5),
        (units.Length, "0.09375 inch", 3 / 32 * 0.0254),
        (units.Temperature, "20 degC", 293.15),
        (units.Temperature, 293.15, 293.15),
        (units.Fraction, "0.5 %", 0.005),
        (units.Angle, "180 deg", 3.141592653589793),
        (units.Angle, "10.266 rad", 10.266),
        (units.AreaPerMoment, "1.2e-6 m^2/(N*m)", 1.2e-6),
        (units.AreaPerPressure, "3.413e-9 m^2/Pa", 3.413e-9),
        (units.Viscosity, "1 mPa*s", 1e-3),
        (units.Viscosity, "1 cP", 1e-3),
        (units.Pressure, "1 bar", 1e5),
        (units.Volume, "5 mL", 5e-6),
        (units.Volume, "5 mm3", 5e-9),
        (units.Density, "950 kg/m3", 950.0),
        (units.Acceleration, "9.81 m/s2", 9.81),
        (units.Length, "1e3 mm", 1.0),
        (units.Pressure, "1 psi", 6894.757293168361),  # beyond the common units
        (units.Pressure, "10 hPa", 1000.0),
        (units.Temperature, "20 °C", 293.15),
    ],
)
def test_values_are_exact_to_the_last_digit(kind: object, text: object, expected: float) -> None:
    assert TypeAdapter(kind).validate_python(text) == pytest.approx(expected, rel=4e-16)


@pytest.mark.parametrize(
    "text",
    ["5 kg", "mm", "", "five mm", "5 mm mm2", True, None, [1], "nan", "inf", float("nan"),
     float("inf"), "5 degC", "1e400 mm", "__import__('os')", "5 mm; 3", "(" * 500],
)  # fmt: skip
def test_invalid_lengths_are_refused(text: object) -> None:
    with pytest.raises(ValidationError, match="expected a length"):
        LENGTH.validate_python(text)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("37.5 kg", "'37.5 kg' is a mass; expected a length, such as '37.5 mm'"),
        ("3 furlongz", "unknown unit 'furlongz'"),
        ("1 dB", "'dB' is not a unit that a value may have; expected a length"),
        ("mm", "has no number"),
        ("yes", "has no number"),
        ("0,325 mm", "is not one number and one unit: a decimal point is meant"),
        (True, "on (or true) is not a number"),
        (float("nan"), "not finite"),
    ],
)
def test_messages_say_what_was_given_and_expected(text: object, words: str) -> None:
    with pytest.raises(ValidationError) as caught:
        LENGTH.validate_python(text)
    assert words in str(caught.value)


def kinds() -> dict[str, QuantityKind]:
    found = {name: getattr(alias, "__metadata__", ()) for name, alias in vars(units).items()}
    return {name: notes[0] for name, notes in found.items() if notes and name[0].isupper()}


@pytest.mark.parametrize("name", kinds())
def test_every_kind_reads_its_example(name: str) -> None:
    kind = kinds()[name]
    assert kind.parse(kind.example) > 0
    assert kind.parse(f"2 {kind.unit}" if kind.unit != "1" else 2) == 2.0


@pytest.mark.parametrize("name", kinds())
@given(value=st.floats(allow_nan=False, allow_infinity=False))
@settings(max_examples=25, deadline=None)
def test_written_values_survive_a_round_trip_exactly(name: str, value: float) -> None:
    kind = kinds()[name]
    assert kind.parse(kind.written(value)) == value


def test_common_units_equal_those_of_pint() -> None:
    prefixes = ["", *"pnµumcdkMG"]
    names = [name for name in dir_of_common_units() if name != "%"]
    compared = 0
    for text in (prefix + name for prefix in prefixes for name in names):
        try:
            common = common_units_registry().Quantity(1, text).to_root_units()
        except (pint.UndefinedUnitError, pint.OffsetUnitCalculusError):
            continue  # then the whole list is asked, or refuses as well
        whole = all_units_registry().Quantity(1, text).to_root_units()
        assert str(common.units) == str(whole.units), text
        assert float(common.magnitude) == pytest.approx(float(whole.magnitude), rel=1e-15), text
        compared += 1
    assert compared > 300


@pytest.mark.parametrize("name", kinds())
@given(
    space=st.sampled_from(["", " "]),
    number=st.sampled_from(["1", "-0.0", "0", "3.413e-9", "20", ".5", "7.", "-1.25e3", "1e-7"]),
    parts=st.lists(
        st.tuples(
            st.sampled_from(["*", "/", " * ", " ", "/("]),
            st.sampled_from(["", *"munkMcdµ", "milli"]),
            st.sampled_from(["", "m", "s", "g", "K", "Pa", "N", "degC", "deg", "%", "rad", "L",
                             "min", "Hz", "J", "inch", "bar", "V", "cP", "meters", "Pas"]),
            st.sampled_from(["", "", "2", "^2", "**3", "^-1", "^0.5", ")"]),
        ),
        max_size=3,
    ),
)  # fmt: skip
@settings(max_examples=60, deadline=None)
def test_the_table_reads_what_pint_reads_or_nothing(
    name: str, space: str, number: str, parts: list[tuple[str, ...]]
) -> None:
    kind = kinds()[name]
    text = number + space + "".join("".join(part) for part in parts)[1:]
    try:
        value = parse_value_text(text)
    except GrammarError:
        return
    found = value_in_si(value.number, value.unit, kind.unit)
    if found is not None and value.unit:
        by_pint = kind._by_pint(text, value)
        assert (found, math.copysign(1.0, found)) == (by_pint, math.copysign(1.0, by_pint))


@pytest.mark.parametrize("name", kinds())
def test_the_table_reads_the_example_of_every_kind(name: str) -> None:
    kind = kinds()[name]
    example = kind.example.removesuffix(" gauge")
    value = parse_value_text(example)
    assert value_in_si(value.number, value.unit, kind.unit) == kind._by_pint(example, value)


def test_every_prefix_of_every_common_unit_agrees_with_pint() -> None:
    compared = 0
    for text in ("2.5 " + p + name for p in ["", *"pnµumcdkMG"] for name in dir_of_common_units()):
        if text.endswith("%") and text[-2] != " ":
            continue  # a percent has no prefix
        value = parse_value_text(text)
        for kind in kinds().values():
            found = value_in_si(value.number, value.unit, kind.unit)
            if found is not None:
                assert found == pytest.approx(kind._by_pint(text, value), rel=2e-16), text
                compared += 1
    assert compared > 300


def dir_of_common_units() -> list[str]:
    known = [line.split("=") for line in definitions() if "=" in line and not line.startswith("#")]
    units_only = [d for d in known if not d[0].strip().endswith("-") and d[0].strip() != "pi"]
    return [name.strip() for d in units_only for name in (d[0], *d[2:])]


def test_reading_a_spec_imports_no_heavy_library() -> None:
    code = (
        "import sys, viscodesign.scene.reading.read as load\n"
        "heavy = {'pint', 'casadi', 'scipy', 'pandas', 'matplotlib', 'chemicals', 'CoolProp'}\n"
        "assert not heavy & set(sys.modules), heavy & set(sys.modules)\n"
        f"load.load_scene({str(CONFIGS / 'leg_16_straight_air.yaml')!r})\n"
        "assert 'pint' not in sys.modules, 'common units need no pint'\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True, cwd=ROOT)
