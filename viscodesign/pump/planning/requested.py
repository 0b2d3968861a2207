"""The pressures that a scene asks for, through its own model, as what its pumps have to do."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.pump.planning.barrel import FeedLine
from viscodesign.pump.planning.demand import PumpDemand
from viscodesign.pump.planning.model_runs import InletHistory, run_model
from viscodesign.pump.planning.scene_variants import with_pressures
from viscodesign.scene.pump import PumpSpec
from viscodesign.scene.scene import Scene

FeedLines = Mapping[str, FeedLine]


@dataclass(frozen=True)
class LeadInNumbers:
    """How gently a pump goes from home to the pressures of the start."""

    speed_share: float = 0.5
    """Of the speed that is left."""
    shortest_ramp: float = 1.0
    """[s]"""
    shortest_rest: float = 0.5
    """[s]"""
    ramp_settling_times: float = 2.0
    """Ramp over the time in which the network settles."""
    rest_settling_times: float = 10.0
    """Rest over the same."""
    no_pressure: float = 1.0
    """Pressure beyond the baseline that needs no lead-in [Pa]."""
    samples: int = 100


LEAD_IN = LeadInNumbers()


@dataclass(frozen=True)
class LeadIn:
    """From home to the pressures of the start; L times before the run's own 0."""

    time: np.ndarray
    """(L,) from 0 [s]"""
    pressure: np.ndarray
    """(L, P) gauge [Pa]."""
    given: np.ndarray
    """(L, P) [m3 at ambient density]."""
    duration: float
    """Until the run's own 0 [s]."""

    @classmethod
    def none(cls, run: InletHistory) -> LeadIn:
        """Nothing before a run."""
        empty = np.zeros((0, run.pressure.shape[1]))
        return cls(np.zeros(0), empty, empty, 0.0)


@dataclass(frozen=True)
class RequestedMotion:
    """A run of given pressures, with the lead-in before it."""

    scene: Scene
    run: InletHistory
    active: frozenset[str]
    """Effects of the model."""
    lines: FeedLines
    lead: LeadIn

    @property
    def time(self) -> np.ndarray:
        """(T,) from the start of the lead-in [s]."""
        return np.concatenate([self.lead.time, self.lead.duration + self.run.time])

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

    def demands(self, pump: PumpSpec) -> tuple[PumpDemand, ...]:
        """What is asked of a pump at every inlet."""
        time, pressure, given = self.time, self.pressure, self.given
        return tuple(
            PumpDemand(
                self.scene, pump, name, self.lines[name], time, self.lead.duration,
                pressure[:, k], given[:, k],
            )
            for k, name in enumerate(self.scene.inputs)
        )  # fmt: skip


def shares_a_network(scene: Scene) -> bool:
    """Whether several inlets feed the same network."""
    return any(len(c.inlets) > 1 for c in scene.graph.components())


def lead_in(
    scene: Scene, pump: PumpSpec, lines: FeedLines, run: InletHistory, active: frozenset[str]
) -> LeadIn:
    """A ramp of pressure to a run's first, and a rest in which the network settles.

    Nothing where the start is the baseline, or where a run starts at rest.
    """
    baseline, start = scene.gauge_pressure, run.pressure[0]
    if scene.run.start == "rest" or np.max(np.abs(start - baseline)) < LEAD_IN.no_pressure:
        return LeadIn.none(run)
    settling = SceneQuantities(scene).scales.t_net
    unhurried = _unhurried(scene, pump, lines, run)
    ramp = max(LEAD_IN.shortest_ramp, LEAD_IN.ramp_settling_times * settling, unhurried)
    rest = max(LEAD_IN.shortest_rest, LEAD_IN.rest_settling_times * settling)
    ramp, rest = (math.ceil(10 * t) / 10 for t in (ramp, rest))
    spans = ((0.0, ramp), (ramp, ramp + rest))
    times = np.unique(np.concatenate([np.linspace(*span, LEAD_IN.samples) for span in spans]))
    reached = np.minimum(times / ramp, 1.0)[:, None]
    ramped = with_pressures(scene, times, baseline + reached * (start - baseline))
    first = run_model(ramped, active)
    return LeadIn(times[:-1], first.pressure[:-1], first.given[:-1], ramp + rest)


def _unhurried(scene: Scene, pump: PumpSpec, lines: FeedLines, run: InletHistory) -> float:
    """Time for the way from home at a part of the speed that the start's pressure leaves [s]."""
    longest = 0.0
    for k, (name, line) in enumerate(lines.items()):
        start, given = run.pressure[:1, k], run.given[:1, k]
        demand = PumpDemand(scene, pump, name, line, run.time[:1], 0.0, start, given)
        left = float(demand.speed_left_at(demand.torque_at(np.abs(start), 1.0))[0])
        if left > 0.0:
            way = abs(float(demand.position[0]))
            longest = max(longest, way / (LEAD_IN.speed_share * left))
    return longest
