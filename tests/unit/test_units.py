"""Numbers with units."""

from __future__ import annotations

import pytest
from pydantic import TypeAdapter, ValidationError

from viscodesign import units

LENGTH = TypeAdapter(units.Length)


@pytest.mark.parametrize(
    ("kind", "given", "expected"),
    [
        (units.Length, "18 mm", 0.018),
        (units.Length, "0.325 mm", 0.000325),
        (units.Length, 0.5, 0.5),
        (units.Length, "0.5", 0.5),
        (units.Length, "3/32 inch", 3 / 32 * 0.0254),
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
    ],
)
def test_reads_to_the_last_digit(kind: object, given: object, expected: float) -> None:
    assert TypeAdapter(kind).validate_python(given) == pytest.approx(expected, rel=4e-16)


@pytest.mark.parametrize(
    "given",
    ["5 kg", "mm", "", "five mm", "5 mm mm2", True, None, [1], "nan", "inf", float("nan"),
     float("inf"), "5 degC", "1e400 mm", "__import__('os')", "5 mm; 3", "(" * 500],
)  # fmt: skip
def test_refuses_what_is_no_length(given: object) -> None:
    with pytest.raises(ValidationError, match="length is wanted"):
        LENGTH.validate_python(given)
