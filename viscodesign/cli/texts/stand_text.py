"""A study of statics as lines of text."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from viscodesign.cli.texts.layout import files_row, number, table
from viscodesign.results.stand_study import StanceRow, StandStudy


def stand_lines(study: StandStudy, folder: Path, files: Sequence[Path]) -> list[str]:
    """The stance, its table by gauge pressure and by payload, crouches, files."""
    own = study.own
    gauge = number(1e-3 * own.gauge_pressure_pa, "kPa gauge")
    facts = [
        ("height", f"{number(1e3 * own.height_m, 'mm')}, hips over the ground"),
        ("weight", f"{number(own.weight_n, 'N')}; {_limit(study)}"),
        ("tip stiffness", f"{number(own.tip_stiffness_n_per_m, 'N/m')} across, of one leg"),
        *_tilt(own),
    ]
    return [
        f"{study.name}: on its legs at {gauge}",
        *table(facts),
        "",
        *table([*_head(), *(_cells(row, study) for row in study.by_gauge)]),
        "",
        *table([*_head(), *(_cells(row, study) for row in study.by_payload)]),
        "",
        *_crouches(study),
        *table([files_row(folder, files)]),
    ]


def _limit(study: StandStudy) -> str:
    if study.fall is not None:
        return study.fall.how
    return f"sways from {number(study.own.sway_limit_n, 'N')} on"


def _tilt(own: StanceRow) -> Iterator[tuple[str, str]]:
    if max(abs(own.pitch_rad), abs(own.roll_rad)) > 1e-6:
        pitch, roll = (number(1e3 * angle, "mrad") for angle in (own.pitch_rad, own.roll_rad))
        yield "tilt", f"pitch {pitch} (nose up), roll {roll} (right side down)"


def _head() -> list[tuple[str, ...]]:
    return [("gauge", "payload", "weight", "height", "bears", "tip stiffness")]


def _mass(kilograms: float) -> str:
    return number(kilograms, "kg") if kilograms >= 1.0 else number(1e3 * kilograms, "g")


def _cells(row: StanceRow, study: StandStudy) -> tuple[str, ...]:
    falls = "sways" if study.fall is None else study.fall.how
    return (
        number(1e-3 * row.gauge_pressure_pa, "kPa"),
        _mass(row.payload_kg),
        number(row.weight_n, "N"),
        number(1e3 * row.height_m, "mm") if row.stands else falls,
        number(row.sway_limit_n, "N"),
        number(row.tip_stiffness_n_per_m, "N/m") if row.stands else "-",
    )


def _crouches(study: StandStudy) -> list[str]:
    if not study.crouch:
        return []
    heads = ("crouch", "gauge", f"pump {study.pump}: drawn as a liquid", "barrel for the fluid")
    rows: list[tuple[str, ...]] = [heads]
    for row in (own for own in study.crouch if not own.reason):
        pressure = number(1e-3 * row.gauge_pressure_pa, "kPa")
        volumes = (number(1e6 * v, "mL") for v in (row.liquid_volume_m3, row.barrel_volume_m3))
        rows.append((f"{1e2 * row.height_ratio:g} % of the legs", pressure, *volumes))
    reasons = [
        f"  no crouch to {1e2 * row.height_ratio:g} %: {row.reason}"
        for row in study.crouch
        if row.reason
    ]
    return [*(table(rows) if len(rows) > 1 else []), *reasons, ""]
