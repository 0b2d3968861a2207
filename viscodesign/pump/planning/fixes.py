"""The smallest change that makes a limit pass, found and tried, not guessed.

A change of the drive asks nothing new of the actuator: it is tried at once. A change of the
pressures is sought with the amount that the actuator takes in proportion to them, then
tried through the coupled model, and made larger until it holds.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace

from viscodesign.pump.planning.result import Change, PumpVerdict
from viscodesign.pump.planning.scene_variants import jumps, scaled_fields
from viscodesign.pump.planning.trials import Aim, Case, Trials, left
from viscodesign.pump.servo_motor import SERVOS
from viscodesign.scene.inputs.table import Table
from viscodesign.scene.pump import Pump
from viscodesign.scene.reading.field_lookup import quantity_of
from viscodesign.scene.scene import Scene

HALVINGS = 40
FAINTEST, STRONGEST = 0.005, 100.0
"""Factors of pressure between which one is sought."""
SLOWEST = 1000.0
RETRIES = 10
MORE = 0.97
"""What a factor that did not hold is changed by, first; each next time by twice as much."""
GROWING = 2.0
REFINED = 5
"""Halvings between one that did not hold and one that did."""
THINNEST, WIDEST = 5e-3, 0.1
"""Diameters of barrels between which one is sought [m]."""
DIGITS = 3

Found = tuple[Change, Case]
Seek = Callable[[Trials, Aim, Case], Found | None]


def changes_for(trials: Trials, verdict: PumpVerdict) -> tuple[Change, ...]:
    """What makes a verdict pass, each change alone; those that leave least undone first."""
    aim = Aim(verdict.inlet, (verdict.name,))
    sought = [seek(trials, aim, Case()) for seek in SEEKERS.get(verdict.name, ())]
    found = [pair[0] for pair in sought if pair is not None]
    return tuple(sorted(found, key=lambda change: len(change.leaves)))


def together(trials: Trials, verdicts: tuple[PumpVerdict, ...]) -> tuple[Change, ...]:
    """Few changes, one upon the other, after which nothing is infeasible; else none.

    Either one change that does it alone, or the pressures lowered as far as all limits ask
    that have no other cure, and the drive changed for the rest: what leaves most of the
    pressures, and of equals what changes least.
    """
    faults = [v for v in verdicts if v.severity == "infeasible"]
    ways: list[tuple[Change, ...]] = [(change,) for v in faults for change in v.changes]
    if faults and not any(not way[0].leaves and _kept(way) == 1.0 for way in ways):
        ways += [_stepwise(trials, names) for names in (BY_PRESSURE, (*BY_PRESSURE, "cap"))]
    whole = [way for way in ways if way and not way[-1].leaves]
    return max(whole, key=lambda way: (_kept(way), -len(way)), default=())


def _kept(way: tuple[Change, ...]) -> float:
    """Part of the pressures that some changes leave."""
    return min((change.factor for change in way if change.key == "pressure"), default=1.0)


BY_PRESSURE = ("stall", "speed", "suction")
"""What lower pressures cure, and another drive only at a price."""


def _stepwise(trials: Trials, lowered_for: tuple[str, ...]) -> tuple[Change, ...]:
    """Pressures lowered for these limits, then the drive changed for what is left."""
    case = Case()
    made: dict[str, Change] = {}
    steps: tuple[tuple[Seek, tuple[str, ...]], ...] = (
        (weaker, lowered_for),
        (other_home, ("travel", "barrel")),
        (weaker, ("travel", "barrel")),
        (higher_cap, ("cap",)),
    )
    for seek, names in steps:
        demands = trials.demands(case)
        if demands is None or not set(left(demands)) & set(names):
            continue
        found = seek(trials, Aim(None, names), case)
        if found is not None:
            change, case = found
            # Factors multiply: the last one says all, and comes last.
            made.pop(change.key, None)
            made[change.key] = change
    return tuple(made.values())


# -- pressures ------------------------------------------------------------------


def weaker(trials: Trials, aim: Aim, case: Case) -> Found | None:
    """Every pressure of the inputs by a factor below one."""
    return _scaled(trials, aim, case, "pressure", FAINTEST)


def stronger(trials: Trials, aim: Aim, case: Case) -> Found | None:
    """The same by one above."""
    return _scaled(trials, aim, case, "pressure", STRONGEST)


def slower(trials: Trials, aim: Aim, case: Case) -> Found | None:
    """Every time of inputs and run by a factor above one; what jumps gets no slower by that."""
    if jumps(trials.scene):
        return gentler(trials, aim, case)
    return _scaled(trials, aim, case, "time", SLOWEST)


def gentler(trials: Trials, aim: Aim, case: Case) -> Found | None:
    """Every jump of the pressures spread over a time."""

    def holds(lasting: float) -> bool:
        demands = trials.demands(replace(case, ramp=lasting))
        return demands is not None and aim.is_met(demands)

    shortest = float(min(trials.asked.run.time[1:] - trials.asked.run.time[:-1]))
    lasting = _holding(holds, _rounded(shortest, SLOWEST), SLOWEST)
    if lasting is None:
        return None
    tried = replace(case, ramp=lasting)
    words = f"every jump of the pressure spread over {lasting:.3g} s"
    return Change("ramp", words, (), left(trials.demands(tried) or ())), tried


def _scaled(trials: Trials, aim: Aim, case: Case, what: str, far: float) -> Found | None:
    def with_(factor: float) -> Case:
        changed = {"pressure": case.pressure, "time": case.time, what: factor}
        return replace(case, pressure=changed["pressure"], time=changed["time"])

    def foreseen(factor: float) -> bool:
        return aim.is_met(trials.foreseen(with_(factor)))

    guess = _nearest(foreseen, getattr(case, what), far)
    if guess is None:
        return None

    def holds(factor: float) -> bool:
        demands = trials.demands(with_(factor))
        return demands is not None and aim.is_met(demands)

    factor = _holding(holds, _rounded(guess, far), far)
    if factor is None:
        return None
    tried = with_(factor)
    settings = tuple(_settings(trials.scene, tried))
    words = WORDS[what].format(factor)
    return Change(what, words, settings, left(trials.demands(tried) or ()), factor), tried


def _holding(holds: Callable[[float], bool], factor: float, far: float) -> float | None:
    """The factor nearest to a guess, towards ``far``, that the coupled model confirms."""
    step = MORE if far < factor else 1 / MORE
    failed: float | None = None
    for _ in range(RETRIES):
        if holds(factor):
            break
        failed, factor, step = factor, _rounded(factor * step, far), step**GROWING
    else:
        return None
    for _ in range(REFINED if failed is not None else 0):
        assert failed is not None
        middle = _rounded(math.sqrt(failed * factor), far)
        if middle in (failed, factor):
            break
        failed, factor = (failed, middle) if holds(middle) else (middle, factor)
    return factor


WORDS = {
    "pressure": "{:.3g} times every pressure of the input",
    "time": "everything {:.3g} times as slow",
}


def _settings(scene: Scene, case: Case) -> Iterator[str]:
    """What to set in the spec for a case; nothing where a table holds the numbers."""
    if any(isinstance(source, Table) for source in scene.inputs.values()):
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


def _nearest(passes: Callable[[float], bool], near: float, far: float) -> float | None:
    """The value nearest to ``near`` that passes, between the two; None where ``far`` does not."""
    if not passes(far):
        return None
    low, high = math.log(near), math.log(far)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if passes(math.exp(middle)) else (middle, high)
    return math.exp(high)


def _rounded(value: float, far: float) -> float:
    """Few digits, towards ``far``; what has no more already stays."""
    unit = 10.0 ** (math.floor(math.log10(value)) - DIGITS + 1)
    steps = value / unit
    near = round(steps)
    turned = math.floor(steps) if far < value else math.ceil(steps)
    return float(f"{(near if abs(steps - near) < 1e-6 else turned) * unit:.12g}")


# -- the drive ------------------------------------------------------------------


def _with_pump(
    trials: Trials, aim: Aim, case: Case, pump: Pump, words: str, setting: str
) -> Found | None:
    tried = replace(case, pump=pump)
    demands = trials.demands(tried)
    if demands is None or not aim.is_met(demands):
        return None
    key = setting.partition("=")[0]
    return Change(key, words, (setting,), left(demands)), tried


def _sought(trials: Trials, aim: Aim, case: Case, key: str, far: float) -> float | None:
    """The value of a key of the drive nearest to its own that passes, rounded towards ``far``."""
    pump = case.pump or trials.pump
    near = float(getattr(pump, key))
    demands = trials.demands(case)
    if demands is None or near == far:
        return None

    def passes(value: float) -> bool:
        other = pump.model_copy(update={key: value})
        return aim.is_met(tuple(d.with_pump(other) for d in demands))

    found = _nearest(passes, near, far)
    return None if found is None else _rounded(found, far)


def thinner(trials: Trials, aim: Aim, case: Case) -> Found | None:
    """A barrel of smaller diameter."""
    return _diameter(trials, aim, case, THINNEST)


def wider(trials: Trials, aim: Aim, case: Case) -> Found | None:
    """A barrel of larger diameter."""
    return _diameter(trials, aim, case, WIDEST)


def _diameter(trials: Trials, aim: Aim, case: Case, far: float) -> Found | None:
    value = _sought(trials, aim, case, "syringe_diameter", far)
    if value is None:
        return None
    pump = (case.pump or trials.pump).model_copy(update={"syringe_diameter": value})
    words = f"a syringe of {1e3 * value:.4g} mm inner diameter"
    setting = f"pump.syringe_diameter={1e3 * value:.4g} mm"
    return _with_pump(trials, aim, case, pump, words, setting)


def more_voltage(trials: Trials, aim: Aim, case: Case) -> Found | None:
    """A battery of more voltage, up to what the servo is rated for."""
    pump = case.pump or trials.pump
    rated = SERVOS[pump.servo].rated_voltage
    if pump.supply_voltage >= rated:
        return None
    value = _sought(trials, aim, case, "supply_voltage", rated)
    if value is None:
        return None
    pump = pump.model_copy(update={"supply_voltage": min(value, rated)})
    setting = f"pump.supply_voltage={pump.supply_voltage:.4g} V"
    words = f"a supply of {pump.supply_voltage:.4g} V"
    return _with_pump(trials, aim, case, pump, words, setting)


def higher_cap(trials: Trials, aim: Aim, case: Case) -> Found | None:
    """A software cap that lets the pressures through."""
    demands = trials.demands(case)
    if demands is None:
        return None
    highest = max(float(d.pressure.max()) for d in demands)
    value = math.ceil(highest / 100.0) * 100.0
    pump = (case.pump or trials.pump).model_copy(update={"max_pressure": value})
    words = f"a cap of {value / 1e3:.4g} kPa gauge"
    setting = f"pump.max_pressure={value / 1e3:.6g} kPa gauge"
    return _with_pump(trials, aim, case, pump, words, setting)


def other_home(trials: Trials, aim: Aim, case: Case) -> Found | None:
    """Another count of home, the nearest that does; the barrel then is as full as it follows."""
    pump, demands = case.pump or trials.pump, trials.demands(case)
    if demands is None:
        return None
    low, high = pump.travel
    # Whoever leaves its travel seldom stays within its barrel: one home is to do for both.
    aims = Aim(aim.inlet, ("travel", "barrel"))
    for home in sorted(range(low, high + 1), key=lambda count: abs(count - pump.home)):
        moved = pump.model_copy(update={"home": home})
        if aims.is_met(tuple(d.with_pump(moved) for d in demands)):
            words = f"home at count {home}"
            return _with_pump(trials, aim, case, moved, words, f"pump.home={home}")
    return None


SEEKERS: dict[str, tuple[Seek, ...]] = {
    "stall": (weaker, thinner, more_voltage),
    "one_fifth": (weaker, thinner, more_voltage),
    "speed": (slower, weaker, more_voltage),
    "travel": (other_home, weaker, wider),
    "barrel": (other_home, weaker, wider),
    "suction": (weaker,),
    "cap": (higher_cap, weaker),
    "resolution": (thinner, stronger),
    "pressure_step": (thinner,),
    "speed_register": (thinner,),
}
"""What may help against a limit, simplest first."""
