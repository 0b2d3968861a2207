"""Fixes that change what is asked of the pump: lower or higher pressures, more time, ramps.

Each is estimated with the volumes that go in proportion to the pressure, then tried through
the coupled model, and made larger until it holds.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Literal

from viscodesign.pump.planning.factor_search import confirmed, nearest, rounded
from viscodesign.pump.planning.result import SuggestedChange
from viscodesign.pump.planning.scene_variants import jumps, scaled_fields
from viscodesign.pump.planning.trials import Aim, Trials, Variation, remaining
from viscodesign.scene.inputs.table import TableInput
from viscodesign.scene.reading.field_lookup import quantity_of
from viscodesign.scene.scene import Scene

FAINTEST, STRONGEST, SLOWEST = 0.005, 100.0, 1000.0
"""Farthest factors of pressure and of time that are tried."""
Found = tuple[SuggestedChange, Variation]


def lower_pressures(trials: Trials, aim: Aim, case: Variation) -> Found | None:
    """Every pressure of the inputs by a factor below one."""
    return _scaled(trials, aim, case, "pressure", FAINTEST)


def higher_pressures(trials: Trials, aim: Aim, case: Variation) -> Found | None:
    """Every pressure of the inputs by a factor above one."""
    return _scaled(trials, aim, case, "pressure", STRONGEST)


def more_time(trials: Trials, aim: Aim, case: Variation) -> Found | None:
    """Every time of inputs and run by a factor above one; jumps, which have none, as ramps."""
    if jumps(trials.scene):
        return _ramps(trials, aim, case)
    return _scaled(trials, aim, case, "time", SLOWEST)


def _ramps(trials: Trials, aim: Aim, case: Variation) -> Found | None:
    """Every jump of the pressures spread over a time."""
    time = trials.requested.run.time
    shortest = float(min(time[1:] - time[:-1]))
    duration = confirmed(
        lambda duration: aim.is_met(trials.demands(replace(case, ramp=duration))),
        rounded(shortest, SLOWEST),
        SLOWEST,
    )
    if duration is None:
        return None
    tried = replace(case, ramp=duration)
    words = f"every jump of the pressure as a ramp of {duration:.3g} s"
    return SuggestedChange("ramp", words, (), remaining(trials.demands(tried))), tried


def _scaled(
    trials: Trials, aim: Aim, case: Variation, what: Literal["pressure", "time"], far: float
) -> Found | None:
    def changed(factor: float) -> Variation:
        return replace(case, pressure=factor) if what == "pressure" else replace(case, time=factor)

    guess = nearest(lambda f: aim.is_met(trials.estimated(changed(f))), getattr(case, what), far)
    if guess is None:
        return None
    factor = confirmed(lambda f: aim.is_met(trials.demands(changed(f))), rounded(guess, far), far)
    if factor is None:
        return None
    tried = changed(factor)
    words = f"every pressure of the input times {factor:.3g}"
    if what == "time":
        words = f"everything slower by a factor of {factor:.3g}"
    settings, left = tuple(_settings(trials.scene, tried)), remaining(trials.demands(tried))
    return SuggestedChange(what, words, settings, left, factor), tried


def _settings(scene: Scene, case: Variation) -> Iterator[str]:
    """What to set in the spec for a variation; nothing where a table holds the numbers."""
    if any(isinstance(source, TableInput) for source in scene.inputs.values()):
        return
    for name, source in scene.inputs.items():
        prefix = "input" if scene.several_inputs is None else f"inputs.{name}"
        fields = scaled_fields(source, pressure=case.pressure, time=case.time)
        for key, value in fields.items():
            kind = quantity_of(type(source).model_fields[key])
            assert kind is not None, "only quantities are scaled"
            yield f"{prefix}.{key}={value:.6g} {kind.unit}"
    if case.time != 1.0:
        yield f"run.duration={case.time * scene.run.duration:.6g} s"
