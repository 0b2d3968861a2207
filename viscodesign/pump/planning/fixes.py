"""The smallest change that makes a limit pass: estimated, then tried through the coupled model."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.planning.result import PumpVerdict, SuggestedChange
from viscodesign.pump.planning.scene_variants import jumps, scaled_fields
from viscodesign.pump.planning.trials import Aim, Trials, Variation, remaining
from viscodesign.pump.servo_motor import SERVOS
from viscodesign.scene.inputs.table import TableInput
from viscodesign.scene.reading.field_lookup import quantity_of
from viscodesign.scene.scene import Scene


@dataclass(frozen=True)
class SearchNumbers:
    """How long and how finely a value is sought."""

    halvings: int = 40
    model_halvings: int = 9  # where each takes a run of the model
    reach: float = 4.0  # factor by which an estimate may be off
    digits: int = 3


SEARCH = SearchNumbers()


@dataclass(frozen=True)
class Fix:
    """A number that is changed, and as far as to where."""

    key: str  # of a `Variation`
    far: float
    words: str
    unit: str = ""  # in which a spec states it
    si: float = 1.0  # of that unit


LOWER = Fix("pressure", 0.005, "every pressure of the input times {:.3g}")
HIGHER = replace(LOWER, far=100.0)
SLOWER = Fix("time", 1000.0, "everything slower by a factor of {:.3g}")
RAMPS = Fix("ramp", 1000.0, "every jump of the pressure as a ramp of {:.3g} s")
THINNER = Fix("pump.syringe_diameter", 5e-3, "a syringe of {:.4g} mm inner diameter", "mm", 1e-3)
WIDER = replace(THINNER, far=0.1)
RATED = min(servo.rated_voltage for servo in SERVOS.values())
VOLTAGE = Fix("pump.supply_voltage", RATED, "a supply of {:.4g} V", "V")
CAP = Fix("pump.max_pressure", 1e7, "a cap of {:.4g} kPa gauge", "kPa gauge", 1e3)
HOME = Fix("pump.home", 0.0, "home at count {:.0f}")
FIXES = {
    "stall": (LOWER, THINNER, VOLTAGE),
    "one_fifth": (LOWER, THINNER, VOLTAGE),
    "speed": (SLOWER, LOWER, VOLTAGE),
    "travel": (HOME, LOWER, WIDER),
    "barrel": (HOME, LOWER, WIDER),
    "suction": (LOWER,),
    "cap": (CAP, LOWER),
    "resolution": (THINNER, HIGHER),
    "pressure_step": (THINNER,),
    "speed_register": (THINNER,),
}
"""What may help against a limit, simplest first."""
CURED_BY_PRESSURE = ("stall", "speed", "suction")
"""What lower pressures cure, and another drive only at a price."""
CURED_BY_HOME = ("travel", "barrel")


def fixes_for(trials: Trials, verdict: PumpVerdict) -> tuple[SuggestedChange, ...]:
    """What makes a verdict pass, each change alone; those that leave least undone first."""
    aim = Aim(verdict.inlet, (verdict.name,))
    tried = [_applied(fix, trials, aim, {}) for fix in FIXES.get(verdict.name, ())]
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
        stepwise = [_stepwise(trials, (*CURED_BY_PRESSURE, *more)) for more in ((), ("cap",))]
        options += [option for option in stepwise if option and not option[-1].leaves]
    return max(options, key=lambda option: (_kept_pressure(option), -len(option)), default=())


def _kept_pressure(changes: tuple[SuggestedChange, ...]) -> float:
    """Share of the pressures that some changes leave."""
    return min((c.factor for c in changes if c.key == "pressure"), default=1.0)


def _stepwise(trials: Trials, lowered_for: tuple[str, ...]) -> tuple[SuggestedChange, ...]:
    """Pressures lowered for these limits, then the drive changed for what is left."""
    case: Variation = {}
    made: dict[str, SuggestedChange] = {}
    steps = ((LOWER, lowered_for), (HOME, CURED_BY_HOME), (LOWER, CURED_BY_HOME), (CAP, ("cap",)))
    for fix, names in steps:
        if not set(remaining(trials.demands(case))) & set(names):
            continue
        if found := _applied(fix, trials, Aim(None, names), case):
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
    value = _home(trials, aim, case) if fix is HOME else _value(fix, trials, aim, case)
    if value is None:
        return None
    tried, shown = {**case, fix.key: value}, value / fix.si
    settings: tuple[str, ...] = (f"{fix.key}={shown:.6g} {fix.unit}".strip(),)
    if not fix.key.startswith("pump."):
        settings = tuple(_input_settings(scene, tried))
    words, left = fix.words.format(shown), remaining(trials.demands(tried))
    factor = value if fix.key in ("pressure", "time") else 1.0
    return SuggestedChange(fix.key, words, settings, left, factor), tried


def _home(trials: Trials, aim: Aim, case: Variation) -> float | None:
    """The home nearest to its own with which neither travel nor barrel is left."""
    pump, aim = trials.pump_of(case), Aim(aim.inlet, CURED_BY_HOME)
    low, high = pump.travel
    homes = sorted(range(low, high + 1), key=lambda count: abs(count - pump.home))
    passing = (h for h in homes if aim.is_met(trials.demands({**case, HOME.key: h})))
    return next(passing, None)


def _value(fix: Fix, trials: Trials, aim: Aim, case: Variation) -> float | None:
    """The value nearest to the present one that meets an aim: estimated, then tried."""

    def fits(value: float) -> bool:
        return aim.is_met(trials.estimated(case, {**case, fix.key: value}))

    def holds(value: float) -> bool:
        return aim.is_met(trials.demands({**case, fix.key: value}))

    if fix is RAMPS:
        time = trials.requested.run.time
        value, far = float(min(time[1:] - time[:-1])), float(time[-1])
    else:
        own = getattr(trials.pump_of(case), fix.key.removeprefix("pump."), 1.0)
        guess = _nearest(fits, case.get(fix.key, own), fix.far, SEARCH.halvings)
        if guess is None:
            return None
        value = _rounded(guess, fix.far)
        far = float(np.clip(fix.far, value / SEARCH.reach, value * SEARCH.reach))
    found = value if holds(value) else _nearest(holds, value, far, SEARCH.model_halvings)
    if found is None:
        return None
    value = _rounded(found, far)
    return value if holds(value) else None


def _nearest(
    passes: Callable[[float], bool], near: float, far: float, halvings: int
) -> float | None:
    """The value nearest to ``near`` that passes, between the two; None where ``far`` does not."""
    if not passes(far):
        return None
    low, high = math.log(near), math.log(far)
    for _ in range(halvings):
        middle = (low + high) / 2
        low, high = (low, middle) if passes(math.exp(middle)) else (middle, high)
    return math.exp(high)


def _rounded(value: float, far: float) -> float:
    """Few digits, rounded towards ``far``; what has no more already stays."""
    unit = 10.0 ** (math.floor(math.log10(value)) - SEARCH.digits + 1)
    steps = value / unit
    whole = round(steps)
    turned = math.floor(steps) if far < value else math.ceil(steps)
    return float(f"{(whole if abs(steps - whole) < 1e-6 else turned) * unit:.12g}")


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
