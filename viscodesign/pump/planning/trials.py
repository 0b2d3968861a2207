"""Scene and pump changed for a trial, and what they then ask."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from viscodesign.errors import SolveError
from viscodesign.pump.planning.demand import PumpDemand
from viscodesign.pump.planning.limits import infeasible, verdict
from viscodesign.pump.planning.model_runs import run_model
from viscodesign.pump.planning.requested import (
    LeadIn,
    RequestedMotion,
    lead_in,
    shares_a_network,
)
from viscodesign.pump.planning.scene_variants import ramped, scaled
from viscodesign.scene.pump import PumpSpec
from viscodesign.scene.scene import Scene


@dataclass(frozen=True)
class Variation:
    """A scene and its pump, as they are or changed."""

    pressure: float = 1.0
    """Factor of every pressure of the inputs."""
    time: float = 1.0
    """Factor of every time."""
    ramp: float = 0.0
    """Time over which every jump is spread [s]."""
    pump: PumpSpec | None = None
    """Instead of the scene's own."""


@dataclass(frozen=True)
class Aim:
    """Limits that are to pass, at one inlet or at all."""

    inlet: str | None
    names: tuple[str, ...]

    def is_met(self, demands: tuple[PumpDemand, ...] | None) -> bool:
        """Whether they do; never where the model could not be run."""
        if demands is None:
            return False
        own = [d for d in demands if self.inlet in (None, d.inlet)]
        return all(verdict(d, name).severity == "ok" for d in own for name in self.names)


@dataclass
class Trials:
    """What was tried of one scene, so that no model runs twice."""

    scene: Scene
    """As it is run, with its effects settled."""
    requested: RequestedMotion
    pump: PumpSpec
    _known: dict[tuple[float, ...], RequestedMotion | None] = field(default_factory=dict)

    def pump_of(self, case: Variation) -> PumpSpec:
        """The pump settings of a variation."""
        return case.pump or self.pump

    def demands(self, case: Variation) -> tuple[PumpDemand, ...] | None:
        """What a variation asks, through the coupled model; None where that fails."""
        key = (case.pressure, case.time, case.ramp)
        if key == (1.0, 1.0, 0.0):
            return self.requested.demands(self.pump_of(case))
        if key not in self._known:
            self._known[key] = self._run(case)
        found = self._known[key]
        return None if found is None else found.demands(self.pump_of(case))

    def _run(self, case: Variation) -> RequestedMotion | None:
        scene = scaled(self.scene, pressure=case.pressure, time=case.time)
        active, lines = self.requested.active, self.requested.lines
        if case.ramp:
            scene = ramped(scene, case.ramp)
        try:
            run = run_model(scene, active)
            # A lead-in never hurries; it matters where it tells which inlet gave how much.
            lead = LeadIn.none(run)
            if shares_a_network(scene):
                lead = lead_in(scene, self.pump_of(case), lines, run, active)
        except SolveError:
            return None
        return RequestedMotion(scene, run, active, lines, lead)

    def estimated(self, case: Variation) -> tuple[PumpDemand, ...]:
        """The same without a run: what is given goes with the pressure."""
        base = self.scene.gauge_pressure
        return tuple(
            replace(
                d,
                pressure=base + case.pressure * (d.pressure - base),
                given=case.pressure * d.given,
                time=case.time * d.time,
            )
            for d in self.requested.demands(self.pump_of(case))
        )


def remaining(demands: tuple[PumpDemand, ...] | None) -> tuple[str, ...]:
    """Names of all limits that forbid a variation."""
    return tuple(dict.fromkeys(name for d in demands or () for name in infeasible(d)))
