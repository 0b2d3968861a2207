"""A run that nobody had to solve: a chain of bellows that lag, on arcs of constant curvature."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np

from viscodesign.results.findings import Classification, EffectAblation, Notice, Scales, Verdict
from viscodesign.results.trajectory import Accuracy, Cost, Invariants, Trajectory
from viscodesign.scene.reading.write import resolved_yaml
from viscodesign.scene.scene import Scene

LENGTH, WIDTH = 0.109, 0.03
CURVATURE = 10.266 / 1.8e6 / LENGTH
"""Curvature of a section for the difference of its two pressures [1/m/Pa]."""
STRETCH = 0.047 / 1.8e6 / 0.02
"""Extension of a section for the sum of its two pressures, roughly the paper's [1/Pa]."""
POINTS = 8
"""Points of the axis in a section."""
CLASSIFICATION = Classification(
    "leg",
    Scales(t_s=0.029, t_f=0.16, t_i=0.67, t_net=1.1),
    "III",
    "the pressure distribution rules",
    0.14,
)


def pulse(time: np.ndarray) -> np.ndarray:
    """The paper's cycle: from +40 kPa to -100 kPa and back [Pa gauge]."""
    fall, rise = (1 / (1 + np.exp(-13.7 * (time - at))) for at in (0.5, 4.0))
    return np.asarray(40410.0 - 141300.0 * (fall - rise))


def lagged(time: np.ndarray, inlet: np.ndarray, bellows: int, lag: float) -> np.ndarray:
    """Pressures (T, B) of a chain of equal bellows and tubes, along the chain.

    dp/dt = (A p + e_1 u) / lag, exact for an inlet that is linear between the times.
    """
    matrix = np.diag(np.full(bellows, -2.0))
    matrix[-1, -1] = -1.0
    matrix += np.diag(np.ones(bellows - 1), 1) + np.diag(np.ones(bellows - 1), -1)
    rates, modes = np.linalg.eigh(matrix / lag)
    push = modes[0] / lag
    found = np.empty((len(time), bellows))
    found[0] = inlet[0]
    mode = modes.T @ found[0]
    for k, step in enumerate(np.diff(time)):
        slope = (inlet[k + 1] - inlet[k]) / step
        growth = np.exp(rates * step)
        steady = np.expm1(rates * step) / rates
        ramp = (steady - step) / rates
        mode = growth * mode + push * (steady * inlet[k] + ramp * slope)
        found[k + 1] = modes @ mode
    return found


def bent(curvature: np.ndarray, stretch: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Axis (T, K, 2) and angle at the tip (T,) of arcs, from (T, S) curvature and stretch."""
    times, sections = curvature.shape
    fine = np.repeat(curvature, POINTS, axis=1)
    step = LENGTH / sections / POINTS * np.repeat(stretch, POINTS, axis=1)
    turn = fine * LENGTH / sections / POINTS
    angle = np.cumsum(turn, axis=1)
    middle = angle - turn / 2
    # A chord of an arc points to its middle and is shorter than the arc.
    chord = step * np.sinc(turn / 2 / np.pi)
    pieces = np.stack((chord * np.sin(middle), chord * np.cos(middle)), axis=2)
    axis = np.concatenate([np.zeros((times, 1, 2)), np.cumsum(pieces, axis=1)], axis=1)
    return axis, angle[:, -1]


def made_run(
    *,
    bellows: int = 16,
    time: np.ndarray | None = None,
    inlet: Callable[[np.ndarray], np.ndarray] = pulse,
    lag: float = 0.0105,
    bending: float = 1.0,
    **changes: Any,
) -> Trajectory:
    """A run of a straight chain: up the right column, down the left one."""
    times = np.linspace(0.0, 8.0, 401) if time is None else time
    fed = inlet(times)
    chain = lagged(times, fed, bellows, lag)
    sections = bellows // 2
    right, left = chain[:, :sections], chain[:, : sections - 1 : -1]
    axis, angle = bent(bending * CURVATURE * (left - right), 1 + STRETCH * (left + right) / 2)
    names = (*(f"{side}{k + 1}" for side in "RL" for k in range(sections)),)
    tubes = ["inlet", *names[:sections], *reversed(names[sections:])]
    found = Trajectory(
        name="leg_made_up",
        status="complete",
        arrays={
            "time": times,
            "tip": np.column_stack((axis[:, -1], angle)),
            "inlet_pressure": fed[:, None],
            "pressure": np.concatenate([right, left], axis=1),
            "volume": 1e-6 + 6.1434e-11 * np.concatenate([right, left], axis=1),
            "flow": -np.diff(chain, axis=1, prepend=fed[:, None]) / 1.7e8,
            "shape": axis,
        },
        arc=np.linspace(0.0, LENGTH, axis.shape[1]),
        inlets=("inlet",),
        bellows=names,
        tubes=tuple(f"{a}-{b}" for a, b in pairwise(tubes)),
        length=LENGTH,
        width=WIDTH,
        classification=CLASSIFICATION,
        effects=(Verdict("gravity", "auto", False, 0.02, "m g l^3 / (E I)", "0.02 < 0.05"),),
        accuracy=Accuracy(0.000545, None, "not verified"),
        cost=Cost(steps=100),
        invariants=Invariants(volume_imbalance_rel=1e-12),
        warnings=(Notice("cavitation", "the inlet comes near to a vacuum", "inlet", 1.0),),
        spec_text="name: leg_made_up\n",
        spec_sha256="0" * 64,
        version="0.1",
        settings={"edges_per_section": 2, "tolerance": np.float64(1e-4)},
    )
    return replace(found, **changes)


def with_two_inlets(run: Trajectory, factor: float, **changes: Any) -> Trajectory:
    """The run fed from a left inlet and, by a factor of it, from a right one."""
    fed = run["inlet_pressure"] * (1.0, factor)
    fed_twice = run.with_arrays(inlet_pressure=fed)
    return replace(fed_twice, inlets=("left", "right"), **changes)


def of_scene(run: Trajectory, scene: Scene) -> Trajectory:
    """The run as one of a scene with as many bellows: its spec, and fluid at rest in its tubes."""
    tubes = tuple(tube.name for tube in scene.graph.tubes)
    still = run.with_arrays(flow=np.zeros((len(run.time), len(tubes))))
    return replace(still, tubes=tubes, spec_text=resolved_yaml(scene), period=scene.period)


def verdict(name: str, taken: bool, contribution_m: float = 0.0, mode: str = "auto") -> Verdict:
    """A verdict of the made-up run, whose tip may err by 0.545 mm."""
    reason = f"{'included' if taken else 'neglected'}: made up"
    share = contribution_m / 0.000545
    return Verdict(name, mode, taken, 0.5, "a / b", reason, contribution_m, share)  # type: ignore[arg-type]


VERDICTS = (
    verdict("tip_load", False, mode="on"),
    verdict("fluid_mass", False, 4.3e-6),
    verdict("pressure_distribution", True, 0.114),
    verdict("material_curve", False),
    verdict("gas_compressibility", True, 0.0613),
    verdict("flow_regime", True, math.inf),
    verdict("fluid_inertance", False, 2e-12),
    verdict("gravity", False, 2e-4, mode="off"),
    verdict("inertia", True, 7.9e-4),
    verdict("damping", True, 4e-4),
    verdict("feedback", False, 1.02e-4),
)
"""Absent, tiny, large and unbounded ones."""
ABLATIONS = (
    EffectAblation("fluid_mass", False, 4.3e-6, 3.9e-6, 1.1),
    EffectAblation("pressure_distribution", True, 0.114, 0.0987, 0.4),
    EffectAblation("gas_compressibility", True, 0.0613, None, 0.0, "bellows empty at t = 0.7 s"),
    EffectAblation("flow_regime", True, math.inf, 0.0974, 2.0),
    EffectAblation("fluid_inertance", False, 2e-12, 0.0, 1.3),
    EffectAblation("gravity", False, 2e-4, 2.3e-3, 1.2),
    EffectAblation("inertia", True, 7.9e-4, 8.1e-4, 0.9),
    EffectAblation("damping", True, 4e-4, 1.1e-4, 0.9, "compared up to t = 0.41 s, where it ended"),
    EffectAblation("feedback", False, 1.02e-4, 1.3e-4, 1.2),
)
"""Significant, minor, within budget, and one neglected although it moves the tip by 2.3 mm."""


def ablated_run(**changes: Any) -> Trajectory:
    """The made-up run with what its effects were measured to do."""
    return made_run(**{"effects": VERDICTS, "proof": ABLATIONS, **changes})
