"""A sweep: designs, and what each came to.

Plain data. Nothing here knows how a number was computed; `report` draws it, the command line
prints it, and a script reads it.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from dataclasses import asdict
from typing import TYPE_CHECKING, Any, Literal

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Notice, documents, json_ready
from viscodesign.results.metrics import METRIC_NAMES
from viscodesign.results.notebook_view import NotebookView

if TYPE_CHECKING:
    import pandas as pd

COMPLETE, FAILED, MISSING = "complete", "failed", "missing"
"""Status of a row: it was solved; it cannot be; it was not yet, or the process that did it died."""


SweepStatus = Literal["complete", "incomplete", "interrupted"]
"""Incomplete: rows are missing because a process died."""


@dataclass(frozen=True)
class DesignResult:
    """What one design came to."""

    row: int
    status: str
    effects: frozenset[str]
    """Those that it was solved with."""
    metrics: list[float]
    """In the order of `METRIC_NAMES`; NaN where one is not defined, or the design failed."""
    failure: str = ""

    @classmethod
    def failed(cls, row: int, why: str) -> DesignResult:
        """That of a design that has no solution."""
        return cls(row, FAILED, frozenset(), [math.nan] * len(METRIC_NAMES), why)


@dataclass(frozen=True)
class VerifiedRow:
    """A row that was simulated again, with its error stated."""

    row: int
    estimated_tip_error_m: float | None
    """Stated by the verified run; None where it could not."""
    extremes_apart_m: float | None
    """Largest distance of the tip's extremes from those in the table; None without a run."""
    validity: Literal["inside", "outside", "unknown"]
    """Whether the run stays within what its model describes."""
    reasons: tuple[str, ...]
    """Why it does not, or why there is no run."""


@dataclass(frozen=True)
class SweptColumn:
    """A key that varies."""

    key: str
    unit: str | None
    """SI unit; "1" for a ratio, None for words."""
    values: tuple[Any, ...] | None
    """Those of a list or a grid; None where they were drawn at random."""
    low: float | None = None
    high: float | None = None
    scale: Literal["linear", "log"] = "linear"

    @property
    def name(self) -> str:
        """The column: the key, with its unit as the last word."""
        return f"{self.key}{unit_suffix(self.unit)}"

    @property
    def is_number(self) -> bool:
        """Whether its values are numbers."""
        return self.unit is not None


def unit_suffix(unit: str | None) -> str:
    """A unit as the last word of a column: ``_m2_pa`` for m^2/Pa; a ratio has none."""
    words = re.findall(r"\w+", (unit or "1").replace("^", ""))
    return "".join(f"_{word.lower()}" for word in words if word != "1")


@dataclass(frozen=True)
class Sweep(NotebookView):
    """A table of designs."""

    name: str
    version: str
    spec_sha256: str
    status: SweepStatus
    columns: tuple[SweptColumn, ...]
    designs: tuple[tuple[Any, ...], ...]
    """Rows of values in the order of the columns: numbers in SI, and settings as given."""
    results: dict[int, DesignResult]
    """By row; those that are missing are not there."""
    requested_m: float
    """Tip error that the scene asks for [m]; each row is solved for it, few are verified."""
    sample: int | None
    seed: int | None
    verified: tuple[VerifiedRow, ...] = ()
    """Some rows, simulated again with their error stated."""
    warnings: tuple[Notice, ...] = ()
    wall_s: float = 0.0
    computed: int = 0
    """Rows that this call computed; others were there from before."""
    workers: int = 1

    def __repr__(self) -> str:
        keys = ", ".join(column.key for column in self.columns)
        there = f"{len(self.results)} of {len(self.designs)} designs"
        return f"<Sweep {self.name}: {self.status}, {there} over {keys}>"

    @property
    def models(self) -> list[frozenset[str]]:
        """Sets of effects that rows were solved with, the most frequent first."""
        done = [r.effects for r in self.results.values() if r.status == COMPLETE]
        return [
            effects
            for effects, _ in sorted(Counter(done).items(), key=lambda m: (-m[1], sorted(m[0])))
        ]

    @property
    def failures(self) -> list[DesignResult]:
        """Rows that have no solution."""
        return [r for _, r in sorted(self.results.items()) if r.status == FAILED]

    @property
    def missing(self) -> list[int]:
        """Rows that were not computed."""
        return [row for row in range(len(self.designs)) if row not in self.results]

    @property
    def table_columns(self) -> list[str]:
        """Names of the columns of `sweep.csv`."""
        own = [column.name for column in self.columns]
        return ["row", *own, "status", *METRIC_NAMES, "model", "failure"]

    def rows(self) -> list[list[Any]]:
        """Rows of `sweep.csv`."""
        models = {effects: k + 1 for k, effects in enumerate(self.models)}
        blank = DesignResult(-1, MISSING, frozenset(), [math.nan] * len(METRIC_NAMES))
        found = []
        for row, design in enumerate(self.designs):
            own = self.results.get(row, blank)
            values = [v if isinstance(v, (str, bool, float, int)) else str(v) for v in design]
            model = models[own.effects] if own.status == COMPLETE else ""
            found.append([row, *values, own.status, *own.metrics, model, own.failure])
        return found

    def frame(self) -> pd.DataFrame:
        """The table: the columns of `sweep.csv`."""
        import pandas as pd

        return pd.DataFrame(self.rows(), columns=self.table_columns)

    def words(self, row: int, most: int | None = None) -> str:
        """A design in words, with ``most`` of its keys."""
        pairs = list(zip(self.columns, self.designs[row], strict=True))
        more = len(pairs) - len(pairs[:most])
        named = ", ".join(f"{c.key}={value_words(v, c.unit)}" for c, v in pairs[:most])
        return f"{named} and {more} more" if more else named

    def document(self) -> dict[str, Any]:
        """All but the rows as one document."""
        count = Counter(r.effects for r in self.results.values() if r.status == COMPLETE)
        solved = sum(count.values())
        document = {
            "name": self.name,
            "version": self.version,
            "spec_sha256": self.spec_sha256,
            "status": self.status,
            "keys": [
                {
                    "key": c.key,
                    "unit": c.unit,
                    "column": c.name,
                    **({"low": c.low, "high": c.high} if c.values is None else {}),
                    **({"values": c.values} if c.values is not None else {}),
                    "scale": c.scale,
                }
                for c in self.columns
            ],
            "sample": self.sample,
            "seed": self.seed,
            "rows": len(self.designs),
            "complete": solved,
            "failed": [
                {"row": r.row, "design": self.words(r.row), "failure": r.failure}
                for r in self.failures
            ],
            "missing": self.missing,
            "models": [
                {"model": k + 1, "effects": sorted(effects), "rows": count[effects]}
                for k, effects in enumerate(self.models)
            ],
            "metrics": METRIC_NAMES,
            "accuracy": {
                "requested_m": self.requested_m,
                "method": "each row solved for the requested accuracy with its model's effects; "
                "some rows simulated again, with their error stated",
                "verified": [asdict(own) for own in self.verified],
            },
            "warnings": documents(self.warnings),
            "cost": {"wall_s": self.wall_s, "computed": self.computed, "workers": self.workers},
        }
        return dict(json_ready(document))


def value_words(value: Any, unit: str | None) -> str:
    """A value with its unit."""
    if not isinstance(value, float):
        return str(value)
    return f"{value:.6g} {unit}" if unit not in (None, "1") else f"{value:.6g}"
