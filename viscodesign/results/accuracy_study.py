"""An accuracy study: points of error and time, and what follows from them.

Plain data. Nothing here knows how a number was measured; `report` draws it, the command
line prints it, and a script reads it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, replace
from typing import TYPE_CHECKING, Any, Literal

from viscodesign.results.findings import json_ready

if TYPE_CHECKING:
    import pandas as pd

STATED_ERRORS = (1e-2, 1e-3, 1e-4)
"""Tip errors, in actuator lengths, whose cost every study states."""
POINT_COLUMNS = (
    "model", "edges", "tolerance", "solver", "solve_s", "build_s", "tip_error_m",
    "tip_error_rel", "dominated",
)  # fmt: skip
"""Of `accuracy.csv`; `edges` are those of one section."""


@dataclass(frozen=True)
class Model:
    """A set of effects under a name."""

    name: str
    """`auto`: the effects that the spec selects; `everything`: all that it allows;
    I to IV: the form of a quadrant, on top of `auto`."""
    effects: tuple[str, ...]
    also: tuple[str, ...] = ()
    """Other names of the same set of effects."""
    is_distributed: bool = False
    """Whether pressures differ along the network."""
    is_inertial: bool = False
    """Whether the rod resists acceleration."""

    @property
    def words(self) -> str:
        """The kind of model in words."""
        pressure = "distributed" if self.is_distributed else "uniform"
        return f"{pressure}, {'inertial' if self.is_inertial else 'quasi-static'}"

    @property
    def title(self) -> str:
        """Name and kind."""
        return f"{self.name} ({self.words})"


@dataclass(frozen=True)
class Point:
    """One setting, what it costs, and how wrong its tip is."""

    model: str
    edges: int
    """Per section."""
    tolerance: float
    solver: str
    solve_s: float
    """Wall time of solving, the shortest of several where it is short [s]."""
    build_s: float
    """Wall time of building the equations and the integrator for the first time [s]."""
    tip_error_m: float
    """Largest distance from the reference's tip over the output times [m]."""
    tip_error_rel: float
    """The same in actuator lengths."""
    is_bound: bool = False
    """Whether the error is an upper bound: the reference is not accurate enough to say more."""
    is_exact_in_space: bool = False
    """Whether the rod is a chain of exact arcs, which has no mesh."""
    is_stepless: bool = False
    """Whether every output time is solved independently, without solver and tolerance."""
    steps: int = 0
    """Time steps, independent of the speed of the machine."""
    dominated: bool = False
    """Whether another point is both cheaper and more accurate."""

    @property
    def setting(self) -> str:
        """Solver, edges and tolerance in words."""
        edges = f"{self.edges} edge{'s' * (self.edges != 1)} per section"
        mesh = "exact arcs" if self.is_exact_in_space else edges
        if self.is_stepless:
            return f"no time steps, {mesh}"
        return f"{self.solver}, {mesh}, tolerance {tolerance_words(self.tolerance)}"


@dataclass(frozen=True)
class Reference:
    """The solution that errors are measured against."""

    effects: tuple[str, ...]
    edges: int
    """Per section."""
    tolerance: float
    solver: str
    solve_s: float
    convergence_m: float
    """Largest distance of its tip from that of the next coarser solution [m]."""
    convergence_rel: float
    """The same in actuator lengths."""
    smallest_error_m: float
    """Smallest error that it resolves [m]; smaller ones are stated as bounds."""
    is_converged: bool
    """Whether that is well below the smallest error whose cost the study states."""


@dataclass(frozen=True)
class AccuracyStudy:
    """What accuracy costs in solve time, for one scene."""

    name: str
    version: str
    spec_sha256: str
    status: Literal["complete", "interrupted"]
    length: float
    """Actuator length [m]."""
    requested_rel: float
    """Requested tip error, in actuator lengths."""
    models: tuple[Model, ...]
    taken: tuple[str, ...]
    """Effects that the spec selects."""
    reference: Reference | None
    """None if the study was interrupted before it was solved."""
    points: tuple[Point, ...]
    start: Point | None
    """The initial setting of `simulate`, measured."""
    notes: tuple[str, ...]
    """What was not measured, and why."""
    limit_s: float
    spent_s: float

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


def _reference_document(found: Reference) -> dict[str, Any]:
    told = asdict(found)
    names = ("effects", "edges", "tolerance", "solver")
    return {"settings": {name: told.pop(name) for name in names}, **told}


def _point_document(point: Point | None) -> dict[str, Any] | None:
    return None if point is None else asdict(point)


def with_dominated(points: Iterable[Point]) -> tuple[Point, ...]:
    """The points, marked where another one is faster and no less accurate.

    Of two with the same time the more accurate one wins, of two with the same error the
    faster one; of two equal ones the first.
    """
    given = list(points)
    order = sorted(range(len(given)), key=lambda k: (given[k].solve_s, given[k].tip_error_m, k))
    best, beaten = float("inf"), set[int]()
    for k in order:
        if given[k].tip_error_m >= best:
            beaten.add(k)
        best = min(best, given[k].tip_error_m)
    return tuple(replace(point, dominated=k in beaten) for k, point in enumerate(given))


def tolerance_words(tolerance: float) -> str:
    """A tolerance in short form: 1e-3, 1.25e-4."""
    digits, _, exponent = f"{tolerance:.2e}".partition("e")
    return f"{float(digits):g}e{int(exponent)}"


def spread(front: Sequence[Point], most: int) -> list[Point]:
    """At most ``most`` points of a front, evenly spaced in its order, with both ends."""
    if len(front) <= most:
        return list(front)
    last = len(front) - 1
    return [front[round(k * last / (most - 1))] for k in range(most)]
