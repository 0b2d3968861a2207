"""What the actuator does with what its pumps can really deliver.

The wanted pressures are kept between the deepest suction and the highest pressure that a
pump may make; the plungers follow the motion that this asks for, in whole counts, inside
their travel, no faster than the torque of the moment allows; that motion drives the coupled
model, whose pressures say anew how fast they may be, until both agree.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from viscodesign.pump.planning.assessment import MARGINS
from viscodesign.pump.planning.demand import PumpDemand
from viscodesign.pump.planning.model_runs import InletHistory, run_model, run_verified
from viscodesign.pump.planning.requested import (
    LeadIn,
    RequestedMotion,
    lead_in,
    shares_a_network,
)
from viscodesign.pump.planning.scene_variants import with_inputs, with_outputs, with_pressures
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.pump import PumpSpec
from viscodesign.scene.scene import Scene
from viscodesign.simulation.solve_once import Progress


@dataclass(frozen=True)
class SweepNumbers:
    """How motion and pressure are brought to agree, sweep by sweep."""

    most: int = 12
    agreement_counts: float = 0.5
    """By which two sweeps may differ."""
    damped_after: int = 4
    """Sweeps after which each goes only half of the way, so that what overshoots settles."""
    rounding_counts: float = 1.0
    """That whole counts may be off without being reported as clipped."""


SWEEPS = SweepNumbers()


@dataclass(frozen=True)
class AchievableMotion:
    """The motion of the pumps, and how the actuator responded."""

    demands: tuple[PumpDemand, ...]
    run: Trajectory
    clipped: tuple[str, ...]
    sweeps: int
    unsettled_counts: float


def achievable_motion(
    requested: RequestedMotion, pump: PumpSpec, progress: Progress | None = None
) -> AchievableMotion:
    """Let the pumps do what they can, and the coupled model what follows from it."""
    goal = _within_bounds(requested, pump)
    demands = goal.demands(pump)
    # Where inlets share a network its first flows are known from the lead-in alone.
    before = 0 if shares_a_network(requested.scene) else goal.lead.time.size
    paths = _paths(demands, [d.pressure for d in demands])
    apart, sweeps = np.inf, 0
    while apart > SWEEPS.agreement_counts and sweeps < SWEEPS.most:
        run = run_model(_driven(goal, demands, paths, before), requested.active)
        sweeps += 1
        again = _paths(demands, _with_lead(goal, run))
        apart = max(
            float(np.max(np.abs(new - old))) / d.drive.advance_per_count
            for new, old, d in zip(again, paths, demands, strict=True)
        )
        if apart > SWEEPS.agreement_counts:
            share = 1.0 if sweeps <= SWEEPS.damped_after else 0.5
            paths = [old + share * (new - old) for new, old in zip(again, paths, strict=True)]
    last = run_verified(_driven(goal, demands, paths, before), progress)
    last = last.with_arrays(time=requested.run.time)
    found = _demands(goal, pump, InletHistory.of(last), demands, paths)
    clipped = _clipped(requested.demands(pump), demands, found)
    return AchievableMotion(found, last, clipped, sweeps, float(apart))


def _within_bounds(requested: RequestedMotion, pump: PumpSpec) -> RequestedMotion:
    """The requested motion, its pressures between the pump's lowest and highest."""
    low, high = bounds(requested.demands(pump)[0])
    lead = requested.lead
    pressure = requested.pressure[lead.time.size :]
    kept = np.clip(pressure, low, high)
    if np.array_equal(kept, pressure):
        return requested
    scene, active = requested.scene, requested.active
    run = run_model(with_pressures(scene, requested.run.time, kept), active)
    if lead.time.size and not np.array_equal(kept[0], pressure[0]):
        lead = _at_same_times(requested, lead_in(scene, pump, requested.lines, run, active))
    return replace(requested, run=run, lead=lead)


def bounds(demand: PumpDemand) -> tuple[float, float]:
    """Lowest and highest gauge pressure that a pump may make [Pa]."""
    ambient, stall = demand.scene.ambient_pressure, demand.stall_pressure
    floor = max(MARGINS.sensor_floor, demand.scene.fluid.vapour_pressure or 0.0) - ambient
    return max(floor, -stall), min(demand.pump.max_pressure, stall)


def _paths(demands: Sequence[PumpDemand], pressure: Sequence[np.ndarray]) -> list[np.ndarray]:
    """Each plunger's positions (T,) after its goal, as far as servo and travel let it [m]."""
    return [_path(d, p) for d, p in zip(demands, pressure, strict=True)]


def _path(demand: PumpDemand, pressure: np.ndarray) -> np.ndarray:
    """One plunger's: it starts at home, or where the run starts when nothing leads in."""
    counts = np.clip(np.round(demand.count), *demand.pump.travel)
    goals = np.array([demand.drive.position(count) for count in counts])
    path = np.empty_like(goals)
    path[0] = goals[0]
    # The reach of every step in both directions, at the harder of its ends' pressures.
    speeds = {s: demand.speed_left_at(s * demand.torque_at(pressure, s)) for s in (1.0, -1.0)}
    steps = np.diff(demand.time)
    reach = {sign: np.minimum(v[:-1], v[1:]) * steps for sign, v in speeds.items()}
    for k, goal in enumerate(goals[1:]):
        way = goal - path[k]
        most = reach[1.0 if way > 0.0 else -1.0][k]
        path[k + 1] = path[k] + np.clip(way, -most, most)
    return path


def _driven(
    goal: RequestedMotion,
    demands: Sequence[PumpDemand],
    paths: Sequence[np.ndarray],
    before: int,
) -> Scene:
    """The scene driven by plungers from one of the times on; its outputs are the run's own."""
    begin = float(demands[0].time[before])
    inputs = {
        d.inlet: d.barrel.syringe(d.time[before:] - begin, path[before:])
        for d, path in zip(demands, paths, strict=True)
    }
    return with_inputs(with_outputs(goal.scene, goal.lead.duration - begin + goal.run.time), inputs)


def _with_lead(goal: RequestedMotion, run: InletHistory) -> list[np.ndarray]:
    """Pressures (T,) of each inlet: the lead-in's, then the run's."""
    return list(np.concatenate([goal.lead.pressure, run.pressure]).T)


def _demands(
    goal: RequestedMotion,
    pump: PumpSpec,
    run: InletHistory,
    demands: Sequence[PumpDemand],
    paths: Sequence[np.ndarray],
) -> tuple[PumpDemand, ...]:
    """What the pumps do, as demands of their own."""
    if goal.lead.time.size:
        lead = lead_in(goal.scene, pump, goal.lines, run, goal.active)
        goal = replace(goal, lead=_at_same_times(goal, lead))
    pressure = _with_lead(goal, run)
    given = np.concatenate([goal.lead.given, run.given]).T
    return tuple(
        replace(d, pressure=pressure[k], given=given[k], stated_position=paths[k])
        for k, d in enumerate(demands)
    )


def _at_same_times(goal: RequestedMotion, lead: LeadIn) -> LeadIn:
    """A lead-in to another pressure, at the times of the one that was run."""
    share = goal.lead.time / goal.lead.duration * lead.duration

    def at(values: np.ndarray) -> np.ndarray:
        return np.stack([np.interp(share, lead.time, column) for column in values.T], axis=1)

    if not lead.time.size:
        flat = np.zeros_like(goal.lead.given)
        return replace(goal.lead, pressure=flat + goal.scene.gauge_pressure, given=flat)
    return LeadIn(goal.lead.time, at(lead.pressure), at(lead.given), goal.lead.duration)


def _clipped(
    requested: Sequence[PumpDemand], goals: Sequence[PumpDemand], found: Sequence[PumpDemand]
) -> tuple[str, ...]:
    """What of the requested motion is cut off, in words."""
    words = []
    for asked, goal, done in zip(requested, goals, found, strict=True):
        low, high = bounds(asked)
        name = "" if len(found) == 1 else f"{asked.inlet}: "
        if asked.pressure.max() > high:
            words.append(f"{name}pressures above {high / 1e3:.4g} kPa gauge")
        if asked.pressure.min() < low:
            words.append(f"{name}pressures below {low / 1e3:.4g} kPa gauge")
        counts, ends = goal.count, done.pump.travel
        most = SWEEPS.rounding_counts
        if counts.max() > ends[1] + most or counts.min() < ends[0] - most:
            words.append(f"{name}counts outside travel, {ends[0]} to {ends[1]}")
        late = np.abs(np.clip(counts, *ends) - done.count)
        if late.max() > most:
            when = float(done.time[int(np.argmax(late))])
            words.append(f"{name}speed: up to {late.max():.3g} counts behind, at {when:.4g} s")
    return tuple(words)
