"""Scenes for tests: the paper's leg with single keys changed."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from viscodesign import Scene, load
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.simulation.build_problem import build, suggest_settings
from viscodesign.solve.problem import Problem

ROOT = Path(__file__).parent.parent
CONFIGS = ROOT / "configs"
ROBOT_SPECS = (CONFIGS / "hexapod.yaml",)
SEVERAL_SPECS = (CONFIGS / "three_legs.yaml", CONFIGS / "two_legs.yaml")
ACTUATOR_SPECS = sorted({*CONFIGS.glob("*.yaml")} - {*ROBOT_SPECS, *SEVERAL_SPECS})
"""Bundled specs of one actuator."""
DATA = Path(__file__).parent / "validation" / "data"

LEG_MASS_PER_LENGTH = 0.03 * 0.02 * 0.47 * 950
LEG_EI = 1.8e6 * 0.02 * 0.03**3 / 12 * 0.55
LEG_EA = 1.8e6 * 0.03 * 0.02 * 0.53
LEG_LENGTH = 0.109
STILL = "input={kind: constant, value: 0}"
STATIC = "effects={gravity: auto, others: off}"


def leg(*overrides: str, config: str = "leg_16_straight_air") -> Scene:
    """A bundled scene with overrides 'key=value'."""
    return load(CONFIGS / f"{config}.yaml", overrides)


def problem_of(scene: Scene) -> Problem:
    """A scene's equations with the effects and the settings that it calls for."""
    quantities = SceneQuantities(scene)
    effects = select_effects(quantities).effects
    return build(quantities, effects, suggest_settings(quantities, effects))


def reference(name: str) -> dict[str, Any]:
    """One of the reference files in `validation/data`."""
    return dict(json.loads((DATA / f"{name}.json").read_text()))


def chain_order(sections: int) -> list[str]:
    """Bellows of a straight chain from the inlet on."""
    numbers = range(1, sections + 1)
    return [f"R{j}" for j in numbers] + [f"L{j}" for j in reversed(numbers)]


def in_order(pressure: np.ndarray, bellows: tuple[str, ...], order: list[str]) -> np.ndarray:
    """Columns of a pressure table in another order of the bellows."""
    return pressure[:, [bellows.index(name) for name in order]]
