"""The smallest change that makes a limit pass: estimated, then tried through the coupled model."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Callable, Iterator, Mapping
from dataclasses import field, replace
from typing import NamedTuple

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.planning.demand import PumpDemand
from viscodesign.pump.planning.limits import RAMPS, SLOWER, Fix, Steps, infeasible, verdict
from viscodesign.pump.planning.motion import RequestedMotion, run_model, shares_a_network
from viscodesign.pump.planning.result import PumpVerdict, SuggestedChange
from viscodesign.pump.planning.scene_variants import jumps, ramped, scaled, scaled_fields
from viscodesign.scene.inputs.table import TableInput
from viscodesign.scene.pumps.base import PumpSpec
from viscodesign.scene.reading.field_lookup import quantity_of
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import copied

Variation = Mapping[str, float]
"""What is changed: factors of all pressures (`pressure`) and times (`time`), the duration of every
jump (`ramp`) [s], and keys of the pump, such as `pump.home`."""
FIX_DIGITS = 3
"""Of the values that are tried."""
ESTIMATE_MARGIN = 4.0
"""Factor by which an estimate may be off."""


class Aim(NamedTuple):
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

    def left(self, case: Variation) -> tuple[str, ...]:
        """Names of all limits that forbid a variation."""
        return tuple(dict.fromkeys(name for d in self.demands(case) for name in infeasible(d)))


def fixes_for(trials: Trials, verdict: PumpVerdict) -> tuple[SuggestedChange, ...]:
    """What makes a verdict pass, each change alone; those that leave least undone first."""
    limit, names = trials.requested.kind.limits[verdict.name], (verdict.name,)
    tried = [
        _applied(fix, trials, Aim(verdict.inlet, fix.cures or names), {}) for fix in limit.fixes
    ]
    found = [pair[0] for pair in tried if pair is not None]
    return tuple(sorted(found, key=lambda change: len(change.leaves)))


def combined_fix(trials: Trials, verdicts: tuple[PumpVerdict, ...]) -> tuple[SuggestedChange, ...]:
    """Few changes, one upon the other, after which nothing is infeasible; else none.

    What leaves most of the pressures, and of equals what changes least.
    """
    faults = [v for v in verdicts if v.severity == "infeasible"]
    options: list[tuple[SuggestedChange, ...]]
    options = [(change,) for v in faults for change in v.changes if not change.leaves]
    if faults and not any(_kept_pressure(option) == 1.0 for option in options):
        (first, names), *others = trials.requested.kind.stepwise
        stepwise = [
            _stepwise(trials, ((first, (*names, *more)), *others)) for more in ((), ("cap",))
        ]
        options += [option for option in stepwise if option and not option[-1].leaves]
    return max(options, key=lambda option: (_kept_pressure(option), -len(option)), default=())


def _kept_pressure(changes: tuple[SuggestedChange, ...]) -> float:
    """Share of the pressures that some changes leave."""
    return min((c.factor for c in changes if c.key == "pressure"), default=1.0)


def _stepwise(trials: Trials, steps: Steps) -> tuple[SuggestedChange, ...]:
    """One change after the other, each for what is left of its limits."""
    case: Variation = {}
    made: dict[str, SuggestedChange] = {}
    for fix, names in steps:
        if not set(trials.left(case)) & set(names):
            continue
        if found := _applied(fix, trials, Aim(None, tuple(names)), case):
            change, case = found
            # Factors multiply: the last one says all, and comes last.
            made.pop(change.key, None)
            made[change.key] = change
    return tuple(made.values())


def _applied(
    fix: Fix, trials: Trials, aim: Aim, case: Variation
) -> tuple[SuggestedChange, Variation] | None:
    """The smallest change of this kind that meets an aim, and the variation with it."""
    scene = trials.requested.scene
    if fix is SLOWER and jumps(scene):  # which have no time of their own
        fix = RAMPS
    value = _value(fix, trials, aim, case)
    if value is None:
        return None
    tried, shown = {**case, fix.key: value}, value / fix.si
    settings: tuple[str, ...] = (f"{fix.key}={shown:.6g} {fix.unit}".strip(),)
    if not fix.key.startswith("pump."):
        settings = tuple(_input_settings(scene, tried))
    factor = value if fix.key in ("pressure", "time") else 1.0
    words = fix.words.format(shown)
    return SuggestedChange(fix.key, words, settings, trials.left(tried), factor), tried


def _value(fix: Fix, trials: Trials, aim: Aim, case: Variation) -> float | None:
    """The value nearest to the present one that meets an aim: estimated, then tried."""
    pump = trials.pump_of(case)
    own = getattr(pump, fix.key.removeprefix("pump."), 1.0)

    def fits(value: float) -> bool:
        return aim.is_met(trials.estimated(case, {**case, fix.key: value}))

    def holds(value: float) -> bool:
        return aim.is_met(trials.demands({**case, fix.key: value}))

    if fix.whole is not None:
        nearest = sorted(fix.whole(pump), key=lambda value: abs(value - own))
        return next(filter(holds, nearest), None)
    if fix is RAMPS:
        time = trials.requested.run.time
        return _nearest(holds, float(min(np.diff(time))), float(time[-1]))
    guess = _nearest(fits, case.get(fix.key, own), fix.far)
    if guess is None or holds(guess):
        return guess
    return _nearest(
        holds, guess, float(np.clip(fix.far, guess / ESTIMATE_MARGIN, guess * ESTIMATE_MARGIN))
    )


def _nearest(passes: Callable[[float], bool], near: float, far: float) -> float | None:
    """The value of few digits nearest to ``near`` that passes; None where ``far`` does not.

    Both are above 0; what passes is taken to pass all the way from there to ``far``.
    """
    low, high = sorted((near, far))
    decades = range(math.floor(math.log10(low)), math.floor(math.log10(high)) + 1)
    digits = range(10 ** (FIX_DIGITS - 1), 10**FIX_DIGITS)
    values = [float(f"{n}e{decade - FIX_DIGITS + 1}") for decade in decades for n in digits]
    values = [value for value in values if low <= value <= high]
    if far < near:
        values.reverse()
    if not values or not passes(values[-1]):
        return None
    return values[bisect_left(values, True, key=passes)]


def _input_settings(scene: Scene, case: Variation) -> Iterator[str]:
    """What to set in the spec for other pressures and times; nothing for a table or ramps."""
    if "ramp" in case or any(isinstance(source, TableInput) for source in scene.inputs.values()):
        return
    pressure, time = case.get("pressure", 1.0), case.get("time", 1.0)
    for name, source in scene.inputs.items():
        prefix = "input" if scene.several_inputs is None else f"inputs.{name}"
        for key, value in scaled_fields(source, pressure=pressure, time=time).items():
            kind = quantity_of(type(source).model_fields[key])
            assert kind is not None, "only quantities are scaled"
            yield f"{prefix}.{key}={value:.6g} {kind.unit}"
    if time != 1.0:
        yield f"run.duration={time * scene.run.duration:.6g} s"
