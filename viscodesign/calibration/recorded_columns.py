"""Which quantity of a scene each column of a recording is, by its header."""

from __future__ import annotations

import enum
import re
from collections.abc import Sequence
from typing import get_args

from viscodesign.compiled.reading import SECTION_END_AXES, section_end_columns
from viscodesign.errors import Fault, SpecError, did_you_mean
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.cross_checks import SINGLE_INLET
from viscodesign.scene.scene import Scene
from viscodesign.scene.tables.header_units import header_unit
from viscodesign.units import Length, Pressure, QuantityKind, Time, Volume


class Measured(enum.StrEnum):
    """What a column of a recording is."""

    TIME = "time"
    PLACE = "place"
    PRESSURE = "pressure"
    VOLUME = "volume"


KINDS: dict[Measured, QuantityKind] = {
    Measured.TIME: get_args(Time)[1],
    Measured.PLACE: get_args(Length)[1],
    Measured.PRESSURE: get_args(Pressure)[1],
    Measured.VOLUME: get_args(Volume)[1],
}
TIME_NAMES = ("time", "t")
MARKER = re.compile(r"m(\d+)_([xyz])")
EXPECTED = (
    "time_s with m1_x_m, m1_z_m, ... (markers at the ends of the sections, from the clamp), "
    "tip_x_m, tip_z_m, inlet_pressure_pa, syringe_volume_m3"
)


@dataclass(frozen=True)
class RecordedColumn:
    """A column of a file."""

    place: int
    """In its file, from 0."""
    header: str
    measured: Measured
    output: str
    """The output of a compiled function that it is compared with; "" for the time."""
    factor: float = 1.0
    is_absolute: bool = False
    """Whether a pressure is above vacuum."""


def recorded_columns(
    header: Sequence[str], scene: Scene, file: str, line: int, *, has_tip: bool = False
) -> tuple[list[RecordedColumn], list[str]]:
    """The columns that mean something, the time first, and headers of the others.

    ``has_tip``: whether the tip is known without one. Raises `SpecError` for columns without
    units, markers that no section has, and files without time or without anything to compare.
    """
    known = _outputs(scene)
    found: list[RecordedColumn] = []
    others: list[str] = []
    faults: list[Fault] = []
    for place, cell in enumerate(header):
        own = _column(place, cell.strip(), known)
        if isinstance(own, RecordedColumn):
            found.append(own)
        elif own:
            faults.append(Fault(own, file=file, line=line))
        elif cell.strip():
            others.append(cell.strip())
    if faults:
        raise SpecError(faults)
    _check(found, others, file, line, has_tip=has_tip)
    return sorted(found, key=lambda own: own.measured is not Measured.TIME), others


def _outputs(scene: Scene) -> dict[str, tuple[Measured, str]]:
    """What each name in a header, without its unit, is compared with."""
    known = {name: (Measured.TIME, "") for name in TIME_NAMES}
    sections = scene.bellows.count // 2
    for column in [*section_end_columns(sections), "tip_x_m", "tip_z_m"]:
        known[column.removesuffix("_m")] = Measured.PLACE, column
    for inlet in scene.inputs:
        is_single = inlet == SINGLE_INLET
        for ending in ["", f"_{inlet}"] if is_single else [f"_{inlet}"]:
            tail = "" if is_single else f"_{inlet}"
            known[f"inlet_pressure{ending}"] = Measured.PRESSURE, f"inlet_pressure{tail}_pa"
            for word in ("syringe_volume", "inflow"):
                known[f"{word}{ending}"] = Measured.VOLUME, f"inflow{tail}_m3"
    return known


def _column(
    place: int, header: str, known: dict[str, tuple[Measured, str]]
) -> RecordedColumn | str | None:
    """A column, or what is wrong with its header; None where it is none of a scene's."""
    for measured, kind in KINDS.items():
        unit = header_unit(header, kind)
        name = "" if unit is None else _plain(unit.name)
        if unit is not None and known.get(name, ("", ""))[0] == measured:
            is_absolute = unit.reference == "abs"
            return RecordedColumn(place, header, measured, known[name][1], unit.factor, is_absolute)
        if unit is not None and (fault := _no_such_place(name, header, known)):
            return fault
    name = _plain(header)
    if name in known:
        kind = KINDS[known[name][0]]
        example = f"{name}_{kind.unit.lower().replace('^', '')}"
        return (
            f"column '{header}' has no unit that a {kind.name} may have; "
            f"write it after the name, such as '{example}'"
        )
    return None


def _plain(name: str) -> str:
    return re.sub(r"[\s_]+", "_", name.strip().lower())


def _no_such_place(name: str, header: str, known: dict[str, tuple[Measured, str]]) -> str:
    """Why a marker cannot be compared; empty where it can, or where it is none."""
    found = MARKER.fullmatch(name)
    if found is None or name in known:
        return ""
    if found[2] not in SECTION_END_AXES:
        return (
            f"column '{header}' is out of the plane of motion; a recording in space needs "
            "x, y and z of all its markers"
        )
    sections = sum(key.startswith("m") and key.endswith("_x") for key in known)
    return (
        f"column '{header}': the actuator has {sections} sections, so that its markers are "
        f"m1 (near the clamp) to m{sections} (the tip); rename or remove the column"
    )


def _check(
    found: Sequence[RecordedColumn], others: Sequence[str], file: str, line: int, *, has_tip: bool
) -> None:
    """Raise a fault unless there are one time and something to compare, nothing twice."""
    times = [own.header for own in found if own.measured is Measured.TIME]
    words = ", ".join(f"'{cell[:40]}'" for cell in others[:6]) or "nothing else"
    if len(times) != 1:
        problem = f"has {len(times)} columns of time ({', '.join(times)})" if times else "no time_s"
        raise SpecError(
            [
                Fault(
                    f"{problem} among its columns; expected {EXPECTED}; got {words}", "", file, line
                )
            ]
        )
    outputs = [own.output for own in found]
    if twice := {output for output in outputs if outputs.count(output) > 1}:
        both = ", ".join(f"'{own.header}'" for own in found if own.output in twice)
        raise SpecError(
            [Fault(f"columns {both} are the same quantity; keep one of them", "", file, line)]
        )
    if not has_tip and not any(own.measured in (Measured.PLACE, Measured.VOLUME) for own in found):
        wanted = ["tip_x_m", "tip_z_m", "m1_x_m", "syringe_volume_m3"]
        hint = "".join(did_you_mean(cell, wanted) for cell in others)[:120]
        raise SpecError(
            [Fault(f"nothing to compare with a motion; expected {EXPECTED}; got {words}{hint}",
                   "", file, line)]
        )  # fmt: skip
