"""The desk that the pages assume: a small spec, its run, recordings of it, and a wanted path."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pandas as pd

from tests.scenes import CONFIGS, ROOT
from viscodesign import load, simulate
from viscodesign.results.trajectory import Trajectory

SMALL = (
    "name=leg",
    "run.duration=4 s",
    "run.output_interval=0.1 s",
    "input={kind: double_sigmoid, start: 8 kPa, drop: 16 kPa, fall_time: 0.8 s, rise_time: 2.4 s, transition: 0.8 s}",
    "effects={pressure_distribution: on, tip_load: auto, others: off}",
    "loads.gravity=off",
)
"""A leg of four bellows with slow flow alone, solved in milliseconds, and an input that a pump can play."""
NOISE, PRESSURE_NOISE = 2e-5, 10.0
"""Standard deviations of a recorded place [m], and of a pressure [Pa]."""
TARGET = """\
spec: leg.yaml
free: {network.tube_radius: [0.2 mm, 0.6 mm]}
target: {file: path.csv, closed: false}
tolerance: 0.15 mm
"""


def set_up(desk: Path) -> None:
    """Write all that commands and blocks of the pages find beside them.

    Of the configs, those of one actuator: `configs/*.yaml` stands for specs of a reader's own.
    """
    pump = load(CONFIGS / "leg_16_pump.yaml").model_dump()["pump"]
    scene = load(CONFIGS / "leg_4_air.yaml", list(SMALL)).replace({"pump": pump})
    run = simulate(scene)
    run.save(desk / "runs" / "leg", plots=False, report=False)
    spec = run.spec_text
    for name in ("leg", "straight"):
        (desk / f"{name}.yaml").write_text(spec.replace("name: leg", f"name: {name}", 1))
    crossed = scene.replace({"name": "crossed", "network.layout": "crossed"})
    moved = simulate(crossed, verify=False)
    moved.save(desk / "runs" / "leg_water", plots=False, report=False)
    for name in ("crossed", "tripled"):
        (desk / f"{name}.yaml").write_text(moved.spec_text.replace("crossed", name, 1))
    for name in ("camera", "data", "slow", "fast"):
        _recording(run).to_csv(desk / f"{name}.csv", index=False)
    path = pd.DataFrame({"x_m": run.tip[:, 0], "z_m": run.tip[:, 1]})
    path.to_csv(desk / "path.csv", index=False)
    (desk / "trace.csv").write_text("time [s],pressure [kPa]\n0,0\n1,15\n2,0\n")
    (desk / "target.yaml").write_text(TARGET)
    shutil.copy(CONFIGS / "three_legs.yaml", desk)
    shutil.copytree(CONFIGS, desk / "configs", ignore=shutil.ignore_patterns("hexapod*"))
    (desk / "docs").mkdir()
    shutil.copytree(ROOT / "docs" / "validation", desk / "docs" / "validation")


def _recording(run: Trajectory) -> pd.DataFrame:
    chance = np.random.default_rng(0)
    x, z = (run.tip[:, k] + NOISE * chance.standard_normal(len(run.time)) for k in (0, 1))
    pressure = run.inlet_pressure["inlet"] + PRESSURE_NOISE * chance.standard_normal(len(run.time))
    return pd.DataFrame(
        {"time_s": run.time, "inlet_pressure_pa": pressure, "tip_x_m": x, "tip_z_m": z}
    )
