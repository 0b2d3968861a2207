"""Runs at the edges of what a picture meets."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tests.trajectories import made_run, with_two_inlets
from viscodesign.results.trajectory import Trajectory


def _cycles(time: np.ndarray) -> np.ndarray:
    return 2e4 + 5e4 * np.sin(2 * np.pi * 0.7 * time)


def _two_inlets() -> Trajectory:
    return with_two_inlets(made_run(), -0.5, name="two_inlets")


CASES: dict[str, Callable[[], Trajectory]] = {
    "leg": made_run,
    "one_time": lambda: made_run(time=np.zeros(1), inlet=lambda t: 0 * t + 2e4),
    "two_times": lambda: made_run(time=np.array([0.0, 0.5])),
    "two_bellows": lambda: made_run(bellows=2, lag=0.5),
    "thin_air": lambda: made_run(bellows=2, ambient_pressure=6e4),
    "many_bellows": lambda: made_run(bellows=128, lag=0.001),
    "all_equal": lambda: made_run(inlet=lambda t: 0 * t + 3e4),
    "all_zero": lambda: made_run(inlet=lambda t: 0 * t),
    "turns": lambda: made_run(bending=60.0, name="several_turns"),
    "long": lambda: made_run(time=np.linspace(0, 200, 20001), inlet=_cycles, name="long_run"),
    "far_above": lambda: made_run(inlet=lambda t: 1.4e5 + 0.1 * pulse_about_zero(t)),
    "tiny": lambda: made_run(time=np.linspace(0, 1e-9, 30), inlet=lambda t: 1e5 * (t > 0)),
    "two_inlets": _two_inlets,
    "failed": lambda: made_run(
        time=np.linspace(0, 1.23, 62),
        status="failed",
        failure="pressure R3: no step small enough was found at t = 1.23 s (residual 3.1e+02). "
        "Ask for less accuracy, or give the actuator a damping_time.",
    ),
    "interrupted": lambda: made_run(time=np.linspace(0, 1.23, 62), status="interrupted"),
    "strange_name": lambda: made_run(
        name="cost $a_{1 of $2\n\N{CJK UNIFIED IDEOGRAPH-8173} \N{PILE OF POO} " + "x" * 200
    ),
}


def pulse_about_zero(time: np.ndarray) -> np.ndarray:
    """One swing of about 1 bar [Pa]."""
    return 1e5 * np.sin(2 * np.pi * time / 4)
