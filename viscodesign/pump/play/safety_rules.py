"""The rules that stop the pump, one class each.

Each is checked once per tick against what was read and what is about to be sent, and returns a
reason to stop, or None.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import field

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.play.axis import AxisLimits, Sample
from viscodesign.pump.play.guard import NOISE_SAMPLES, Guard
from viscodesign.pump.play.pressure_rules import PressureCap, SensorFrozen

LONGEST_SILENCE = 0.25  # without a whole round of replies this long, the pump stops [s]
LATE_SAMPLES = 8
"""Samples in succession in which a stream may be too far behind; then it is not catching up."""
LOST = 3  # commands lost in succession that stop the pump
FOLLOWING_SAMPLES = 3


def _first(faults: Iterator[str]) -> str | None:
    return next(faults, None)


@dataclass
class LimitSwitchPressed(Guard):
    """With an end switch pressed, only motion away from it."""

    rule = "limit_switch"
    may_retreat = True
    before: dict[int, frozenset[str]] = field(default_factory=dict, init=False)
    heading: dict[int, int] = field(default_factory=dict, init=False)
    """Direction of each axis by its last change of goal: 1 to higher steps, -1 to lower."""

    def _fault(self, sample: Sample) -> str | None:
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
class Travel(Guard):
    """No axis outside of its travel."""

    rule = "travel"
    limits: AxisLimits

    def _fault(self, sample: Sample) -> str | None:
        (first, last), tolerance = self.limits.travel, self.limits.travel_tolerance
        low, high = first - tolerance, last + tolerance
        return _first(
            f"{sample.noun} {axis} is at {state.position} {self.limits.unit}, outside of "
            f"[{first}, {last}] (pump.travel); find out what moved it, then calibrate again"
            for axis, state in sample.axes.items()
            if not low <= state.position <= high
        )


@dataclass
class Following(Guard):
    """An axis that stays behind its goal is blocked, or too weak."""

    rule = "following"
    samples = FOLLOWING_SAMPLES
    limits: AxisLimits
    reach: int
    """One tick's travel [steps]."""

    def _fault(self, sample: Sample) -> str | None:
        errors = {s: abs(sample.goals[s] - state.position) for s, state in sample.axes.items()}
        worst = max(errors, key=lambda axis: errors[axis])
        if errors[worst] <= self.limits.following_error + self.reach:
            return None
        return (
            f"{sample.noun} {worst} is {errors[worst]} {self.limits.unit} from its goal: "
            f"{self.limits.weakness}"
        )


class Obedience(Guard):
    """Set-points are not acknowledged, so each tick reads whether the last one arrived."""

    rule = "command_lost"
    samples = LOST

    def _fault(self, sample: Sample) -> str | None:
        for axis, state in sample.axes.items():
            if not state.driven:
                self.count = self.samples  # at once
                return f"{sample.noun} {axis} is not driven: it restarted or was switched off"
        return _first(
            f"{sample.noun} {axis} holds goal {state.goal}, not the {sample.goals[axis]} it "
            f"was sent, {LOST} times in succession"
            for axis, state in sample.axes.items()
            if state.goal != sample.goals[axis]
        )


class ErrorBitsSet(Guard):
    """Overload, overheating, voltage: what an axis reports of itself."""

    rule = "alarm"

    def name(self, sample: Sample) -> str:
        return f"{sample.noun}_{self.rule}"

    def _fault(self, sample: Sample) -> str | None:
        return _first(
            f"{sample.noun} {s} {state.alarm}" for s, state in sample.axes.items() if state.alarm
        )


@dataclass
class Overheating(Guard):
    """Stop before the axis shuts down by itself."""

    rule = "temperature"
    samples = NOISE_SAMPLES
    highest: float
    """[degC]"""

    def _fault(self, sample: Sample) -> str | None:
        known = [
            (s.temperature, axis) for axis, s in sample.axes.items() if s.temperature is not None
        ]
        hottest, axis = max(known, default=(-math.inf, 0))
        limit = f"limit {self.highest:g}"
        words = f"{sample.noun} {axis} is at {hottest:g} degC ({limit}); let it cool down"
        return words if hottest >= self.highest else None


@dataclass
class LowBattery(Guard):
    """Stop before the battery is damaged; a dip in one sample may be an inrush current."""

    rule = "low_battery"
    samples = NOISE_SAMPLES
    lowest: float
    """[V]"""

    def _fault(self, sample: Sample) -> str | None:
        known = [s.voltage for s in sample.axes.values() if s.voltage is not None]
        lowest = min(known, default=math.inf)
        words = (
            f"{lowest:g} V at the {sample.noun}; charge the battery (at least {self.lowest:g} V)"
        )
        return words if lowest < self.lowest else None


@dataclass
class Silence(Guard):
    """No complete round of replies for too long: the host or the link stalled."""

    rule = "silence"
    heard: float = field(default=math.inf, init=False)

    def _fault(self, sample: Sample) -> str | None:
        gap, self.heard = sample.time - self.heard, sample.time
        words = f"no reply for {1e3 * gap:.0f} ms (limit {1e3 * LONGEST_SILENCE:.0f} ms)"
        return words if gap > LONGEST_SILENCE else None


@dataclass
class BehindProfile(Guard):
    """A stream that stays behind its profile plays something else than was planned."""

    rule = "behind_profile"
    samples = LATE_SAMPLES
    may_retreat = True
    max_lag: float
    """[ticks]"""

    def _fault(self, sample: Sample) -> str | None:
        if sample.lag <= self.max_lag:
            return None
        return (
            f"{sample.lag:.1f} ticks behind the profile (limit {self.max_lag:g}) in {LATE_SAMPLES} "
            "samples: the link or this computer is too slow for the rate; lower --rate"
        )


def stream_rules(pump: AxisLimits, reach: int, max_lag: float = math.inf) -> list[Guard]:
    """The rules of a profile; ``reach`` is one tick's travel [steps].

    Where several are broken at once, the first is reported: causes before consequences.
    """
    silence, *others = retreat_rules(pump, reach)
    cap = PressureCap(pump.max_pressure)
    return [silence, BehindProfile(max_lag), cap, SensorFrozen(), *others]


def retreat_rules(pump: AxisLimits, reach: int) -> list[Guard]:
    """What remains while the plunger is drawn back, which relieves the pressure."""
    return [
        Silence(),
        LimitSwitchPressed(),
        Travel(pump),
        ErrorBitsSet(),
        Following(pump, reach),
        Obedience(),
        Overheating(pump.highest_temperature),
        LowBattery(pump.lowest_voltage),
    ]
