"""The likely slip behind a unit that is unknown or of the wrong kind."""

from __future__ import annotations

import re
import unicodedata
from typing import Protocol

from viscodesign.values.common_units import value_in_si
from viscodesign.values.slips import odd_letter

_MEANT = {
    "K": {
        "C": "degC",
        "c": "degC",
        "Celsius": "degC",
        "℃": "degC",
        "F": "degF",
        "f": "degF",
        "deg": "degC",
        "°": "degC",
        "oC": "degC",
        "oF": "degF",
        "˚C": "degC",
        "˚F": "degF",
        "R": "degR",
    },
    "rad": {"degC": "deg", "degrees": "deg", "%": "deg"},
    "Hz": {"rpm": "Hz"},
    "J/(kg*K)": dict.fromkeys(
        ("J/kg/C", "J/(kg*C)", "J/kgK", "J/kg K", "J/kg·K", "J/kg*K", "J/(kgK)"), "J/(kg*K)"
    ),
    "Pa*s": {"Pa": "Pa*s", "mPa": "mPa*s", "Pas": "Pa*s", "mPas": "mPa*s", "Pa/s": "Pa*s"},
    "kg/m^3": {"kg": "kg/m^3", "g/cc": "g/cm^3", "kg/m": "kg/m^3"},
}
"""Units that are read as something else or as nothing, and what was meant, by SI unit."""
_SPELLED = {
    "m": "m mm cm um km inch in micron",
    "Pa": "Pa hPa kPa MPa GPa bar mbar psi atm mmHg torr",
    "s": "s ms us min h",
    "Hz": "Hz kHz mHz",
    "rad": "rad deg mrad",
    "K": "K degC degF",
    "N": "N mN kN",
    "kg": "kg g mg",
    "kg/m^3": "kg/m^3 g/cm^3 g/mL kg/L",
    "Pa*s": "Pa*s mPa*s cP uPa*s poise",
    "m^3": "mL L uL m^3 mm^3 cm^3",
    "m/s": "m/s mm/s",
    "V": "V mV",
    "C": "mAh Ah C",
}
"""Spellings of the common units, by SI unit; the first that fits is suggested."""
AMBIGUOUS = {"gr": ("g", "grain")}
"""Units whose name means one thing to pint and another to many who write it: what to write."""
_SUFFIX = re.compile(r"(k|M|m|h)?(Pa|bar|psi) ?\(?([ga])\)?")
"""A pressure with a letter for its reference, such as barg, psia or kPa(g)."""
_REFERENCES = {"g": "gauge", "a": "abs"}
_REFERENCE = re.compile(r"\b(abs|gauge|gage|rel)(?:olute|ative)?\b", re.IGNORECASE)
_GRAMS = {"g": 1e-3, "kg": 1.0}
_KINEMATIC = {"cSt": 1e-6, "St": 1e-4, "mm^2/s": 1e-6, "mm2/s": 1e-6, "m^2/s": 1.0, "m2/s": 1.0}
"""Units of kinematic viscosity [m2/s]."""
_VALUE = re.compile(
    r"\s*([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)\s*([^\W\d].*|[%°˚℃℉\"㎛㎜㎝㎡㎥㎎㎏㎪㎫].*)\s*",
    re.DOTALL,
)


class KeyKind(Protocol):
    """A kind of quantity."""

    @property
    def name(self) -> str: ...
    @property
    def unit(self) -> str: ...
    @property
    def references(self) -> tuple[str, ...]: ...


def unit_hint(text: str, wanted: KeyKind) -> str:
    """'; did you mean ...?' for a value whose unit does not fit, or nothing."""
    found = _VALUE.fullmatch(text)
    if found is None:
        return ""
    number, spelled = found[1], found[2].strip()
    if wanted.unit == "Pa*s" and spelled in _KINEMATIC:
        return _by_density(number, spelled)
    if re.search(r"\b(rpm|rps|rad ?/ ?s|deg ?/ ?s)\b", spelled) and wanted.unit == "Hz":
        return " (an angular speed); a frequency is in Hz (1 Hz is 60 rpm, or 6.2832 rad/s)"
    if wanted.unit == "Pa" and (words := _REFERENCE.findall(spelled)):
        return _by_reference(number, spelled, words, wanted)
    if wanted.unit == "Pa" and (suffixed := _SUFFIX.fullmatch(spelled)):
        unit = f"{suffixed[1] or ''}{suffixed[2]}"
        return f"; did you mean '{number} {unit} {_REFERENCES[suffixed[3]]}'?"
    if wanted.unit == "N" and spelled in _GRAMS:
        return f", whose weight is {9.80665 * float(number) * _GRAMS[spelled]:.4g} N"
    if wanted.unit == "m/s^2" and spelled in ("g", "G", "gee", "gn"):
        return f", and standard gravity {9.80665 * float(number):.6g} m/s^2"
    if re.search(r"\bNm\b", spelled):
        together = re.sub(r"\(Nm\)|\bNm\b", "(N*m)", spelled)
        return f"; did you mean '{number} {together}'?"
    meant = _meant(spelled, wanted.unit) or _meant(_plain(spelled), wanted.unit)
    if not meant and (odd := odd_letter(spelled)):
        return f"; the unit contains {odd}"
    return f"; did you mean '{number} {meant}'?" if meant else ""


def _meant(spelled: str, unit: str) -> str:
    return _MEANT.get(unit, {}).get(spelled) or _other_case(spelled, unit)


def _plain(spelled: str) -> str:
    """A unit without its full stop, inches in a word, and signs that stand for letters as these."""
    words = spelled.replace('"', "inch").removesuffix(".").strip()
    return words if "˚" in words else unicodedata.normalize("NFKC", words).replace("°", "deg")


def _by_reference(number: str, spelled: str, words: list[str], wanted: KeyKind) -> str:
    """A hint where what a pressure is relative to is written in another way, or not allowed."""
    if not wanted.references:
        return ": this key has no choice between gauge and absolute; leave the word out"
    meant = {"abs" if word.lower() == "abs" else "gauge" for word in words}
    if len(meant) > 1:
        return ": a pressure is either gauge or absolute; write one of the words"
    unit = _REFERENCE.sub("", spelled).strip(" ()[]*_,")
    return f"; did you mean '{number} {unit} {meant.pop()}'?"


def _by_density(number: str, spelled: str) -> str:
    kinematic = float(number) * _KINEMATIC[spelled]  # the grammar has read the number
    return (
        f": a kinematic viscosity; the dynamic one is this times the density, "
        f"{1e6 * kinematic:.4g} mPa*s at 1000 kg/m^3"
    )


def _other_case(spelled: str, unit: str) -> str:
    """The same letters in other cases as a common unit of this kind; the first letter's stays."""
    names = _SPELLED.get(unit, "").split()
    same = [name for name in names if name.lower() == spelled.lower()]
    same.sort(key=lambda name: name[0] != spelled[0])
    return next((name for name in same if value_in_si("1", name, unit) is not None), "") or next(
        iter(same), ""
    )
