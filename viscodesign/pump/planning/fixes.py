"""The smallest change that makes a limit pass: estimated, then tried through the coupled model."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.planning.fix import RAMPS, SLOWER, Fix, Steps
from viscodesign.pump.planning.result import PumpVerdict, SuggestedChange
from viscodesign.pump.planning.scene_variants import jumps, scaled_fields
from viscodesign.pump.planning.trials import Aim, Trials, Variation, remaining
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


def fixes_for(trials: Trials, verdict: PumpVerdict) -> tuple[SuggestedChange, ...]:
    """What makes a verdict pass, each change alone; those that leave least undone first."""
    aim = Aim(verdict.inlet, (verdict.name,))
    tried = [
        _applied(fix, trials, aim, {}) for fix in trials.requested.kind.fixes.get(verdict.name, ())
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
        steps = trials.requested.kind.stepwise
        first, names = steps[0]
        stepwise = [
            _stepwise(trials, ((first, (*names, *more)), *steps[1:])) for more in ((), ("cap",))
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
        if not set(remaining(trials.demands(case))) & set(names):
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
    value = (_whole if fix.whole else _value)(fix, trials, aim, case)
    if value is None:
        return None
    tried, shown = {**case, fix.key: value}, value / fix.si
    settings: tuple[str, ...] = (f"{fix.key}={shown:.6g} {fix.unit}".strip(),)
    if not fix.key.startswith("pump."):
        settings = tuple(_input_settings(scene, tried))
    words, left = fix.words.format(shown), remaining(trials.demands(tried))
    factor = value if fix.key in ("pressure", "time") else 1.0
    return SuggestedChange(fix.key, words, settings, left, factor), tried


def _whole(fix: Fix, trials: Trials, aim: Aim, case: Variation) -> float | None:
    """The value of a key that counts, nearest to its own, that passes all that it cures."""
    assert fix.whole is not None
    pump, aim = trials.pump_of(case), Aim(aim.inlet, fix.cures)
    own = getattr(pump, fix.key.removeprefix("pump."))
    values = sorted(fix.whole(pump), key=lambda value: abs(value - own))
    passing = (v for v in values if aim.is_met(trials.demands({**case, fix.key: v})))
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
