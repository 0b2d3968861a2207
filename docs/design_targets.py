"""Ten paths for the tip of the paper's leg, and what of the leg is free to follow each."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

MM = 1e-3
OIL = {"name": "oil", "viscosity": "0.06 Pa*s", "density": "950 kg/m^3", "bulk_modulus": "1.6 GPa"}
LEG = {"network.tube_radius": "0.9 mm", "loads.gravity": "off"}
LENGTHS = {"network.tubes[*].length": ["20 mm", "600 mm"]}
RADIUS = {"network.tube_radius": ["0.3 mm", "1.2 mm"]}
LIMITS = ["-25 kPa", "30 kPa"]
LOOP_INPUT = {"harmonics": 6, "period": ["5 s", "400 s"], "limits": LIMITS}
TURN = np.linspace(0.0, 2 * np.pi, 97)
ROWS = 9
"""Free rows of an input that is a table."""


@dataclass(frozen=True, eq=False)
class DesignTarget:
    """A path, and what is free."""

    name: str
    words: str
    """What is free, in words."""
    free: Mapping[str, Any]
    path: Mapping[str, Any]
    """As `target` of a task has it."""
    tolerance: str = "0.15 mm"
    changes: Mapping[str, Any] = field(default_factory=lambda: {"fluid": OIL})
    """Of the leg, where the search starts."""


def loop(x: np.ndarray, z: np.ndarray) -> dict[str, Any]:
    """A closed path of these places [mm]."""
    return {"rows": (MM * np.column_stack([x, z])).tolist(), "closed": True}


def circle(radius: float, height: float, sense: int) -> dict[str, Any]:
    """A circle about (0, height) [mm]; counter-clockwise, z up, for a positive sense."""
    return loop(radius * np.cos(TURN), height + sense * radius * np.sin(TURN))


def letter_d() -> dict[str, Any]:
    """A bow of 8 by 10 mm and its string, clockwise."""
    bow = np.linspace(np.pi / 2, -np.pi / 2, 40)
    x = [-4.0, *(-4 + 8 * np.cos(bow)), -4.0, -4.0]
    return loop(np.array(x), 111 + np.array([5.0, *(5 * np.sin(bow)), -5.0, 5.0]))


def letter_c() -> dict[str, Any]:
    """Three quarters of a circle of 8 mm, open to the right, from its upper end."""
    angle = np.linspace(-np.pi / 4, -7 * np.pi / 4, 60)
    x, z = 4 * np.cos(angle), 111 + 4 * np.sin(angle)
    return {"rows": (MM * np.column_stack([x, z])).tolist(), "closed": False}


def stride() -> dict[str, Any]:
    """A foot's: 12 mm back along the ground, and forth 3 mm above it (z points down to it)."""
    ground = np.linspace(-6.0, 6.0, 40)
    swing = np.linspace(0.0, np.pi, 40)[1:]
    x = np.concatenate([ground, 6 * np.cos(swing)])
    return loop(x, 113 - np.concatenate([np.zeros(40), 3 * np.sin(swing)]))


def points_at_times() -> dict[str, Any]:
    """Three places, each at its time."""
    rows = [[2.0, 10.0, 109.0], [5.0, -4.0, 108.0], [9.0, 6.0, 112.0]]
    return {"rows": [[t, MM * x, MM * z] for t, x, z in rows]}


PULSE_ROWS = {f"input.rows[{k}].pressure": LIMITS for k in range(1, ROWS + 1)}


def from_rest(duration: float, fluid: Any, radius: str) -> dict[str, Any]:
    """The leg at rest without pressure, for so long [s]; the rows of its input are free."""
    rows = [[float(t), 0.0] for t in np.linspace(0.0, duration, ROWS + 1)]
    return {
        "fluid": fluid,
        "network.tube_radius": radius,
        "input": {"kind": "table", "rows": rows},
        "run": {"duration": duration, "output_interval": duration / 100, "start": "rest"},
    }


TARGETS = (
    DesignTarget(
        "circle, clockwise", "lengths, radius, input",
        {**LENGTHS, **RADIUS, "input": LOOP_INPUT}, circle(4, 111, -1),
    ),
    DesignTarget(
        "circle, counter-clockwise", "lengths, radius, input",
        {**LENGTHS, **RADIUS, "input": LOOP_INPUT}, circle(4, 111, 1),
    ),
    DesignTarget(
        "the same, other chains allowed", "lengths, radius, input, chain",
        {**LENGTHS, **RADIUS, "network.graph": "chain", "input": LOOP_INPUT}, circle(4, 111, 1),
    ),
    DesignTarget(
        "ellipse in water", "lengths, radius, input",
        {**LENGTHS, **RADIUS, "input": LOOP_INPUT},
        loop(8 * np.cos(TURN), 111 - 3 * np.sin(TURN)), changes={"fluid": "water"},
    ),
    DesignTarget(
        "letter D", "lengths, input, tree",
        {**LENGTHS, "network.graph": "tree", "input": LOOP_INPUT}, letter_d(),
    ),
    DesignTarget(
        "letter C, open", "lengths, pressure at nine times",
        {**LENGTHS, **PULSE_ROWS}, letter_c(), changes=from_rest(90.0, OIL, "0.9 mm"),
    ),
    DesignTarget(
        "eight, standing", "lengths, input, tree",
        {**LENGTHS, "network.graph": "tree", "input": {**LOOP_INPUT, "harmonics": 8}},
        loop(3 * np.sin(2 * TURN), 111 + 6 * np.cos(TURN)), tolerance="0.6 mm",
    ),
    DesignTarget(
        "three points at 2, 5 and 9 s", "pressure at nine times", PULSE_ROWS,
        points_at_times(), tolerance="0.2 mm", changes=from_rest(9.0, "air", "0.325 mm"),
    ),
    DesignTarget(
        "stride of a foot", "lengths, radius, input, chain",
        {**LENGTHS, **RADIUS, "network.graph": "chain", "input": LOOP_INPUT}, stride(),
        tolerance="0.3 mm",
    ),
    DesignTarget(
        "circle that is too far", "lengths, radius, input",
        {**LENGTHS, **RADIUS, "input": LOOP_INPUT}, circle(4, 150, -1),
    ),
)  # fmt: skip
