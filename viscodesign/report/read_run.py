"""A run read again from its folder."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from viscodesign.errors import UsageError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.folder import BAND_TABLE, SUMMARY
from viscodesign.report.saved_files import (
    SavedTable,
    all_made,
    fitting_files,
    made,
    saved_spec,
    saved_summary,
    saved_table,
)
from viscodesign.results.channels import (
    CONTACT_QUANTITIES,
    SHAPE,
    TIP_COLUMNS,
    TRAJECTORY,
    Per,
    channels_of,
)
from viscodesign.results.coefficient_band import BAND_COLUMNS, CoefficientBand, UncertainNumber
from viscodesign.results.findings import (
    Classification,
    EffectAblation,
    Notice,
    RetryAttempt,
    Scales,
    Verdict,
)
from viscodesign.results.trajectory import Accuracy, Cost, Invariants, Trajectory
from viscodesign.scene.reading.read import scene_of
from viscodesign.scene.scene import Scene


def read_run(directory: str | Path) -> Trajectory:
    """The run in a folder that `write_run` has written, to the last digit of its tables.

    Quantities that no table has (`results.channels` lists the files) are absent from its arrays;
    asking for one says so. Raises `UsageError` where the folder holds no complete run.
    """
    folder = Path(directory)
    summary = saved_summary(folder / SUMMARY)
    if not {"metrics", "effects"} <= set(summary):
        raise UsageError(f"{folder / SUMMARY} is not the summary of a run of one actuator")
    text, scene = saved_spec(folder, summary, scene_of, "run")
    motion, shape = saved_table(folder / TRAJECTORY), saved_table(folder / SHAPE)
    with fitting_files(folder):
        names = RunNames(scene, _contacts(motion, scene))
        arrays = _arrays(motion, names)
        axes = _axes(shape, arrays["time"])
        arrays["shape"] = axes.shape
        told = _told(summary) | _band(folder, summary.get("uncertainty"))
    return Trajectory(
        **told,
        **names.of_run(),
        arrays=arrays,
        arc=axes.arc,
        shape_every=axes.every,
        spec_text=text,
    )


@dataclass(frozen=True)
class RunNames:
    """What the tables of a run have columns for, from its spec."""

    scene: Scene
    contacts: tuple[str, ...]

    def of_run(self) -> dict[str, Any]:
        """What a trajectory holds of its scene."""
        scene = self.scene
        return {
            "inlets": self.members(Per.INLET),
            "bellows": self.members(Per.BELLOW),
            "tubes": self.members(Per.TUBE),
            "junctions": self.members(Per.JUNCTION),
            "contacts": self.contacts,
            "length": scene.actuator.length,
            "width": scene.actuator.height,
            "section_widths": scene.sections.heights,
            "ambient_pressure": scene.ambient_pressure,
            "period": scene.period,
        }

    def members(self, per: Per) -> tuple[str, ...]:
        """Names of what a quantity has one value of."""
        scene, graph = self.scene, self.scene.graph
        return {
            Per.INLET: tuple(scene.inputs),
            Per.BELLOW: graph.bellows,
            Per.TUBE: tuple(tube.name for tube in graph.tubes),
            Per.JUNCTION: graph.junctions,
            Per.CONTACT: self.contacts,
            Per.SECTION: tuple(str(k + 1) for k in range(graph.sections)),
        }[per]


def _arrays(table: SavedTable, names: RunNames) -> dict[str, np.ndarray]:
    """The arrays of `trajectory.csv`: none of parts that the run, or its version, does not have."""
    known = set(table.names)
    found = {
        "time": table.columns(["time_s"])[:, 0],
        "tip": table.columns(TIP_COLUMNS),
    }
    for row in channels_of(TRAJECTORY):
        columns = row.columns(names)
        if row.read is None and not known.isdisjoint(columns):
            values = table.columns(columns)
            found[row.quantity] = values[:, 0] if row.per is Per.RUN else values
    return found


def _contacts(table: SavedTable, scene: Scene) -> tuple[str, ...]:
    """Names of the points whose contact a run has solved: none where the spec switches it off."""
    is_solved = any(name.startswith(CONTACT_QUANTITIES[0]) for name in table.names)
    if not is_solved or scene.loads.ground is None:
        return ()
    return scene.loads.ground.points(scene.bellows.count // 2)


@dataclass(frozen=True)
class _Axes:
    """The axis at some output times."""

    shape: np.ndarray
    """(N, K, 2): x, z [m]"""
    arc: np.ndarray
    """(K,) [m]"""
    every: int
    """Output times from one shape to the next."""


def _axes(table: SavedTable, time: np.ndarray) -> _Axes:
    """The axes of `shape.csv`, of a run with these output times."""
    points = table.columns(["time_s", "arc_m", "x_m", "z_m"])
    count = int(np.count_nonzero(points[:, 0] == points[0, 0]))
    shapes = points.reshape(-1, count, 4)
    rows = np.searchsorted(time, shapes[:, 0, 0])
    if not np.array_equal(time[rows], shapes[:, 0, 0]):
        raise ValueError("shapes are at other times than the motion")
    every = int(rows[1] - rows[0]) if len(rows) > 1 else 1
    return _Axes(shapes[..., 2:].copy(), shapes[0, :, 1].copy(), every)


def _band(folder: Path, told: Mapping[str, Any] | None) -> dict[str, Any]:
    """How uncertain the tip is, of a run whose summary tells it."""
    if told is None:
        return {}
    time, x, z, xz = saved_table(folder / BAND_TABLE).columns(BAND_COLUMNS).T
    numbers = [
        {**own, "deviation": own["standard_deviation"], "share": own["share_of_variance"]}
        for own in told["keys"]
    ]
    band = CoefficientBand(
        covariance=np.column_stack([x**2, z**2, xz]),
        time=time,
        numbers=all_made(UncertainNumber, numbers),
        left_out=tuple((own["key"], own["reason"]) for own in told["left_out"]),
        wall_s=told["wall_s"],
    )
    return {"uncertainty": band}


def _told(summary: Mapping[str, Any]) -> dict[str, Any]:
    """What `summary.json` says, as the fields of a trajectory."""
    provenance = dict(summary.get("provenance", {}))
    settings = provenance.pop("settings", summary.get("settings", {}))
    scales = made(Scales, summary["scales"])
    return {
        **{key: summary[key] for key in ("name", "status", "failure", "version", "spec_sha256")},
        "failure_time_s": summary.get("failure_time_s"),
        "classification": made(Classification, {**summary, "scales": scales, "warnings": ()}),
        "effects": all_made(Verdict, summary["effects"]),
        "accuracy": made(Accuracy, summary["accuracy"]),
        "cost": made(Cost, summary["cost"]),
        "invariants": made(Invariants, summary["invariants"]),
        "warnings": all_made(Notice, summary["warnings"]),
        "violations": all_made(Notice, summary.get("validity", {}).get("reasons", ())),
        "proof": all_made(EffectAblation, summary.get("proof", ())),
        "ladder": all_made(RetryAttempt, summary.get("ladder", ())),
        "notes": tuple(summary.get("notes", ())),
        "settings": settings,
        "provenance": provenance,
    }
