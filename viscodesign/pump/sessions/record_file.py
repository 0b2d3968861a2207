"""A pump's record: a table with the simulator's columns, only whole rows whatever happens."""

from __future__ import annotations

import contextlib
import json
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field
from io import FileIO
from pathlib import Path
from typing import Any

import numpy as np

from viscodesign._version import __version__
from viscodesign.errors import OutputError, UsageError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.kinds.base import Channels
from viscodesign.pump.play.axis import Sample
from viscodesign.pump.play.stream_result import RecordingError
from viscodesign.storage.atomic_files import write_bytes, write_errors_as_usage

FLUSH_INTERVAL_S = 1.0
"""Rows reach the disk this long after they were read, at the latest."""


def columns(inlets: Sequence[str], channels: Channels, more: Sequence[str] = ()) -> list[str]:
    """Names of the columns; time and pressures as in `trajectory.csv`."""

    def named(quantity: str, inlet: str, unit: str) -> str:
        # Only several inlets need their names.
        return f"{quantity}_{unit}" if len(inlets) == 1 else f"{quantity}_{inlet}_{unit}"

    pressures = ("inlet_pressure", "wanted_pressure")
    return [
        "time_s",
        *more,
        *(named(pressure, inlet, "pa") for pressure in pressures for inlet in inlets),
        *(named(what, inlet, unit) for inlet in inlets for what, unit in channels),
    ]


@dataclass
class Record:
    """A CSV that grows with each sample, and beside it a JSON document that describes it.

    The document says "running" from the start, so that a record whose writer was killed is not
    taken for a complete one.
    """

    path: Path
    table: FileIO
    inlets: Sequence[str]
    facts: Mapping[str, Any]
    """What else the document says: board, whether simulated, spec, plan."""
    channels: Channels
    """Columns of each axis."""
    more: Mapping[str, Callable[[], float]]
    """Columns behind the time, each with what gives its value."""
    rows: int = field(default=0, init=False)
    started: bool = field(default=False, init=False)
    """Whether something may be moving: a full disk is then not a usage error."""
    broken: bool = field(default=False, init=False)
    """Whether the disk has refused a row; no more are written then."""

    def __post_init__(self) -> None:
        self.columns = columns(self.inlets, self.channels, list(self.more))
        self.beside = self.path.with_suffix(".json")
        """The document."""
        self._whole = 0
        """Bytes of whole rows in the file."""
        self._waiting = (",".join(self.columns) + "\n").encode()
        self._flushed = time.monotonic()
        self._errors: list[float] = []

    def add(self, moment: float, sample: Sample) -> None:
        """One row; ``moment`` is the time of its first column [s]."""
        row: list[float | None] = [moment, *(value() for value in self.more.values())]
        row += [*sample.pressure, *sample.wanted]
        for axis, state in sample.axes.items():
            goal = sample.goals.get(axis, state.goal)
            row += [value(state, goal) for value in self.channels.values()]
        self._waiting += (",".join(map(_number, row)) + "\n").encode()
        self.rows += 1
        pairs = zip(sample.pressure, sample.wanted, strict=True)
        self._errors += [p - w for p, w in pairs if p is not None and w is not None]
        if time.monotonic() - self._flushed >= FLUSH_INTERVAL_S:
            self.flush()

    def tracking_error(self) -> dict[str, Any]:
        """Measured minus planned pressures, under names with units; empty without any."""
        if not self._errors:
            return {}
        size = np.abs(self._errors)
        rms = float(np.sqrt(np.mean(size**2)))
        return {"largest_pa": float(size.max()), "rms_pa": rms, "samples": len(size)}

    def state(self, status: str, **more: Any) -> None:
        """Write the document again: whether the table is complete, and what is known of it."""
        self.flush()
        document = {
            "record": self.path.name,
            "version": __version__,
            "status": status,
            "partial": status != "complete",
            "rows": self.rows,
            "columns": self.columns,
            **self.facts,
            **more,
        }
        with self._write_errors():
            write_bytes(self.beside, (json.dumps(document, indent=2) + "\n").encode())

    def flush(self) -> None:
        """All waiting rows, or none: a full disk leaves no half a row behind."""
        self._flushed = time.monotonic()
        left = rows = b"" if self.broken else self._waiting
        with self._write_errors():
            try:
                while left:
                    left = left[self.table.write(left) :]
            except OSError:
                with contextlib.suppress(OSError):
                    self.table.truncate(self._whole)
                    self.table.seek(self._whole)
                raise
        self._whole += len(rows)
        self._waiting = b""

    @contextlib.contextmanager
    def _write_errors(self) -> Iterator[None]:
        try:
            with write_errors_as_usage(self.path):
                yield
        except (OutputError, UsageError) as error:
            if not self.started:
                raise
            if self.broken:
                return  # as reported already
            self.broken = True
            raise RecordingError(f"{error} The record ends here") from error


@contextlib.contextmanager
def recorded(
    path: Path,
    inlets: Sequence[str],
    facts: Mapping[str, Any],
    channels: Channels,
    more: Mapping[str, Callable[[], float]] | None = None,
) -> Iterator[Record]:
    """A record in progress; replaces an earlier one of the same name. Arguments as for `Record`."""
    with write_errors_as_usage(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        table = FileIO(path, "w")
    with contextlib.closing(table):
        record = Record(path, table, inlets, facts, channels, more or {})
        record.state("running")
        record.started = True
        try:
            yield record
        finally:
            record.flush()


def _number(value: float | None) -> str:
    """As few digits as reproduce the number; empty where there is none."""
    if value is None:
        return ""
    return repr(round(float(value), 6)) if isinstance(value, float) else str(value)
