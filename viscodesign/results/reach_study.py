"""Where a tip can be, and the input that brings it to a point.

Plain data. `report` draws it, the command line prints it, and a script reads it.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Notice, json_ready, validity_document
from viscodesign.results.notebook_view import NotebookView
from viscodesign.results.provenance import provenance


@dataclass(frozen=True, eq=False)
class ReachedPoint:
    """The input that brings the tip nearest to a point."""

    at: tuple[float, float]
    """x, z of the point [m]."""
    time_s: float
    """When the tip is to be there [s]."""
    tip: tuple[float, float]
    """Where the verified run brings it [m]; NaN without one."""
    miss_m: float
    """Distance of the two [m]."""
    stated_error_m: float | None
    """Tip error that the run states [m]."""
    tolerance_m: float
    """Distance that counts as reached [m]."""
    path: np.ndarray
    """(T, 2) of the tip [m]; empty where nothing was verified."""
    times: np.ndarray
    """(K,) of the input's rows [s]."""
    pressures: np.ndarray
    """(K,) above the baseline [Pa]."""
    spec_text: str
    """The spec with that input, runnable."""
    evaluations: int
    """Solutions of the search."""
    violations: tuple[Notice, ...] = ()
    """Where the verified run leaves what its model describes."""
    is_cut: bool = False
    """Whether time ended the search."""

    @property
    def is_verified(self) -> bool:
        """Whether a run has brought the tip there; else the search was interrupted."""
        return len(self.path) > 0

    @property
    def is_reached(self) -> bool:
        """Whether the tip comes there."""
        return self.miss_m <= self.tolerance_m

    @property
    def out_of_reach_m(self) -> float:
        """By how much the point is out of reach [m]; 0 where it is reached."""
        return 0.0 if self.is_reached else self.miss_m


@dataclass(frozen=True, eq=False)
class ReachStudy(NotebookView):
    """The set of points that a tip can visit, by its edge."""

    name: str
    """Name of the scene."""
    limits: tuple[float, float]
    """Limits of the inlet's pressure above the baseline [Pa]."""
    harmonics: int | None
    """Number of harmonics of periodic inputs; None for any input within the limits."""
    edge: np.ndarray
    """(N, 2) of the set with the spec's inlet, in order [m]; empty where none was asked for."""
    edge_two_inlets: np.ndarray
    """(M, 2) with one inlet a column and the same limits [m]."""
    edge_error_m: float | None
    """Largest distance of verified points of the edge from where `simulate` brings the tip [m]."""
    point: ReachedPoint | None
    """Where a point was asked for."""
    wall_s: float
    """[s]"""
    edge_failures: tuple[str, ...] = ()
    """Why points of the edge could not be verified: the set may not reach so far there."""
    interrupted: bool = False
    """Whether Ctrl-C ended it: what there is was not verified, or not all of it."""

    def __repr__(self) -> str:
        return f"<ReachStudy {self.name}: {1e4 * self.area_m2:.3g} cm2>"

    @property
    def area_m2(self) -> float:
        """Area of the set [m2]; NaN without an edge."""
        return polygon_area(self.edge)

    @property
    def area_two_inlets_m2(self) -> float:
        """Area of the set with one inlet a column [m2]."""
        return polygon_area(self.edge_two_inlets)

    def document(self) -> dict[str, Any]:
        """As in `reach.json`."""
        own = self.point
        place = None if own is None else {
            "at_m": own.at,
            "time_s": own.time_s,
            "tip_m": own.tip,
            "miss_m": own.miss_m,
            "out_of_reach_m": own.out_of_reach_m,
            "stated_error_m": own.stated_error_m,
            "tolerance_m": own.tolerance_m,
            "validity": validity_document(own.violations) if own.is_verified else None,
            "evaluations": own.evaluations,
        }  # fmt: skip
        found: dict[str, Any] = json_ready({
            "name": self.name,
            "limits_pa": self.limits,
            "harmonics": self.harmonics,
            "area_m2": self.area_m2,
            "area_two_inlets_m2": self.area_two_inlets_m2,
            "edge_error_m": self.edge_error_m,
            "edge_failures": self.edge_failures,
            "interrupted": self.interrupted,
            **(place or {}),
            "wall_s": self.wall_s,
            "provenance": provenance(),
        })  # fmt: skip
        return found


def polygon_area(points: np.ndarray) -> float:
    """Area within a closed polygon (N, 2); NaN without one."""
    if len(points) < 3:
        return float("nan")
    x, z = points.T
    return abs(float(np.sum(x * np.roll(z, -1) - np.roll(x, -1) * z)) / 2)
