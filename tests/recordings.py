"""Recordings of a scene with known numbers, as instruments would have made them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from tests.scenes import leg
from viscodesign import compile
from viscodesign.scene.scene import Scene

PULSE = (
    "input={kind: double_sigmoid, start: 20 kPa, drop: 45 kPa, fall_time: 0.4 s, rise_time: 1.2 s, "
    "transition: 0.2 s}"
)
QUIET = "effects={pressure_distribution: on, others: off}"
"""Arcs and slow flow: quick to solve."""
RUN = "run={duration: 2 s, output_interval: 20 ms}"
FLUID = "fluid={name: oil, viscosity: 1e-4 Pa*s, density: 900 kg/m^3, bulk_modulus: 1 GPa}"
MARKER_SD, PRESSURE_SD, VOLUME_SD = 2e-4, 30.0, 1e-8
"""[m], [Pa], [m3]"""


def small_scene(*overrides: str) -> Scene:
    """Four bellows, that a fit solves in milliseconds."""
    return leg(QUIET, PULSE, RUN, FLUID, "loads={gravity: off}", *overrides, config="leg_4_air")


def columns_of(
    scene: Scene,
    truth: Mapping[str, float],
    *,
    seed: int = 0,
    late_s: float = 0.0,
    volume: bool = True,
) -> dict[str, np.ndarray]:
    """Columns of a recording with noise by header; markers ``late_s`` late."""
    chance = np.random.default_rng(seed)
    sections = scene.bellows.count // 2
    markers = [f"m{k}_{axis}_m" for k in range(1, sections + 1) for axis in "xz"]
    times = scene.run.output_times_array()
    every = np.unique(np.concatenate([times, np.maximum(times - late_s, 0.0)]).round(9))
    run = {"duration": scene.run.duration, "output_times": every.tolist()}
    motion = compile(
        scene.replace({"run": run}),
        list(truth),
        [*markers, "inlet_pressure_pa", "inflow_m3"],
        tolerance=1e-7,
    )
    found = motion(truth)
    on_time, delayed = (
        np.searchsorted(every, np.maximum(times - late, 0.0).round(9) - 1e-10)
        for late in (0.0, late_s)
    )

    def noise(deviation: float) -> np.ndarray:
        return deviation * chance.standard_normal(len(times))

    columns = {
        "time_s": times,
        "inlet_pressure_pa": found["inlet_pressure_pa"][on_time] + noise(PRESSURE_SD),
    }
    if volume:
        delivered = found["inflow_m3"][on_time] - found["inflow_m3"][0]
        columns["syringe_volume_m3"] = delivered + noise(VOLUME_SD)
    return columns | {name: found[name][delayed] + noise(MARKER_SD) for name in markers}


def written(columns: Mapping[str, np.ndarray], path: Path) -> Path:
    """A recording as a file; NaN is an empty cell."""
    rows = zip(*columns.values(), strict=True)
    lines = [",".join(columns)]
    lines += [",".join("" if np.isnan(v) else f"{v:.9g}" for v in row) for row in rows]
    path.write_text("\n".join([*lines, ""]))
    return path
