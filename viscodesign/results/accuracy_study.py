"""An accuracy study: points of error and time, and what follows from them.

Plain data. Nothing here knows how a number was measured; `report` draws it, the command
line prints it, and a script reads it.
"""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Any, Literal

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.accuracy_points import (
    POINT_COLUMNS,
    Model,
    Point,
    Reference,
)
from viscodesign.results.findings import json_ready
from viscodesign.results.provenance import provenance

if TYPE_CHECKING:
    import pandas as pd

STATED_ERRORS = (1e-2, 1e-3, 1e-4)
"""Tip errors, in actuator lengths, whose cost every study states."""


@dataclass(frozen=True)
class AccuracyStudy:
    """What accuracy costs in solve time, for one scene."""

    name: str
    """Name of the scene."""
    version: str
    """Version of this program."""
    spec_sha256: str
    """Digest of the spec's file as it was read, without overrides."""
    status: Literal["complete", "interrupted"]
    """Whether all was measured that the time allowed."""
    length: float
    """Actuator length [m]."""
    requested_rel: float
    """Requested tip error, in actuator lengths."""
    models: tuple[Model, ...]
    """Sets of effects that were measured."""
    taken: tuple[str, ...]
    """Effects that the spec selects."""
    reference: Reference | None
    """None if the study was interrupted before it was solved."""
    points: tuple[Point, ...]
    """Every setting that was measured, with its error [m] and its time [s]."""
    start: Point | None
    """The initial setting of `simulate`, measured."""
    notes: tuple[str, ...]
    """What was not measured, and why."""
    limit_s: float
    """Wall time that the study was allowed [s]."""
    spent_s: float
    """Wall time that it took [s]."""
    resolved_sha256: str = ""
    """SHA-256 of the resolved spec, with all overrides."""

    @property
    def requested_m(self) -> float:
        """Requested tip error [m]."""
        return self.requested_rel * self.length

    @property
    def errors(self) -> tuple[float, ...]:
        """The errors whose cost is stated, largest first, in actuator lengths."""
        return tuple(sorted({*STATED_ERRORS, self.requested_rel}, reverse=True))

    @property
    def front(self) -> list[Point]:
        """The Pareto front: points that no other beats in both time and error, cheapest first."""
        return sorted((p for p in self.points if not p.dominated), key=lambda p: p.solve_s)

    @property
    def recommended(self) -> Point | None:
        """The cheapest setting with the requested accuracy."""
        return self.cheapest(self.requested_rel)

    @property
    def recommended_changes(self) -> tuple[str, ...]:
        """Changes of the spec that select the recommended effects, as for `--set`."""
        if self.recommended is None:
            return ()
        wanted = set(self.model(self.recommended).effects)
        order = sorted(wanted ^ set(self.taken))
        return tuple(f"effects.{name}={'on' if name in wanted else 'off'}" for name in order)

    def model(self, point: Point) -> Model:
        """The model of a point."""
        return next(model for model in self.models if model.name == point.model)

    def __repr__(self) -> str:
        return (
            f"<AccuracyStudy {self.name}: {self.status}, {len(self.points)} points of "
            f"{len(self.models)} models in {self.spent_s:.3g} s>"
        )

    def words(self, point: Point) -> str:
        """All of a setting in words."""
        return f"{self.model(point).title}; {point.setting}"

    def cheapest(self, error_rel: float) -> Point | None:
        """The fastest point whose error is at most this, in actuator lengths."""
        good = [point for point in self.points if point.tip_error_rel <= error_rel]
        return min(good, key=lambda point: point.solve_s, default=None)

    def most_accurate(self, budget_s: float) -> Point | None:
        """The point with the smallest error whose solve takes at most this time [s]."""
        quick = [point for point in self.points if point.solve_s <= budget_s]
        return min(quick, key=lambda point: (point.tip_error_m, point.solve_s), default=None)

    def frame(self) -> pd.DataFrame:
        """All points: the columns of `accuracy.csv`."""
        import pandas as pd

        rows = [[asdict(point)[name] for name in POINT_COLUMNS] for point in self.points]
        return pd.DataFrame(rows, columns=list(POINT_COLUMNS))

    def document(self, budget_s: float | None = None) -> dict[str, Any]:
        """The study as one document; ``budget`` is there where a time [s] is given."""
        document = {
            "name": self.name,
            "version": self.version,
            "spec_sha256": self.spec_sha256,
            "resolved_sha256": self.resolved_sha256,
            "status": self.status,
            "reference": None if self.reference is None else _reference_document(self.reference),
            "requested": {"tip_error_m": self.requested_m, "tip_error_rel": self.requested_rel},
            "models": [
                {"name": m.name, "also": m.also, "words": m.words, "effects": m.effects}
                for m in self.models
            ],
            "points": [asdict(point) for point in self.points],
            "recommended": self._recommended_document(),
            "simulate_starts_with": _point_document(self.start),
            "table": [
                {
                    "tip_error_rel": error,
                    "tip_error_m": error * self.length,
                    "cheapest": _point_document(self.cheapest(error)),
                }
                for error in self.errors
            ],
            **({} if budget_s is None else {"budget": self._budget_document(budget_s)}),
            "notes": self.notes,
            "limit_s": self.limit_s,
            "spent_s": self.spent_s,
            "provenance": provenance(),
        }
        return dict(json_ready(document))

    def _recommended_document(self) -> dict[str, Any] | None:
        point = self.recommended
        return None if point is None else {**asdict(point), "set": self.recommended_changes}

    def _budget_document(self, budget_s: float) -> dict[str, Any]:
        return {
            "time_s": budget_s,
            "most_accurate": _point_document(self.most_accurate(budget_s)),
            "cheapest": _point_document(min(self.points, key=lambda p: p.solve_s, default=None)),
        }


class AccuracyInterruptedError(KeyboardInterrupt):
    """Ctrl-C ended a study; ``study`` is what was measured, with the status "interrupted"."""

    def __init__(self, study: AccuracyStudy) -> None:
        self.study = study
        super().__init__(f"interrupted with {len(study.points)} points measured")


def _reference_document(found: Reference) -> dict[str, Any]:
    told = asdict(found)
    names = ("effects", "edges", "tolerance", "solver")
    return {"settings": {name: told.pop(name) for name in names}, **told}


def _point_document(point: Point | None) -> dict[str, Any] | None:
    return None if point is None else asdict(point)
