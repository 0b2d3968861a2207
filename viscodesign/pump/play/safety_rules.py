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
from viscodesign.pump.sensors.base import SensorError, Stillness

NOISE_SAMPLES = 2
"""Samples that must agree where one alone may be noise."""
LONGEST_SILENCE = 0.25
"""Without a whole round of replies this long, the pump stops [s]."""
LATE_SAMPLES = 8
"""Samples in succession in which a stream may be too far behind; then it is not catching up."""
LOST = 3
"""Replies lost in succession that stop the pump."""
LOWEST_VOLTAGE = 10.0
"""Below it a battery of three lithium cells is ruined; its servo would go on to 6 V [V]."""
HIGHEST_TEMPERATURE = 70.0
"""AX servos switch themselves off at 70 (AX-12A) or 75 degC (AX-18A)."""
TRAVEL_TOLERANCE = 5
"""A position this far outside of travel is not yet one that slipped [counts]."""
FOLLOWING_ERROR = 60
"""A plunger farther behind its goal than this and one tick's travel does not follow it
[counts]; the servo's controller needs an error of up to 32 to give all its torque."""
FROZEN_PRESSURE_CHANGE = 6e3
"""A reading that stays the same to the last bit while the model's pressure changes by this
much is none [Pa]; the sensor is good to 1.5 % of its span, 5.7 kPa."""


@dataclass(frozen=True)
class Stop:
    """Why the pump has to stop."""

    rule: str
    reason: str
    trusted: bool = True
    """Whether the counts still tell where the plunger is."""
    may_retreat: bool = False
    """Whether the plunger may be drawn back."""

    def __str__(self) -> str:
        return f"{self.rule.replace('_', ' ')}: {self.reason}"


class Guard(ABC):
    """One rule."""

    rule: ClassVar[str]
    trusted: ClassVar[bool] = True
    """Whether the counts still tell where the plunger is, after this."""
    may_retreat: ClassVar[bool] = False
    """Whether the plunger may be drawn back after this."""

    @abstractmethod
    def check(self, sample: Sample) -> str | None:
        """Why the pump has to stop now; None where it may go on."""


def _where(sample: Sample, inlet: int) -> str:
    """Which of several inlets it is, by its servo."""
    servos = list(sample.servos)
    return f" at the inlet of servo {servos[inlet]}" if len(servos) > 1 else ""


@dataclass
class InSuccession:
    """Tells that something was so in several samples, one right after the other."""

    samples: int = NOISE_SAMPLES
    count: int = 0

    def note(self, so: bool) -> bool:
        self.count = self.count + 1 if so else 0
        return self.count >= self.samples


@dataclass
class PressureCap(Guard):
    """No inlet above the cap in two samples; a sample without a number counts as above."""

    rule = "pressure_cap"
    may_retreat = True
    cap: float
    """Gauge [Pa]."""
    over: dict[int, InSuccession] = field(default_factory=dict)
    """By inlet."""

    def check(self, sample: Sample) -> str | None:
        # Every inlet is asked, since each counts.
        above = [k for k, p in enumerate(sample.pressure) if p is not None and self._over(k, p)]
        if not above:
            return None
        highest = sample.pressure[above[0]] or 0.0
        return (
            f"{highest / 1e3:.2f} kPa gauge in {NOISE_SAMPLES} samples{_where(sample, above[0])}; "
            f"the limit is {self.cap / 1e3:g} kPa (pump.max_pressure)"
        )

    def _over(self, inlet: int, pressure: float) -> bool:
        # Not `pressure > cap`: a nan is to count as above.
        return self.over.setdefault(inlet, InSuccession()).note(not pressure <= self.cap)


@dataclass
class SensorFrozen(Guard):
    """A reading that stays constant while the model's pressure changes is not valid."""

    rule = "sensor_frozen"
    still: dict[int, Stillness] = field(default_factory=dict)
    """By inlet."""

    def check(self, sample: Sample) -> str | None:
        pairs = zip(sample.pressure, sample.wanted, strict=True)
        for inlet, (measured, wanted) in enumerate(pairs):
            if measured is None or wanted is None:
                self.still.pop(inlet, None)
                continue
            try:
                self.still.setdefault(inlet, Stillness(FROZEN_PRESSURE_CHANGE)).check(
                    measured, wanted
                )
            except SensorError as error:
                told = f"{error}{_where(sample, inlet)}"
                return f"{told}. Check its cable, and the hose for a leak"
        return None


@dataclass
class LimitSwitchPressed(Guard):
    """With an end switch pressed, only motion away from it."""

    rule = "limit_switch"
    trusted = False
    may_retreat = True
    before: dict[int, frozenset[str]] = field(default_factory=dict)
    heading: dict[int, int] = field(default_factory=dict)
    """Of each servo: 1 towards higher counts, -1 towards lower, by its last change of goal."""

    def check(self, sample: Sample) -> str | None:
        steps = {servo: goal - sample.goals[servo] for servo, goal in sample.next_goals.items()}
        hit = [
            (servo, end)
            for servo, ends in sample.pressed.items()
            for end in sorted(ends)
            if self._meets(servo, end, steps.get(servo, 0))
        ]
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
    trusted = False
    low: int
    high: int

    def check(self, sample: Sample) -> str | None:
        for servo, state in sample.servos.items():
            if not self.low - TRAVEL_TOLERANCE <= state.position <= self.high + TRAVEL_TOLERANCE:
                return (
                    f"servo {servo} is at {state.position} counts, outside of "
                    f"[{self.low}, {self.high}] (pump.travel); find out "
                    "what moved it, then calibrate again"
                )
        return None


@dataclass
class Following(Guard):
    """A plunger that stays behind its goal is blocked, or too weak."""

    rule = "following"
    reach: int
    """One tick's travel [counts]."""
    behind: InSuccession = field(default_factory=lambda: InSuccession(3))

    def check(self, sample: Sample) -> str | None:
        errors = {s: sample.goals[s] - state.position for s, state in sample.servos.items()}
        worst = max(errors, key=lambda servo: abs(errors[servo]))
        if not self.behind.note(abs(errors[worst]) > FOLLOWING_ERROR + self.reach):
            return None
        return (
            f"servo {worst} is {abs(errors[worst])} counts from its goal: the plunger is blocked, "
            "or the torque limit is too low for the requested pressure"
        )


@dataclass
class Obedience(Guard):
    """Set-points are not acknowledged, so each tick reads whether the last one arrived."""

    rule = "command_lost"
    lost: InSuccession = field(default_factory=lambda: InSuccession(LOST))

    def check(self, sample: Sample) -> str | None:
        for servo, state in sample.servos.items():
            if not state.torque:
                return f"servo {servo} has its torque off: it restarted or was switched off"
        wrong = [s for s, state in sample.servos.items() if state.goal != sample.goals[s]]
        if not self.lost.note(bool(wrong)):
            return None
        servo = wrong[0]
        return (
            f"servo {servo} holds goal {sample.servos[servo].goal}, not the "
            f"{sample.goals[servo]} it was sent, {LOST} times in succession"
        )


@dataclass
class ErrorBitsSet(Guard):
    """Overload, overheating, voltage: what an axis reports of itself."""

    rule = "servo_alarm"

    def check(self, sample: Sample) -> str | None:
        for servo, state in sample.servos.items():
            if state.alarm:
                return f"servo {servo} {state.alarm}"
        return None


@dataclass
class Overheating(Guard):
    """Stop before the servo shuts down by itself."""

    rule = "temperature"
    over: InSuccession = field(default_factory=InSuccession)

    def check(self, sample: Sample) -> str | None:
        servo, hottest = max(
            ((s, state.temperature) for s, state in sample.servos.items()), key=lambda pair: pair[1]
        )
        if not self.over.note(hottest >= HIGHEST_TEMPERATURE):
            return None
        limit = f"limit {HIGHEST_TEMPERATURE:g}"
        return f"servo {servo} is at {hottest:g} degC ({limit}); let it cool down"


@dataclass
class LowBattery(Guard):
    """Stop before the battery is damaged; a dip in one sample may be an inrush current."""

    rule = "low_battery"
    under: InSuccession = field(default_factory=InSuccession)

    def check(self, sample: Sample) -> str | None:
        lowest = min(state.voltage for state in sample.servos.values())
        if not self.under.note(lowest < LOWEST_VOLTAGE):
            return None
        return f"{lowest:g} V at the servo; charge the battery (at least {LOWEST_VOLTAGE:g} V)"


@dataclass
class Silence(Guard):
    """No complete round of replies for too long: the host or the link stalled."""

    rule = "silence"
    longest: float = LONGEST_SILENCE
    heard: float | None = None

    def check(self, sample: Sample) -> str | None:
        gap = 0.0 if self.heard is None else sample.time - self.heard
        self.heard = sample.time
        if gap <= self.longest:
            return None
        return f"no reply for {1e3 * gap:.0f} ms (limit {1e3 * self.longest:.0f} ms)"


@dataclass
class BehindProfile(Guard):
    """A stream that stays behind its profile plays something else than was planned."""

    rule = "behind_profile"
    may_retreat = True
    max_lag: float
    """[ticks]"""
    behind: InSuccession = field(default_factory=lambda: InSuccession(LATE_SAMPLES))

    def check(self, sample: Sample) -> str | None:
        if not self.behind.note(sample.lag > self.max_lag):
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
        broken = list(self._broken(sample))
        if self.stop is None and broken:
            self.stop = broken[0]
        return self.stop

    def _broken(self, sample: Sample) -> Iterator[Stop]:
        """Every rule is asked every time, since they count."""
        for guard in self.guards:
            reason = guard.check(sample)
            if reason is not None:
                yield Stop(guard.rule, reason, guard.trusted, guard.may_retreat)


def stream_rules(pump: AxisLimits, reach: int, max_lag: float = math.inf) -> list[Guard]:
    """What monitors a profile; ``reach`` is one tick's travel [counts].

    Where several are broken at once, the first one is told: causes before consequences.
    """
    return [
        Silence(),
        BehindProfile(max_lag),
        PressureCap(pump.max_pressure),
        SensorFrozen(),
        *_axis_rules(pump, reach),
    ]


def retreat_rules(pump: AxisLimits, reach: int) -> list[Guard]:
    """What remains while the plunger is drawn back, which makes room for the pressure."""
    return [Silence(), *_axis_rules(pump, reach)]


def _axis_rules(pump: AxisLimits, reach: int) -> list[Guard]:
    low, high = pump.travel
    return [
        LimitSwitchPressed(),
        Travel(low, high),
        ErrorBitsSet(),
        Following(reach),
        Obedience(),
        Overheating(),
        LowBattery(),
    ]
