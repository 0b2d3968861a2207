"""Hard cases of the network: time scales, contrasts, jumps, sealed and branching parts."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tests.hard.case import EXACT, Case, Finding, at_most
from viscodesign import Trajectory

ONE_WAY = "effects={pressure_distribution: on, others: off}"


def air(viscosity: str = "2e-5") -> str:
    """A fluid with the viscosity of the references."""
    return f"fluid={{name: thin air, viscosity: {viscosity}, density: 1.2}}"


def pressures_at(run: Trajectory, time: float, **wanted: float) -> Iterator[Finding]:
    """Pressures of named bellows at one time, to 1e-6 of the inlet's swing."""
    row = int(np.argmin(np.abs(run.time - time)))
    swing = float(np.ptp(np.concatenate([p for p in run.inlet_pressure.values()])))
    for name, value in wanted.items():
        found = run.pressure[row, run.bellows.index(name)]
        yield Finding(f"p {name}({time:g} s)", float(found), value, 1e-6 * max(swing, abs(value)))


CASES: tuple[Case, ...] = (
    Case(
        "1a",
        "viscosity 2e-11 Pa s",
        "p_L1(0.5 s) as the inlet's; steps set by the input",
        (ONE_WAY, air("2e-11"), EXACT),
        lambda run: [
            *pressures_at(run, 0.5, L1=-30239.307099),
            at_most("steps", run.cost.steps, 2000),
        ],
    ),
)
