"""What a run leaves behind: arrays, verdicts, status and provenance.

Plain data. Nothing here knows how a number was computed; `report` draws it,
the command line prints it, and a script reads it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from viscodesign.results.rung import Rung

if TYPE_CHECKING:
    import pandas as pd

Status = Literal["complete", "failed", "interrupted"]


@dataclass(frozen=True)
class Scales:
    """The four characteristic times of a scene [s]."""

    t_s: float
    """Elastic-inertial time of the solid."""
    t_f: float
    """Viscous-elastic time of the fluid, as the paper defines it."""
    t_i: float
    """Shortest monotone swing of the inlet pressure (infinite for a constant)."""
    t_net: float
    """Slowest time constant of the real network."""

    @property
    def ratios(self) -> dict[str, float]:
        """`ts_over_tf` (x of the quadrant plane), `ts_over_ti` (y) and `tnet_over_ti`."""
        return {
            "ts_over_tf": _ratio(self.t_s, self.t_f),
            "ts_over_ti": _ratio(self.t_s, self.t_i),
            "tnet_over_ti": _ratio(self.t_net, self.t_i),
        }


def _ratio(above: float, below: float) -> float:
    if below == 0.0:
        return float("inf")
    return above / below


@dataclass(frozen=True)
class Verdict:
    """Why an effect is in or out of a run."""

    name: str
    mode: Literal["auto", "on", "off"]
    taken: bool
    weight: float
    formula: str
    reason: str
    contribution_m: float = 0.0
    """Estimate of how far the tip moves when this effect alone is switched [m]."""
    budget_share: float = 0.0
    """The same over the tip error asked for."""
    present: bool = True
    """Whether the scene has what the effect acts on."""


@dataclass(frozen=True)
class Proof:
    """What switching one effect did to the tip, measured by a second solution."""

    name: str
    taken: bool
    """Whether the run has the effect; the second solution has it the other way round."""
    estimated_m: float
    """The verdict's contribution [m]."""
    measured_m: float | None
    """Largest distance of the tips over all output times [m]; None where there is no solution."""
    solve_s: float
    """Wall time of the second solution [s]."""
    note: str = ""
    """Why there is none, or up to when it reached."""


@dataclass(frozen=True)
class Notice:
    """A warning: something the numbers say and the user should hear."""

    code: str
    message: str
    where: str = ""
    time_s: float | None = None


@dataclass(frozen=True)
class Classification:
    """Timescales, ratios and quadrant of one scene, with what they mean."""

    name: str
    scales: Scales
    quadrant: Literal["I", "II", "III", "IV"]
    meaning: str
    cutoff_frequency_hz: float
    warnings: tuple[Notice, ...] = ()


@dataclass(frozen=True)
class Accuracy:
    """The error asked for and the error estimated, at the tip over all output times [m]."""

    requested_m: float
    estimated_tip_error_m: float | None
    """Sum of the parts below; None where the run was not verified."""
    method: str
    time_m: float | None = None
    """Part of the steps through time."""
    space_m: float | None = None
    """Part of the mesh along the rod."""
    omitted_m: float | None = None
    """Part of the effects that were left out by choice; those that the spec forbids
    are none of it."""


@dataclass(frozen=True)
class Cost:
    """What a run cost: wall seconds, and counts that no clock disturbs."""

    build_s: float = 0.0
    solve_s: float = 0.0
    verify_s: float = 0.0
    steps: int = 0
    residual_calls: int = 0
    jacobian_calls: int = 0


@dataclass(frozen=True)
class Invariants:
    """Balances that must hold in every run, as relative errors."""

    volume_imbalance_rel: float | None = None
    energy_imbalance_rel: float | None = None
    coupling_work_j: float | None = None
    """Work created by coefficients that are not reciprocal (None without feedback)."""


@dataclass(frozen=True)
class Trajectory:
    """One run: T times, B bellows, Q tubes, K points along the axis.

    Pressures are gauge, relative to the ambient; lengths in m, times in s.
    """

    name: str
    status: Status
    time: np.ndarray
    """(T,) [s]"""
    tip: np.ndarray
    """(T, 3): x [m], z [m], angle from +z [rad], never wrapped."""
    inlet_pressure: Mapping[str, np.ndarray]
    """Inlet name -> (T,) gauge [Pa]."""
    bellows: tuple[str, ...]
    """R1..RS, then L1..LS."""
    pressure: np.ndarray
    """(T, B) gauge [Pa]."""
    volume: np.ndarray
    """(T, B) [m3]."""
    tubes: tuple[str, ...]
    flow: np.ndarray
    """(T, Q) [m3/s], positive from the tube's first end to its second."""
    arc: np.ndarray
    """(K,) reference arc length of the shape's points [m], from the clamp."""
    shape: np.ndarray
    """(N, K, 2): x, z of the axis [m], at the rows of `shape_rows`: all, or in a long run some."""
    length: float
    """Actuator length [m]."""
    width: float
    """Actuator size along x (the YAML's `height`) [m], for drawing."""
    classification: Classification
    effects: tuple[Verdict, ...]
    accuracy: Accuracy
    cost: Cost
    invariants: Invariants
    warnings: tuple[Notice, ...]
    spec_text: str
    """The spec as resolved, YAML, runnable again."""
    spec_sha256: str
    version: str
    ambient_pressure: float = 101325.0
    """Absolute [Pa]."""
    inflow: Mapping[str, np.ndarray] = field(default_factory=dict)
    """Inlet name -> (T,) what it has given to the network since all was filled at the baseline,
    unloaded [m3 at ambient density]; from what is held, not from flows."""
    shape_every: int = 1
    """Rows from one shape to the next."""
    proof: tuple[Proof, ...] = ()
    """What every effect changes, where that was asked for."""
    ladder: tuple[Rung, ...] = ()
    """What was tried where a solver had come to a stop, in order."""
    settings: Mapping[str, Any] = field(default_factory=dict)
    """What the solver chose: edges, tolerance, form of rod and network."""
    failure: str | None = None
    """The message of what ended the run early."""

    @property
    def sections(self) -> int:
        """Number of equal sections along the axis (bellows come in pairs)."""
        return len(self.bellows) // 2

    @property
    def shape_rows(self) -> np.ndarray:
        """Which rows (N,) of ``time`` have a shape: every ``shape_every``-th, and the last."""
        last = len(self.time) - 1
        rows = np.arange(0, last + 1, self.shape_every)
        return rows if last % self.shape_every == 0 or last < 0 else np.append(rows, last)

    def summary(self) -> dict[str, Any]:
        """The run without its arrays, ready for JSON (numbers that are not finite as None)."""
        from viscodesign.report.tables import summary_document

        return summary_document(self)

    def frame(self) -> pd.DataFrame:
        """Tip, pressures and flows against time: the columns of `trajectory.csv`."""
        from viscodesign.report.tables import trajectory_frame

        return trajectory_frame(self)

    def shape_frame(self) -> pd.DataFrame:
        """The axis at the times of its shapes: the columns of `shape.csv`."""
        from viscodesign.report.tables import shape_frame

        return shape_frame(self)
