"""Overrides and criteria that the rod's hard cases share."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tests.hard.case import Finding, Judge, at_most
from tests.scenes import LEG_EI, LEG_LENGTH, leg
from tests.validation.rc_network import columns
from viscodesign import Trajectory, simulate

L, EI = LEG_LENGTH, LEG_EI
CRITICAL = np.pi**2 / 4 * EI / L**2
"""Euler's load of an inextensible cantilever [N]."""
PER_PASCAL = 8 * 10.266 / 1.8e6
"""Angle of all sections per pressure of the left bellows above the right ones [rad/Pa]."""
FINE = "accuracy=0.01 %"
"""Settings for long vibrations."""
STATIC = "effects={gravity: auto, others: off}"
IN_MOTION = "effects={gravity: auto, inertia: auto, damping: auto, others: off}"
UNDAMPED = "effects={inertia: on, gravity: auto, others: off}"
COUPLED = (
    "effects={pressure_distribution: on, inertia: on, feedback: on, gravity: auto, others: off}"
)
SHORT = "run={duration: 1 s, output_interval: 0.5 s}"
STILL = "input={kind: constant, value: 0}"
INEXTENSIBLE = "actuator.extension_factor=1e6"
DENSITY = f"actuator.density={0.269 / (0.03 * 0.02 * 0.47)!r}"
"""As in the references: 0.269 kg/m, the paper's rounded mass per length."""
PULSE = "run={duration: 2 s, output_interval: 0.05 s}"


def stiffness_ratio(eta: float) -> str:
    """Extension factor with which EA L2/EI is ``eta``."""
    return f"actuator.extension_factor={eta * EI / (L**2 * 1.8e6 * 0.03 * 0.02)!r}"


def compressed(load: float, aside: float = 1e-3) -> tuple[str, ...]:
    """A column under a multiple of Euler's load, with an imperfection in EI/L2."""
    force = f"loads.tip_force={{x: {aside * EI / L**2!r}, z: {-load * CRITICAL!r}}}"
    return STILL, STATIC, SHORT, force


def bent(*points: tuple[float, float]) -> tuple[str, ...]:
    """Intrinsic curvature times length against time, without extension."""

    def table(sign: float) -> str:
        rows = ", ".join(f"[{t!r} s, {sign * angle / PER_PASCAL / 2!r}]" for t, angle in points)
        return f"{{kind: table, rows: [{rows}]}}"

    return columns(16, table(1.0), table(-1.0))


def tip(run: Trajectory, allowed: float, **wanted: float) -> Iterator[Finding]:
    """The last tip, in lengths of the rod: x, z, and phi in rad."""
    for name, value in wanted.items():
        column = ("x", "z", "phi").index(name)
        found = run.tip[-1, column] / (1.0 if name == "phi" else L)
        yield Finding(f"tip {name}", float(found), value, allowed)


def tip_at(run: Trajectory, time: float, allowed: float, **wanted: float) -> Iterator[Finding]:
    """The tip at one time [m]."""
    row = int(np.argmin(np.abs(run.time - time)))
    for name, value in wanted.items():
        found = float(run.tip[row, ("x", "z").index(name)])
        yield Finding(f"tip {name}({time:g} s)", found, value, allowed)


def as_stated(run: Trajectory) -> float:
    """The error that a run states, in lengths."""
    return (run.accuracy.estimated_tip_error_m or 0.0) / L


def same_without(*changes: str) -> Judge:
    """The tip is as in a scene without an effect, to both stated errors."""

    def judge(run: Trajectory) -> Iterator[Finding]:
        other = simulate(leg(*changes))
        apart = np.max(np.hypot(*(run.tip[:, :2] - other.tip[:, :2]).T)) / L
        yield at_most("tip apart, in lengths", float(apart), as_stated(run) + as_stated(other))

    return judge
