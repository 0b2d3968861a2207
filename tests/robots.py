"""Robots for tests: the bundled hexapod with single keys changed."""

from __future__ import annotations

import itertools
from typing import Any

import yaml

from tests.scenes import CONFIGS
from viscodesign import RobotScene, load_robot

HEXAPOD = CONFIGS / "hexapod.yaml"
TEXT = HEXAPOD.read_text(encoding="utf-8")


def hexapod(*overrides: str) -> RobotScene:
    """The bundled robot with overrides 'key=value'."""
    return load_robot(HEXAPOD, overrides)


def keys() -> dict[str, Any]:
    """Its keys as plain data."""
    found: dict[str, Any] = yaml.safe_load(TEXT)
    return found


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
