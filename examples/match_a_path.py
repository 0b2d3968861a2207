"""Which tubes make the tip follow a path? Lengths and pulse found by exact derivatives.

The wanted path was made by other tubes and another pulse, so that the answer is known.
Run it from anywhere: python examples/match_a_path.py
"""

from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import least_squares

from viscodesign import compile, load

SPEC = Path(__file__).parent.parent / "configs" / "leg_16_straight_air.yaml"
FREE = ["network.tubes[*].length", "input.drop", "input.fall_time"]

scene = load(SPEC, ["run.output_interval=100 ms"])
tip = compile(scene, FREE, ["tip_x_m", "tip_z_m"])
answer = tip.values * np.linspace(1.4, 0.8, len(tip.values))
wanted = tip(answer)


def stacked(parts: dict[str, Any]) -> np.ndarray:
    """Both coordinates below each other, in millimetres."""
    return 1e3 * np.concatenate([parts["tip_x_m"], parts["tip_z_m"]])


found = least_squares(
    lambda factors: stacked(tip(factors * tip.values)) - stacked(wanted),
    np.ones(len(tip.values)),
    jac=lambda factors: stacked(tip.jacobian(factors * tip.values)) * tip.values,
    bounds=(0.5, 2.0),
    max_nfev=30,
)
rms = np.sqrt(np.mean(found.fun**2))
print(f"{found.nfev} evaluations, {found.njev} Jacobians, distance {rms:.2g} mm rms")
print("key                             found    answer")
for name, value, known in zip(tip.names, found.x * tip.values, answer, strict=True):
    print(f"{name:30} {value:8.4g}  {known:8.4g}")
print(f"the same effects suit the answer: {tip.judge(found.x * tip.values).suits}")
