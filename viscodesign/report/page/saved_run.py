"""A run read back from the files in its folder, as far as the page and the films need it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from viscodesign.errors import UsageError, ViscodesignError
from viscodesign.report.folder import SUMMARY
from viscodesign.report.page.shown_run import ShownRun
from viscodesign.scene.reading.read import parse_scene
from viscodesign.scene.scene import Scene

INLET, PRESSURE, FLOW = "inlet_pressure", "pressure", "flow"


def saved_run(directory: str | Path) -> ShownRun:
    """Read `summary.json`, `spec.yaml`, `trajectory.csv` and `shape.csv`.

    Raises `UsageError` where the folder holds no complete run.
    """
    folder = Path(directory)
    summary = _summary(folder / SUMMARY)
    spec_text = _text(folder / "spec.yaml")
    try:
        scene = parse_scene(spec_text.encode(), str(folder / "spec.yaml"), folder)
    except ViscodesignError as error:
        raise UsageError(f"{folder} holds no run that can be shown: {error}") from error
    names, values = _table(folder / "trajectory.csv")
    _, points = _table(folder / "shape.csv")
    try:
        return _joined(summary, spec_text, scene, names, values, points)
    except (ValueError, IndexError, KeyError) as error:
        raise UsageError(
            f"the tables in {folder} do not fit together ({error}). Simulate the spec again"
        ) from error


def _joined(
    summary: dict[str, Any],
    spec_text: str,
    scene: Scene,
    names: list[str],
    values: np.ndarray,
    points: np.ndarray,
) -> ShownRun:
    columns = {name: k for k, name in enumerate(names)}
    graph = scene.graph
    inlets = _members(names, INLET, "pa") if len(graph.inlets) > 1 else graph.inlets
    bellows, tubes = _members(names, PRESSURE, "pa"), _members(names, FLOW, "m3_s")
    time = values[:, columns["time_s"]]
    count = int(np.count_nonzero(points[:, 0] == points[0, 0]))
    shape = points.reshape(-1, count, 4)
    return ShownRun(
        summary=summary,
        spec_text=spec_text,
        inlets=inlets,
        bellows=bellows,
        tubes=tubes,
        length=scene.actuator.length,
        width=scene.actuator.height,
        time=time,
        tip=values[:, [columns[f"tip_{name}"] for name in ("x_m", "z_m", "angle_rad")]],
        inlet_pressure=_columns(values, names, INLET, "pa"),
        pressure=_columns(values, names, PRESSURE, "pa"),
        flow=_columns(values, names, FLOW, "m3_s"),
        arc=shape[0, :, 1],
        shape=shape[..., 2:],
        shape_rows=np.searchsorted(time, shape[:, 0, 0]),
    )


def _members(names: list[str], quantity: str, unit: str) -> tuple[str, ...]:
    start, end = f"{quantity}_", f"_{unit}"
    return tuple(
        name[len(start) : -len(end)]
        for name in names
        if name.startswith(start) and name.endswith(end)
    )


def _columns(values: np.ndarray, names: list[str], quantity: str, unit: str) -> np.ndarray:
    return values[
        :, [k for k, n in enumerate(names) if n.startswith(f"{quantity}_") and n.endswith(unit)]
    ]


def _summary(file: Path) -> dict[str, Any]:
    try:
        found = json.loads(_text(file))
    except json.JSONDecodeError as error:
        raise UsageError(f"{file} is not valid JSON ({error}). Simulate the spec again") from error
    if not isinstance(found, dict) or not {"status", "metrics", "effects"} <= set(found):
        raise UsageError(f"{file} is not the summary of a run. Give the folder of `simulate`")
    return found


def _table(file: Path) -> tuple[list[str], np.ndarray]:
    text = _text(file)
    head, _, body = text.partition("\n")
    names = head.strip().split(",")
    try:
        values = np.array(body.replace("\n", ",").strip(",").split(","), dtype=float)
        return names, values.reshape(-1, len(names))
    except ValueError as error:
        raise UsageError(f"{file} is not a whole table ({error}). Simulate the spec again") from (
            error
        )


def _text(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8")
    except FileNotFoundError as error:
        raise UsageError(
            f"there is no {file.name} in {file.parent}: expected the folder of a run, such as "
            "`viscodesign simulate` writes"
        ) from error
    except (OSError, UnicodeDecodeError) as error:
        raise UsageError(f"cannot read {file}: {error}") from error
