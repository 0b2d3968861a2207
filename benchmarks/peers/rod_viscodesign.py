"""The rod by viscodesign: a scene of one section whose left bellow holds the input's pressure.

The network is one short tube into L1; R1 is sealed off, at rest. Pressure distribution,
feedback and damping are off, so L1 follows the inlet at once and the intrinsic curvature
is the pressure times a constant. The extension per pressure is zero.

By the accuracy alone inertia is taken only where it moves the tip by more than that allows.
"""

from __future__ import annotations

import math
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

import rod
import yaml
from ours import Ours

if TYPE_CHECKING:
    import numpy as np

    from viscodesign.results.motion_arrays import MotionArrays
    from viscodesign.scene.scene import Scene

MODULUS, HEIGHT, WIDTH, SOLID = 1.8e6, 0.03, 0.02, 0.47
"""Of the body: Young's modulus [Pa], size [m], solid part [1]."""
PRESSURE = 1e3
"""At the largest curvature [Pa]."""
RELEASES = [
    (4, 1e-2),
    (8, 1e-4),
    (12, 1e-5),
    (16, 1e-5),
    (12, 1e-6),
    (12, 3e-7),
    (16, 1e-7),
    (32, 1e-7),
]
CYCLES = [(4, 1e-2), (4, 1e-3), (5, 5e-4), (6, 3e-4), (8, 1e-4), (16, 1e-5), (32, 1e-6)]
"""Edges and tolerance, refined together."""


def spec(case: rod.RodCase) -> dict[str, Any]:
    """The spec, in SI."""
    inertia = WIDTH * HEIGHT**3 / 12
    return {
        "name": case.name,
        "actuator": {
            "length": rod.LENGTH,
            "height": HEIGHT,
            "width": WIDTH,
            "youngs_modulus": MODULUS,
            "density": rod.MASS_PER_LENGTH / (HEIGHT * WIDTH * SOLID),
            "solid_fraction": SOLID,
            "extension_factor": rod.EXTENSION_STIFFNESS / (MODULUS * HEIGHT * WIDTH),
            "bending_factor": rod.BENDING_STIFFNESS / (MODULUS * inertia),
            "damping_time": 0.0,
        },
        "bellows": {
            "count": 2,
            "height": 0.01,
            "width": 0.012,
            "length": 0.018,
            "area_per_pressure": 3.413e-9,
            "angle_per_pressure": rod.CURVATURE * rod.LENGTH * MODULUS / PRESSURE,
            "extension_per_pressure": 0.0,
        },
        "network": {
            "layout": "custom",
            "tube_radius": 1e-3,
            "tubes": [{"from": "inlet", "to": "L1", "length": 0.01}],
        },
        "fluid": "water",
        "input": _input(case),
        "loads": {"gravity": {"acceleration": case.gravity, "tilt": math.pi / 2}},
        "effects": {"inertia": True, "gravity": case.gravity > 0.0, "others": False},
        "run": {
            "duration": case.duration,
            "output_interval": float(case.times[1]),
            "start": "rest",
        },
    }


def _input(case: rod.RodCase) -> dict[str, Any]:
    if math.isinf(case.period):
        return {"kind": "constant", "value": 0.0}
    half, quarter = PRESSURE / 2, math.pi / 2
    swing = {"amplitude": half, "frequency": 1 / case.period, "phase": -quarter}
    return {"kind": "sine", "mean": half, **swing}


class Viscodesign(Ours):
    """One of its solvers."""

    inertia = "on"

    def __init__(self, case: rod.RodCase) -> None:
        self.case = case

    def ladder(self) -> list[dict[str, Any]]:
        pairs = CYCLES if self.case.gravity == 0.0 else RELEASES
        return [{"edges_per_section": edges, "tolerance": tol} for edges, tol in pairs]

    def scene(self, *more: str) -> Scene:
        from viscodesign import load

        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"{self.case.name}.yaml"
            path.write_text(yaml.safe_dump(spec(self.case), sort_keys=False))
            return load(path, [f"effects.inertia={self.inertia}", *more])

    def values(self, motion: MotionArrays) -> np.ndarray:
        return motion.tip[:, :2]


class Idas(Viscodesign):
    """BDF of IDAS."""

    name = "viscodesign (IDAS)"
    solver = "idas"


class Rosenbrock(Viscodesign):
    """Rodas5P."""

    name = "viscodesign (Rodas5P)"
    solver = "rosenbrock"


class Called(Viscodesign):
    """Asked for an accuracy; effects, mesh, tolerance and solver are the program's choice."""

    name = "viscodesign (by accuracy)"
    solver = None
    inertia = "auto"
