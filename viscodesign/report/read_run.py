"""A run read again from its folder."""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Iterable, Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from viscodesign.errors import UsageError, ViscodesignError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.folder import BAND_TABLE, RUN_TABLES, SUMMARY
from viscodesign.results.channels import SHAPE, TIP_QUANTITIES, TRAJECTORY, Per, channel
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
from viscodesign.scene.reading.read import parse_scene
from viscodesign.scene.scene import Scene

SPEC = RUN_TABLES[2]
ARRAYS = ("inlet_pressure", "pressure", "flow")
"""Quantities that are arrays of their own in `trajectory.csv`."""
CONTACT_ARRAYS = ("contact_normal", "contact_tangential", "contact_gap")
"""The same of a run with contact."""
MEMBERS = {Per.INLET: "inlets", Per.BELLOW: "bellows", Per.TUBE: "tubes"}
FoundT = TypeVar("FoundT")


def read_run(directory: str | Path) -> Trajectory:
    """The run in a folder that `write_run` has written, to the last digit of its tables.

    Quantities that no table has (`results.channels` lists the files) are absent from its arrays;
    asking for one says so. Raises `UsageError` where the folder holds no complete run.
    """
    folder = Path(directory)
    summary = _summary(folder / SUMMARY)
    text = _spec_text(folder / SPEC, summary)
    try:
        names = RunNames(parse_scene(text.encode(), str(folder / SPEC)))
    except ViscodesignError as error:
        raise UsageError(f"{folder} holds no run that can be read: {error}") from error
    motion, shape = _table(folder / TRAJECTORY), _table(folder / SHAPE)
    try:
        arrays = _arrays(motion, names)
        contacts = _contacts(motion, names.scene)
        arrays |= _contact_arrays(motion, contacts)
        axes = _axes(shape, arrays["time"])
        arrays["shape"] = axes.shape
        told = _told(summary) | _band(folder, summary.get("uncertainty"))
    except (ValueError, IndexError, KeyError, TypeError) as error:
        raise UsageError(
            f"the files in {folder} do not fit together ({error}). Simulate the spec again"
        ) from error
    return Trajectory(
        **told,
        **names.of_run(),
        contacts=contacts,
        arrays=arrays,
        arc=axes.arc,
        shape_every=axes.every,
        spec_text=text,
    )


@dataclass(frozen=True)
class RunNames:
    """What the tables of a run have columns for, from its spec."""

    scene: Scene

    def of_run(self) -> dict[str, Any]:
        """What a trajectory holds of its scene."""
        scene, graph = self.scene, self.scene.graph
        return {
            "inlets": tuple(scene.inputs),
            "bellows": graph.bellows,
            "tubes": tuple(tube.name for tube in graph.tubes),
            "junctions": graph.junctions,
            "length": scene.actuator.length,
            "width": scene.actuator.height,
            "section_widths": scene.sections.heights,
            "ambient_pressure": scene.ambient_pressure,
            "period": scene.period,
        }

    def columns(self, quantity: str) -> list[str]:
        """The columns of a quantity in `trajectory.csv`."""
        per = channel(quantity).per
        if per is Per.RUN or (per is Per.INLET and len(self.scene.inputs) == 1):
            return [channel(quantity).column()]
        key = MEMBERS[per]
        return [channel(quantity).column(member) for member in self.of_run()[key]]


@dataclass(frozen=True)
class _RunTable:
    """A table of numbers."""

    names: list[str]
    values: np.ndarray
    """(n, columns)"""

    def columns(self, names: Iterable[str]) -> np.ndarray:
        """Some columns (n, names)."""
        return np.ascontiguousarray(self.values[:, [self._at(name) for name in names]])

    def _at(self, name: str) -> int:
        if name not in self.names:
            raise ValueError(f"there is no column {name}")
        return self.names.index(name)


def _arrays(table: _RunTable, names: RunNames) -> dict[str, np.ndarray]:
    """The arrays of `trajectory.csv`."""
    return {
        "time": table.columns(["time_s"])[:, 0],
        "tip": table.columns(channel(name).column() for name in TIP_QUANTITIES),
        **{name: table.columns(names.columns(name)) for name in ARRAYS},
    }


def _contacts(table: _RunTable, scene: Scene) -> tuple[str, ...]:
    """Names of the points whose contact a run has solved: none where the spec switches it off."""
    is_solved = any(name.startswith(CONTACT_ARRAYS[0]) for name in table.names)
    if not is_solved or scene.loads.ground is None:
        return ()
    return scene.loads.ground.points(scene.bellows.count // 2)


def _contact_arrays(table: _RunTable, contacts: tuple[str, ...]) -> dict[str, np.ndarray]:
    if not contacts:
        return {}
    names = contacts if len(contacts) > 1 else ("",)
    return {
        array: table.columns(channel(array).column(name) for name in names)
        for array in CONTACT_ARRAYS
    }


@dataclass(frozen=True)
class _Axes:
    """The axis at some output times."""

    shape: np.ndarray
    """(N, K, 2): x, z [m]"""
    arc: np.ndarray
    """(K,) [m]"""
    every: int
    """Output times from one shape to the next."""


def _axes(table: _RunTable, time: np.ndarray) -> _Axes:
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
    time, x, z, xz = _table(folder / BAND_TABLE).columns(BAND_COLUMNS).T
    numbers = [
        {**own, "deviation": own["standard_deviation"], "share": own["share_of_variance"]}
        for own in told["keys"]
    ]
    band = CoefficientBand(
        covariance=np.column_stack([x**2, z**2, xz]),
        time=time,
        numbers=_all(UncertainNumber, numbers),
        left_out=tuple((own["key"], own["reason"]) for own in told["left_out"]),
        wall_s=told["wall_s"],
    )
    return {"uncertainty": band}


def _table(file: Path) -> _RunTable:
    head, _, body = _text(file).partition("\n")
    names = head.strip().split(",")
    try:
        values = np.array(body.replace("\n", ",").strip(",").split(","), dtype=float)
        return _RunTable(names, values.reshape(-1, len(names)))
    except ValueError as error:
        raise UsageError(
            f"{file} is not a whole table ({error}). Simulate the spec again"
        ) from error


def _summary(file: Path) -> dict[str, Any]:
    try:
        found = json.loads(_text(file))
    except json.JSONDecodeError as error:
        raise UsageError(f"{file} is not valid JSON ({error}). Simulate the spec again") from error
    if not isinstance(found, dict) or not {"status", "metrics", "effects"} <= set(found):
        raise UsageError(f"{file} is not the summary of a run. Give the folder of `simulate`")
    return found


def _spec_text(file: Path, summary: Mapping[str, Any]) -> str:
    """The resolved spec, which must be the one that the run was made of."""
    text = _text(file)
    digest = hashlib.sha256(text.encode()).hexdigest()
    if summary.get("resolved_sha256", digest) != digest:
        raise UsageError(
            f"{file} was changed after the run, so the tables beside it are of another spec. "
            "Simulate it again, in a folder of its own"
        )
    return text


def _text(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8")  # line ends of another system become ours
    except (FileNotFoundError, NotADirectoryError) as error:
        raise UsageError(
            f"there is no {file.name} in {file.parent}: expected the folder of a run, such as "
            "`viscodesign simulate` writes"
        ) from error
    except (OSError, UnicodeDecodeError) as error:
        raise UsageError(f"cannot read {file}: {error}") from error


def _told(summary: Mapping[str, Any]) -> dict[str, Any]:
    """What `summary.json` says, as the fields of a trajectory."""
    provenance = dict(summary.get("provenance", {}))
    settings = provenance.pop("settings", summary.get("settings", {}))
    scales = _made(Scales, summary["scales"])
    return {
        **{key: summary[key] for key in ("name", "status", "failure", "version", "spec_sha256")},
        "failure_time_s": summary.get("failure_time_s"),
        "classification": _made(Classification, {**summary, "scales": scales, "warnings": ()}),
        "effects": _all(Verdict, summary["effects"]),
        "accuracy": _made(Accuracy, summary["accuracy"]),
        "cost": _made(Cost, summary["cost"]),
        "invariants": _made(Invariants, summary["invariants"]),
        "warnings": _all(Notice, summary["warnings"]),
        "violations": _all(Notice, summary.get("validity", {}).get("reasons", ())),
        "proof": _all(EffectAblation, summary.get("proof", ())),
        "ladder": _all(RetryAttempt, summary.get("ladder", ())),
        "notes": tuple(summary.get("notes", ())),
        "settings": settings,
        "provenance": provenance,
    }


def _all(kind: type[FoundT], documents: Iterable[Mapping[str, Any]]) -> tuple[FoundT, ...]:
    return tuple(_made(kind, document) for document in documents)


def _made(kind: type[FoundT], document: Mapping[str, Any]) -> FoundT:
    """A finding from its document, where an infinite number is null."""
    known: Any = fields(kind)  # type: ignore[arg-type]
    given = {field.name: document[field.name] for field in known if field.name in document}
    given = {name: tuple(v) if isinstance(v, list) else v for name, v in given.items()}
    infinite = {
        f.name: math.inf for f in known if f.type == "float" and given.get(f.name, 0) is None
    }
    return kind(**{**given, **infinite})
