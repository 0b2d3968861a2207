"""Reports on a pump before it moves and after it has come to rest, as text and as data."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from viscodesign.errors import InterruptedRunError, PumpError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.play.axis import FoundAxis
from viscodesign.pump.play.stream_result import StreamResult

STATUS_WORDS = {"complete": "played to its end", "interrupted": "interrupted", "stopped": "STOPPED"}


def aligned(rows: Sequence[Sequence[str]]) -> list[str]:
    """Rows as indented lines with aligned columns."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = (zip(row, widths, strict=True) for row in rows)
    return ["  " + "  ".join(f"{cell:<{w}}" for cell, w in line).rstrip() for line in lines]


def axis_rows(axes: Sequence[FoundAxis]) -> list[tuple[str, ...]]:
    """Axes as a table, its heading first."""
    return [tuple(axes[0].cells), *(tuple(axis.cells.values()) for axis in axes)]


def found_lines(identity: str, axes: Sequence[FoundAxis]) -> list[str]:
    """What answered, and how it is."""
    return [f"found {identity}", *aligned(axis_rows(axes))]


def result_lines(result: StreamResult) -> list[str]:
    """How it ended, and how each axis was left."""
    first = STATUS_WORDS[result.status]
    if result.status != "complete":
        first += f": {result.reason}"
    lines = [first, *(f"  {state}" for state in result.standing)]
    if result.retreat:
        lines.append(f"  not fully retracted: {result.retreat}")
    if not result.verified:
        lines.append("  NOT VERIFIED: look at the pump, and switch its power off if in doubt")
    return lines


@dataclass(frozen=True)
class PlaybackReport:
    """How a stream or an upload ended."""

    name: str
    """Name of the scene."""
    result: StreamResult | None
    """How the pump was left; None where poses were loaded and not played."""
    facts: Mapping[str, Any]
    """What else is known, under names with units."""
    noun: str
    """What an axis of this pump is called."""
    kept: str = ""
    """Where the record is, in words."""

    @property
    def status(self) -> str:
        """`complete`, `interrupted` or `stopped`; `loaded` where nothing was played."""
        return "loaded" if self.result is None else self.result.status

    @property
    def lines(self) -> list[str]:
        """How it ended, for people."""
        return [] if self.result is None else result_lines(self.result)

    def document(self) -> dict[str, Any]:
        """All of it for a program."""
        document = {"name": self.name, **self.facts, "status": self.status}
        if (result := self.result) is None:
            return document
        axes = {f"{self.noun}s": [one.document() for one in result.standing]}
        return {**document, **result.outcome(), **axes, "retreat": result.retreat}

    def raise_failure(self) -> None:
        """Raise what did not end well as an error."""
        if self.result is None:
            return
        kept = f"; {self.kept}" if self.kept else ""
        if not self.result.verified or self.status == "stopped":
            raise PumpError(f"stopped ({self.result.rule or 'hold not verified'}){kept}")
        if self.status == "interrupted":
            raise InterruptedRunError(f"interrupted{kept}")
