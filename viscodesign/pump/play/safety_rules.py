"""The rules that stop the pump: a table, and below it what each finds wrong in a sample.

Each is asked once per tick, of what was read and what is about to be sent. A rule that needs
samples before remembers them, so a stream makes its own.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import field
from functools import partial

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.play.axis import AxisLimits, Sample
from viscodesign.pump.play.guard import Guard

NOISE_SAMPLES = 2  # samples in succession that must agree where one alone may be noise
FOLLOWING_SAMPLES = 3
LATE_SAMPLES = 8
"""Samples in succession in which a stream may be too far behind; then it is not catching up."""
LOST = 3  # commands lost in succession that stop the pump
LONGEST_SILENCE = 0.25  # without a whole round of replies this long, the pump stops [s]
FROZEN_PRESSURE_CHANGE = 6e3
"""A reading that stays the same to the last bit while the model's pressure changes by this
much is none [Pa]; the sensor is good to 1.5 % of its span, 5.7 kPa."""


def stream_rules(pump: AxisLimits, reach: int, max_lag: float = math.inf) -> list[Guard]:
    """The rules of a profile; ``reach`` is one tick's travel [steps], ``max_lag`` in ticks.

    Where several are broken at once, the first is reported: causes before consequences.
    """
    silence, *others = retreat_rules(pump, reach)
    return [
        silence,
        Guard("behind_profile", partial(_late, max_lag), LATE_SAMPLES, may_retreat=True),
        Guard("pressure_cap", _PressureCap(pump.max_pressure), may_retreat=True),
        Guard("sensor_frozen", _FrozenSensor()),
        *others,
    ]


def retreat_rules(pump: AxisLimits, reach: int) -> list[Guard]:
    """What remains while the plunger is drawn back, which relieves the pressure."""
    return [
        Guard("silence", _Silence()),
        Guard("limit_switch", _PressedSwitch(), may_retreat=True),
        Guard("travel", partial(_outside_travel, pump)),
        Guard(f"{pump.noun}_alarm", _alarm),
        Guard("following", partial(_behind_goal, pump, reach), FOLLOWING_SAMPLES),
        Guard("command_lost", _LostCommand()),
        Guard("temperature", partial(_too_hot, pump.highest_temperature), NOISE_SAMPLES),
        Guard("low_battery", partial(_low_battery, pump.lowest_voltage), NOISE_SAMPLES),
    ]


def _first(faults: Iterator[str]) -> str | None:
    return next(faults, None)


def _outside_travel(pump: AxisLimits, sample: Sample) -> str | None:
    """No axis outside of its travel."""
    (first, last), tolerance = pump.travel, pump.travel_tolerance
    low, high = first - tolerance, last + tolerance
    return _first(
        f"{sample.noun} {axis} is at {state.position} {pump.unit}, outside of "
        f"[{first}, {last}] (pump.travel); find out what moved it, then calibrate again"
        for axis, state in sample.axes.items()
        if not low <= state.position <= high
    )


def _behind_goal(pump: AxisLimits, reach: int, sample: Sample) -> str | None:
    """An axis that stays behind its goal is blocked, or too weak."""
    errors = {s: abs(sample.goals[s] - state.position) for s, state in sample.axes.items()}
    worst = max(errors, key=lambda axis: errors[axis])
    if errors[worst] <= pump.following_error + reach:
        return None
    return f"{sample.noun} {worst} is {errors[worst]} {pump.unit} from its goal: {pump.weakness}"


def _alarm(sample: Sample) -> str | None:
    """Overload, overheating, voltage: what an axis reports of itself."""
    return _first(
        f"{sample.noun} {s} {state.alarm}" for s, state in sample.axes.items() if state.alarm
    )


def _too_hot(highest: float, sample: Sample) -> str | None:
    """Stop before the axis shuts down by itself, at a temperature [degC]."""
    known = [(s.temperature, axis) for axis, s in sample.axes.items() if s.temperature is not None]
    hottest, axis = max(known, default=(-math.inf, 0))
    words = f"{sample.noun} {axis} is at {hottest:g} degC (limit {highest:g}); let it cool down"
    return words if hottest >= highest else None


def _low_battery(lowest: float, sample: Sample) -> str | None:
    """Stop before the battery is damaged [V]; a dip in one sample may be an inrush current."""
    voltage = min((s.voltage for s in sample.axes.values() if s.voltage is not None), default=None)
    if voltage is None or voltage >= lowest:
        return None
    return f"{voltage:g} V at the {sample.noun}; charge the battery (at least {lowest:g} V)"


def _late(max_lag: float, sample: Sample) -> str | None:
    """A stream that stays behind its profile plays something else than was planned."""
    if sample.lag <= max_lag:
        return None
    return (
        f"{sample.lag:.1f} ticks behind the profile (limit {max_lag:g}) in {LATE_SAMPLES} "
        "samples: the link or this computer is too slow for the rate; lower the rate"
    )


@dataclass
class _Silence:
    """No complete round of replies for too long: the host or the link stalled."""

    heard: float = math.inf

    def __call__(self, sample: Sample) -> str | None:
        gap, self.heard = sample.time - self.heard, sample.time
        words = f"no reply for {1e3 * gap:.0f} ms (limit {1e3 * LONGEST_SILENCE:.0f} ms)"
        return words if gap > LONGEST_SILENCE else None


@dataclass
class _LostCommand:
    """Set-points are not acknowledged, so each tick reads whether the last one arrived."""

    count: int = 0

    def __call__(self, sample: Sample) -> str | None:
        undriven = _first(
            f"{sample.noun} {axis} is not driven: it restarted or was switched off"
            for axis, state in sample.axes.items()
            if not state.driven
        )
        lost = _first(
            f"{sample.noun} {axis} holds goal {state.goal}, not the {sample.goals[axis]} it "
            f"was sent, {LOST} times in succession"
            for axis, state in sample.axes.items()
            if state.goal != sample.goals[axis]
        )
        self.count = self.count + 1 if lost else 0
        return undriven or (lost if self.count >= LOST else None)


@dataclass
class _PressedSwitch:
    """With an end switch pressed, only motion away from it."""

    before: dict[int, frozenset[str]] = field(default_factory=dict)
    heading: dict[int, int] = field(default_factory=dict)
    """Direction of each axis by its last change of goal: 1 to higher steps, -1 to lower."""

    def __call__(self, sample: Sample) -> str | None:
        steps = {axis: goal - sample.goals[axis] for axis, goal in sample.next_goals.items()}
        pressed = [(axis, end) for axis, ends in sample.pressed.items() for end in sorted(ends)]
        hit = [(s, end) for s, end in pressed if self._meets(s, end, steps.get(s, 0))]
        self.before = dict(sample.pressed)
        if not hit:
            self.heading |= {s: (step > 0) - (step < 0) for s, step in steps.items() if step}
            return None
        axis, end = hit[0]
        which = f" of {sample.noun} {axis}" if len(sample.axes) > 1 else ""
        return (
            f"the switch at the {end} end{which} is pressed (or its wire broken); "
            "its position is no longer certain: run `pump calibrate` again"
        )

    def _meets(self, axis: int, end: str, step: int) -> bool:
        """Whether an axis is to go on towards a pressed switch, or has just run into it."""
        sign = 1 if end == "high" else -1
        fresh = end not in self.before.get(axis, frozenset())
        return step * sign > 0 or (fresh and self.heading.get(axis, 0) * sign > 0)


@dataclass
class _PressureCap:
    """No inlet above the cap in two samples; a sample without a number counts as above."""

    cap: float
    """Gauge [Pa]."""
    above: dict[int, int] = field(default_factory=dict)
    """By inlet, samples in succession."""

    def __call__(self, sample: Sample) -> str | None:
        for inlet, pressure in enumerate(sample.pressure):
            # Not `pressure > cap`: a nan is to count as above.
            over = pressure is not None and not pressure <= self.cap
            self.above[inlet] = self.above.get(inlet, 0) + 1 if over else 0
        broken = [inlet for inlet, count in self.above.items() if count >= NOISE_SAMPLES]
        if not broken:
            return None
        pressure = sample.pressure[broken[0]] or 0.0
        return (
            f"{pressure / 1e3:.2f} kPa gauge in {NOISE_SAMPLES} samples"
            f"{sample.inlet_words(broken[0])}; the limit is {self.cap / 1e3:g} kPa "
            "(pump.max_pressure)"
        )


@dataclass
class _FrozenSensor:
    """A reading that stays constant while the model's pressure changes is not valid."""

    still: dict[int, tuple[float, float, float]] = field(default_factory=dict)
    """By inlet: its reading, lowest and highest expected pressure since that changed [Pa]."""

    def __call__(self, sample: Sample) -> str | None:
        pairs = zip(sample.pressure, sample.wanted, strict=True)
        for inlet, (measured, expected) in enumerate(pairs):
            if measured is None or expected is None:
                self.still.pop(inlet, None)
                continue
            reading, low, high = self.still.get(inlet, (measured, expected, expected))
            if measured != reading:
                low = high = expected
            low, high = min(low, expected), max(high, expected)
            self.still[inlet] = (measured, low, high)
            if high - low > FROZEN_PRESSURE_CHANGE:
                return (
                    f"the pressure sensor is frozen: it kept reading {measured / 1e3:.2f} kPa "
                    f"while the pressure should have changed by {(high - low) / 1e3:.1f} kPa"
                    f"{sample.inlet_words(inlet)}. Check its cable, and the hose for a leak"
                )
        return None
