"""The smallest change that makes a limit pass, found and tried, not guessed."""

from __future__ import annotations

from collections.abc import Callable

from viscodesign.pump.planning import drive_fixes as drive
from viscodesign.pump.planning import input_fixes as inputs
from viscodesign.pump.planning.result import PumpVerdict, SuggestedChange
from viscodesign.pump.planning.trials import Aim, Trials, Variation, remaining

Fix = Callable[[Trials, Aim, Variation], inputs.Found | None]

FIXES: dict[str, tuple[Fix, ...]] = {
    "stall": (inputs.lower_pressures, drive.thinner_barrel, drive.more_voltage),
    "one_fifth": (inputs.lower_pressures, drive.thinner_barrel, drive.more_voltage),
    "speed": (inputs.more_time, inputs.lower_pressures, drive.more_voltage),
    "travel": (drive.other_home, inputs.lower_pressures, drive.wider_barrel),
    "barrel": (drive.other_home, inputs.lower_pressures, drive.wider_barrel),
    "suction": (inputs.lower_pressures,),
    "cap": (drive.higher_cap, inputs.lower_pressures),
    "resolution": (drive.thinner_barrel, inputs.higher_pressures),
    "pressure_step": (drive.thinner_barrel,),
    "speed_register": (drive.thinner_barrel,),
}
"""What may help against a limit, simplest first."""
CURED_BY_PRESSURE = ("stall", "speed", "suction")
"""What lower pressures cure, and another drive only at a price."""


def fixes_for(trials: Trials, verdict: PumpVerdict) -> tuple[SuggestedChange, ...]:
    """What makes a verdict pass, each change alone; those that leave least undone first."""
    aim = Aim(verdict.inlet, (verdict.name,))
    tried = [fix(trials, aim, Variation()) for fix in FIXES.get(verdict.name, ())]
    found = [pair[0] for pair in tried if pair is not None]
    return tuple(sorted(found, key=lambda change: len(change.leaves)))


def combined_fix(trials: Trials, verdicts: tuple[PumpVerdict, ...]) -> tuple[SuggestedChange, ...]:
    """Few changes, one upon the other, after which nothing is infeasible; else none.

    Either one change that does it alone, or the pressures lowered as far as all limits ask
    that have no other cure, and the drive changed for the rest: what leaves most of the
    pressures, and of equals what changes least.
    """
    faults = [v for v in verdicts if v.severity == "infeasible"]
    options: list[tuple[SuggestedChange, ...]] = [(c,) for v in faults for c in v.changes]
    if faults and not any(not one[0].leaves and _kept_pressure(one) == 1.0 for one in options):
        for names in (CURED_BY_PRESSURE, (*CURED_BY_PRESSURE, "cap")):
            options.append(_stepwise(trials, names))
    whole = [option for option in options if option and not option[-1].leaves]
    return max(whole, key=lambda option: (_kept_pressure(option), -len(option)), default=())


def _kept_pressure(changes: tuple[SuggestedChange, ...]) -> float:
    """Part of the pressures that some changes leave."""
    return min((c.factor for c in changes if c.key == "pressure"), default=1.0)


def _stepwise(trials: Trials, lowered_for: tuple[str, ...]) -> tuple[SuggestedChange, ...]:
    """Pressures lowered for these limits, then the drive changed for what is left."""
    case = Variation()
    made: dict[str, SuggestedChange] = {}
    steps: tuple[tuple[Fix, tuple[str, ...]], ...] = (
        (inputs.lower_pressures, lowered_for),
        (drive.other_home, ("travel", "barrel")),
        (inputs.lower_pressures, ("travel", "barrel")),
        (drive.higher_cap, ("cap",)),
    )
    for fix, names in steps:
        if not set(remaining(trials.demands(case))) & set(names):
            continue
        found = fix(trials, Aim(None, names), case)
        if found is not None:
            change, case = found
            # Factors multiply: the last one says all, and comes last.
            made.pop(change.key, None)
            made[change.key] = change
    return tuple(made.values())
