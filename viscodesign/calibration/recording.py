"""Recordings: what was measured of an actuator, one file a run."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from pydantic_core import PydanticCustomError

from viscodesign.calibration.recorded_columns import (
    Measured,
    RecordedColumn,
    recorded_columns,
)
from viscodesign.errors import Fault, SpecError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.far_places import far_words
from viscodesign.scene.reading.markers_file import MarkersFile, recorded_tip
from viscodesign.scene.scene import Scene
from viscodesign.scene.table_file import text_of_file
from viscodesign.scene.tables.layout import taken_apart
from viscodesign.scene.tables.numbers import read_numbers
from viscodesign.scene.tables.space_markers import TipInSpace, without_markers

MIN_RECORDED_ROWS = 10
MAX_RECORDED_ROWS = 200_000
MAX_LISTED = 5
"""Faults of one kind that a message lists."""
OVERRIDE = "@"


@dataclass(frozen=True, eq=False)
class RecordedChannel:
    """One column of a recording."""

    header: str
    measured: Measured
    output: str
    """The output of a compiled function that it is compared with."""
    values: np.ndarray
    """(T,) In SI, pressures gauge; NaN where nothing was measured."""

    @property
    def gaps(self) -> int:
        """Rows without a value."""
        return int(np.isnan(self.values).sum())


@dataclass(frozen=True, eq=False)
class Recording:
    """One run of an actuator, as it was measured."""

    file: str
    """As the user calls it."""
    time: np.ndarray
    """(T,) Increasing [s]."""
    channels: tuple[RecordedChannel, ...]
    overrides: tuple[str, ...] = ()
    """Keys of the spec that are others in this run, ``KEY=VALUE``."""
    notices: tuple[str, ...] = ()
    """What a user should know of how it was read."""

    def of(self, *measured: Measured) -> list[RecordedChannel]:
        """The channels of some kinds."""
        return [own for own in self.channels if own.measured in measured]


def split_source(source: str) -> tuple[str, tuple[str, ...]]:
    """The file, and the overrides, of a text ``DATA.csv@KEY=VALUE@KEY=VALUE``."""
    if Path(source).exists() or OVERRIDE not in source:
        return source, ()
    file, *parts = source.split(OVERRIDE)
    for part in parts:
        if "=" not in part or not part.partition("=")[0].strip():
            raise SpecError.plain(
                f"'{source}': expected KEY=VALUE behind '@', such as "
                f"{file}@loads.payload=200 g; got '{part}'"
            )
    return file, tuple(part.strip() for part in parts)


def read_recording(
    source: str | Path, scene: Scene, markers: MarkersFile | None = None
) -> Recording:
    """The recording of a source ``DATA.csv`` or ``DATA.csv@KEY=VALUE``, read for a scene.

    ``markers``: which of a recording in space are at the clamp and which at the tip. Raises
    `SpecError` that names the file and the line.
    """
    file, overrides = split_source(str(source))
    try:
        text = taken_apart(text_of_file(Path(file), file))
    except PydanticCustomError as error:
        raise SpecError.plain(error.message()) from None
    if not text.header:
        problem = "is empty" if not text.columns else "has no header"
        message = f"{problem}; expected a line with the names and units of its columns"
        raise SpecError([Fault(message, file=file, line=1)])
    found = recorded_tip(text.header, file, markers)
    header = list(text.header) if found is None else without_markers(text.header)
    columns, others = recorded_columns(
        header, scene, file, text.header_line, has_tip=found is not None
    )
    places, headers = [own.place for own in columns], [own.header for own in columns]
    try:
        values = read_numbers(text, places, headers, file, None, gaps=True)
    except PydanticCustomError as error:
        raise SpecError.plain(error.message()) from None
    scaled = values.values * [own.factor for own in columns]
    _check_times(scaled[:, 0], values.lines, file)
    channels = [
        _channel(own, row, scene) for own, row in zip(columns[1:], scaled.T[1:], strict=True)
    ]
    time = scaled[:, 0]
    if found is not None:
        channels = [_from_row(own, found.first_row) for own in channels] + _tip_channels(found)
        time = found.time
    _check_channels(channels, file)
    _check_places(channels, scene.actuator.length, file)
    notices = (*(() if found is None else found.notices), *_notices(channels, others))
    return Recording(file, time, tuple(channels), overrides, notices)


def _from_row(channel: RecordedChannel, first: int) -> RecordedChannel:
    return replace(channel, values=channel.values[first:])


def _tip_channels(found: TipInSpace) -> list[RecordedChannel]:
    return [
        RecordedChannel(header, Measured.PLACE, header, values)
        for header, values in zip(("tip_x_m", "tip_z_m"), found.tip.T, strict=True)
    ]


def _channel(column: RecordedColumn, values: np.ndarray, scene: Scene) -> RecordedChannel:
    if column.is_absolute:
        values = values - scene.ambient_pressure
    return RecordedChannel(column.header, column.measured, column.output, values)


def _check_times(time: np.ndarray, lines: Callable[[], list[int]], file: str) -> None:
    if len(time) < MIN_RECORDED_ROWS or len(time) > MAX_RECORDED_ROWS:
        raise SpecError(
            [
                Fault(
                    f"has {len(time)} rows; a fit needs {MIN_RECORDED_ROWS} to {MAX_RECORDED_ROWS}",
                    file=file,
                )
            ]
        )
    back = np.flatnonzero(~(np.diff(time) > 0.0)) + 1
    if not len(back):
        return
    numbers = lines()
    faults = [
        Fault(
            f"time goes from {time[k - 1]:g} s to {time[k]:g} s; times must increase from row to "
            "row. Sort the rows, or remove duplicates",
            file=file,
            line=numbers[k],
        )
        for k in back[:MAX_LISTED]
    ]
    raise SpecError(faults)


def _check_channels(channels: Sequence[RecordedChannel], file: str) -> None:
    """Raise faults for columns without numbers, and for markers that never move."""
    faults = []
    still = _still_markers(channels)
    for own in channels:
        known = own.values[~np.isnan(own.values)]
        if len(known) < MIN_RECORDED_ROWS:
            faults.append(
                Fault(
                    f"column '{own.header}' has {len(known)} values, the rest is missing; a fit "
                    f"needs {MIN_RECORDED_ROWS}. Remove the column",
                    file=file,
                )
            )
    for name, headers in still.items():
        faults.append(
            Fault(
                f"{name} never moves: every row has the same value, to the last digit, so that "
                f"nothing was tracked. Remove {' and '.join(headers)}",
                file=file,
            )
        )
    if faults:
        raise SpecError(faults)


def _check_places(channels: Sequence[RecordedChannel], length: float, file: str) -> None:
    """Raise a fault for places [m] far beyond the actuator: those of other units."""
    places = [own for own in channels if own.measured is Measured.PLACE]
    values = [np.column_stack([own.values, np.zeros_like(own.values)]) for own in places]
    words = [far_words(own, length) for own in values]
    headers = [own.header for own, told in zip(places, words, strict=True) if told]
    if headers:
        shown = ", ".join(headers[:MAX_LISTED]) + (" ..." if len(headers) > MAX_LISTED else "")
        told = next(own for own in words if own)
        message = f"{shown}: {told} Write the unit after the name, such as tip_x_mm"
        raise SpecError([Fault(message, file=file)])


def _still_markers(channels: Sequence[RecordedChannel]) -> dict[str, list[str]]:
    """Headers of markers, and of volumes, all of whose numbers stay the same."""
    groups: dict[str, list[RecordedChannel]] = {}
    for own in channels:
        if own.measured is Measured.PLACE:
            groups.setdefault(f"marker {own.output.split('_')[0]}", []).append(own)
        elif own.measured is Measured.VOLUME:
            groups.setdefault(f"column '{own.header}'", []).append(own)
    return {
        name: [own.header for own in members]
        for name, members in groups.items()
        if all(_range(own.values) == 0.0 for own in members)
    }


def _range(values: np.ndarray) -> float:
    known = values[~np.isnan(values)]
    return float(np.ptp(known)) if len(known) else math.nan


def _notices(channels: Sequence[RecordedChannel], others: Sequence[str]) -> tuple[str, ...]:
    found = []
    gaps = [f"{own.header} {own.gaps}" for own in channels if own.gaps]
    if gaps:
        found.append(f"missing samples are left out: {', '.join(gaps)}")
    if others:
        found.append(f"columns that mean nothing to a fit are ignored: {', '.join(others[:8])}")
    return tuple(found)
