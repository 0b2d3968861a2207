"""The smallest change that makes a limit pass, found and tried, not guessed.

A change of the drive asks nothing new of the actuator: it is tried at once. A change of the
pressures is sought with the amount that the actuator takes in proportion to them, then
tried through the coupled model, and made larger until it holds.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace

from viscodesign.errors import SolveError
from viscodesign.physics.servo import SERVOS
from viscodesign.planning.demand import Demand
from viscodesign.planning.limits import infeasible, is_passed
from viscodesign.planning.variants import scaled, scaled_fields
from viscodesign.planning.wanted import Wanted, follow, wanted
from viscodesign.pumpplan import Change, PumpVerdict
from viscodesign.scene.inputs.table import Table
from viscodesign.scene.keys import quantity_of
from viscodesign.scene.pump import Pump
from viscodesign.scene.scene import Scene

HALVINGS = 40
FAINTEST, STRONGEST = 0.005, 100.0
"""Factors of pressure between which one is sought."""
SLOWEST = 1000.0
RETRIES = 12
MORE = 0.97
"""What a factor that did not hold is changed by."""
THINNEST, WIDEST = 5e-3, 0.1
"""Diameters of barrels between which one is sought [m]."""
MOST_TOGETHER = 4
DIGITS = 3


@dataclass(frozen=True)
class Case:
    """A scene and a pump, as they are or changed."""

    pressure: float = 1.0
    time: float = 1.0
    pump: Pump | None = None


@dataclass
class Trials:
    """What was tried of one scene, so that nothing is followed twice."""

    scene: Scene
    """As it is followed, with its effects settled."""
    asked: Wanted
    pump: Pump
    _followed: dict[tuple[float, float], Wanted | None] = field(default_factory=dict)

    def demands(self, case: Case) -> tuple[Demand, ...] | None:
        """What a case asks, through the coupled model; None where it cannot be followed."""
        pump = case.pump or self.pump
        key = (case.pressure, case.time)
        if key == (1.0, 1.0):
            return self.asked.demands(pump)
        if key not in self._followed:
            self._followed[key] = self._follow(*key, pump)
        found = self._followed[key]
        return None if found is None else found.demands(pump)

    def _follow(self, pressure: float, time: float, pump: Pump) -> Wanted | None:
        scene = scaled(self.scene, pressure=pressure, time=time)
        try:
            return wanted(scene, follow(scene), pump)
        except SolveError:
            return None

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


def changes_for(trials: Trials, verdict: PumpVerdict, case: Case | None = None) -> tuple[Change, ...]:
    """What makes a verdict pass, each change alone; those that leave least undone first."""
    found = [
        change
        for seek in SEEKERS.get(verdict.name, ())
        if (change := seek(trials, verdict, case or Case())) is not None
    ]
    return tuple(change for change, _ in sorted(found, key=lambda pair: len(pair[0].leaves)))


def together(trials: Trials, verdicts: tuple[PumpVerdict, ...]) -> tuple[Change, ...]:
    """Few changes, one upon the other, after which nothing is infeasible; else none.

    One change that does it alone comes first. Else the pressures are lowered as far as all
    limits that follow them ask, and the drive is changed for the rest.
    """
    faults = [v for v in verdicts if v.severity == "infeasible"]
    for verdict in faults:
        for change in verdict.changes:
            if change.cures and not change.leaves:
                return (change,)
    case, made = Case(), []
    for _ in range(MOST_TOGETHER):
        demands = trials.demands(case)
        left = [] if demands is None else [n for d in demands for n in infeasible(d)]
        if not left:
            return tuple(made) if demands is not None else ()
        step = _next_step(trials, case, demands or (), left)
        if step is None:
            return ()
        case, change = step
        made.append(change)
    return ()


def _next_step(
    trials: Trials, case: Case, demands: tuple[Demand, ...], left: list[str]
) -> tuple[Case, Change] | None:
    """The next change towards a feasible plan, built upon those made before."""
    for name in left:
        demand = next(d for d in demands if name in infeasible(d))
        verdict = PumpVerdict(name, demand.inlet, "infeasible", 0, 0, "", 2, 0, "")
        best: tuple[Change, Case] | None = None
        for seek in SEEKERS.get(name, ()):
            found = seek(trials, verdict, case)
            if found and found[0].cures and (best is None or _better(found[0], best[0])):
                best = found
        if best is not None:
            return best[1], best[0]
    return None


def _better(one: Change, other: Change) -> bool:
    return len(one.leaves) < len(other.leaves)


Found = tuple[Change, Case]
Seek = Callable[[Trials, PumpVerdict, Case], Found | None]


# -- pressures ------------------------------------------------------------------


def weaker(trials: Trials, verdict: PumpVerdict, case: Case) -> Found | None:
    """Every pressure of the inputs by a factor below one."""
    return _scaled(trials, verdict, case, "pressure", FAINTEST)


def stronger(trials: Trials, verdict: PumpVerdict, case: Case) -> Found | None:
    """The same by one above."""
    return _scaled(trials, verdict, case, "pressure", STRONGEST)


def slower(trials: Trials, verdict: PumpVerdict, case: Case) -> Found | None:
    """Every time of inputs and run by a factor above one."""
    return _scaled(trials, verdict, case, "time", SLOWEST)


def _scaled(
    trials: Trials, verdict: PumpVerdict, case: Case, what: str, far: float
) -> Found | None:
    def with_(factor: float) -> Case:
        return replace(case, **{what: getattr(case, what) * factor})

    def foreseen(factor: float) -> bool:
        return _pass(trials.foreseen(with_(factor)), verdict)

    guess = _nearest(foreseen, 1.0, far)
    if guess is None:
        return None
    step = MORE if far < 1.0 else 1 / MORE
    factor = _rounded(guess, far)
    for _ in range(RETRIES):
        demands = trials.demands(with_(factor))
        if demands is not None and _pass(demands, verdict):
            break
        factor = _rounded(factor * step, far)
    else:
        return None
    tried = with_(factor)
    words = {
        "pressure": f"every pressure of the input by {factor:g}",
        "time": f"everything slower by {factor:g}",
    }[what]
    settings = tuple(_settings(trials.scene, tried))
    return Change(words, settings, True, _left(demands)), tried


def _settings(scene: Scene, case: Case) -> Iterator[str]:
    """What to set in the spec for a case; nothing where a table or a file holds the numbers."""
    if any(isinstance(source, Table) for source in scene.inputs.values()):
        return
    for name, source in scene.inputs.items():
        prefix = "input" if scene.several_inputs is None else f"inputs.{name}"
        fields = scaled_fields(source, pressure=case.pressure, time=case.time)
        for key, value in fields.items():
            kind = quantity_of(type(source).model_fields[key])
            assert kind is not None
            yield f"{prefix}.{key}={float(f'{value:.6g}'):g} {kind.unit}"
    if case.time != 1.0:
        yield f"run.duration={case.time * scene.run.duration:.6g} s"


def _pass(demands: tuple[Demand, ...], verdict: PumpVerdict) -> bool:
    own = next(d for d in demands if d.inlet == verdict.inlet)
    return is_passed(own, verdict.name)


def _left(demands: tuple[Demand, ...]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(name for d in demands for name in infeasible(d)))


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
    """Few digits, towards ``far``."""
    unit = 10.0 ** (math.floor(math.log10(value)) - DIGITS + 1)
    turn = math.floor if far < value else math.ceil
    return float(f"{turn(value / unit * (1 + (1e-9 if far < value else -1e-9))) * unit:.12g}")


# -- the drive ------------------------------------------------------------------


def _with_pump(
    trials: Trials, verdict: PumpVerdict, case: Case, pump: Pump, words: str, setting: str
) -> Found | None:
    tried = replace(case, pump=pump)
    demands = trials.demands(tried)
    if demands is None or not _pass(demands, verdict):
        return None
    return Change(words, (setting,), True, _left(demands)), tried


def _sought(
    trials: Trials, verdict: PumpVerdict, case: Case, key: str, far: float
) -> float | None:
    """The value of a key of the drive nearest to its own that passes, rounded towards ``far``."""
    pump = case.pump or trials.pump
    near = float(getattr(pump, key))
    demands = trials.demands(case)
    if demands is None or near == far:
        return None
    own = next(d for d in demands if d.inlet == verdict.inlet)

    def passes(value: float) -> bool:
        return is_passed(own.with_pump(pump.model_copy(update={key: value})), verdict.name)

    found = _nearest(passes, near, far)
    return None if found is None else _rounded(found, far)


def thinner(trials: Trials, verdict: PumpVerdict, case: Case) -> Found | None:
    """A barrel of smaller diameter."""
    return _diameter(trials, verdict, case, THINNEST)


def wider(trials: Trials, verdict: PumpVerdict, case: Case) -> Found | None:
    """A barrel of larger diameter."""
    return _diameter(trials, verdict, case, WIDEST)


def _diameter(trials: Trials, verdict: PumpVerdict, case: Case, far: float) -> Found | None:
    value = _sought(trials, verdict, case, "syringe_diameter", far)
    if value is None:
        return None
    pump = (case.pump or trials.pump).model_copy(update={"syringe_diameter": value})
    words = f"a syringe of {1e3 * value:.4g} mm inner diameter"
    setting = f"pump.syringe_diameter={1e3 * value:.4g} mm"
    return _with_pump(trials, verdict, case, pump, words, setting)


def more_voltage(trials: Trials, verdict: PumpVerdict, case: Case) -> Found | None:
    """A battery of more voltage, up to what the servo is rated for."""
    pump = case.pump or trials.pump
    rated = SERVOS[pump.servo].rated_voltage
    value = _sought(trials, verdict, case, "supply_voltage", rated)
    if value is None or pump.supply_voltage >= rated:
        return None
    value = min(value, rated)
    pump = pump.model_copy(update={"supply_voltage": value})
    setting = f"pump.supply_voltage={value:.4g} V"
    return _with_pump(trials, verdict, case, pump, f"a supply of {value:.4g} V", setting)


def higher_cap(trials: Trials, verdict: PumpVerdict, case: Case) -> Found | None:
    """A software cap that lets the pressures through."""
    demands = trials.demands(case)
    if demands is None:
        return None
    highest = max(float(d.pressure.max()) for d in demands)
    value = math.ceil(highest / 100.0) * 100.0
    pump = (case.pump or trials.pump).model_copy(update={"max_pressure": value})
    words = f"a cap of {value / 1e3:.4g} kPa gauge"
    setting = f"pump.max_pressure={value / 1e3:.6g} kPa gauge"
    return _with_pump(trials, verdict, case, pump, words, setting)


def other_home(trials: Trials, verdict: PumpVerdict, case: Case) -> Found | None:
    """Another count of home, the nearest that does; the barrel then is as full as it follows."""
    pump, demands = case.pump or trials.pump, trials.demands(case)
    if demands is None:
        return None
    low, high = pump.travel
    for home in sorted(range(low, high + 1), key=lambda count: abs(count - pump.home)):
        moved = pump.model_copy(update={"home": home})
        if all(is_passed(d.with_pump(moved), verdict.name) for d in demands):
            words = f"home at count {home}"
            return _with_pump(trials, verdict, case, moved, words, f"pump.home={home}")
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
    "speed_register": (thinner,),
}
"""What may help against a limit, simplest first."""

