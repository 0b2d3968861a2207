"""Scene and pump changed for a trial, and what they then ask."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from viscodesign.errors import SolveError
from viscodesign.pump.planning.demand import Demand
from viscodesign.pump.planning.limits import infeasible, is_passed
from viscodesign.pump.planning.model_runs import follow
from viscodesign.pump.planning.requested import Wanted, lead_in, no_lead, shares_a_network
from viscodesign.pump.planning.scene_variants import ramped, scaled
from viscodesign.scene.pump import Pump
from viscodesign.scene.scene import Scene


@dataclass(frozen=True)
class Case:
    """A scene and its pump, as they are or changed."""

    pressure: float = 1.0
    """Factor of every pressure of the inputs."""
    time: float = 1.0
    """Factor of every time."""
    ramp: float = 0.0
    """Time over which every jump is spread [s]."""
    pump: Pump | None = None
    """Instead of the scene's own."""


@dataclass(frozen=True)
class Aim:
    """Limits that are to pass, at one inlet or at all."""

    inlet: str | None
    names: tuple[str, ...]

    def is_met(self, demands: tuple[Demand, ...]) -> bool:
        """Whether they do."""
        own = [d for d in demands if self.inlet in (None, d.inlet)]
        return all(is_passed(d, name) for d in own for name in self.names)


@dataclass
class Trials:
    """What was tried of one scene, so that nothing is followed twice."""

    scene: Scene
    """As it is followed, with its effects settled."""
    asked: Wanted
    pump: Pump
    _followed: dict[tuple[float, ...], Wanted | None] = field(default_factory=dict)

    def demands(self, case: Case) -> tuple[Demand, ...] | None:
        """What a case asks, through the coupled model; None where it cannot be followed."""
        pump = case.pump or self.pump
        key = (case.pressure, case.time, case.ramp)
        if key == (1.0, 1.0, 0.0):
            return self.asked.demands(pump)
        if key not in self._followed:
            self._followed[key] = self._follow(case, pump)
        found = self._followed[key]
        return None if found is None else found.demands(pump)

    def _follow(self, case: Case, pump: Pump) -> Wanted | None:
        scene, taken = scaled(self.scene, pressure=case.pressure, time=case.time), self.asked.taken
        if case.ramp:
            scene = ramped(scene, case.ramp)
        try:
            run = follow(scene, taken)
            # A lead-in never hurries; it matters where it tells which inlet gave how much.
            lead = no_lead(run)
            if shares_a_network(scene):
                lead = lead_in(scene, pump, self.asked.lines, run, taken)
        except SolveError:
            return None
        return Wanted(scene, run, taken, self.asked.lines, lead)

    def foreseen(self, case: Case) -> tuple[Demand, ...]:
        """The same without following it: what is taken goes with the pressure."""
        base = self.scene.gauge_pressure
        return tuple(
            replace(
                d,
                pressure=base + case.pressure * (d.pressure - base),
                given=case.pressure * d.given,
                time=case.time * d.time,
            )
            for d in self.asked.demands(case.pump or self.pump)
        )


def left(demands: tuple[Demand, ...]) -> tuple[str, ...]:
    """Names of all limits that forbid a case."""
    return tuple(dict.fromkeys(name for d in demands for name in infeasible(d)))
