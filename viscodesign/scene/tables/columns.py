"""Columns of a table: those that it must have, and where each stands in a file."""

from __future__ import annotations

from viscodesign.lazy_dataclass import dataclass
from viscodesign.units import QuantityKind


@dataclass(frozen=True)
class WantedColumn:
    """A column that a table must have."""

    name: str
    kind: QuantityKind
    words: tuple[str, ...] = ()
    """Other names that it has in headers, in lower case."""

    @property
    def names(self) -> tuple[str, ...]:
        """All names that it may have in headers, in lower case."""
        return (self.name, *self.words)

    @property
    def header(self) -> str:
        """The header that is never ambiguous: name and SI unit."""
        return f"{self.name}_{self.unit_word}"

    @property
    def unit_word(self) -> str:
        """The SI unit as the last word of a header."""
        return self.kind.unit.lower().replace("^", "")

    def is_of_run(self, header: str) -> bool:
        """Whether a header is that of `trajectory.csv` or `record.csv`, which hold the baseline."""
        is_pressure = header.startswith("inlet_pressure_") and header.endswith("_pa")
        return self.name == "pressure" and is_pressure


@dataclass(frozen=True)
class ChosenColumn:
    """Where a wanted column stands in a file, and what its numbers are."""

    place: int
    header: str
    factor: float
    reference: str = ""
    """Reference of a pressure: ``gauge``, ``abs`` or not said."""
    has_baseline: bool = False
    """Whether the scene's baseline is part of the numbers, as in the tables that a run writes."""


@dataclass(frozen=True)
class Header:
    """The header of a file, as its messages call it; without cells where there is none."""

    shown: str
    cells: tuple[str, ...]
    count: int
    """Columns of the file."""
