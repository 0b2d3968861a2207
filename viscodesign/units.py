"""Quantities with units: a bare number is SI, text is parsed.

Common units are read by a small table, all others by pint.

Each kind of quantity is an annotated float for pydantic models; all values in the program are SI.
"""

from __future__ import annotations

import math
import re
from decimal import Decimal
from functools import cache
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import PydanticCustomError, core_schema

from viscodesign.errors import described
from viscodesign.lazy_dataclass import dataclass
from viscodesign.values.common_units import definitions, value_in_si
from viscodesign.values.grammar import GrammarError, ValueText, parse_value_text
from viscodesign.values.repeated_units import repeated_units
from viscodesign.values.unit_hints import AMBIGUOUS, unit_hint

if TYPE_CHECKING:
    import pint


_NO_UNITS = ("dB", "decibel", "Np", "neper", "delta_degC", "delta_degF", "delta_celsius")
"""Names that pint converts by a logarithm or without the zero of the scale."""


@dataclass(frozen=True)
class QuantityKind:
    """A kind of quantity: its name, its SI unit and an example."""

    references: ClassVar[tuple[str, ...]] = ()
    """What a value may say that it is relative to."""
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
        try:
            found = parse_value_text(text)
        except GrammarError as error:
            if not str(error) and not any(char.isdigit() for char in text):
                raise self._invalid(f"'{_shown(text)}' has no number") from None
            hint = unit_hint(text, self) if str(error).endswith("is not a unit") else ""
            raise self._unreadable(text, str(error) + hint) from None
        if found.unit and found.has_difference and self.unit == "K":
            raise self._invalid(f"'{text}' is a difference of temperatures")
        if found.unit in _NO_UNITS:
            raise self._unreadable(text, f"'{found.unit}' is not a unit that a value may have")
        if ambiguous := AMBIGUOUS.get(found.unit):
            written = " or ".join(f"'{found.number} {unit}'" for unit in ambiguous)
            raise self._invalid(f"'{text}': '{found.unit}' is ambiguous; write {written}")
        if len(found.names) > 1 and (repeated := repeated_units(found.unit, found.names)):
            written = " and ".join(f"'{name}'" for name in repeated)
            raise self._unreadable(text, f"{written} cancel{'s' * (len(repeated) == 1)}")
        value = value_in_si(found.number, found.unit, self.unit)
        return self._by_pint(text, found) if value is None else value

    def _by_pint(self, text: str, found: ValueText) -> float:
        quantity = self._quantity(text, found)
        try:
            return self._in_si(quantity, text)
        except PydanticCustomError:
            raise
        except (TypeError, ValueError, ArithmeticError) as error:  # as pint does for decibels
            raise self._invalid(f"'{text}' has an unsupported unit") from error

    def _in_si(self, quantity: pint.Quantity[Any], text: str) -> float:
        """The magnitude in SI. Radians count as a unit: 60 rpm are not 6.28 Hz."""
        units = type(quantity)(Decimal(1), self.unit if self.unit != "1" else "")
        if quantity.dimensionality != units.dimensionality or (
            _has_angle(quantity) != _has_angle(units)
        ):
            words = _dimension_words(quantity)
            raise self._invalid(f"'{text}' is {words}{unit_hint(text, self)}")
        return float(quantity.to(units.units).magnitude)

    def _quantity(self, text: str, found: ValueText) -> pint.Quantity[Any]:
        """A value by pint with the common units, or else with all units of pint."""
        import pint

        try:
            try:
                return quantity_in(common_units_registry(), found)
            except pint.UndefinedUnitError:
                return quantity_in(all_units_registry(), found)
        except pint.UndefinedUnitError as error:
            names = error.args[0] if error.args else text
            name = names if isinstance(names, str) else ", ".join(names)
            raise self._invalid(
                f"'{text}': unknown unit '{name}'{unit_hint(text, self)}"
            ) from error
        except Exception as error:  # pint's tokenizer raises many types
            raise self._unreadable(text, "") from error

    def _unreadable(self, text: str, why: str) -> PydanticCustomError:
        reason = f": {why}" if why else ""
        return self._invalid(f"'{_shown(text)}' is not one number and one unit{reason}")

    def _invalid(self, problem: str) -> PydanticCustomError:
        """A fault; its problem stands apart, as a key may know a better example."""
        context = {"message": self.explained(problem, self.example), "problem": problem}
        return PydanticCustomError("quantity", "{message}", context)

    def explained(self, problem: str, example: str) -> str:
        """A problem, and what is expected instead, with an example."""
        expected = "Expected" if problem.endswith("?") else "; expected"
        article = "an" if self.name[0] in "aeiou" else "a"
        space = " " if problem.endswith("?") else ""
        return f"{problem}{space}{expected} {article} {self.name}, such as '{example}'"


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


def _with_reference(given: Any) -> tuple[Any, str]:
    """A value and its reference, ``gauge`` or ``abs``; as given where it has none, or several."""
    found = _WITH_REFERENCE.fullmatch(given.strip()) if isinstance(given, str) else None
    if found is None or _WITH_REFERENCE.fullmatch(found[1]):
        return given, ""
    return found[1], "gauge" if found[2] == "gauge" else "abs"


class ReferencedPressureKind(QuantityKind):
    """A pressure that may state its reference, as in '25 kPa gauge' or '140 kPa abs'."""

    references = ("gauge", "abs")

    def parse(self, given: Any) -> ReferencedPressure:
        """A pressure with its reference."""
        return self.parse_with_reference(given)

    def has_reference(self, text: str) -> bool:
        """Whether a text ends with a reference."""
        return bool(_with_reference(text)[1])

    def parse_with_reference(self, given: Any) -> ReferencedPressure:
        """A pressure with its reference."""
        if isinstance(given, ReferencedPressure):
            return given
        number, reference = _with_reference(given)
        value = super().parse(number)
        if reference == "abs" and value < 0.0:
            raise self._invalid(f"'{given}': no absolute pressure is negative")
        return ReferencedPressure.of(value, reference)

    def written(self, value: float) -> Any:
        """As gauge pressure, with the word."""
        return f"{float(value)!r} {self.unit} gauge"

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        del handler  # a plain float would lose the reference
        return core_schema.no_info_plain_validator_function(
            self.parse,
            json_schema_input_schema=core_schema.float_schema(),
            # A number alone would lose it, too.
            serialization=core_schema.plain_serializer_function_ser_schema(
                self.written, when_used="json"
            ),
        )


class PressureLevelKind(ReferencedPressureKind):
    """A level of an input, above the baseline; a scene makes absolute ones gauge before."""

    def parse(self, given: Any) -> ReferencedPressure:
        """A level above the baseline."""
        level = self.parse_with_reference(given)
        if level.reference == "abs":
            raise self._invalid(f"'{given}' is absolute, which takes a scene's ambient pressure")
        return level

    def written(self, value: float) -> Any:
        """With the word if it was given one."""
        word = getattr(value, "reference", "")
        return f"{float(value)!r} {self.unit}{' gauge' if word else ''}"


class ReferredPressureKind(QuantityKind):
    """A pressure whose reference the key fixes: `gauge` or `abs` may stand behind it, or not."""

    reference: ClassVar[str]
    """The word that may stand behind it: ``gauge`` or ``abs``."""
    other: ClassVar[str]
    """What to do with a pressure of the other reference."""

    def __init_subclass__(cls) -> None:
        cls.references = (cls.reference,)

    def parse(self, given: Any) -> float:
        """A pressure; refuses the other reference."""
        number, reference = _with_reference(given)
        if reference not in ("", self.reference):
            raise self._invalid(f"'{given}': this key is {self.reference}, {self.other}")
        return super().parse(number)


class GaugePressureKind(ReferredPressureKind):
    """A pressure above that of the surroundings."""

    reference = "gauge"
    other = "so subtract the ambient pressure"


class AbsolutePressureKind(ReferredPressureKind):
    """A pressure above vacuum."""

    reference = "abs"
    other = "so add the ambient pressure"


def _shown(text: str) -> str:
    """A text short enough for a message, every odd character readable."""
    clear = "".join(char if char.isprintable() else repr(char)[1:-1] for char in text)
    return clear if len(clear) <= 60 else clear[:57] + "..."


def quantity_in(registry: pint.UnitRegistry[Any], found: ValueText) -> pint.Quantity[Any]:
    """A value as a quantity of a registry; only its unit is parsed, nothing is computed."""
    return registry.Quantity(Decimal(found.number), registry.parse_units(found.unit))


def _has_angle(quantity: pint.Quantity[Any]) -> bool:
    return "radian" in dict(type(quantity)(1, quantity.units).to_root_units().unit_items())


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
    "[mass] / [time] ** 2": "a force per length",
    "[mass] / [length] / [time]": "a dynamic viscosity",
    "[current] * [time]": "a charge",
    "dimensionless": "a plain number",
}


def _dimension_words(quantity: pint.Quantity[Any]) -> str:
    if _has_angle(quantity):
        return "an angle" if quantity.dimensionless else "a quantity per angle or with an angle"
    dimension = str(quantity.dimensionality)
    return _KNOWN_DIMENSIONS.get(dimension, f"of dimension {dimension}")


Length = Annotated[float, QuantityKind("length", "m", "37.5 mm")]
Pressure = Annotated[float, QuantityKind("pressure", "Pa", "40 kPa")]
GaugePressure = Annotated[float, GaugePressureKind("pressure", "Pa", "2 kPa")]
AbsolutePressure = Annotated[float, AbsolutePressureKind("pressure", "Pa", "101.325 kPa")]
PRESSURE_LEVEL = PressureLevelKind("pressure", "Pa", "25 kPa")
PressureLevel = Annotated[float, PRESSURE_LEVEL]
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
PressureRate = Annotated[float, QuantityKind("pressure rate", "Pa/s", "50 kPa/s")]
SpringStiffness = Annotated[float, QuantityKind("spring stiffness", "N/m", "500 N/m")]
Speed = Annotated[float, QuantityKind("speed", "m/s", "5 mm/s")]
Area = Annotated[float, QuantityKind("area", "m^2", "1e-5 m^2")]
Voltage = Annotated[float, QuantityKind("voltage", "V", "11.1 V")]
Charge = Annotated[float, QuantityKind("charge", "C", "450 mAh")]
