"""A silicone arm that was recorded by others: at rest under eight pressures, and on its way."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from fitted import fitted

from viscodesign import Scene, Trajectory, load, simulate
from viscodesign.results.coefficient_band import COVERAGE_FACTOR

SPEC = Path(__file__).parent / "validation" / "arm.yaml"
PRESSURES = (100, 150, 200, 250, 300, 350, 400, 450)
"""In the names of the recordings [mbar]."""
SEGMENT_PRESSURES = (200, 300, 400)
ARM_FITTED = (100, 150, 200)
"""By which the linear law is fitted [mbar]."""
CURVE_FROM = (100, 200, 300, 450)
"""Those that give the measured curve [mbar]."""
STEP_TIP, SEGMENT_TIP = slice(4, 7), slice(0, 4)
"""Markers m5 to m7, m1 to m4."""
STILL_ROWS = 20
"""Rows before the first movement."""
HELD, BEGUN = 0.8, 0.05
"""Parts of the largest movement from which on the pressure acts, and the tip has started."""
LAST = 0.5
"""Before it is let go, the time in which the arm counts as at rest [s]."""
FIRST = 1.0
"""Time after the step in which motions are compared [s]."""
ANGLE = "bellows.angle_per_pressure"
PASCAL_PER_MBAR = 100.0
WITHIN = 0.05
"""Relative deviation up to which a law is said to hold."""
SMALL_AREA = 1e-12
"""Area per pressure of the scene, which has next to no fluid [m2/Pa]."""
CURVE_SPREAD = {"actuator.length": "2 mm", "inputs.chamber.value": "5 %"}


@dataclass(frozen=True, eq=False)
class Recorded:
    """How far the tip of one recording is from where it was without pressure."""

    name: str
    pressure: int
    """[mbar]"""
    time: np.ndarray
    """(T,) since the step [s]."""
    moved: np.ndarray
    """(T,) [m]"""
    rest: float
    """At the end of the step [m]."""


def recordings(folder: Path) -> list[Recorded]:
    """All steps, then all segments."""
    steps = [_recorded(folder / f"step_{own}mbar.csv", own, STEP_TIP) for own in PRESSURES]
    names = ((folder / f"segment_{own}mbar.csv", own) for own in SEGMENT_PRESSURES)
    return [*steps, *(_recorded(file, own, SEGMENT_TIP) for file, own in names)]


def _recorded(file: Path, pressure: int, markers: slice) -> Recorded:
    rows = np.loadtxt(file, delimiter=",", skiprows=1)
    time, tip = rows[:, 0], rows[:, 1:].reshape(len(rows), -1, 3)[:, markers].mean(axis=1)
    moved = np.linalg.norm(tip - tip[:STILL_ROWS].mean(axis=0), axis=1)
    end = time[np.flatnonzero(moved > HELD * moved.max())[-1]] - 2 * LAST / 10
    rest = float(np.median(moved[(time > end - LAST) & (time <= end)]))
    half = np.flatnonzero(moved > rest / 2)[0]
    begin = time[np.flatnonzero(moved[:half] < BEGUN * rest)[-1]]
    return Recorded(file.stem, pressure, time - begin, moved, rest)


# -- the model ---------------------------------------------------------------------


def moved_by(run: Trajectory, scene: Scene) -> np.ndarray:
    """(T,) How far the tip is from its place without pressure [m]."""
    return np.asarray(np.hypot(run.tip[:, 0], run.tip[:, 1] - scene.actuator.length))


def run_at(scene: Scene, pressure: int, *, verify: bool = True) -> Trajectory:
    """The scene under a pressure [mbar]."""
    own = scene.replace({"inputs.chamber.value": PASCAL_PER_MBAR * pressure})
    run = simulate(own, verify=verify, uncertainty=verify)
    if run.status != "complete":
        raise RuntimeError(f"{pressure} mbar: {run.failure}")
    return run


def _resting(scene: Scene, angle: float, pressure: int) -> float:
    own = scene.replace({ANGLE: angle})
    return float(moved_by(run_at(own, pressure, verify=False), own)[-1])


def _fitted_angle(scene: Scene, measured: Sequence[Recorded]) -> float:
    """[rad] By which the linear law is nearest to some recordings."""

    def left(unknown: np.ndarray) -> np.ndarray:
        found = [_resting(scene, float(unknown[0]), own.pressure) - own.rest for own in measured]
        return 1e3 * np.array(found)

    return float(fitted(left, [2.0], [0.3], [12.0])[0])


def fitted_scenes(steps: Sequence[Recorded]) -> tuple[float, Scene, Scene]:
    """The angle of the linear law [rad], its scene, and that of a measured curve."""
    scene = load(SPEC)
    angle = _fitted_angle(scene, [own for own in steps if own.pressure in ARM_FITTED])
    rows = [_curve_row(-50, -1e-3), _curve_row(0, 0.0)]
    for own in steps:
        if own.pressure in CURVE_FROM:
            turned = _fitted_angle(scene, [own]) * PASCAL_PER_MBAR * own.pressure
            rows.append(_curve_row(own.pressure, turned / scene.actuator.youngs_modulus))
    curved = scene.replace({"bellows.curve": {"rows": rows}, "uncertainty": CURVE_SPREAD})
    return angle, scene.replace({ANGLE: angle}), curved


def _curve_row(pressure: int, angle: float) -> list[float]:
    """Pressure, area, angle and extension [Pa, m2, rad, m]."""
    own = PASCAL_PER_MBAR * pressure
    return [own, SMALL_AREA * own, angle, 0.0]


# -- tables ------------------------------------------------------------------------


def arm_rest_rows(
    measured: Sequence[Recorded], scene: Scene, used: Sequence[int], word: str
) -> list[tuple[str, ...]]:
    """Places of rest, measured and computed, one row a recording."""
    rows = []
    for own in measured:
        run = run_at(scene, own.pressure)
        model, half = float(moved_by(run, scene)[-1]), _half_width(run, scene)
        off, error = model / own.rest - 1, run.accuracy.estimated_tip_error_m
        is_used = own.pressure in used and own.name.startswith("step")
        held = "holds" if abs(model - own.rest) <= half else "misses"
        rows.append(
            (f"`{own.name}`", word if is_used else "predicted", f"{1e3 * own.rest:.2f} mm",
             f"{1e5 * own.rest / own.pressure:.2f} mm", f"{1e3 * model:.2f} mm",
             f"{100 * off:+.1f} %", f"±{1e3 * half:.2f} mm, {held}",
             "unknown" if error is None else f"{1e3 * error:.2g} mm",
             "yes" if abs(off) <= WITHIN else "no")
        )  # fmt: skip
    return rows


ARM_HEAD = (
    "recording", "used", "measured", "measured, per 100 mbar", "computed", "off", "its 95 % band",
    "numerical error", "within 5 %",
)  # fmt: skip


def _half_width(run: Trajectory, scene: Scene) -> float:
    """Half of the 95 % band along the movement, at the end [m]."""
    assert run.uncertainty is not None, run.warnings
    xx, zz, xz = run.uncertainty.covariance[-1]
    way = run.tip[-1, :2] - np.array([0.0, scene.actuator.length])
    x, z = way / np.linalg.norm(way)
    return COVERAGE_FACTOR * float(np.sqrt(x * x * xx + z * z * zz + 2 * x * z * xz))


def motion_rows(measured: Sequence[Recorded], scene: Scene) -> list[tuple[str, ...]]:
    """The first second after the step, by the measured curve."""
    moving = scene.replace(
        {"run.start": "rest", "run.duration": FIRST, "run.output_interval": 0.005}
    )
    rows = []
    for own in measured:
        run = run_at(moving, own.pressure, verify=False)
        model = moved_by(run, moving)
        known = (own.time >= 0.0) & (own.time <= FIRST)
        apart = own.moved[known] - np.interp(own.time[known], run.time, model)
        rms, seen = float(np.sqrt(np.mean(apart**2))), own.moved[known]
        first = float(seen[-1])
        rows.append(
            (f"`{own.name}`", f"{1e3 * rms:.2f} mm, {100 * rms / float(np.ptp(seen)):.0f} %",
             f"{1e3 * _rise(own.time[known], seen):.0f} / {1e3 * _rise(run.time, model):.0f} ms",
             f"{100 * (seen.max() / first - 1):.0f} / {100 * (model.max() / model[-1] - 1):.0f} %",
             f"{100 * (own.rest / first - 1):+.0f} %")
        )  # fmt: skip
    return rows


MOTION_HEAD = (
    "recording", "rms, of the swing", "rise from 10 to 90 %", "overshoot",
    "moves on after the first second",
)  # fmt: skip


def _rise(time: np.ndarray, moved: np.ndarray) -> float:
    """Time between a tenth and nine tenths of where it is at the end [s]."""
    first, last = (time[np.flatnonzero(moved >= part * moved[-1])[0]] for part in (0.1, 0.9))
    return float(last - first)
