"""The path that the tip is to follow: read from a table, and its points equally spaced."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np
from pydantic_core import PydanticCustomError

from viscodesign.errors import Fault, SpecError
from viscodesign.inverse.target_spec import PathSpec, ReadTarget
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.spec_part import faults_of, invalid_at
from viscodesign.scene.table_file import table_of_file
from viscodesign.scene.tables.columns import WantedColumn
from viscodesign.scene.tables.layout import taken_apart
from viscodesign.units import Length, Time

TIME = WantedColumn("time", get_args(Time)[1], ("t",))
LENGTH = get_args(Length)[1]
CLOSED_SHARE = 0.02
"""A distance between a path's ends below this part of its length closes it."""
MAX_WANTED_ROWS = 50_000
SPACED_POINTS = 96
"""Points of a path whose timing is free."""
MAX_LINE = 480
"""Corners of the line from which found points are measured."""
Timing = Literal["free", "given"]


@dataclass(frozen=True, eq=False)
class WantedPath:
    """A path of the tip in the plane of motion."""

    points: np.ndarray
    """(N, 2): x, z [m]; of a closed one without its first point once more."""
    times: np.ndarray | None
    """(N,) [s], where they count."""
    closed: bool
    timing: Timing
    any_sense: bool = False
    line: np.ndarray | None = None
    """(M, 2) The path as it was given [m], a closed one with its beginning once more; its points
    cut corners. None where times count."""

    @property
    def is_free_loop(self) -> bool:
        """Whether it is a limit cycle passed at any time."""
        return self.closed and self.timing == "free"

    @property
    def coarser(self) -> WantedPath:
        """With every second point, where times do not count."""
        if self.timing == "given" or len(self.points) < SPACED_POINTS:
            return self
        return replace(self, points=self.points[::2])

    @property
    def length(self) -> float:
        """Length of the whole way [m]."""
        return float(np.linalg.norm(np.diff(self.way, axis=0), axis=1).sum())

    @property
    def way(self) -> np.ndarray:
        """(N or N + 1, 2): its points, and the first again where it is closed."""
        return np.concatenate([self.points, self.points[:1]]) if self.closed else self.points

    @property
    def area(self) -> float:
        """Signed area of a loop [m2], positive when it goes counter-clockwise with z upwards."""
        x, z = self.way.T
        return float(np.sum(x[:-1] * z[1:] - x[1:] * z[:-1]) / 2) if self.closed else 0.0


def equally_spaced(way: np.ndarray, count: int, *, closed: bool) -> np.ndarray:
    """(count, 2) Points along a way (M, 2), without its end where it is closed."""
    steps = np.linalg.norm(np.diff(way, axis=0), axis=1)
    along = np.concatenate([[0.0], np.cumsum(steps)])
    wanted = np.linspace(0.0, along[-1], count, endpoint=not closed)
    return np.column_stack([np.interp(wanted, along, axis) for axis in way.T])


def wanted_path(read: ReadTarget) -> WantedPath:
    """The path of a design task. Raises `SpecError` with what is wrong with it."""
    spec = read.spec.target
    try:
        values = _values(spec, read.folder)
        _check(values, "file" if spec.rows is None else "rows")
        return _path(spec, values)
    except PydanticCustomError as error:
        file, line = read.document.place(("target",))
        faults = faults_of(error)
        raise SpecError(
            [Fault(f.message, ".".join(("target", *f.path)), file, line) for f in faults]
        ) from None


def _values(spec: PathSpec, folder: Path) -> np.ndarray:
    """(N, 3): time or NaN, x, z."""
    if (spec.file is None) == (spec.rows is None):
        raise invalid_at("file", "the target needs exactly one of 'file' and 'rows'")
    if spec.file is None:
        return _listed(spec.rows or ())
    columns, has_time = _columns(spec, folder)
    given = {"file": spec.file, "columns": spec.columns, "decimal": spec.decimal}

    def check(first: np.ndarray) -> Iterator[tuple[int, str]]:
        return _time_faults(first) if has_time else iter(())

    found = table_of_file(given, folder, columns, check, most_rows=MAX_WANTED_ROWS).values
    blank = np.full((len(found), 0 if has_time else 1), np.nan)
    return np.concatenate([blank, found], axis=1)


def _columns(spec: PathSpec, folder: Path) -> tuple[list[WantedColumn], bool]:
    """The columns that the file has: with times or without, of a run or of a plain path."""
    named = set(spec.columns or ())
    try:
        text = (folder / str(spec.file)).read_text(encoding="utf-8-sig", errors="replace")
        header = taken_apart(text[:20_000]).header
    except (OSError, ValueError):
        header = ()  # reading the table says why
    cells = [cell.strip().lower() for cell in header]
    prefix = "tip_" if any(cell.startswith("tip_x") for cell in cells) or "tip_x" in named else ""
    has_time = "time" in named or any(cell.split("_")[0] in ("time", "t") for cell in cells)
    wanted = [
        WantedColumn(f"{prefix}x", LENGTH, ("x",)),
        WantedColumn(f"{prefix}z", LENGTH, ("z",)),
    ]
    return ([TIME, *wanted] if has_time else wanted), has_time


def _listed(rows: tuple[tuple[float, ...], ...]) -> np.ndarray:
    widths = {len(row) for row in rows}
    if widths - {2, 3} or len(widths) != 1:
        raise invalid_at("rows", "every row needs x and z, or time, x and z, in m and s")
    found = np.array(rows, dtype=float)
    if not np.all(np.isfinite(found)):
        raise invalid_at("rows", "a number is not finite")
    if found.shape[1] == 2:
        return np.concatenate([np.full((len(found), 1), np.nan), found], axis=1)
    if fault := next(_time_faults(found[:, 0]), None):
        raise invalid_at("rows", f"row {fault[0] + 1}: {fault[1]}")
    return found


def _time_faults(times: np.ndarray) -> Iterator[tuple[int, str]]:
    if len(times) and times[0] < 0:
        yield 0, f"time is {times[0]:g} s, before the start at 0 s"
    for k in np.flatnonzero(times[1:] <= times[:-1]) + 1:
        yield int(k), f"times must increase; got {times[k]:g} s after {times[k - 1]:g} s"


def _check(values: np.ndarray, key: str) -> None:
    if len(values) < 2 or not np.ptp(values[:, 1:], axis=0).max(initial=0.0) > 0.0:
        raise invalid_at(
            key,
            "the target is one point; give a path of at least two, or use 'viscodesign reach "
            '--at "X, Z"\' for a point',
        )


def _path(spec: PathSpec, values: np.ndarray) -> WantedPath:
    points, times = values[:, 1:], values[:, 0]
    has_times = bool(np.all(np.isfinite(times)))
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    gap = float(np.linalg.norm(points[-1] - points[0]))
    ends_meet = len(points) > 3 and gap <= CLOSED_SHARE * steps.sum()
    # A pulse brings the tip back, too: with times that count, a path is a loop only by request.
    is_loop = ends_meet and (not has_times or spec.timing == "free")
    closed = is_loop if spec.closed is None else spec.closed
    if closed and len(points) < 3:
        raise invalid_at("closed", "a loop needs at least three points")
    timing: Timing = spec.timing or ("given" if has_times and not closed else "free")
    if timing == "given" and not has_times:
        raise invalid_at("timing", "given needs a column of times, such as time_s; or use free")
    if timing == "given":
        return WantedPath(points, times, closed, timing)
    if closed and gap <= 1e-9 * steps.sum():
        points = points[:-1]
    way = np.concatenate([points, points[:1]]) if closed else points
    spaced = equally_spaced(way, SPACED_POINTS, closed=closed)
    line = way if len(way) <= MAX_LINE else equally_spaced(way, MAX_LINE, closed=False)
    return WantedPath(spaced, None, closed, timing, spec.sense == "any", line)


def rms(distances: Any) -> float:
    """Root mean square of distances (N,)."""
    return float(np.sqrt(np.mean(np.square(distances))))
