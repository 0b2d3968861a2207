"""What the actuator does with what its pumps can really deliver.

Pressures are clipped to the pump's; the axes follow in whole steps, within travel and speed;
that motion drives the coupled model, whose pressures limit the speed anew, until both agree.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.planning.demand import PumpDemand
from viscodesign.pump.planning.motion import (
    InletHistory,
    RequestedMotion,
    inlets_of,
    run_model,
    run_verified,
    shares_a_network,
)
from viscodesign.pump.planning.scene_variants import with_inputs, with_outputs, with_pressures
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.pumps.base import PumpSpec
from viscodesign.scene.scene import Scene
from viscodesign.simulation.solve_once import Progress


@dataclass(frozen=True)
class SweepNumbers:
    """How motion and pressure are brought to agree, sweep by sweep."""

    most: int = 12
    agreement_steps: float = 0.5  # by which two sweeps may differ
    damped_after: int = 4  # sweeps after which each goes half of the way: what overshoots settles
    rounding_steps: float = 1.0  # that whole steps may be off without being reported as clipped


SWEEPS = SweepNumbers()


@dataclass(frozen=True)
class AchievableMotion:
    """The motion of the pumps, and how the actuator responded."""

    demands: tuple[PumpDemand, ...]
    run: Trajectory
    clipped: tuple[str, ...]
    sweeps: int
    unsettled_steps: float


def achievable_motion(
    requested: RequestedMotion, pump: PumpSpec, progress: Progress | None = None
) -> AchievableMotion:
    """Let the pumps do what they can, and the coupled model what follows from it."""
    goal = _within_bounds(requested, pump)
    demands = goal.demands(pump)
    paths = [d.path(d.pressure) for d in demands]
    apart, sweeps = np.inf, 0
    while apart > SWEEPS.agreement_steps and sweeps < SWEEPS.most:
        run = run_model(_driven(goal, demands, paths), goal.active)
        sweeps += 1
        pressures = np.concatenate([goal.lead.pressure, run.pressure]).T
        steps = [d.path(p) - path for d, p, path in zip(demands, pressures, paths, strict=True)]
        apart = float(np.max(np.abs(steps))) / demands[0].axis.step
        if apart > SWEEPS.agreement_steps:
            share = 1.0 if sweeps <= SWEEPS.damped_after else 0.5
            paths = [path + share * step for path, step in zip(paths, steps, strict=True)]
    last = run_verified(_driven(goal, demands, paths), progress)
    last = last.with_arrays(time=requested.run.time)
    found = _done(goal, inlets_of(goal.scene, last), demands, paths)
    inlets = zip(requested.demands(pump), demands, found, strict=True)
    clipped = tuple(words for inlet in inlets for words in _clipped(*inlet, alone=len(found) == 1))
    return AchievableMotion(found, last, clipped, sweeps, apart)


def _within_bounds(requested: RequestedMotion, pump: PumpSpec) -> RequestedMotion:
    demands, before = requested.demands(pump), requested.lead.time.size
    pressure = np.stack([d.pressure[before:] for d in demands], axis=1)
    kept = np.clip(pressure, *demands[0].bounds)
    if np.array_equal(kept, pressure):
        return requested
    scene = with_pressures(requested.scene, requested.run.time, kept)
    goal = replace(requested, run=run_model(scene, requested.active))
    return goal.led_in(goal.ramp_s, goal.rest_s) if before else goal


def _driven(
    goal: RequestedMotion, demands: Sequence[PumpDemand], paths: Sequence[np.ndarray]
) -> Scene:
    """The scene driven by the axes; its outputs are the run's own."""
    # Where inlets share a network its first flows are known from the lead-in alone.
    before = 0 if shares_a_network(goal.scene) else goal.lead.time.size
    time = demands[0].time[before:] - demands[0].time[before]
    inputs = {
        d.inlet: d.source(time, path[before:]) for d, path in zip(demands, paths, strict=True)
    }
    outputs = goal.run.time + (0.0 if before else goal.lead_s)
    return with_inputs(with_outputs(goal.scene, outputs), inputs)


def _done(
    goal: RequestedMotion,
    run: InletHistory,
    demands: Sequence[PumpDemand],
    paths: Sequence[np.ndarray],
) -> tuple[PumpDemand, ...]:
    """What the pumps do, as demands of their own."""
    if goal.lead.time.size:
        goal = replace(goal, run=run).led_in(goal.ramp_s, goal.rest_s)
    pressure = np.concatenate([goal.lead.pressure, run.pressure]).T
    given = np.concatenate([goal.lead.given, run.given]).T
    return tuple(
        replace(d, pressure=pressure[k], given=given[k], stated_position=paths[k])
        for k, d in enumerate(demands)
    )


def _clipped(
    asked: PumpDemand, goal: PumpDemand, done: PumpDemand, *, alone: bool
) -> Iterator[str]:
    """What of the requested motion is cut off, in words."""
    name = "" if alone else f"{asked.inlet}: "
    (low, high), ends, most = asked.bounds, done.axis.travel, SWEEPS.rounding_steps
    if asked.pressure.max() > high:
        yield f"{name}pressures above {high / 1e3:.4g} kPa gauge"
    if asked.pressure.min() < low:
        yield f"{name}pressures below {low / 1e3:.4g} kPa gauge"
    if goal.steps.max() > ends[1] + most or goal.steps.min() < ends[0] - most:
        yield f"{name}{done.axis.unit} outside travel, {ends[0]} to {ends[1]}"
    late = np.abs(np.clip(goal.steps, *ends) - done.steps)
    if late.max() > most:
        when = float(done.time[int(np.argmax(late))])
        yield f"{name}speed: up to {late.max():.3g} {done.axis.unit} behind, at {when:.4g} s"
