"""A silicone arm that was recorded by others, at rest under eight pressures."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from fitted import fitted

from viscodesign import Scene, load, simulate

SPEC = Path(__file__).parent / "validation" / "arm.yaml"
PRESSURES = (100, 150, 200, 250, 300, 350, 400, 450)
"""In the names of the recordings [mbar]."""
FITTED = (100, 150, 200)
TIP = slice(4, 7)
"""Markers m5 to m7."""
STILL_ROWS = 20
"""Rows before the first movement."""
HELD = 0.8
"""Part of the largest movement from which on the pressure acts."""
LAST = 0.5
"""Before it is let go, the time in which the arm counts as at rest [s]."""
ANGLE = "bellows.angle_per_pressure"
PASCAL_PER_MBAR = 100.0
WITHIN = 0.05
"""Relative deviation up to which the linear law is said to hold."""


def deflections(folder: Path) -> dict[int, float]:
    """How far the tip stands from where it was without pressure [m], by pressure [mbar]."""
    return {own: _deflection(folder / f"step_{own}mbar.csv") for own in PRESSURES}


def _deflection(file: Path) -> float:
    rows = np.loadtxt(file, delimiter=",", skiprows=1)
    time, tip = rows[:, 0], rows[:, 1:].reshape(len(rows), -1, 3)[:, TIP].mean(axis=1)
    moved = np.linalg.norm(tip - tip[:STILL_ROWS].mean(axis=0), axis=1)
    end = time[np.flatnonzero(moved > HELD * moved.max())[-1]] - 2 * LAST / 10
    return float(np.median(moved[(time > end - LAST) & (time <= end)]))


def predicted(scene: Scene, angle: float, pressure: int) -> float:
    """The same of the model, whose bellow turns by ``angle`` [rad] per pressure over modulus."""
    own = scene.replace({ANGLE: angle, "inputs.chamber.value": PASCAL_PER_MBAR * pressure})
    run = simulate(own, verify=False)
    if run.status != "complete":
        raise RuntimeError(f"{pressure} mbar: {run.failure}")
    return float(np.hypot(run.tip[-1, 0], run.tip[-1, 1] - scene.actuator.length))


def arm_rows(folder: Path) -> tuple[list[tuple[str, ...]], float]:
    """One row a pressure, and the fitted angle [rad]."""
    scene, measured = load(SPEC), deflections(folder)

    def left(unknown: np.ndarray) -> np.ndarray:
        found = [predicted(scene, float(unknown[0]), own) - measured[own] for own in FITTED]
        return 1e3 * np.array(found)

    angle = float(fitted(left, [1.0], [0.3], [8.0])[0])
    rows = []
    for own, moved in measured.items():
        model = predicted(scene, angle, own)
        off = model / moved - 1
        use = "fitted" if own in FITTED else "predicted"
        verdict = "yes" if abs(off) <= WITHIN else "no"
        rows.append(
            (f"{own} mbar", use, f"{1e3 * moved:.2f} mm", f"{1e3 * moved / own * 100:.2f} mm",
             f"{1e3 * model:.2f} mm", f"{100 * off:+.0f} %", verdict)
        )  # fmt: skip
    return rows, angle


ARM_HEAD = (
    "pressure", "used", "measured", "measured, per 100 mbar", "linear law", "off", "within 5 %",
)  # fmt: skip
