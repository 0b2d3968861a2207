"""Documents and tables, under the names of the public interface."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import numpy as np

from viscodesign.results.trajectory import Classification, Notice, Proof, Trajectory, Verdict

if TYPE_CHECKING:
    import pandas as pd


def plain(value: Any) -> Any:
    """JSON-ready: numbers that are not finite become null, tuples and arrays lists."""
    if isinstance(value, (np.generic, np.ndarray)):
        value = value.tolist()
    if isinstance(value, dict):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if isinstance(value, (bool, int, str)) or value is None:
        return value
    number = float(value)
    return number if math.isfinite(number) else None


def verdict_documents(verdicts: Iterable[Verdict]) -> list[dict[str, Any]]:
    """Verdicts as objects."""
    return [plain(asdict(verdict)) for verdict in verdicts]


def proof_documents(proofs: Iterable[Proof]) -> list[dict[str, Any]]:
    """Proofs as objects: name, taken, estimated_m, measured_m, solve_s, note."""
    return [plain(asdict(proof)) for proof in proofs]


def notice_documents(notices: Iterable[Notice]) -> list[dict[str, Any]]:
    """Warnings as objects: code, message, where, time_s."""
    return [plain(asdict(notice)) for notice in notices]


def classification_document(found: Classification) -> dict[str, Any]:
    """Scales, ratios and quadrant of one spec."""
    scales = found.scales
    document = {
        "name": found.name,
        "scales": {"t_s": scales.t_s, "t_f": scales.t_f, "t_i": scales.t_i, "t_net": scales.t_net},
        "ratios": scales.ratios,
        "quadrant": found.quadrant,
        "meaning": found.meaning,
        "cutoff_frequency_hz": found.cutoff_frequency_hz,
        "warnings": notice_documents(found.warnings),
    }
    return dict(plain(document))


def check_document(
    found: Classification, verdicts: Iterable[Verdict], facts: Sequence[str]
) -> dict[str, Any]:
    """What a check tells, under the names of a run's summary."""
    return {
        **classification_document(found),
        "effects": verdict_documents(verdicts),
        "facts": list(facts),
    }


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
        **({"proof": proof_documents(trajectory.proof)} if trajectory.proof else {}),
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
