"""The pressures that a scene wants, through its own model, as what its pumps are asked."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.physics import syringe_pump
from viscodesign.physics.servo import SERVOS
from viscodesign.planning.barrel import Barrel, Line, line_at
from viscodesign.planning.demand import Demand
from viscodesign.planning.variants import with_pressures
from viscodesign.pumps.drive import Drive
from viscodesign.scene.pump import Pump
from viscodesign.scene.scene import Scene
from viscodesign.simulating import simulate
from viscodesign.trajectory import Trajectory

UNHURRIED = 0.5
"""Part of the speed that is left which a lead-in takes."""
LEAST_RAMP, LEAST_REST = 1.0, 0.5
"""Shortest ramp and rest of a lead-in [s]."""
RAMP_TIMES, REST_TIMES = 2.0, 10.0
"""The same, in times in which the network settles."""
NO_PRESSURE = 1.0
"""Pressure beyond the baseline that needs no lead-in [Pa]."""
LEAD_SAMPLES = 200


@dataclass(frozen=True)
class Lead:
    """From home to the pressures of the start; L times before the run's own 0."""

    time: np.ndarray
    """(L,) from 0 [s]"""
    pressure: np.ndarray
    """(L, P) gauge [Pa]."""
    given: np.ndarray
    """(L, P) [m3 at ambient density]."""
    lasts: float
    """Until the run's own 0 [s]."""


@dataclass(frozen=True)
class Wanted:
    """A run of given pressures, with the lead-in before it."""

    scene: Scene
    run: Trajectory
    lines: Mapping[str, Line]
    lead: Lead

    @property
    def time(self) -> np.ndarray:
        """(T,) from the start of the lead-in [s]."""
        return np.concatenate([self.lead.time, self.lead.lasts + self.run.time])

    @property
    def pressure(self) -> np.ndarray:
        """(T, P) gauge [Pa]."""
        own = self._from_home(_columns(self.run.inlet_pressure), self.scene.gauge_pressure)
        return np.concatenate([self.lead.pressure, own])

    @property
    def given(self) -> np.ndarray:
        """(T, P) to the network since it was filled [m3 at ambient density]."""
        own = self._from_home(_columns(self.run.inflow), 0.0)
        if len(self.lead.given) and shares_a_network(self.scene):
            # How the first filling came in is known from the lead-in alone.
            own = own - own[0] + self.lead.given[-1]
        return np.concatenate([self.lead.given, own])

    def _from_home(self, values: np.ndarray, at_home: float) -> np.ndarray:
        """A run that starts at rest starts with the plunger at home."""
        if self.scene.run.start == "rest":
            values = values.copy()
            values[0] = at_home
        return values

    def demands(self, pump: Pump) -> tuple[Demand, ...]:
        """What is asked of a pump at every inlet."""
        pressure, given = self.pressure, self.given
        return tuple(
            Demand(
                self.scene, pump, name, self.lines[name], self.time, self.lead.lasts,
                pressure[:, k], given[:, k],
            )
            for k, name in enumerate(self.scene.inputs)
        )  # fmt: skip


def _columns(values: Mapping[str, np.ndarray]) -> np.ndarray:
    return np.stack(list(values.values()), axis=1)


def shares_a_network(scene: Scene) -> bool:
    """Whether several inlets feed the same network."""
    return any(len(c.inlets) > 1 for c in scene.graph.components())


def wanted(scene: Scene, run: Trajectory, pump: Pump) -> Wanted:
    """The whole course of a run that was followed to its end."""
    taken = frozenset(v.name for v in run.effects if v.taken)
    lines = {name: line_at(scene, name, taken) for name in scene.inputs}
    start = np.array([values[0] for values in run.inlet_pressure.values()])
    given = np.array([values[0] for values in run.inflow.values()])
    lead = lead_in(scene, pump, lines, start, given, run.classification.scales.t_net)
    return Wanted(scene, run, lines, lead)


def follow(scene: Scene) -> Trajectory:
    """A run to its end, not verified; raises `SolveError` where it ends before."""
    return to_its_end(simulate(scene, verify=False))


def to_its_end(run: Trajectory) -> Trajectory:
    """A run, unless it broke off: then `SolveError` with its own words."""
    times = run.time
    if run.status == "failed" and run.accuracy.estimated_tip_error_m is None and run.failure:
        raise SolveError(
            f"the coupled model could not be followed: {run.failure}",
            quantity="motion",
            where="plan",
            time_s=float(times[-1]) if times.size else 0.0,
        )
    if run.status == "interrupted":
        raise KeyboardInterrupt
    return run


def lead_in(
    scene: Scene,
    pump: Pump,
    lines: Mapping[str, Line],
    start: np.ndarray,
    given: np.ndarray,
    settling: float,
) -> Lead:
    """A ramp of pressure to the start's, and a rest in which the network settles.

    ``start`` (P,) gauge [Pa]; ``given`` (P,) by then; ``settling``: slowest time of the
    network [s]. Nothing where the start is the baseline, or where a run starts at rest.
    """
    baseline, inlets = scene.gauge_pressure, len(start)
    none = np.zeros((0, inlets))
    if scene.run.start == "rest" or np.max(np.abs(start - baseline)) < NO_PRESSURE:
        return Lead(np.zeros(0), none, none, 0.0)
    ramp = max(LEAST_RAMP, RAMP_TIMES * settling, _unhurried(scene, pump, lines, start, given))
    rest = max(LEAST_REST, REST_TIMES * settling)
    ramp, rest = (math.ceil(10 * t) / 10 for t in (ramp, rest))
    times = np.unique(
        np.concatenate(
            [np.linspace(0.0, ramp, LEAD_SAMPLES), np.linspace(ramp, ramp + rest, LEAD_SAMPLES)]
        )
    )
    reached = np.minimum(times / ramp, 1.0)[:, None]
    run = follow(with_pressures(scene, times, baseline + reached * (start - baseline)))
    before = slice(0, len(times) - 1)
    pressure, taken = _columns(run.inlet_pressure)[before], _columns(run.inflow)[before]
    return Lead(times[before], pressure, taken, ramp + rest)


def _unhurried(
    scene: Scene, pump: Pump, lines: Mapping[str, Line], start: np.ndarray, given: np.ndarray
) -> float:
    """Time for the way from home at a part of the speed that the start's pressure leaves [s]."""
    servo, drive = SERVOS[pump.servo], Drive(pump)
    longest = 0.0
    for k, line in enumerate(lines.values()):
        way = abs(float(Barrel.of(scene, drive, line).position(start[k], given[k])))
        torque = syringe_pump.shaft_torque(
            abs(start[k]), pump.syringe_diameter, pump.pinion_diameter, pump.plunger_friction
        )
        left = float(syringe_pump.speed_left(servo, pump.supply_voltage, torque))
        if left > 0.0:
            longest = max(longest, way / (UNHURRIED * left * pump.pinion_diameter / 2))
    return longest
