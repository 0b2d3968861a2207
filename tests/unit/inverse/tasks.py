"""Design tasks on a small scene: four bellows on a chain, thick oil, a pulse of seconds."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from viscodesign import Scene, load, simulate

TUBES = ["inlet", "R1", "R2", "L2", "L1"]
SPEC: dict[str, Any] = {
    "name": "small",
    "actuator": {
        "length": "27.25 mm", "height": "30 mm", "width": "20 mm", "youngs_modulus": "1.8 MPa",
        "density": "950 kg/m^3", "solid_fraction": 0.47, "extension_factor": 0.53,
        "bending_factor": 0.55, "damping_time": "1 ms",
    },
    "bellows": {
        "count": 4, "height": "10 mm", "width": "12 mm", "length": "18 mm",
        "area_per_pressure": "3.413e-9 m^2/Pa", "angle_per_pressure": "10.266 rad",
        "extension_per_pressure": "47 mm", "area_per_force": "3.0e-7 m^2/N",
        "area_per_moment": "1.2e-6 m^2/(N*m)", "collapse_fraction": 0.1,
    },
    "network": {
        "layout": "custom", "tube_radius": "0.9 mm", "tube_length": "37.5 mm",
        "tubes": [{"from": a, "to": b} for a, b in itertools.pairwise(TUBES)],
    },
    "fluid": {
        "name": "oil", "viscosity": "0.06 Pa*s", "density": "950 kg/m^3", "bulk_modulus": "1.6 GPa",
    },
    "input": {
        "kind": "double_sigmoid", "start": "20 kPa", "drop": "42 kPa", "fall_time": "2 s",
        "rise_time": "8 s", "transition": "1.6 s",
    },
    "loads": {"gravity": "off"},
    "accuracy": 0.001,
    "run": {"duration": "12 s", "output_interval": "0.2 s"},
}  # fmt: skip
"""A spec as a mapping."""
PULSE = {"input.start": ["5 kPa", "30 kPa"], "input.drop": ["10 kPa", "60 kPa"]}


def small(**changes: Any) -> Scene:
    """The scene with other values of some keys, whose dots are two underscores."""
    return load(SPEC, {key.replace("__", "."): value for key, value in changes.items()})


def task(folder: Path, free: dict[str, Any], target: Any, **more: Any) -> Path:
    """The file of a task; ``target``: a mapping, or the scene whose path is wanted."""
    (folder / "spec.yaml").write_text(yaml.safe_dump(SPEC))
    if isinstance(target, Scene):
        run = simulate(target, verify=False)
        rows = np.column_stack([run.time, run.tip[:, :2]])
        np.savetxt(
            folder / "path.csv", rows, delimiter=",", header="time_s,tip_x_m,tip_z_m", comments=""
        )
        target = {"file": "path.csv", "closed": False}
    document = {"spec": "spec.yaml", "free": free, "target": target, **more}
    (folder / "target.yaml").write_text(yaml.safe_dump(document))
    return folder / "target.yaml"


def loop(sense: float) -> dict[str, Any]:
    """A target: the limit cycle of one harmonic, or its mirror image for a positive sense."""
    source = {"kind": "harmonics", "period": 7.0, "mean": 2e3, "cosine": [12e3]}
    run = {"duration": 7.0, "output_interval": 0.125, "start": "periodic"}
    rows = simulate(small(input=source, run=run), verify=False).tip[:, :2]
    return {"rows": (rows * [-1 if sense > 0 else 1, 1]).tolist()}
