"""Numbers with units: a bare number is SI, a text is read by pint.

Each kind of quantity is an annotated float for pydantic models; inside the program
every value is SI.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from decimal import Decimal
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import PydanticCustomError, core_schema

if TYPE_CHECKING:
    import pint


_PLAIN = re.compile(r"[\w\s.+*/^()%°·-]{1,80}")
"""What a number with a unit may be written with."""
_POWER = re.compile(r"(?<![0-9.][eE])(?<=[A-Za-zµμ])([23])(?![\w.])")
"""The 2 of mm2 and the 3 of m3, but not that of 1e3."""


@dataclass(frozen=True)
class Kind:
    """A kind of quantity: what it is called, its SI unit, and an example."""

    name: str
    unit: str
    example: str

    def parse(self, given: Any) -> float:
        """Read a number (SI) or a text with a unit; raises a message for users."""
        if isinstance(given, bool) or given is None:
            raise self._refuse(f"{_shown(given)} is not a number")
        if isinstance(given, (int, float)):
            value = float(given)
        elif isinstance(given, str):
            value = self._read(given)
        else:
            raise self._refuse(f"{_shown(given)} is not a number")
        if not math.isfinite(value):
            raise self._refuse(f"{_shown(given)} is not finite")
        return value

    def written(self, value: float) -> Any:
        """A value as a spec has it: SI with its unit; a fraction is a plain number."""
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
        if not _PLAIN.fullmatch(text):
            raise self._refuse(f"'{text}' is not a number with a unit")
        if not _starts_with_number(text):
            raise self._refuse(f"'{text}' has no number")
        quantity = self._quantity(text)
        try:
            return self._in_si(quantity, text)
        except PydanticCustomError:
            raise
        except (TypeError, ValueError, ArithmeticError) as error:  # as pint does for decibels
            raise self._refuse(f"'{text}' is in a unit that is not read here") from error

    def _in_si(self, quantity: pint.Quantity[Any], text: str) -> float:
        if quantity.dimensionless and self.unit not in ("1", "rad") and not _has_unit(text):
            return float(quantity.magnitude)
        units = type(quantity)(Decimal(1), self.unit if self.unit != "1" else "")
        if quantity.dimensionality != units.dimensionality:
            raise self._refuse(f"'{text}' is {_dimension_words(quantity)}")
        return float(quantity.to(units.units).magnitude)

    def _quantity(self, text: str) -> pint.Quantity[Any]:
        """What pint reads in ``text``, from the common units or else from all that it knows."""
        import pint

        plain = _POWER.sub(r"^\1", text)
        try:
            try:
                return registry().Quantity(plain)
            except pint.UndefinedUnitError:
                return every_unit().Quantity(plain)
        except pint.UndefinedUnitError as error:
            names = error.args[0] if error.args else text
            name = names if isinstance(names, str) else ", ".join(names)
            raise self._refuse(f"'{text}': no unit is called '{name}'") from error
        except Exception as error:  # pint's tokenizer raises what it likes on odd text
            raise self._refuse(f"'{text}' is not a number with a unit") from error

    def _refuse(self, complaint: str) -> PydanticCustomError:
        article = "an" if self.name[0] in "aeiou" else "a"
        message = f"{complaint}; {article} {self.name} is wanted, like '{self.example}'"
        return PydanticCustomError("quantity", "{message}", {"message": message})


class StatedPressure(float):
    """A pressure [Pa], and what it was said to be counted from: "gauge", "abs", or nothing."""

    counted: str = ""

    @classmethod
    def of(cls, value: float, counted: str) -> StatedPressure:
        """A pressure with what it is counted from."""
        made = cls(value)
        made.counted = counted
        return made

    def gauge(self, ambient: float) -> float:
        """The same above the ambient [Pa]; what nothing is said of is gauge."""
        return float(self) - ambient if self.counted == "abs" else float(self)


_COUNTED = re.compile(r"(.*\S)\s*\b(gauge|abs|absolute)", re.DOTALL)


class StatedKind(Kind):
    """A pressure that may say what it is counted from, as in '25 kPa gauge' or '140 kPa abs'."""

    def parse(self, given: Any) -> StatedPressure:
        """Read a pressure; what it is counted from is kept with it."""
        if isinstance(given, StatedPressure):
            return given
        found = _COUNTED.fullmatch(given.strip()) if isinstance(given, str) else None
        number, counted = found.groups() if found else (given, "")
        return StatedPressure.of(super().parse(number), counted[:5].replace("absol", "abs"))

    def written(self, value: float) -> Any:
        """Gauge, and said to be."""
        return f"{float(value)!r} {self.unit} gauge"

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        del handler  # a plain float would forget what it is counted from
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


def _shown(given: Any) -> str:
    words = {True: "on (or true)", False: "off (or false)", None: "nothing"}
    if given is None or isinstance(given, bool):
        return words[given]
    if isinstance(given, dict):
        return "a mapping"
    if isinstance(given, list):
        return "a list"
    return f"{given!r}"


@cache
def registry() -> pint.UnitRegistry[Any]:
    """The registry of the common units of `units.txt`; built at the first text with a unit."""
    common = _registry_of(None)
    common.load_definitions(_definitions())
    return common


@cache
def every_unit() -> pint.UnitRegistry[Any]:
    """The registry of every unit that pint knows; ten times slower to build."""
    return _registry_of("")


def _registry_of(source: str | None) -> pint.UnitRegistry[Any]:
    import pint

    # Decimals inside, so that '18 mm' becomes 0.018 and not its neighbour.
    return pint.UnitRegistry(source, autoconvert_offset_to_baseunit=True, non_int_type=Decimal)


def _definitions() -> list[str]:
    return Path(__file__).with_name("units.txt").read_text(encoding="utf-8").splitlines()


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


Length = Annotated[float, Kind("length", "m", "37.5 mm")]
Pressure = Annotated[float, Kind("pressure", "Pa", "40 kPa")]
CountedPressure = Annotated[float, StatedKind("pressure", "Pa", "25 kPa gauge")]
Time = Annotated[float, Kind("time", "s", "20 ms")]
Frequency = Annotated[float, Kind("frequency", "Hz", "0.5 Hz")]
Angle = Annotated[float, Kind("angle", "rad", "90 deg")]
Temperature = Annotated[float, Kind("temperature", "K", "20 degC")]
Force = Annotated[float, Kind("force", "N", "0.5 N")]
Mass = Annotated[float, Kind("mass", "kg", "20 g")]
Density = Annotated[float, Kind("density", "kg/m^3", "950 kg/m^3")]
Viscosity = Annotated[float, Kind("dynamic viscosity", "Pa*s", "1.0 mPa*s")]
Fraction = Annotated[float, Kind("fraction", "1", "0.5 %")]
Acceleration = Annotated[float, Kind("acceleration", "m/s^2", "9.81 m/s^2")]
AreaPerPressure = Annotated[float, Kind("area per pressure", "m^2/Pa", "3.413e-9 m^2/Pa")]
AreaPerForce = Annotated[float, Kind("area per force", "m^2/N", "3.0e-7 m^2/N")]
AreaPerMoment = Annotated[float, Kind("area per moment", "m^2/(N*m)", "1.2e-6 m^2/(N*m)")]
GasConstant = Annotated[float, Kind("specific gas constant", "J/(kg*K)", "287 J/(kg*K)")]
Volume = Annotated[float, Kind("volume", "m^3", "5 mL")]
Speed = Annotated[float, Kind("speed", "m/s", "5 mm/s")]
Area = Annotated[float, Kind("area", "m^2", "1e-5 m^2")]
Voltage = Annotated[float, Kind("voltage", "V", "11.1 V")]
Charge = Annotated[float, Kind("charge", "C", "450 mAh")]
