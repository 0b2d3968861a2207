"""What a run leaves behind: arrays, verdicts, status and provenance.

Plain data. Nothing here knows how a number was computed; `report` draws it,
the command line prints it, and a script reads it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from viscodesign.results.findings import (
    Classification,
    EffectAblation,
    Notice,
    RetryAttempt,
    Verdict,
    ablation_documents,
    classification_document,
    notice_documents,
    plain,
    verdict_documents,
)

if TYPE_CHECKING:
    import pandas as pd

Status = Literal["complete", "failed", "interrupted"]


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
    proof: tuple[EffectAblation, ...] = ()
    """What every effect changes, where that was asked for."""
    ladder: tuple[RetryAttempt, ...] = ()
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
        return summary_document(self)

    def frame(self) -> pd.DataFrame:
        """Tip, pressures and flows against time: the columns of `trajectory.csv`."""
        return trajectory_frame(self)

    def shape_frame(self) -> pd.DataFrame:
        """The axis at the times of its shapes: the columns of `shape.csv`."""
        return shape_frame(self)


def summary_document(trajectory: Trajectory) -> dict[str, Any]:
    """The run without its arrays; ``proof`` is there where it was asked for."""
    document = {
        "name": trajectory.name,
        "version": trajectory.version,
        "spec_sha256": trajectory.spec_sha256,
        "status": trajectory.status,
        "failure": trajectory.failure,
        **{
            key: value
            for key, value in classification_document(trajectory.classification).items()
            if key not in ("name", "warnings")
        },
        "effects": verdict_documents(trajectory.effects),
        **({"proof": ablation_documents(trajectory.proof)} if trajectory.proof else {}),
        "accuracy": asdict(trajectory.accuracy),
        "cost": asdict(trajectory.cost),
        "invariants": asdict(trajectory.invariants),
        "ladder": [plain(asdict(rung)) for rung in trajectory.ladder],
        "settings": dict(trajectory.settings),
        "warnings": notice_documents(trajectory.warnings),
    }
    return dict(plain(document))


WHOLE = slice(None)


def trajectory_columns(trajectory: Trajectory, rows: slice = WHOLE) -> tuple[list[str], np.ndarray]:
    """Names and values (T, columns) of `trajectory.csv`, or of some rows; pressures are gauge."""
    names = ["time_s", "tip_x_m", "tip_z_m", "tip_angle_rad"]
    inlets = list(trajectory.inlet_pressure)
    alone = len(inlets) == 1
    names += ["inlet_pressure_pa" if alone else f"inlet_pressure_{name}_pa" for name in inlets]
    names += [f"pressure_{name}_pa" for name in trajectory.bellows]
    names += [f"flow_{name}_m3_s" for name in trajectory.tubes]
    inlet_values = [values[rows, None] for values in trajectory.inlet_pressure.values()]
    values = [
        trajectory.time[rows, None],
        trajectory.tip[rows],
        *inlet_values,
        trajectory.pressure[rows],
        trajectory.flow[rows],
    ]
    return names, np.concatenate(values, axis=1)


def shape_columns(trajectory: Trajectory, rows: slice = WHOLE) -> tuple[list[str], np.ndarray]:
    """Names and values (N K, 4) of `shape.csv`, or of some shapes."""
    time, shape = trajectory.time[trajectory.shape_rows[rows]], trajectory.shape[rows]
    times, points = shape.shape[:2]
    values = np.column_stack(
        (
            np.repeat(time, points),
            np.tile(trajectory.arc, times),
            shape.reshape(-1, 2),
        )
    )
    return ["time_s", "arc_m", "x_m", "z_m"], values


def trajectory_frame(trajectory: Trajectory) -> pd.DataFrame:
    """`trajectory.csv` as a data frame."""
    import pandas as pd

    names, values = trajectory_columns(trajectory)
    return pd.DataFrame(values, columns=names)


def shape_frame(trajectory: Trajectory) -> pd.DataFrame:
    """`shape.csv` as a data frame."""
    import pandas as pd

    names, values = shape_columns(trajectory)
    return pd.DataFrame(values, columns=names)
