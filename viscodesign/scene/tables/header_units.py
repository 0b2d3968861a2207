"""The header of a column: a name, a unit, and what a pressure is relative to."""

from __future__ import annotations

import re
from functools import cache

from viscodesign.lazy_dataclass import dataclass
from viscodesign.units import QuantityKind

SPELLINGS = {
    "s": "s sec second seconds ms msec millisecond milliseconds us µs μs microseconds min minute "
    "minutes h hour hours",
    "Pa": "Pa pascal hPa kPa kilopascal MPa mPa bar mbar millibar psi atm torr mmHg inHg mmH2O "
    "cmH2O inH2O",
    "m": "m meter metre mm cm um µm μm inch in",
    "rad": "rad deg °",
    "m^2": "m^2 m2 m² mm^2 mm2 mm² cm^2 cm2 cm²",
    "m^3": "m^3 m3 m³ mm^3 mm3 mm³ cm^3 cm3 cm³ L mL uL µL μL",
}
"""Units that a header may have, by SI unit; the case of letters counts where two differ in it."""
_MEANT = {"msec": "ms", "hours": "h", "hour": "h", "°": "deg", "inch": "in"}
_FORMS = (
    r"(?P<name>.*?)\s*\[(?P<unit>.+)\]",
    r"(?P<name>.*?)\s*\((?P<unit>.+)\)",
    r"(?P<name>.*?)\s*[/,]\s*(?P<unit>.+)",
    r"(?P<name>.*?)\s+(?:in\s+)?(?P<unit>\S+(?:\s+(?:gauge|abs|absolute))?)",
    r"(?P<name>.*?)_(?P<unit>[^\W_]+(?:_(?:gauge|abs))?)",
)
"""``Time [ms]``, ``p (mbar)``, ``P/kPa``, ``Pressure in kPa``, ``pressure_kPa``."""
_REFERENCE = re.compile(r"(?P<unit>.*?)[\s_(]*(?P<word>gauge|absolute|abs|g|a)\)?")
_RATE = re.compile(r".*_(?:m3|m|mm|l|ml|pa|kpa|rad|deg|kg|g)", re.IGNORECASE)
"""Names before a unit of time that make it that of a rate, as in ``flow_m3_s``."""


@dataclass(frozen=True)
class HeaderUnit:
    """A header taken apart."""

    name: str
    factor: float
    """Value of one unit in SI."""
    reference: str = ""
    """What a pressure is relative to: ``gauge``, ``abs`` or not said."""


def header_unit(header: str, kind: QuantityKind) -> HeaderUnit | None:
    """The name and the unit of a header; None unless it has a unit of this kind."""
    for form in _FORMS:
        found = re.fullmatch(form, header.strip())
        if found is None:
            continue
        own, reference = unit_factor(found["unit"].strip(), kind)
        if own is not None and not _RATE.fullmatch(found["name"]):
            return HeaderUnit(found["name"].strip(), own, reference or _in_name(found["name"]))
    return None


def unit_factor(text: str, kind: QuantityKind) -> tuple[float | None, str]:
    """Value of a unit in SI, None if it is none of this kind; and what it is relative to."""
    own = _factors(kind).get(text)
    if own is None and not _meant_by_case(text, kind):
        own = _factors(kind).get(text.lower())
    if own is not None or kind.unit != "Pa":
        return own, ""
    found = _REFERENCE.fullmatch(text)
    if found is None:
        return None, ""
    own, _ = unit_factor(found["unit"], kind) if found["unit"] != text else (None, "")
    return own, "gauge" if found["word"].startswith("g") else "abs"


def unclear_unit(header: str, kind: QuantityKind) -> str:
    """What is unclear in the unit of a header, where letters of other cases mean another one."""
    if kind.unit == "Pa" and re.search(r"(?<![a-zA-Z])mpa\W*$", header.lower()):
        own = header_unit(header, kind)
        return "" if own else "may be in MPa or in mPa; write its unit with its capital letters"
    for form in _FORMS:
        found = re.fullmatch(form, header.strip())
        if found is not None and (meant := _meant_by_case(found["unit"].strip(), kind)):
            return f"is not in '{meant}' as it is written; did you mean '{meant}'?"
    return ""


def _meant_by_case(text: str, kind: QuantityKind) -> str:
    """The unit that a text such as ``Ms`` or ``mS`` is in small letters, but not as it stands.

    Capitals throughout, as in ``MS``, are a way of writing; of a prefix alone they change it.
    """
    small = text.lower()
    if text in (small, text.upper()) or text in _factors(kind) or small[:1] not in "mu\u00b5\u03bc":
        return ""
    return small if small in _factors(kind) and small[1:] in _factors(kind) else ""


def _in_name(name: str) -> str:
    """The reference that a name such as ``p_abs`` says."""
    words = re.split(r"[\W_]+", name.lower())
    if {"abs", "absolute"} & set(words):
        return "abs"
    return "gauge" if "gauge" in words else ""


@cache
def _factors(kind: QuantityKind) -> dict[str, float]:
    """Value of every spelling in SI; in lower letters too where these mean one unit alone."""
    spelled = SPELLINGS.get(kind.unit, kind.unit).split()
    known = {text: kind.parse(f"1 {_MEANT.get(text, text)}") for text in spelled}
    lower: dict[str, set[float]] = {}
    for text, value in known.items():
        lower.setdefault(text.lower(), set()).add(value)
    same = {text: values.pop() for text, values in lower.items() if len(values) == 1}
    return {**same, **known}
