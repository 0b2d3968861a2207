"""A value is exactly one number and one unit; all else is refused, never computed."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic_core import PydanticCustomError

from viscodesign import units
from viscodesign.units import QuantityKind


def kind_of(alias: object) -> QuantityKind:
    return alias.__metadata__[0]  # type: ignore[attr-defined,no-any-return]


PRESSURE, LENGTH = kind_of(units.Pressure), kind_of(units.Length)
TEMPERATURE, FREQUENCY = kind_of(units.Temperature), kind_of(units.Frequency)
FRACTION, ANGLE = kind_of(units.Fraction), kind_of(units.Angle)
GAS_CONSTANT, VISCOSITY = kind_of(units.GasConstant), kind_of(units.Viscosity)
FORCE, MASS, DENSITY = kind_of(units.Force), kind_of(units.Mass), kind_of(units.Density)
ACCELERATION, AREA_PER_MOMENT = kind_of(units.Acceleration), kind_of(units.AreaPerMoment)

REFUSED = [
    # thousands
    ("1 800 kPa", "thousands"), ("37 500 um", "'37500 um'"), ("1'800 kPa", "thousands"),
    ("1,800,000 Pa", "'1800000 Pa'"), ("1,800.5 kPa", "thousands"), ("1,800 kPa", "comma"),
    # decimal comma
    ("37,5 mm", "decimal point"), ("0,325 mm", "'0.325 mm'"), (",5 mm", "decimal point"),
    # underscores
    ("37_5 mm", "underscores"), ("1_800 kPa", "underscores"), ("1_0.5 mm", "underscores"),
    # tolerances and uncertainties
    ("37.5 mm +- 1 mm", "tolerance"), ("37.5 +/- 1 mm", "tolerance"), ("37.5±1 mm", "tolerance"),
    ("±5 kPa", "tolerance"), ("37.5(5) mm", "brackets"), ("37.5 (5) mm", "brackets"),
    # fractions
    ("3 1/2 in", "fraction"), ("1/2 in", "fraction"), ("3/32 inch", "fraction"), ("½ mm", "U+00BD"),
    # ranges
    ("10 kPa - 20 kPa", "range"), ("10-20 kPa", "range"), ("10..20 kPa", "range"),
    ("10 to 20 kPa", "range"), ("10–20 kPa", "range"),
    # sums, products, powers
    ("2*5 kPa", "products"), ("2 x 3 mm", "products"), ("5+5 kPa", "sums"), ("5 kPa/2", "sums"),
    ("5 mm*2", "products"), ("4e0*10^3 Pa", "not one number"), ("4*10^3 Pa", "powers of ten"),
    ("2**3 mm", "not one number"), ("1 m - 1 m", "not one number"),
    # two numbers
    ("37.5 mm 2", "two numbers"), ("5 kPa; 3", "two numbers"), ("5 5 kPa", "not one number"),
    ("1 e3 Pa", "exponent"), ("1e 3 Pa", "exponent"), ("1e3.5 Pa", "not one number"),
    # brackets
    ("(5 kPa)", "brackets"), ("[5] kPa", "brackets"), ("5 (kPa)", "brackets"), ("5 [kPa]", "brackets"),
    # look-alikes
    ("\u0661\u0662 mm", "arabic-indic digit"), ("\uff11 mm", "fullwidth"), ("1.8\u00a0MPa", "no-break space"),
    ("\u22125 kPa", "minus sign"), ("1\u202f800 kPa", "narrow no-break"), ("5\u200b kPa", "zero width"),
    # others
    ("0x10 mm", "decimal digits"), ("1:30 s", "clock time is not supported"), ("~5 mm", "exact"), ("<5 mm", "exact"),
    ("ca. 5 mm", "exact"), (".inf", "not finite"), ("-.inf", "not finite"), (".nan", "not finite"),
    ("--5 kPa", "not one number"), ("5.5.5 kPa", "not one number"), ("kPa 5", "not one number"),
    ("5'", "not one number"), ("5 mPa.s", "the sign '*'"), ("5 % %", "not one number"), ("5 m^1.5", "not one number"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "words"), REFUSED)
@pytest.mark.parametrize("kind", [PRESSURE, LENGTH])
def test_what_is_not_one_number_and_one_unit_is_refused(
    kind: QuantityKind, text: str, words: str
) -> None:
    with pytest.raises(PydanticCustomError, match=re.escape(words)) as caught:
        kind.parse(text)
    assert f"; expected a {kind.name}" in str(caught.value)


@pytest.mark.parametrize(
    ("kind", "text", "expected"),
    [
        (GAS_CONSTANT, "287.05 J/(kg*degC)", 287.05),
        (GAS_CONSTANT, "287.05 J/kg/degC", 287.05),
        (GAS_CONSTANT, "287.05 J/(kg*°C)", 287.05),
        (GAS_CONSTANT, "287.05 J/(kg celsius)", 287.05),
        (GAS_CONSTANT, "0.5 kJ/(kg*degF)", 900.0),
        (GAS_CONSTANT, "287.05 m²/s²/degC", 287.05),
        (TEMPERATURE, "20 degC", 293.15),
        (TEMPERATURE, "68 degF", 293.15),
        (FREQUENCY, "5 1/s", 5.0),
        (FREQUENCY, "5/s", 5.0),
        (FREQUENCY, "30 per minute", 0.5),
        (PRESSURE, "1.8 N/mm²", 1.8e6),
        (PRESSURE, "1.8 N mm^-2", 1.8e6),
        (PRESSURE, "5 cmH2O", 490.3325),
        (VISCOSITY, "1.8e-5 Pa·s", 1.8e-5),
        (VISCOSITY, "1.8e-5 Pa s", 1.8e-5),
        (ANGLE, "90 °", 1.5707963267948966),
        (FRACTION, "47 %", 0.47),
    ],
)
def test_one_number_with_one_unit_is_read(kind: QuantityKind, text: str, expected: float) -> None:
    assert kind.parse(text) == pytest.approx(expected, rel=4e-16)


@pytest.mark.parametrize(
    ("kind", "text"),
    [
        (TEMPERATURE, "20 degC^1"), (TEMPERATURE, "20 degC*m/m"), (TEMPERATURE, "20 delta_degC"),
        (TEMPERATURE, "1 degC/%"), (TEMPERATURE, "68 degF*s/s"),
    ],
)  # fmt: skip
def test_a_difference_of_temperatures_is_no_temperature(kind: QuantityKind, text: str) -> None:
    with pytest.raises(PydanticCustomError):
        kind.parse(text)


@pytest.mark.parametrize(
    ("kind", "text"),
    [
        (FREQUENCY, "60 rpm"), (FREQUENCY, "6.28 rad/s"), (FREQUENCY, "360 deg/s"),
        (FREQUENCY, "1 turn/s"), (FRACTION, "30 deg"), (FRACTION, "1 rad"), (FRACTION, "1 turn"),
        (ANGLE, "50 %"), (ANGLE, "5 ppm"), (LENGTH, "37 mm/rad"),
    ],
)  # fmt: skip
def test_an_angle_is_a_unit_and_no_plain_number(kind: QuantityKind, text: str) -> None:
    with pytest.raises(PydanticCustomError):
        kind.parse(text)


@pytest.mark.parametrize(
    ("kind", "text", "hint"),
    [
        (PRESSURE, "40 KPa", "'40 kPa'"), (PRESSURE, "1.8 Mpa", "'1.8 MPa'"), (PRESSURE, "1.8 mpa", "'1.8 MPa'"),
        (PRESSURE, "40 kpa", "'40 kPa'"), (PRESSURE, "2 Bar", "'2 bar'"), (LENGTH, "37.5 MM", "'37.5 mm'"),
        (LENGTH, "2 CM", "'2 cm'"), (TEMPERATURE, "20 C", "'20 degC'"), (TEMPERATURE, "68 F", "'68 degF'"),
        (TEMPERATURE, "300 k", "'300 K'"), (VISCOSITY, "20 cSt", "20 mPa*s at 1000 kg/m^3"),
        (VISCOSITY, "2e-5 m^2/s", "20 mPa*s at 1000 kg/m^3"), (VISCOSITY, "1 mPas", "'1 mPa*s'"),
        (VISCOSITY, "1 mPa", "'1 mPa*s'"), (PRESSURE, "40 kPa abs", "gauge and absolute"),
        (FREQUENCY, "60 rpm", "1 Hz is 60 rpm"), (FREQUENCY, "2 hz", "'2 Hz'"),
        (PRESSURE, "2 barg", "'2 bar gauge'"), (PRESSURE, "2 kPa(g)", "'2 kPa gauge'"),
        (PRESSURE, "15 psia", "'15 psi abs'"), (PRESSURE, "103 kPaa", "'103 kPa abs'"),
        (FORCE, "100 g", "whose weight is 0.9807 N"), (ACCELERATION, "1 G", "9.80665 m/s^2"),
        (AREA_PER_MOMENT, "1.2e-6 m^2/Nm", "'1.2e-6 m^2/(N*m)'"), (GAS_CONSTANT, "287 J/kgK", "'287 J/(kg*K)'"),
        (DENSITY, "950 kg m-3", "a power has the sign '^'"), (GAS_CONSTANT, "287 J/(kg.K)", "has the sign '*'"),
        (MASS, "200 gr", "'gr' is ambiguous; write '200 g' or '200 grain'"),
    ],
)  # fmt: skip
def test_a_slip_of_the_unit_has_a_hint(kind: QuantityKind, text: str, hint: str) -> None:
    with pytest.raises(PydanticCustomError, match=re.escape(hint)):
        kind.parse(text)


NUMBERS = st.from_regex(r"[+-]?([0-9]{1,6}(\.[0-9]{0,6})?|\.[0-9]{1,6})([eE][+-]?[0-9]{1,2})?", fullmatch=True)  # fmt: skip
UNITS = {
    "Pa": {"Pa": 1, "kPa": 1000, "MPa": 10**6, "N/m^2": 1, "N/mm2": 10**6, "N mm^-2": 10**6, "bar": 10**5, "J/m³": 1},
    "m": {"m": 1, "mm": Fraction(1, 1000), "cm": Fraction(1, 100), "km": 1000, "inch": Fraction(254, 10000)},
}  # fmt: skip


@pytest.mark.parametrize("kind", [PRESSURE, LENGTH])
@given(number=NUMBERS, data=st.data(), space=st.sampled_from(["", " ", "  ", "\t"]))
@settings(max_examples=150, deadline=None)
def test_every_sentence_of_the_grammar_is_read_exactly_and_survives_a_round_trip(
    kind: QuantityKind, number: str, data: st.DataObject, space: str
) -> None:
    spelled, size = data.draw(st.sampled_from(sorted(UNITS[kind.unit].items())))
    value = kind.parse(f"{number}{space}{spelled}")
    assert value == float(Fraction(number) * size)
    assert kind.parse(kind.written(value)) == value


@given(
    number=st.sampled_from(["5", "37.5", "1e3", "-2", ".5", "800"]),
    rest=st.text(alphabet="0123456789 .,'_()[]{}+-*/^:;~<>=±×–−½²³eExX\u00a0\u202fmkPa\uff11\u0661", max_size=12),
)  # fmt: skip
@settings(max_examples=1500, deadline=None)
def test_nothing_outside_of_the_grammar_gets_through_with_another_number(
    number: str, rest: str
) -> None:
    """What is read has the text's only number, times a factor that its unit alone has."""
    text = number + rest
    for kind in (PRESSURE, LENGTH):
        try:
            value = kind.parse(text)
        except PydanticCustomError:
            continue
        found = re.match(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?", text)
        assert found is not None
        unit = text[found.end() :].strip()
        without_powers = re.sub(
            r"(?<=[A-Za-z)])(\^|\*\*)?[-(]*[1-9]\)?", "", unit.replace("1/", "/")
        )
        assert not re.search(r"[0-9]", without_powers), text
        size = Fraction(kind.parse(f"1 {unit}" if unit else "1"))
        assert value == pytest.approx(float(Fraction(found[0]) * size))


@pytest.mark.parametrize("where", range(6))
@given(char=st.characters(blacklist_categories=("Lu", "Ll", "Lo", "Lm", "Lt")))
@settings(max_examples=150, deadline=None)
def test_a_character_that_slips_in_changes_no_number_unseen(where: int, char: str) -> None:
    text = "37.50 mm"
    slipped = text[:where] + char + text[where:]
    try:
        value = LENGTH.parse(slipped)
    except PydanticCustomError:
        return
    plain = re.sub(r"[ \t\r\n]", "", slipped)
    assert plain.isascii()
    assert value == pytest.approx(float(plain.removesuffix("mm")) / 1000)


@pytest.mark.parametrize(
    ("kind", "text", "words"),
    [
        (PRESSURE, "1.8 MPa MPa/Pa", "'MPa' and 'Pa' cancel"),
        (PRESSURE, "1.8 MPa^2/Pa", "'MPa' and 'Pa' cancel"),
        (PRESSURE, "1.8 MPa*MPa/MPa", "'MPa' cancels"),
        (PRESSURE, "1.8 MPa*m/m", "'m' cancels"),
        (PRESSURE, "1.8 MPa*mm/m", "cancel"),
        (FREQUENCY, "5 kHz*s/s", "'s' cancels"),
        (kind_of(units.AreaPerPressure), "3 psi m^2/(Pa psi)", "'psi' cancels"),
    ],
)
def test_units_that_cancel_are_refused(kind: QuantityKind, text: str, words: str) -> None:
    with pytest.raises(PydanticCustomError, match=words):
        kind.parse(text)


@pytest.mark.parametrize(
    ("kind", "text", "value"),
    [
        (kind_of(units.AreaPerMoment), "1.2 mm^2/(N*m)", 1.2e-6),
        (kind_of(units.AreaPerMoment), "1.2e-6 m^2/(N*m)", 1.2e-6),
        (kind_of(units.Acceleration), "9.81 m/s/s", 9.81),
        (PRESSURE, "5 kg*m/s^2/m^2", 5.0),
        (FRACTION, "3 mm/m", 3e-3),
        (FRACTION, "0.5 m/m", 0.5),
        (GAS_CONSTANT, "287 J/(kg*degC)", 287.0),
        (VISCOSITY, "1 dyn*s/cm^2", 0.1),
    ],
)
def test_lengths_may_stand_above_and_below_the_line(
    kind: QuantityKind, text: str, value: float
) -> None:
    assert kind.parse(text) == pytest.approx(value, rel=1e-15)
