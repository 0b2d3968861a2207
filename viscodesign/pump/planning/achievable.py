"""What the actuator does with what its pumps can really deliver.

The wanted pressures are kept between the deepest suction and the highest pressure that a
pump may make; the plungers follow the motion that this asks for, in whole counts, inside
of their travel, no faster than the torque of the moment allows; that motion drives the
coupled model, whose pressures tell anew how fast they may be, until both agree.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from viscodesign.pump import syringe as syringe_pump
from viscodesign.pump.planning.demand import Demand
from viscodesign.pump.planning.limits import SENSOR_FLOOR
from viscodesign.pump.planning.model_runs import Inlets, follow, followed_and_verified
from viscodesign.pump.planning.requested import Lead, Wanted, lead_in, shares_a_network
from viscodesign.pump.planning.scene_variants import with_inputs, with_pressures
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.pump import Pump
from viscodesign.scene.scene import Scene
from viscodesign.simulation.solve_once import Progress

MOST_SWEEPS = 12
AGREED = 0.5
"""Counts by which two sweeps may differ and still be told as one."""
EASED = 4
"""Sweeps after which each goes only half of the way: what overshoots then settles."""
ROUNDING = 1.0
"""Counts that whole counts may be off without being told as clipped."""


@dataclass(frozen=True)
class Achieved:
    """The pumps' own motion, and what the actuator made of it."""

    demands: tuple[Demand, ...]
    run: Trajectory
    clipped: tuple[str, ...]
    sweeps: int
    unsettled_counts: float


def achieve(asked: Wanted, pump: Pump, progress: Progress | None = None) -> Achieved:
    """Let the pumps do what they can, and the coupled model what follows from it."""
    goal = _kept_within(asked, pump)
    wanted_demands, demands = asked.demands(pump), goal.demands(pump)
    # Where inlets share a network its first flows are known from the lead-in alone.
    before = 0 if shares_a_network(asked.scene) else goal.lead.time.size
    pressure = [d.pressure for d in demands]
    paths = _paths(demands, pressure)
    apart, sweeps = np.inf, 0
    while apart > AGREED and sweeps < MOST_SWEEPS:
        run = follow(_driven(goal, demands, paths, before), asked.taken)
        sweeps += 1
        pressure = _with_lead(goal, run)
        again = _paths(demands, pressure)
        apart = max(
            float(np.max(np.abs(new - old))) / d.drive.advance_per_count
            for new, old, d in zip(again, paths, demands, strict=True)
        )
        if apart > AGREED:
            share = 1.0 if sweeps <= EASED else 0.5
            paths = [old + share * (new - old) for new, old in zip(again, paths, strict=True)]
    last = followed_and_verified(_driven(goal, demands, paths, before), progress)
    last = last.with_arrays(time=asked.run.time)
    found = _demands(goal, pump, Inlets.of(last), demands, paths)
    return Achieved(found, last, _clipped(wanted_demands, found, goal), sweeps, float(apart))


def _kept_within(asked: Wanted, pump: Pump) -> Wanted:
    """The wanted course, its pressures between the pump's lowest and highest."""
    demands = asked.demands(pump)
    low, high = bounds(demands[0])
    pressure = asked.pressure[asked.lead.time.size :]
    kept = np.clip(pressure, low, high)
    if np.array_equal(kept, pressure):
        return asked
    run = follow(with_pressures(asked.scene, asked.run.time, kept), asked.taken)
    lead = asked.lead
    if lead.time.size and not np.array_equal(kept[0], pressure[0]):
        lead = _same_times(asked, lead_in(asked.scene, pump, asked.lines, run, asked.taken))
    return replace(asked, run=run, lead=lead)


def bounds(demand: Demand) -> tuple[float, float]:
    """Lowest and highest gauge pressure that a pump may make [Pa]."""
    ambient, stall = demand.scene.ambient_pressure, demand.stall_pressure
    floor = max(SENSOR_FLOOR, demand.scene.fluid.vapour_pressure or 0.0) - ambient
    return max(floor, -stall), min(demand.pump.max_pressure, stall)


def _paths(demands: Sequence[Demand], pressure: Sequence[np.ndarray]) -> list[np.ndarray]:
    """Each plunger's positions (T,) after its goal, as far as servo and travel let it [m]."""
    return [_path(d, p) for d, p in zip(demands, pressure, strict=True)]


def _path(demand: Demand, pressure: np.ndarray) -> np.ndarray:
    """One plunger's: it starts at home, or where the run starts when nothing leads in."""
    drive = demand.drive
    low, high = demand.pump.travel
    counts = np.clip(np.round(demand.count), low, high)
    goals = np.array([drive.position(count) for count in counts])
    steps = np.diff(demand.time)
    path = np.empty_like(goals)
    path[0] = goals[0]
    # The reach of every step in both directions, at the harder of its ends' pressures.
    speeds = {sign: _speed(demand, pressure, sign) for sign in (1.0, -1.0)}
    reach = {sign: np.minimum(v[:-1], v[1:]) * steps for sign, v in speeds.items()}
    for k, goal in enumerate(goals[1:]):
        way = goal - path[k]
        most = reach[1.0 if way > 0.0 else -1.0][k]
        path[k + 1] = path[k] + np.clip(way, -most, most)
    return path


def _speed(demand: Demand, pressure: np.ndarray, sign: float) -> np.ndarray:
    """Speed of a plunger that moves in (1) or out (-1) against a pressure (T,) [m/s]."""
    pump = demand.pump
    torque = sign * syringe_pump.shaft_torque(
        pressure, pump.syringe_diameter, pump.pinion_diameter, sign * pump.plunger_friction
    )
    left = syringe_pump.speed_left(demand.servo, pump.supply_voltage, torque)
    return np.asarray(left * pump.pinion_diameter / 2)


def _driven(
    goal: Wanted, demands: Sequence[Demand], paths: Sequence[np.ndarray], before: int
) -> Scene:
    """The scene driven by plungers from one of the times on; its outputs are the run's own."""
    begin = float(demands[0].time[before])
    inputs = {
        d.inlet: d.barrel.syringe(d.time[before:] - begin, path[before:])
        for d, path in zip(demands, paths, strict=True)
    }
    outputs = goal.lead.lasts - begin + goal.run.time
    run = goal.scene.run.model_copy(
        update={"duration": float(outputs[-1]), "output_times": tuple(outputs.tolist())}
    )
    return with_inputs(goal.scene.model_copy(update={"run": run}), inputs)


def _with_lead(goal: Wanted, run: Inlets) -> list[np.ndarray]:
    """Pressures (T,) of each inlet: the lead-in's, then the run's."""
    return list(np.concatenate([goal.lead.pressure, run.pressure]).T)


def _demands(
    goal: Wanted,
    pump: Pump,
    run: Inlets,
    demands: Sequence[Demand],
    paths: Sequence[np.ndarray],
) -> tuple[Demand, ...]:
    """What the pumps do, as a course of its own."""
    if goal.lead.time.size:
        lead = lead_in(goal.scene, pump, goal.lines, run, goal.taken)
        goal = replace(goal, lead=_same_times(goal, lead))
    pressure = _with_lead(goal, run)
    given = np.concatenate([goal.lead.given, run.given]).T
    return tuple(
        replace(d, pressure=pressure[k], given=given[k], stated_position=paths[k])
        for k, d in enumerate(demands)
    )


def _same_times(goal: Wanted, lead: Lead) -> Lead:
    """A lead-in to another pressure, at the times of the one that was followed."""
    share = goal.lead.time / goal.lead.lasts * lead.lasts

    def at(values: np.ndarray) -> np.ndarray:
        return np.stack([np.interp(share, lead.time, column) for column in values.T], axis=1)

    if not lead.time.size:
        flat = np.zeros_like(goal.lead.given)
        return replace(goal.lead, pressure=flat + goal.scene.gauge_pressure, given=flat)
    return Lead(goal.lead.time, at(lead.pressure), at(lead.given), goal.lead.lasts)


def _clipped(wanted: Sequence[Demand], found: Sequence[Demand], goal: Wanted) -> tuple[str, ...]:
    """What of the wanted motion is cut off, in words."""
    told = []
    for asked, done in zip(wanted, found, strict=True):
        low, high = bounds(asked)
        name = "" if len(found) == 1 else f"{asked.inlet}: "
        if asked.pressure.max() > high:
            told.append(f"{name}pressures above {high / 1e3:.4g} kPa gauge")
        if asked.pressure.min() < low:
            told.append(f"{name}pressures below {low / 1e3:.4g} kPa gauge")
        goals = goal.demands(done.pump)[list(goal.scene.inputs).index(asked.inlet)].count
        ends = done.pump.travel
        if goals.max() > ends[1] + ROUNDING or goals.min() < ends[0] - ROUNDING:
            told.append(f"{name}counts outside of travel, {ends[0]} to {ends[1]}")
        late = np.abs(np.clip(goals, *ends) - done.count)
        if late.max() > ROUNDING:
            when = float(done.time[int(np.argmax(late))])
            told.append(f"{name}speed: up to {late.max():.3g} counts behind, at {when:.4g} s")
    return tuple(told)
