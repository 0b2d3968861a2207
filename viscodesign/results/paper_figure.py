"""A figure of the paper made again: its panels, and where the model agrees with its words."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field
from typing import Any

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import (
    Classification,
    classification_document,
    json_ready,
    violation_codes,
)
from viscodesign.results.trajectory import Trajectory

CHECK_COLUMNS = ("figure", "panel", "section", "verdict", "words", "found")


@dataclass(frozen=True)
class PaperCheck:
    """A statement of the paper, and what the model gives."""

    figure: int
    panel: str
    section: str
    """Where the paper says it."""
    words: str
    """The paper's own, or nearly."""
    agrees: bool | None
    """None where a run is not complete, or errors hide it, or too little is found of it."""
    found: str
    """Numbers of this run of the model, in words."""
    outside: tuple[str, ...] = ()
    """Its runs that leave what their model describes."""

    @property
    def verdict(self) -> str:
        """Its outcome in words."""
        return {True: "agrees", False: "DIFFERS", None: "undecided"}[self.agrees]

    def row(self) -> tuple[Any, ...]:
        """Under `CHECK_COLUMNS`."""
        return self.figure, self.panel, self.section, self.verdict, self.words, self.found


@dataclass(frozen=True, eq=False)
class FigurePanel:
    """One panel: runs whose motions it shows."""

    name: str
    """Its letter."""
    title: str
    assumed: str
    """What of it the paper does not print, and was chosen here."""
    runs: tuple[Trajectory, ...]


@dataclass(frozen=True, eq=False)
class PaperFigure:
    """A figure: panels of motions, or a plane of timescales."""

    number: int
    title: str
    panels: tuple[FigurePanel, ...]
    checks: tuple[PaperCheck, ...]
    version: str
    classifications: tuple[Classification, ...] = ()
    """Classifications that Figure 1 shows."""
    beside: Mapping[str, str] = field(default_factory=dict)
    """What the literature has in each of its quadrants."""
    changes: tuple[str, ...] = ()
    """Keys that were set to other values than the bundled specs have."""

    @property
    def outside(self) -> list[str]:
        """Runs that leave what their model describes, with the reasons."""
        runs = {run.name: run for panel in self.panels for run in panel.runs}
        return [
            f"{name} ({', '.join(violation_codes(run.violations))})"
            for name, run in runs.items()
            if run.violations
        ]

    @property
    def count(self) -> tuple[int, int]:
        """Statements that agree, and statements that could be checked."""
        known = [bool(check.agrees) for check in self.checks if check.agrees is not None]
        return sum(known), len(known)

    @property
    def agreement(self) -> str:
        """How many statements agree, and how many of these by runs outside of their model."""
        agree, known = self.count
        outside = sum(bool(check.agrees and check.outside) for check in self.checks)
        open_ones = sum(check.agrees is None for check in self.checks)
        parts = [f"{agree} of {known} statements agree"]
        if outside:
            parts.append(f"{outside} of these by runs outside of their model")
        if open_ones:
            parts.append(f"{open_ones} undecided")
        return ", ".join(parts)

    def of_panel(self, name: str) -> Iterator[PaperCheck]:
        """Statements about a panel."""
        return (check for check in self.checks if check.panel == name)

    def rows(self) -> list[tuple[Any, ...]]:
        """Its table: one row a statement."""
        return [check.row() for check in self.checks]

    def document(self) -> dict[str, Any]:
        """The figure without its curves."""
        document = {
            "figure": self.number,
            "title": self.title,
            "version": self.version,
            "changes": list(self.changes),
            "agree": self.count[0],
            "checked": self.count[1],
            "outside_of_the_model": self.outside,
            "statements": [dict(zip(CHECK_COLUMNS, row, strict=True)) for row in self.rows()],
            "panels": [
                {
                    "panel": panel.name,
                    "title": panel.title,
                    "assumed": panel.assumed or None,
                    "motions": [
                        {
                            "label": run.name,
                            "status": run.status,
                            "stated_error_m": run.accuracy.estimated_tip_error_m,
                            "validity": run.validity,
                            "metrics": dict(run.metrics),
                        }
                        for run in panel.runs
                    ],
                }
                for panel in self.panels
            ],
            "literature": dict(self.beside),
            "specs": [classification_document(c) for c in self.classifications],
        }
        return dict(json_ready(document))
