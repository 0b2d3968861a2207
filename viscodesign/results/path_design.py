"""What a design came to: numbers, distances from the wanted path, and why it is no better.

Plain data. `report` draws it, the command line prints it, and a script reads it.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Notice, json_ready, validity_document
from viscodesign.results.notebook_view import NotebookView
from viscodesign.results.provenance import provenance

DesignStatus = Literal["met", "not_met", "refused"]


@dataclass(frozen=True, eq=False)
class DesignAlternative:
    """Another design, which is better in something than every other."""

    rms_m: float
    """Root mean square distance of its search [m]."""
    fluid_volume_m3: float
    """In its tubes [m3]."""
    pressure_swing_pa: float
    """Highest less lowest inlet pressure [Pa]."""
    sensitivity_m: float
    """Root mean square shift of the tip by one percent of each free number [m]."""
    parameters: Mapping[str, float]
    """Values of the free numbers by key [SI]."""
    spec_text: str
    """The spec, runnable."""

    @property
    def measures(self) -> tuple[float, float, float, float]:
        """What it is judged by; less is better."""
        return self.rms_m, self.fluid_volume_m3, self.pressure_swing_pa, self.sensitivity_m

    def document(self) -> dict[str, Any]:
        """For `result.json`."""
        return {
            "rms_m": self.rms_m,
            "fluid_volume_m3": self.fluid_volume_m3,
            "pressure_swing_pa": self.pressure_swing_pa,
            "sensitivity_m": self.sensitivity_m,
            "parameters": dict(self.parameters),
        }


@dataclass(frozen=True)
class HistoryRow:
    """The best of a search after so many evaluations."""

    evaluation: int
    wall_s: float
    rms_m: float
    graph: str
    """Tubes in short, where several graphs are tried."""


@dataclass(frozen=True, eq=False)
class PathDesign(NotebookView):
    """The design that a search found for a wanted path of the tip."""

    name: str
    """Name of the spec where the search started."""
    status: DesignStatus
    """Met: confirmed by a simulation within the tolerance."""
    reason: str
    """What limits it, or why it is refused; empty where it is met."""
    tolerance_m: float
    """Root mean square distance that counts as met [m]."""
    wanted: np.ndarray
    """(N, 2) wanted points x, z [m]."""
    found: np.ndarray
    """(T, 2) the confirmed path of the tip [m]; empty without one."""
    band: np.ndarray
    """(T, 2) standard deviation of x and z by one percent of each free number [m]; or empty."""
    closed: bool
    """Whether the wanted path is a loop."""
    rms_m: float | None
    """Root mean square distance that the search left [m]."""
    worst_m: float | None
    """Largest distance of the search [m]."""
    confirmed_rms_m: float | None
    """By `simulate` with the effects that the found design calls for [m]; None without it."""
    confirmed_worst_m: float | None
    """Largest distance of that run [m]."""
    excess_m: float | None
    """Largest distance of a found point from the wanted line, of the run or else of the search [m];
    None where times decide."""
    stated_error_m: float | None
    """Tip error that the run states [m]."""
    parameters: Mapping[str, float]
    """Values of the free numbers by key [SI]."""
    units: Mapping[str, str]
    """Their SI units; "1" of a ratio."""
    graph: tuple[str, ...]
    """Tubes by their ends."""
    at_bounds: tuple[str, ...]
    """Free numbers that ended at a bound."""
    effects: tuple[str, ...]
    """Those of the confirming run."""
    spec_text: str
    """The found spec, runnable; empty where there is none."""
    alternatives: tuple[DesignAlternative, ...]
    """Designs that are better in something than every other."""
    history: tuple[HistoryRow, ...]
    """Every time that the search got better."""
    evaluations: int
    """Solutions of the search."""
    wall_s: float
    """[s]"""
    interrupted: bool = False
    """Whether Ctrl-C ended the search: this is the best so far."""
    ended_by_budget: bool = False
    """Whether time ended the search: on another machine the design may be another."""
    lost_graphs: int = 0
    """Graphs that were not tried, since the process that tried them died."""
    hint: str = ""
    """What would help."""
    violations: tuple[Notice, ...] = ()
    """Where the confirming run leaves what its model describes."""

    def __repr__(self) -> str:
        return f"<PathDesign {self.name}: {self.status}>"

    def document(self) -> dict[str, Any]:
        """As in `result.json`."""
        found: dict[str, Any] = json_ready({
            "name": self.name,
            "status": self.status,
            "reason": self.reason or None,
            "hint": self.hint or None,
            "interrupted": self.interrupted,
            "ended_by_budget": self.ended_by_budget,
            "lost_graphs": self.lost_graphs,
            "tolerance_m": self.tolerance_m,
            "rms_m": self.rms_m,
            "worst_m": self.worst_m,
            "confirmed_rms_m": self.confirmed_rms_m,
            "confirmed_worst_m": self.confirmed_worst_m,
            "excess_m": self.excess_m,
            "stated_error_m": self.stated_error_m,
            "validity": validity_document(self.violations) if self.is_confirmed else None,
            "band_one_percent_m": self.widest_band_m,
            "parameters": dict(self.parameters),
            "graph": list(self.graph),
            "at_bounds": list(self.at_bounds),
            "effects": list(self.effects),
            "alternatives": [own.document() for own in self.alternatives],
            "evaluations": self.evaluations,
            "wall_s": self.wall_s,
            "provenance": provenance(),
        })  # fmt: skip
        return found

    @property
    def is_confirmed(self) -> bool:
        """Whether a run of the found design is there."""
        return self.confirmed_rms_m is not None

    @property
    def widest_band_m(self) -> float | None:
        """Largest shift of the tip by one percent of each free number [m]; None without one."""
        if not self.band.size:
            return None
        return float(np.sqrt((self.band**2).sum(axis=1).max()))


def without_design(
    name: str,
    status: DesignStatus,
    reason: str,
    *,
    tolerance_m: float,
    wanted: np.ndarray,
    closed: bool,
    hint: str = "",
    spec_text: str = "",
    evaluations: int = 0,
    wall_s: float = 0.0,
    interrupted: bool = False,
) -> PathDesign:
    """An answer without a design, and why."""
    none = np.zeros((0, 2))
    return PathDesign(
        name=name,
        status=status,
        reason=reason,
        tolerance_m=tolerance_m,
        wanted=wanted,
        found=none,
        band=none,
        closed=closed,
        rms_m=None,
        worst_m=None,
        confirmed_rms_m=None,
        confirmed_worst_m=None,
        excess_m=None,
        stated_error_m=None,
        parameters={},
        units={},
        graph=(),
        at_bounds=(),
        effects=(),
        spec_text=spec_text,
        alternatives=(),
        history=(),
        evaluations=evaluations,
        wall_s=wall_s,
        interrupted=interrupted,
        hint=hint,
    )
