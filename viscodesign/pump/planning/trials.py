"""Scene and pump changed for a trial, and what they then ask."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.planning.demand import PumpDemand
from viscodesign.pump.planning.limits import infeasible, verdict
from viscodesign.pump.planning.motion import RequestedMotion, run_model, shares_a_network
from viscodesign.pump.planning.scene_variants import ramped, scaled
from viscodesign.scene.pumps.base import PumpSpec
from viscodesign.scene.spec_part import copied

Variation = Mapping[str, float]
"""What is changed: factors of all pressures (`pressure`) and times (`time`), the duration of every
jump (`ramp`) [s], and keys of the pump, such as `pump.home`."""


@dataclass(frozen=True)
class Aim:
    """Limits that are to pass, at one inlet or at all."""

    inlet: str | None
    names: tuple[str, ...]

    def is_met(self, demands: tuple[PumpDemand, ...]) -> bool:
        """Whether they do; never where the model could not be run."""
        own = [d for d in demands if self.inlet in (None, d.inlet)]
        checks = (verdict(d, name).severity == "ok" for d in own for name in self.names)
        return bool(own) and all(checks)


@dataclass(frozen=True)
class Trials:
    """What was tried of one motion, so that no model runs twice."""

    requested: RequestedMotion
    pump: PumpSpec
    _known: dict[tuple[float, ...], RequestedMotion | None] = field(default_factory=dict)

    def pump_of(self, case: Variation) -> PumpSpec:
        """The pump of a variation."""
        own = {key.removeprefix("pump."): case[key] for key in case if key.startswith("pump.")}
        return copied(self.pump, own)

    def demands(self, case: Variation) -> tuple[PumpDemand, ...]:
        """What a variation asks, through the coupled model; empty where that fails."""
        key = (case.get("pressure", 1.0), case.get("time", 1.0), case.get("ramp", 0.0))
        if key not in self._known:
            self._known[key] = self._run(case, *key) if key != (1.0, 1.0, 0.0) else self.requested
        found = self._known[key]
        return () if found is None else found.demands(self.pump_of(case))

    def _run(
        self, case: Variation, pressure: float, time: float, ramp: float
    ) -> RequestedMotion | None:
        scene = scaled(self.requested.scene, pressure=pressure, time=time)
        scene = ramped(scene, ramp) if ramp else scene
        try:
            run = run_model(scene, self.requested.active)
            # A lead-in never hurries; it matters where it tells which inlet gave how much.
            found = self.requested.without_lead_in(scene, run)
            return found.with_lead_in(self.pump_of(case)) if shares_a_network(scene) else found
        except SolveError:
            return None

    def estimated(self, base: Variation, case: Variation) -> tuple[PumpDemand, ...]:
        """What a variation of another one asks, without a run: volumes go with the pressure."""
        baseline, pump = self.requested.scene.gauge_pressure, self.pump_of(case)
        pressure, time = (case.get(k, 1.0) / base.get(k, 1.0) for k in ("pressure", "time"))
        return tuple(
            replace(
                d,
                pump=pump,
                pressure=baseline + pressure * (d.pressure - baseline),
                given=pressure * d.given,
                time=time * d.time,
            )
            for d in self.demands(base)
        )


def remaining(demands: tuple[PumpDemand, ...]) -> tuple[str, ...]:
    """Names of all limits that forbid a variation."""
    return tuple(dict.fromkeys(name for d in demands for name in infeasible(d)))
