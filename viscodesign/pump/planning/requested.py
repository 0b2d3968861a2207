"""The pressures that a scene wants, through its own model, as what its pumps are asked."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.pump import syringe as syringe_pump
from viscodesign.pump.drive import Drive
from viscodesign.pump.planning.barrel import Barrel, Line
from viscodesign.pump.planning.demand import Demand
from viscodesign.pump.planning.model_runs import Inlets, follow
from viscodesign.pump.planning.scene_variants import with_pressures
from viscodesign.pump.servo_motor import SERVOS
from viscodesign.scene.pump import Pump
from viscodesign.scene.scene import Scene

UNHURRIED = 0.5
"""Part of the speed that is left which a lead-in takes."""
LEAST_RAMP, LEAST_REST = 1.0, 0.5
"""Shortest ramp and rest of a lead-in [s]."""
RAMP_TIMES, REST_TIMES = 2.0, 10.0
"""The same, in times in which the network settles."""
NO_PRESSURE = 1.0
"""Pressure beyond the baseline that needs no lead-in [Pa]."""
LEAD_SAMPLES = 100

Lines = Mapping[str, Line]


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
    run: Inlets
    taken: frozenset[str]
    """Effects of the model."""
    lines: Lines
    lead: Lead

    @property
    def time(self) -> np.ndarray:
        """(T,) from the start of the lead-in [s]."""
        return np.concatenate([self.lead.time, self.lead.lasts + self.run.time])

    @property
    def pressure(self) -> np.ndarray:
        """(T, P) gauge [Pa]."""
        own = self._from_home(self.run.pressure, self.scene.gauge_pressure)
        return np.concatenate([self.lead.pressure, own])

    @property
    def given(self) -> np.ndarray:
        """(T, P) to the network since it was filled [m3 at ambient density]."""
        own = self._from_home(self.run.given, 0.0)
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


def shares_a_network(scene: Scene) -> bool:
    """Whether several inlets feed the same network."""
    return any(len(c.inlets) > 1 for c in scene.graph.components())


def no_lead(run: Inlets) -> Lead:
    """Nothing before a run."""
    none = np.zeros((0, run.pressure.shape[1]))
    return Lead(np.zeros(0), none, none, 0.0)


def lead_in(scene: Scene, pump: Pump, lines: Lines, run: Inlets, taken: frozenset[str]) -> Lead:
    """A ramp of pressure to a run's first, and a rest in which the network settles.

    Nothing where the start is the baseline, or where a run starts at rest.
    """
    baseline, start = scene.gauge_pressure, run.pressure[0]
    if scene.run.start == "rest" or np.max(np.abs(start - baseline)) < NO_PRESSURE:
        return no_lead(run)
    settling = SceneQuantities(scene).scales.t_net
    unhurried = _unhurried(scene, pump, lines, start, run.given[0])
    ramp = max(LEAST_RAMP, RAMP_TIMES * settling, unhurried)
    rest = max(LEAST_REST, REST_TIMES * settling)
    ramp, rest = (math.ceil(10 * t) / 10 for t in (ramp, rest))
    times = np.unique(
        np.concatenate(
            [np.linspace(0.0, ramp, LEAD_SAMPLES), np.linspace(ramp, ramp + rest, LEAD_SAMPLES)]
        )
    )
    reached = np.minimum(times / ramp, 1.0)[:, None]
    first = follow(with_pressures(scene, times, baseline + reached * (start - baseline)), taken)
    return Lead(times[:-1], first.pressure[:-1], first.given[:-1], ramp + rest)


def _unhurried(
    scene: Scene, pump: Pump, lines: Lines, start: np.ndarray, given: np.ndarray
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
