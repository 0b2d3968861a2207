"""Recordings of markers in space: their tip, projected to the plane of motion."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import get_args

import numpy as np
from pydantic_core import PydanticCustomError

from viscodesign.errors import Fault, SpecError, did_you_mean
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.table_file import text_of_file
from viscodesign.scene.tables.clamp_frame import ClampFrame, clamp_frame
from viscodesign.scene.tables.header_units import header_unit
from viscodesign.scene.tables.layout import TableText, taken_apart
from viscodesign.scene.tables.numbers import read_numbers
from viscodesign.units import Length, Time

LENGTH, TIME = get_args(Length)[1], get_args(Time)[1]
AXES = "xyz"
TIP = "tip"
_IN_SPACE = re.compile(r"(?P<marker>.+)_(?P<axis>[xyz])")
MAX_MISFIT = 0.1
"""Distance of the clamp's markers from their stated places, relative to their extent, from which
the places are those of other markers, or in another unit."""


@dataclass(frozen=True, eq=False)
class MarkerPlaces:
    """What has to be said of a recording in space."""

    clamp: Mapping[str, tuple[float, float, float]]
    """Places in the actuator's frame [m]: x in the plane of motion, z along it from the clamp."""
    tip: tuple[str, ...]
    """Markers whose mean is the tip."""
    time_zero: float | None = None
    """Time of the recording that is 0 of the run [s]; None: its first row."""
    tip_before: tuple[float, float] | None = None
    """x and z of the tip before it [m], where they are known."""


@dataclass(frozen=True, eq=False)
class TipInSpace:
    """The tip of a recording in space."""

    time: np.ndarray
    """(T,) [s], from time zero on."""
    tip: np.ndarray
    """(T, 2): x and z in the plane of motion [m]; NaN where a marker was not seen."""
    first_row: int
    """Row of the file at time zero."""
    notices: tuple[str, ...]


def is_in_space(header: Sequence[str]) -> bool:
    """Whether a header has x, y and z of some marker; a column of the tip is in the plane."""
    found = _markers(header)
    return any(set(axes) == set(AXES) for name, axes in found.items() if name != TIP)


def without_markers(header: Sequence[str]) -> list[str]:
    """A header in which the coordinates of all markers are blank."""
    found = {place for axes in _markers(header).values() for place, _ in axes.values()}
    return ["" if place in found else cell for place, cell in enumerate(header)]


def _markers(header: Sequence[str]) -> dict[str, dict[str, tuple[int, float]]]:
    """Column and unit of every coordinate, by marker and axis."""
    found: dict[str, dict[str, tuple[int, float]]] = {}
    for place, cell in enumerate(header):
        unit = header_unit(cell, LENGTH)
        own = None if unit is None else _IN_SPACE.fullmatch(unit.name.strip().lower())
        if unit is not None and own is not None:
            found.setdefault(own["marker"], {})[own["axis"]] = place, unit.factor
    return found


def tip_in_space(file: str, places: MarkerPlaces) -> TipInSpace:
    """The tip of a recording. Raises `SpecError` that names the file and what is wrong in it."""
    try:
        return _tip(taken_apart(text_of_file(Path(file), file)), file, places)
    except PydanticCustomError as error:
        raise SpecError.plain(error.message()) from None


def _tip(text: TableText, file: str, places: MarkerPlaces) -> TipInSpace:
    names = [*places.clamp, *places.tip]
    columns, factors = _columns(text, names, file)
    headers = [text.header[place] for place in columns]
    values = read_numbers(text, columns, headers, file, None, gaps=True).values * factors
    time, seen = values[:, 0], values[:, 1:].reshape(len(values), len(names), 3)
    _check_times(time, file)
    clamped, moving = seen[:, : len(places.clamp)], seen[:, len(places.clamp) :]
    first, middle = _first_row(time, places, file), moving.mean(axis=1)
    before = _before(middle[:first], places, file)
    frame, words = _frame(clamped, before, places, file)
    tip = frame.placed(middle)
    if places.tip_before is not None:  # what the fit leaves at the tip is an error of places
        tip += np.array([places.tip_before[0], 0.0, places.tip_before[1]]) - frame.placed(before)
    if not np.isfinite(tip[first:]).all(axis=1).any():
        raise _fault(file, f"no row from time_zero on shows {' and '.join(places.tip)}")
    if tip[:, 2][np.isfinite(tip[:, 2])].mean() < 0.0:
        raise _fault(
            file, "the tip lies behind the clamp: z counts from the clamp along the actuator, and "
            "x, y and z are right-handed; correct the places of the clamp's markers"
        )  # fmt: skip
    out_of_plane = 1e3 * float(np.nanmax(np.abs(tip[first:, 1])))
    notices = (words, f"projected to the plane of motion; up to {out_of_plane:.2g} mm out of it")
    start = time[first] if places.time_zero is None else places.time_zero
    return TipInSpace(time[first:] - start, tip[first:, [0, 2]], first, notices)


def _columns(text: TableText, names: Sequence[str], file: str) -> tuple[list[int], np.ndarray]:
    """Columns of the time and of all coordinates of some markers, and their units in SI."""
    units = [header_unit(cell, TIME) for cell in text.header]
    times = [
        (place, unit.factor)
        for place, unit in enumerate(units)
        if unit is not None and unit.name.lower() in ("time", "t")
    ]
    if len(times) != 1:
        raise _fault(file, f"has {len(times)} columns of time; expected one, such as time_s")
    known, chosen = _markers(text.header), [times[0]]
    for name in names:
        own = known.get(name.lower(), {})
        if missing := [axis for axis in AXES if axis not in own]:
            if own:
                columns = " and ".join(f"{name}_{axis}_m" for axis in missing)
                raise _fault(file, f"marker {name} has no {columns}; it needs x, y and z")
            hint = did_you_mean(name, known) or f"; its markers are {', '.join(known) or 'none'}"
            raise _fault(file, f"has no marker {name}{hint}")
        chosen += [own[axis] for axis in AXES]
    return [place for place, _ in chosen], np.array([factor for _, factor in chosen])


def _check_times(time: np.ndarray, file: str) -> None:
    if len(time) < 2 or not (np.diff(time) > 0.0).all():
        raise _fault(file, "times must increase from row to row, in two rows or more")


def _frame(
    clamped: np.ndarray, before: np.ndarray, places: MarkerPlaces, file: str
) -> tuple[ClampFrame, str]:
    """The frame of a clamp that stands still (T, n, 3), and how well it fits.

    ``before`` (0 or 1, 3) is the tip where its place is known: far from the clamp, it tells
    directions better than the clamp's markers, which are close to each other.
    """
    for name, rows in zip(places.clamp, np.moveaxis(clamped, 1, 0), strict=True):
        if not np.isfinite(rows).all(axis=1).any():
            raise _fault(file, f"marker {name} of the clamp is in no row; name others")
    wanted = np.array(list(places.clamp.values()))
    if places.tip_before is not None:
        x, z = places.tip_before
        wanted = np.vstack([wanted, (x, 0.0, z)])
    frame = clamp_frame(np.vstack([np.nanmedian(clamped, axis=0), before]), wanted)
    extent = float(np.ptp(wanted, axis=0).max())
    moved = float(np.nanmax(np.linalg.norm(clamped - np.nanmedian(clamped, axis=0), axis=2)))
    if frame.misfit > MAX_MISFIT * extent:
        raise _fault(
            file,
            f"the markers are {1e3 * frame.misfit:.3g} mm from their places at best, which are "
            f"{1e3 * extent:.3g} mm apart; check names, units and places",
        )
    return frame, (
        f"the frame fits the markers to {1e3 * frame.misfit:.2g} mm; those of the clamp moved by "
        f"up to {1e3 * moved:.2g} mm"
    )


def _first_row(time: np.ndarray, places: MarkerPlaces, file: str) -> int:
    zero = time[0] if places.time_zero is None else places.time_zero
    if not time[0] <= zero < time[-1]:
        raise _fault(
            file, f"time_zero is {zero:g} s; the recording goes from {time[0]:g} to {time[-1]:g} s"
        )
    return int(np.searchsorted(time, zero - 1e-9 * (time[-1] - time[0])))


def _before(tip: np.ndarray, places: MarkerPlaces, file: str) -> np.ndarray:
    """Mean place (1, 3) of the tip in rows (n, 3) before time zero; (0, 3) if it tells nothing."""
    if places.tip_before is None:
        return np.zeros((0, 3))
    known = tip[np.isfinite(tip).all(axis=1)]
    if not len(known):
        raise _fault(
            file, "no row before time_zero shows the tip, so that tip_before says nothing; leave "
            "it out, or choose a later time_zero"
        )  # fmt: skip
    return np.asarray(known.mean(axis=0, keepdims=True))


def _fault(file: str, message: str) -> SpecError:
    return SpecError([Fault(message, file=file)])
