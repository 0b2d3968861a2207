"""What makes the pump stop, one rule a class.

Each is asked once a tick with what was read and what is to follow, before the next goals are
sent; it answers with a reason, or None.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import ClassVar

from viscodesign.pump.play.axis import AxisLimits, Sample

NOISE_SAMPLES = 2  # samples in succession that must agree where one alone may be noise
LONGEST_SILENCE = 0.25  # without a whole round of replies this long, the pump stops [s]
LATE_SAMPLES = 8
"""Samples in succession in which a stream may be too far behind; then it is not catching up."""
LOST = 3  # commands lost in succession that stop the pump
LOWEST_VOLTAGE = 10.0
"""Below it a battery of three lithium cells is ruined; its servo would go on to 6 V [V]."""
HIGHEST_TEMPERATURE = 70.0  # AX servos switch themselves off at 70 (AX-12A) or 75 degC (AX-18A)
TRAVEL_TOLERANCE = 5  # A position this far outside of travel is not yet one that slipped [counts]
FOLLOWING_ERROR = 60
"""A plunger farther behind its goal than this and one tick's travel does not follow it
[counts]; the servo's controller needs an error of up to 32 to give all its torque."""
FOLLOWING_SAMPLES = 3
FROZEN_PRESSURE_CHANGE = 6e3
"""A reading that stays the same to the last bit while the model's pressure changes by this
much is none [Pa]; the sensor is good to 1.5 % of its span, 5.7 kPa."""


@dataclass(frozen=True)
class Stop:
    """Why the pump has to stop."""

    rule: str
    reason: str
    may_retreat: bool = False
    """Whether the plunger may be drawn back."""

    def __str__(self) -> str:
        return f"{self.rule.replace('_', ' ')}: {self.reason}"


@dataclass
class Guard(ABC):
    """One rule: broken where several samples in succession have its fault."""

    rule: ClassVar[str]
    samples: ClassVar[int] = 1
    may_retreat: ClassVar[bool] = False
    """Whether the plunger may be drawn back after this."""
    count: int = field(default=0, init=False)

    def check(self, sample: Sample) -> str | None:
        """Why the pump has to stop now; None where it may go on."""
        reason = self._fault(sample)
        self.count = self.count + 1 if reason else 0
        return reason if self.count >= self.samples else None

    @abstractmethod
    def _fault(self, sample: Sample) -> str | None:
        """What is wrong in this sample."""


def _first(faults: Iterator[str]) -> str | None:
    return next(faults, None)


def _inlet(sample: Sample, inlet: int) -> str:
    """Which of several inlets it is, by its servo."""
    servos = list(sample.servos)
    return f" at the inlet of servo {servos[inlet]}" if len(servos) > 1 else ""


@dataclass
class PressureCap(Guard):
    """No inlet above the cap in two samples; a sample without a number counts as above."""

    rule = "pressure_cap"
    may_retreat = True
    cap: float
    """Gauge [Pa]."""
    above: dict[int, int] = field(default_factory=dict, init=False)
    """By inlet, samples in succession."""

    def _fault(self, sample: Sample) -> str | None:
        broken = None
        for inlet, pressure in enumerate(sample.pressure):
            # Not `pressure > cap`: a nan is to count as above.
            over = pressure is not None and not pressure <= self.cap
            self.above[inlet] = self.above.get(inlet, 0) + 1 if over else 0
            if broken is None and self.above[inlet] >= NOISE_SAMPLES:
                broken = (
                    f"{(pressure or 0.0) / 1e3:.2f} kPa gauge in {NOISE_SAMPLES} samples"
                    f"{_inlet(sample, inlet)}; the limit is {self.cap / 1e3:g} kPa "
                    "(pump.max_pressure)"
                )
        return broken


@dataclass
class SensorFrozen(Guard):
    """A reading that stays constant while the model's pressure changes is not valid."""

    rule = "sensor_frozen"
    still: dict[int, tuple[float, float, float]] = field(default_factory=dict, init=False)
    """By inlet: its reading, lowest and highest expected pressure since that changed [Pa]."""

    def _fault(self, sample: Sample) -> str | None:
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
                    f"{_inlet(sample, inlet)}. Check its cable, and the hose for a leak"
                )
        return None


@dataclass
class LimitSwitchPressed(Guard):
    """With an end switch pressed, only motion away from it."""

    rule = "limit_switch"
    may_retreat = True
    before: dict[int, frozenset[str]] = field(default_factory=dict, init=False)
    heading: dict[int, int] = field(default_factory=dict, init=False)
    """Of each servo: 1 towards higher counts, -1 towards lower, by its last change of goal."""

    def _fault(self, sample: Sample) -> str | None:
        steps = {servo: goal - sample.goals[servo] for servo, goal in sample.next_goals.items()}
        pressed = [(servo, end) for servo, ends in sample.pressed.items() for end in sorted(ends)]
        hit = [(s, end) for s, end in pressed if self._meets(s, end, steps.get(s, 0))]
        self.before = dict(sample.pressed)
        if not hit:
            self.heading |= {s: (step > 0) - (step < 0) for s, step in steps.items() if step}
            return None
        servo, end = hit[0]
        which = f" of servo {servo}" if len(sample.servos) > 1 else ""
        return (
            f"the switch at the {end} end{which} is pressed (or its wire broken); "
            "its position is no longer certain: run `pump calibrate` again"
        )

    def _meets(self, servo: int, end: str, step: int) -> bool:
        """Whether a servo is to go on towards a pressed switch, or has just run into it."""
        sign = 1 if end == "high" else -1
        fresh = end not in self.before.get(servo, frozenset())
        return step * sign > 0 or (fresh and self.heading.get(servo, 0) * sign > 0)


@dataclass
class Travel(Guard):
    """No plunger outside of its calibrated travel."""

    rule = "travel"
    low: int
    high: int

    def _fault(self, sample: Sample) -> str | None:
        low, high = self.low - TRAVEL_TOLERANCE, self.high + TRAVEL_TOLERANCE
        return _first(
            f"servo {servo} is at {state.position} counts, outside of [{self.low}, {self.high}] "
            "(pump.travel); find out what moved it, then calibrate again"
            for servo, state in sample.servos.items()
            if not low <= state.position <= high
        )


@dataclass
class Following(Guard):
    """A plunger that stays behind its goal is blocked, or too weak."""

    rule = "following"
    samples = FOLLOWING_SAMPLES
    reach: int
    """One tick's travel [counts]."""

    def _fault(self, sample: Sample) -> str | None:
        errors = {s: abs(sample.goals[s] - state.position) for s, state in sample.servos.items()}
        worst = max(errors, key=lambda servo: errors[servo])
        if errors[worst] <= FOLLOWING_ERROR + self.reach:
            return None
        return (
            f"servo {worst} is {errors[worst]} counts from its goal: the plunger is blocked, "
            "or the torque limit is too low for the requested pressure"
        )


class Obedience(Guard):
    """Set-points are not acknowledged, so each tick reads whether the last one arrived."""

    rule = "command_lost"
    samples = LOST

    def _fault(self, sample: Sample) -> str | None:
        for servo, state in sample.servos.items():
            if not state.torque:
                self.count = self.samples  # at once
                return f"servo {servo} has its torque off: it restarted or was switched off"
        return _first(
            f"servo {servo} holds goal {state.goal}, not the {sample.goals[servo]} it was sent, "
            f"{LOST} times in succession"
            for servo, state in sample.servos.items()
            if state.goal != sample.goals[servo]
        )


class ErrorBitsSet(Guard):
    """Overload, overheating, voltage: what an axis reports of itself."""

    rule = "servo_alarm"

    def _fault(self, sample: Sample) -> str | None:
        return _first(
            f"servo {s} {state.alarm}" for s, state in sample.servos.items() if state.alarm
        )


class Overheating(Guard):
    """Stop before the servo shuts down by itself."""

    rule = "temperature"
    samples = NOISE_SAMPLES

    def _fault(self, sample: Sample) -> str | None:
        hottest, servo = max((state.temperature, servo) for servo, state in sample.servos.items())
        limit = f"limit {HIGHEST_TEMPERATURE:g}"
        words = f"servo {servo} is at {hottest:g} degC ({limit}); let it cool down"
        return words if hottest >= HIGHEST_TEMPERATURE else None


class LowBattery(Guard):
    """Stop before the battery is damaged; a dip in one sample may be an inrush current."""

    rule = "low_battery"
    samples = NOISE_SAMPLES

    def _fault(self, sample: Sample) -> str | None:
        lowest = min(state.voltage for state in sample.servos.values())
        words = f"{lowest:g} V at the servo; charge the battery (at least {LOWEST_VOLTAGE:g} V)"
        return words if lowest < LOWEST_VOLTAGE else None


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


class Watch:
    """All rules; the first that is broken is kept, whatever the others say later."""

    def __init__(self, guards: Sequence[Guard]) -> None:
        self.guards = guards
        self.stop: Stop | None = None

    def check(self, sample: Sample) -> Stop | None:
        """The alarm, once there is one: it stays."""
        # Every rule is asked every time, since they count.
        reasons = [(guard, guard.check(sample)) for guard in self.guards]
        broken = [Stop(g.rule, reason, g.may_retreat) for g, reason in reasons if reason]
        self.stop = self.stop or next(iter(broken), None)
        return self.stop


def stream_rules(pump: AxisLimits, reach: int, max_lag: float = math.inf) -> list[Guard]:
    """What monitors a profile; ``reach`` is one tick's travel [counts].

    Where several are broken at once, the first one is told: causes before consequences.
    """
    silence, *others = retreat_rules(pump, reach)
    cap = PressureCap(pump.max_pressure)
    return [silence, BehindProfile(max_lag), cap, SensorFrozen(), *others]


def retreat_rules(pump: AxisLimits, reach: int) -> list[Guard]:
    """What remains while the plunger is drawn back, which relieves the pressure."""
    return [
        Silence(),
        LimitSwitchPressed(),
        Travel(*pump.travel),
        ErrorBitsSet(),
        Following(reach),
        Obedience(),
        Overheating(),
        LowBattery(),
    ]
