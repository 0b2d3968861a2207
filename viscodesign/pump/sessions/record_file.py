"""A pump's record: a table with the simulator's columns, whole rows whatever happens."""

from __future__ import annotations

import contextlib
import json
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from io import FileIO
from pathlib import Path
from typing import Any

from viscodesign._version import __version__
from viscodesign.pump.play.servo_state import Sample, ServoState
from viscodesign.storage.atomic_files import write_bytes, write_errors_as_usage

FLUSH = 1.0
"""Rows are on the disk this long after they were read, at the latest [s]."""
RUNNING = "running"


class Record:
    """The CSV that grows with each sample, and the JSON beside it that says what it is.

    The JSON says "running" from the first moment on, so that a record whose writer was killed
    is not taken for a complete one.
    """

    def __init__(
        self,
        path: Path,
        table: FileIO,
        inlets: Sequence[str],
        facts: Mapping[str, Any],
        more: Mapping[str, Callable[[], float]],
    ) -> None:
        self.path = path
        self.rows = 0
        self._table = table
        self._whole = 0
        """Bytes of whole rows in the file."""
        self._waiting = bytearray()
        self._more = more
        self._columns = columns(inlets, list(more))
        self._facts = dict(facts)
        self._flushed = time.monotonic()
        self._line(self._columns)

    @property
    def beside(self) -> Path:
        """The JSON's path."""
        return self.path.with_suffix(".json")

    def add(self, moment: float, sample: Sample) -> None:
        """One row; ``moment`` is the time of its first column [s]."""
        first, *others = values(moment, sample)
        row = [first, *(value() for value in self._more.values()), *others]
        self._line([_number(value) for value in row])
        self.rows += 1
        if time.monotonic() - self._flushed >= FLUSH:
            self.flush()

    def state(self, status: str, **more: Any) -> None:
        """Write the JSON anew: whether the table is complete, and what is known of the run."""
        self.flush()
        document = {
            "record": self.path.name,
            "version": __version__,
            "status": status,
            "partial": status != "complete",
            "rows": self.rows,
            "columns": self._columns,
            **self._facts,
            **more,
        }
        write_bytes(self.beside, (json.dumps(document, indent=2) + "\n").encode())

    def _line(self, cells: Sequence[str]) -> None:
        self._waiting += (",".join(cells) + "\n").encode()

    def flush(self) -> None:
        """All waiting rows, or none: a full disk leaves no half a row behind."""
        self._flushed = time.monotonic()
        left = bytes(self._waiting)
        with write_errors_as_usage(self.path):
            try:
                while left:
                    left = left[self._table.write(left) :]
            except OSError:
                with contextlib.suppress(OSError):
                    self._table.truncate(self._whole)
                    self._table.seek(self._whole)
                raise
        self._whole += len(self._waiting)
        self._waiting.clear()


@contextlib.contextmanager
def recorded(
    path: Path,
    inlets: Sequence[str],
    facts: Mapping[str, Any],
    more: Mapping[str, Callable[[], float]] | None = None,
) -> Iterator[Record]:
    """A record in progress; replaces an earlier one of the same name.

    ``facts`` go into the JSON: board, whether simulated, spec, plan. ``more`` are columns
    behind the time, each with what gives its value.
    """
    with write_errors_as_usage(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        table = FileIO(path, "w")
    with contextlib.closing(table):
        record = Record(path, table, inlets, facts, more or {})
        record.state(RUNNING)
        try:
            yield record
        finally:
            record.flush()


def columns(inlets: Sequence[str], more: Sequence[str] = ()) -> list[str]:
    """Names of the columns; time and pressures as in `trajectory.csv`."""
    names = ["time_s", *more]
    names += [_named("inlet_pressure", inlets, inlet, "pa") for inlet in inlets]
    names += [_named("wanted_pressure", inlets, inlet, "pa") for inlet in inlets]
    for inlet in inlets:
        names += [
            _named("position", inlets, inlet, "counts"),
            _named("goal", inlets, inlet, "counts"),
            _named("load", inlets, inlet, "rel"),
            _named("voltage", inlets, inlet, "v"),
            _named("temperature", inlets, inlet, "degc"),
        ]
    return names


def _named(quantity: str, inlets: Sequence[str], inlet: str, unit: str) -> str:
    """As `trajectory.csv` has it: only several inlets need their names."""
    return f"{quantity}_{unit}" if len(inlets) == 1 else f"{quantity}_{inlet}_{unit}"


def values(moment: float, sample: Sample) -> list[float | None]:
    """One row; pressures are gauge, None where nothing is known."""
    row: list[float | None] = [moment, *sample.pressure, *sample.wanted]
    for servo, state in sample.servos.items():
        row += [*_of_servo(state, sample.goals.get(servo, state.goal))]
    return row


def _of_servo(state: ServoState, goal: int) -> tuple[float, ...]:
    return (state.position, goal, state.load, state.voltage, state.temperature)


def _number(value: float | None) -> str:
    """As few digits as give the number again; empty where there is none."""
    if value is None:
        return ""
    return repr(round(float(value), 6)) if isinstance(value, float) else str(value)
