"""The rod by viscodesign: a scene of one section whose left bellow holds the input's pressure.

The network is one short tube into L1; R1 is sealed off, at rest. Pressure distribution,
feedback and damping are off, so L1 follows the inlet at once and the intrinsic curvature
is the pressure times a constant. The extension per pressure is zero.

`prepare` reads the scene and solves it once, as whoever works with it does; measured is
a whole further solution: assembling the system, its equations' numbers, the start, the
steps through time, and reading all outputs and balances.
"""

from __future__ import annotations

import math
import tempfile
from abc import ABC
from collections.abc import Callable
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import rod
import yaml

MODULUS, HEIGHT, WIDTH, SOLID = 1.8e6, 0.03, 0.02, 0.47
"""Of the body: Young's modulus [Pa], size [m], solid part [1]."""
PRESSURE = 1e3
"""At the largest curvature [Pa]."""
RELEASES = [
    (4, 1e-2),
    (4, 1e-3),
    (8, 1e-3),
    (8, 1e-4),
    (16, 1e-4),
    (16, 1e-5),
    (32, 1e-6),
    (64, 1e-7),
]
CYCLES = [(4, 1e-2), (4, 1e-3), (8, 1e-4), (16, 1e-5), (32, 1e-6), (64, 1e-7)]
"""Edges and tolerance, refined together."""


def scene(case: rod.RodCase) -> dict[str, Any]:
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


class Viscodesign(ABC):
    """One of its solvers."""

    name: ClassVar[str]
    solver: ClassVar[str]

    def __init__(self, case: rod.RodCase) -> None:
        self.case = case

    def settings(self) -> list[dict[str, Any]]:
        """Meshes and tolerances, coarse to fine."""
        ladder = CYCLES if self.case.gravity == 0.0 else RELEASES
        return [{"edges_per_section": edges, "tolerance": tol} for edges, tol in ladder]

    def prepare(self, setting: dict[str, Any]) -> Callable[[], np.ndarray]:
        """Read, choose, and solve once."""
        from viscodesign import load
        from viscodesign.build import Settings
        from viscodesign.effects.conditions import Conditions
        from viscodesign.effects.select import select_effects
        from viscodesign.solving import solve

        with tempfile.TemporaryDirectory() as folder:
            spec = Path(folder) / f"{self.case.name}.yaml"
            spec.write_text(yaml.safe_dump(scene(self.case), sort_keys=False))
            conditions = Conditions(load(spec))
        effects = select_effects(conditions).effects
        settings = Settings(**setting, solver=self.solver)

        def run() -> np.ndarray:
            found = solve(conditions, effects, settings)
            if not found.is_complete:
                raise RuntimeError(str(found.motion.failure))
            return found.motion.tip[:, :2]

        run()
        return run


class Idas(Viscodesign):
    """BDF of IDAS."""

    name = "viscodesign (IDAS)"
    solver = "idas"


class Rosenbrock(Viscodesign):
    """Rodas5P."""

    name = "viscodesign (Rodas5P)"
    solver = "rosenbrock"
