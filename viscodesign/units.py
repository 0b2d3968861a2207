"""Quantities with units: a bare number is SI, text is parsed.

Common units are read by a small table, all others by pint.

Each kind of quantity is an annotated float for pydantic models; all values in the program are SI.
"""

from __future__ import annotations

import math
import re
from decimal import Decimal
from functools import cache
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import PydanticCustomError, core_schema

from viscodesign.common_units import definitions, value_in_si
from viscodesign.errors import described
from viscodesign.lazy_dataclass import dataclass

if TYPE_CHECKING:
    import pint


_ALLOWED = re.compile(r"[\w\s.+*/^()%°·-]{1,80}")
"""Characters of a number with a unit."""
_BARE_POWER = re.compile(r"(?<![0-9.][eE])(?<=[A-Za-zµμ])([23])(?![\w.])")
"""The 2 of mm2 and the 3 of m3, but not the 3 of 1e3."""


@dataclass(frozen=True)
class QuantityKind:
    """A kind of quantity: its name, its SI unit and an example."""

    name: str
    unit: str
    example: str

    def parse(self, given: Any) -> float:
        """A number (SI) or text with a unit as a finite SI value; raises a message for users."""
        if isinstance(given, str):
            value = self._read(given)
        elif isinstance(given, (int, float)) and not isinstance(given, bool):
            value = float(given)
        else:
            raise self._invalid(f"{described(given)} is not a number")
        if not math.isfinite(value):
            raise self._invalid(f"{described(given)} is not finite")
        return value

    def written(self, value: float) -> Any:
        """A value as written in a spec: in SI with its unit; a fraction as a plain number."""
        return value if self.unit == "1" else f"{value!r} {self.unit}"

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        return core_schema.no_info_before_validator_function(self.parse, handler(source))

    def __get_pydantic_json_schema__(
        self, schema: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        plain = handler(schema)
        names = ("minimum", "maximum", "exclusiveMinimum", "exclusiveMaximum")
        bounds = {name: plain[name] for name in names if name in plain}
        unit = "a plain number" if self.unit == "1" else f"in SI: {self.unit}"
        return {
            "anyOf": [
                {"type": "number", "description": unit, **bounds},
                {"type": "string", "description": f"like {self.example}", "pattern": "[0-9]"},
            ],
            "description": f"{self.name}, {unit}, or with a unit",
            "examples": [self.example],
        }

    def _read(self, text: str) -> float:
        if not _ALLOWED.fullmatch(text):
            raise self._invalid(f"'{text}' is not a number with a unit")
        if not _starts_with_number(text):
            raise self._invalid(f"'{text}' has no number")
        plain = _BARE_POWER.sub(r"^\1", text)
        value = value_in_si(plain, self.unit)
        return self._by_pint(text, plain) if value is None else value

    def _by_pint(self, text: str, plain: str) -> float:
        quantity = self._quantity(text, plain)
        try:
            return self._in_si(quantity, text)
        except PydanticCustomError:
            raise
        except (TypeError, ValueError, ArithmeticError) as error:  # as pint does for decibels
            raise self._invalid(f"'{text}' has an unsupported unit") from error

    def _in_si(self, quantity: pint.Quantity[Any], text: str) -> float:
        if quantity.dimensionless and self.unit not in ("1", "rad") and not _has_unit(text):
            return float(quantity.magnitude)
        units = type(quantity)(Decimal(1), self.unit if self.unit != "1" else "")
        if quantity.dimensionality != units.dimensionality:
            raise self._invalid(f"'{text}' is {_dimension_words(quantity)}")
        return float(quantity.to(units.units).magnitude)

    def _quantity(self, text: str, plain: str) -> pint.Quantity[Any]:
        """Text parsed by pint with the common units, or else with all units of pint.

        ``plain``: the same with every power behind a sign.
        """
        import pint

        try:
            try:
                return common_units_registry().Quantity(plain)
            except pint.UndefinedUnitError:
                return all_units_registry().Quantity(plain)
        except pint.UndefinedUnitError as error:
            names = error.args[0] if error.args else text
            name = names if isinstance(names, str) else ", ".join(names)
            raise self._invalid(f"'{text}': unknown unit '{name}'") from error
        except Exception as error:  # pint's tokenizer raises many types
            raise self._invalid(f"'{text}' is not a number with a unit") from error

    def _invalid(self, problem: str) -> PydanticCustomError:
        article = "an" if self.name[0] in "aeiou" else "a"
        message = f"{problem}; expected {article} {self.name}, such as '{self.example}'"
        return PydanticCustomError("quantity", "{message}", {"message": message})


class ReferencedPressure(float):
    """A pressure [Pa] with its stated reference: "gauge", "abs", or "" if none was given."""

    reference: str = ""

    @classmethod
    def of(cls, value: float, reference: str) -> ReferencedPressure:
        """A pressure with its reference."""
        pressure = cls(value)
        pressure.reference = reference
        return pressure

    def gauge(self, ambient: float) -> float:
        """The gauge pressure [Pa] at this ambient pressure; without a reference it is gauge."""
        return float(self) - ambient if self.reference == "abs" else float(self)


_WITH_REFERENCE = re.compile(r"(.*\S)\s*\b(gauge|abs|absolute)", re.DOTALL)


class ReferencedPressureKind(QuantityKind):
    """A pressure that may state its reference, as in '25 kPa gauge' or '140 kPa abs'."""

    def parse(self, given: Any) -> ReferencedPressure:
        """A pressure with its reference."""
        if isinstance(given, ReferencedPressure):
            return given
        found = _WITH_REFERENCE.fullmatch(given.strip()) if isinstance(given, str) else None
        number, reference = found.groups() if found else (given, "")
        return ReferencedPressure.of(super().parse(number), reference[:5].replace("absol", "abs"))

    def written(self, value: float) -> Any:
        """As gauge pressure, with the word."""
        return f"{float(value)!r} {self.unit} gauge"

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        del handler  # a plain float would lose the reference
        return core_schema.no_info_plain_validator_function(
            self.parse, json_schema_input_schema=core_schema.float_schema()
        )


def _starts_with_number(text: str) -> bool:
    return bool(text.strip()) and text.strip()[0] in "+-.0123456789"


def _has_unit(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return True
    return False


@cache
def common_units_registry() -> pint.UnitRegistry[Any]:
    """The common units of `units.txt`; built at the first text with a unit."""
    common = _registry_of(None)
    common.load_definitions(definitions())
    return common


@cache
def all_units_registry() -> pint.UnitRegistry[Any]:
    """Every unit that pint knows; ten times slower to build."""
    return _registry_of("")


def _registry_of(source: str | None) -> pint.UnitRegistry[Any]:
    import pint

    # Decimal arithmetic, so that '18 mm' becomes 0.018 exactly and not a neighbouring float.
    return pint.UnitRegistry(source, autoconvert_offset_to_baseunit=True, non_int_type=Decimal)


_KNOWN_DIMENSIONS = {
    "[length]": "a length",
    "[mass]": "a mass",
    "[time]": "a time",
    "[temperature]": "a temperature",
    "[mass] / [length] / [time] ** 2": "a pressure",
    "[length] * [mass] / [time] ** 2": "a force",
    "[length] ** 2": "an area",
    "[length] ** 3": "a volume",
    "[mass] / [length] ** 3": "a density",
    "1 / [time]": "a frequency",
    "[length] / [time] ** 2": "an acceleration",
    "[mass] / [length] / [time]": "a dynamic viscosity",
    "dimensionless": "a plain number",
}


def _dimension_words(quantity: pint.Quantity[Any]) -> str:
    dimension = str(quantity.dimensionality)
    return _KNOWN_DIMENSIONS.get(dimension, f"of dimension {dimension}")


Length = Annotated[float, QuantityKind("length", "m", "37.5 mm")]
Pressure = Annotated[float, QuantityKind("pressure", "Pa", "40 kPa")]
GaugeOrAbsolutePressure = Annotated[float, ReferencedPressureKind("pressure", "Pa", "25 kPa gauge")]
Time = Annotated[float, QuantityKind("time", "s", "20 ms")]
Frequency = Annotated[float, QuantityKind("frequency", "Hz", "0.5 Hz")]
Angle = Annotated[float, QuantityKind("angle", "rad", "90 deg")]
Temperature = Annotated[float, QuantityKind("temperature", "K", "20 degC")]
Force = Annotated[float, QuantityKind("force", "N", "0.5 N")]
Mass = Annotated[float, QuantityKind("mass", "kg", "20 g")]
Density = Annotated[float, QuantityKind("density", "kg/m^3", "950 kg/m^3")]
Viscosity = Annotated[float, QuantityKind("dynamic viscosity", "Pa*s", "1.0 mPa*s")]
Fraction = Annotated[float, QuantityKind("fraction", "1", "0.5 %")]
Acceleration = Annotated[float, QuantityKind("acceleration", "m/s^2", "9.81 m/s^2")]
AreaPerPressure = Annotated[float, QuantityKind("area per pressure", "m^2/Pa", "3.413e-9 m^2/Pa")]
AreaPerForce = Annotated[float, QuantityKind("area per force", "m^2/N", "3.0e-7 m^2/N")]
AreaPerMoment = Annotated[float, QuantityKind("area per moment", "m^2/(N*m)", "1.2e-6 m^2/(N*m)")]
GasConstant = Annotated[float, QuantityKind("specific gas constant", "J/(kg*K)", "287 J/(kg*K)")]
Volume = Annotated[float, QuantityKind("volume", "m^3", "5 mL")]
Speed = Annotated[float, QuantityKind("speed", "m/s", "5 mm/s")]
Area = Annotated[float, QuantityKind("area", "m^2", "1e-5 m^2")]
Voltage = Annotated[float, QuantityKind("voltage", "V", "11.1 V")]
Charge = Annotated[float, QuantityKind("charge", "C", "450 mAh")]
