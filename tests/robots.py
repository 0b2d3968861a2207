"""Robots for tests: the bundled hexapod with single keys changed."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import yaml

from tests.scenes import CONFIGS
from viscodesign import RobotScene, load_robot
from viscodesign.results.robot_motion import RobotMotion
from viscodesign.robot.build_robot import build_robot
from viscodesign.robot.march import RecordedWalk, StepPlan, march
from viscodesign.robot.walk import start_state

HEXAPOD = CONFIGS / "hexapod.yaml"
TEXT = HEXAPOD.read_text(encoding="utf-8")


def hexapod(*overrides: str) -> RobotScene:
    """The bundled robot with overrides 'key=value'."""
    return load_robot(HEXAPOD, overrides)


def moved(scene: RobotScene, per_cycle: int, cycles: int) -> RobotMotion:
    """The motion of a robot with a given step."""
    return recorded(scene, per_cycle, cycles).motion


def keys() -> dict[str, Any]:
    """Its keys as plain data."""
    found: dict[str, Any] = yaml.safe_load(TEXT)
    return found


def recorded(scene: RobotScene, per_cycle: int, cycles: int) -> RecordedWalk:
    """The motion of a robot with a given step, as `walk` solves it."""
    model, period = build_robot(scene), scene.period or 0.0
    sources = list(scene.sources.values())

    def pressures(times: np.ndarray) -> np.ndarray:
        return scene.gauge_pressure + np.column_stack([s.values(times) for s in sources])

    plan = StepPlan(period, per_cycle, cycles, per_cycle)
    return march(model, start_state(scene, model), pressures, plan)


def mirrored() -> RobotScene:
    """The hexapod with front and back swapped: hips, leans, and the columns of its legs."""
    data = keys()
    network = data["actuators"]["leg"]["network"]
    sections = range(1, 9)
    chain = ["inlet", *(f"L{j}" for j in sections), *(f"R{j}" for j in reversed(sections))]
    network |= {
        "layout": "custom",
        "tubes": [{"from": a, "to": b} for a, b in itertools.pairwise(chain)],
    }
    for name, leg in data["robot"]["legs"].items():
        data["robot"]["legs"][name] = {
            **leg,
            **_mirrored(leg, "x", "mm"),
            **_mirrored(leg, "lean", "deg"),
        }
    return load_robot(data)


def _mirrored(leg: dict[str, str], key: str, unit: str) -> dict[str, str]:
    return {key: f"{-float(leg[key].split()[0])} {unit}"}
