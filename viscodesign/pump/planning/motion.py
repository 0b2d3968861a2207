"""The pressures that a scene asks for, through its own model, as what its pumps have to do."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from viscodesign.effects.catalogue import catalogue
from viscodesign.errors import SolveError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.interrupt import gentle_interrupt
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.planning.demand import FeedLine, PumpDemand, fed_by_each
from viscodesign.pump.planning.scene_variants import with_pressures
from viscodesign.results.motion_arrays import MotionArrays
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.pumps.base import PumpSpec
from viscodesign.scene.scene import Scene
from viscodesign.simulation.build_problem import suggest_settings
from viscodesign.simulation.simulate import simulate
from viscodesign.simulation.solve_once import Progress, solve


@dataclass(frozen=True)
class LeadInNumbers:
    """How gently a pump goes from home to the pressures of the start."""

    speed_share: float = 0.5  # of the speed that is left
    shortest_ramp: float = 1.0  # [s]
    shortest_rest: float = 0.5  # [s]
    ramp_settling_times: float = 2.0  # ramp over the time in which the network settles
    rest_settling_times: float = 10.0
    no_pressure: float = 1.0  # beyond the baseline, that needs no lead-in [Pa]
    samples: int = 100


LEAD_IN = LeadInNumbers()


@dataclass(frozen=True)
class InletHistory:
    """What happens at P inlets at T times."""

    time: np.ndarray  # (T,) [s]
    pressure: np.ndarray  # (T, P) gauge [Pa]
    given: np.ndarray  # (T, P) to all networks since they were filled [m3 at ambient density]

    def until(self, end: int) -> InletHistory:
        """The times before an index."""
        return InletHistory(self.time[:end], self.pressure[:end], self.given[:end])


@dataclass(frozen=True)
class RequestedMotion:
    """A run of given pressures, with the lead-in before it."""

    kind: type[PumpDemand]  # what is asked of an axis of its pump
    scene: Scene
    active: frozenset[str]  # effects of the model
    lines: Mapping[str, FeedLine]
    run: InletHistory
    lead: InletHistory  # from 0 to the run's own start, without it; may be empty
    ramp_s: float = 0.0
    rest_s: float = 0.0

    @property
    def lead_s(self) -> float:
        """Time before the run's own 0 [s]."""
        return self.ramp_s + self.rest_s

    def demands(self, pump: PumpSpec) -> tuple[PumpDemand, ...]:
        """What is asked of a pump at every inlet, from the start of the lead-in."""
        lead, run = self.lead, self.run
        pressure, given = run.pressure, run.given
        if self.scene.run.start == "rest":  # with the plunger at home
            moved = (run.time > 0.0)[:, None]
            pressure = np.where(moved, pressure, self.scene.gauge_pressure)
            given = np.where(moved, given, 0.0)
        if len(lead.time) and shares_a_network(self.scene):
            # How the first filling came in is known from the lead-in alone.
            given = given - given[0] + lead.given[-1]
        time = np.concatenate([lead.time, self.lead_s + run.time])
        pressure = np.concatenate([lead.pressure, pressure])
        given = np.concatenate([lead.given, given])
        return tuple(
            self.kind(self.scene, pump, name, self.lines[name], time, self.lead_s, *own)
            for name, *own in zip(self.scene.inputs, pressure.T, given.T, strict=True)
        )

    def without_lead_in(self, scene: Scene, run: InletHistory) -> RequestedMotion:
        """That of another scene and its run."""
        return replace(self, scene=scene, run=run, lead=run.until(0), ramp_s=0.0, rest_s=0.0)

    def with_lead_in(self, pump: PumpSpec) -> RequestedMotion:
        """The same behind a ramp from home and a rest; nothing where it starts there."""
        above = np.max(np.abs(self.run.pressure[0] - self.scene.gauge_pressure))
        if self.scene.run.start == "rest" or above < LEAD_IN.no_pressure:
            return self
        settling = SceneQuantities(self.scene).scales.t_net
        settled = LEAD_IN.ramp_settling_times * settling
        ramp = max(LEAD_IN.shortest_ramp, settled, self._unhurried(pump))
        rest = max(LEAD_IN.shortest_rest, LEAD_IN.rest_settling_times * settling)
        return self.led_in(math.ceil(10 * ramp) / 10, math.ceil(10 * rest) / 10)

    def led_in(self, ramp: float, rest: float) -> RequestedMotion:
        """The same behind a ramp and a rest of these times [s]."""
        baseline, start = self.scene.gauge_pressure, self.run.pressure[0]
        spans = ((0.0, ramp), (ramp, ramp + rest))
        times = np.unique(np.concatenate([np.linspace(*span, LEAD_IN.samples) for span in spans]))
        reached = np.minimum(times / ramp, 1.0)[:, None]
        ramped = with_pressures(self.scene, times, baseline + reached * (start - baseline))
        lead = run_model(ramped, self.active).until(-1)
        return replace(self, lead=lead, ramp_s=ramp, rest_s=rest)

    def _unhurried(self, pump: PumpSpec) -> float:
        """Time from home at a share of the speed that the start's pressure leaves [s]."""
        start = replace(self, run=self.run.until(1)).demands(pump)
        return max(demand.approach_time(LEAD_IN.speed_share) for demand in start)


def shares_a_network(scene: Scene) -> bool:
    """Whether several inlets feed the same network."""
    return any(len(c.inlets) > 1 for c in scene.graph.components())


def active_effects(run: Trajectory) -> frozenset[str]:
    """Names of the effects that a run took in."""
    return frozenset(v.name for v in run.effects if v.taken)


def run_model(scene: Scene, active: frozenset[str]) -> InletHistory:
    """The inlets of a scene with just these effects; `SolveError` where the run breaks off."""
    quantities = SceneQuantities(scene)
    effects = [kind.of(quantities) for name, kind in catalogue().items() if name in active]
    run = solve(quantities, effects, suggest_settings(quantities, effects))
    if run.solution.asked_to_stop:
        # Even where it had just been solved: a plan has more to do.
        raise KeyboardInterrupt
    if run.motion.failure is not None:
        raise _broken_off(str(run.motion.failure), run.motion.time)
    return inlets_of(scene, run.motion)


def run_verified(scene: Scene, progress: Progress | None) -> Trajectory:
    """A whole run with its error; `SolveError` in its own words where it broke off."""
    with gentle_interrupt() as interrupt:
        run = simulate(scene, progress=progress)
    if interrupt.asked or run.status == "interrupted":
        raise KeyboardInterrupt
    if run.status == "failed" and run.accuracy.estimated_tip_error_m is None:
        raise _broken_off(run.failure or "no reason given", run.time)
    return run


def inlets_of(scene: Scene, run: MotionArrays) -> InletHistory:
    """What happened at the inlets of a run, with all actuators that they feed."""
    return InletHistory(run.time, run["inlet_pressure"], fed_by_each(scene) * run["inflow"])


def _broken_off(reason: str, times: np.ndarray) -> SolveError:
    end = float(times[-1]) if times.size else 0.0
    message = f"the plan's simulation failed: {reason}"
    return SolveError(message, quantity="motion", where="plan", time_s=end)
