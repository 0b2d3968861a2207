"""Points of an accuracy study: what each setting costs, and how far its tip is off."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from viscodesign.lazy_dataclass import dataclass

POINT_COLUMNS = (
    "model", "edges", "tolerance", "solver", "solve_s", "build_s", "tip_error_m",
    "tip_error_rel", "dominated",
)  # fmt: skip
"""Columns of `accuracy.csv`; `edges` are those of one section."""


@dataclass(frozen=True)
class Model:
    """A set of effects under a name."""

    name: str
    """`auto`: the effects that the spec selects; `everything`: all that it allows;
    I to IV: the form of a quadrant, on top of `auto`."""
    effects: tuple[str, ...]
    """Names of the effects it includes."""
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
    """Name of its model."""
    edges: int
    """Per section."""
    tolerance: float
    """Relative tolerance of the time steps."""
    solver: str
    """Name of the integrator."""
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
    """Names of the effects it includes."""
    edges: int
    """Per section."""
    tolerance: float
    """Relative tolerance of the time steps."""
    solver: str
    """Name of the integrator."""
    solve_s: float
    """Wall time [s]."""
    convergence_m: float
    """Largest distance of its tip from that of the next coarser solution [m]."""
    convergence_rel: float
    """The same in actuator lengths."""
    smallest_error_m: float
    """Smallest error that it resolves [m]; smaller ones are stated as bounds."""
    is_converged: bool
    """Whether that is well below the smallest error whose cost the study states."""


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
