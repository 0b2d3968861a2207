"""Set-points in real time: read, judge, send, once a tick; and whatever happens, come to rest."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import KW_ONLY, dataclass, field
from typing import Literal

from viscodesign.errors import PumpError
from viscodesign.interrupt import StopRequest
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.play.axis import FinalServoState, Sample
from viscodesign.pump.play.path import (
    DEAD_BAND,
    SETTLE_SPEED,
    SETTLED,
    SetPoints,
    TargetPath,
    led_in,
    top_speed,
    way_back,
)
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.play.safety_rules import Guard, Stop, Watch, retreat_rules, stream_rules
from viscodesign.pump.play.ticks import SLICE, Ticks
from viscodesign.pump.profile import Profile

MAX_LAG = 3.0  # how far a stream may fall behind its profile for longer than a moment [ticks]
CATCH_UP = 1.5
"""A late stream goes along its path this many times as fast as planned, until it is in time."""
SETTLE_TIME = 2.0  # for the last of a following error to go, at the end of a profile [s]
SETTLED_READINGS = 2  # in succession, that show the plungers at the end of their path
SECOND_REQUEST_TIME = 3.0
"""After a held stop request, how long a second one is waited for, which drops the torque [s]."""
OnStop = Literal["hold", "release", "retract"]
Status = Literal["complete", "interrupted", "stopped"]


class RecordingError(PumpError):
    """What observes the ticks cannot keep them: the disk is full, or gone."""


@dataclass(frozen=True)
class TickReport:
    """What one tick gives to be recorded and seen."""

    time: float
    """Of the scene; negative on the way to its start [s]."""
    sample: Sample
    skipped: int
    """Ticks skipped so far."""
    stop: Stop | None
    """The rule that this sample breaks."""


@dataclass
class StreamResult:
    """How a stream ended, and how the pump was left."""

    status: Status = "stopped"
    reason: str = "it did not begin"
    rule: str = ""
    """The broken rule, where one was."""
    may_retreat: bool = True
    """Whether the plunger may be drawn back."""
    standing: list[FinalServoState] = field(default_factory=list)
    retreat: str = ""
    """Why the plunger was not drawn back as far as intended, where it was not."""

    @property
    def verified(self) -> bool:
        """Whether every servo was read back as it was left."""
        return bool(self.standing) and all(one.verified for one in self.standing)


@dataclass
class Stream:
    """One profile, streamed once by a connected pump."""

    pump: Pump
    profile: Profile
    request: StopRequest
    observe: Callable[[TickReport], None]
    """Is given every tick after its goals are sent."""
    _: KW_ONLY
    rate: float
    """Of the ticks [Hz]."""
    lead: float = 0.0
    """Part of the profile that lies before the scene's own start [s]."""
    on_stop: OnStop = "hold"
    max_lag: float = MAX_LAG
    """The stream stops where it stays farther behind its profile than this [ticks]."""

    def __post_init__(self) -> None:
        self.result = StreamResult()
        self.ticks = Ticks(self.pump.clock, 1.0 / self.rate)
        self.origin = 0.0  # when the scene's own time begins [s of the clock]

    def play(self) -> StreamResult:
        """Arm, go to the profile, and along it to its end, a stop or a request to stop.

        However this is left, by an exception too, the pump is held (or it is said that no hold
        could be sent) and `result` tells how.
        """
        try:
            self.result = self._forward()
        except RecordingError as error:
            self.result = StreamResult("stopped", str(error), "record")
        except PumpError as error:
            self.result = StreamResult("stopped", str(error), "replies", may_retreat=False)
        except BaseException as error:
            reason = f"{type(error).__name__}: {error}".removesuffix(": ")
            self.result = StreamResult("stopped", reason, "exception", may_retreat=False)
            raise
        finally:
            self._come_to_rest()
        return self.result

    def _forward(self) -> StreamResult:
        if self.request.asked:
            return self.interrupted()
        (low, high), counts = self.pump.limits.travel, self.profile.counts
        if counts.min() < low - DEAD_BAND or counts.max() > high + DEAD_BAND:
            raise PumpError(
                f"the profile goes from {counts.min():.0f} to {counts.max():.0f} counts, outside "
                f"of travel [{low}, {high}]; nothing was sent"
            )
        if not self.pump.armed:
            self.pump.arm(top_speed(self.profile))
        path = led_in(self.profile, self.pump.goals, self.lead)
        self.origin = self.pump.clock.now() + path.zero
        return PathRun(
            self, path, stream_rules(self.pump.limits, self._reach(path), self.max_lag)
        ).go()

    def _reach(self, path: TargetPath) -> int:
        return path.reach(CATCH_UP * self.ticks.period)

    def interrupted(self) -> StreamResult:
        """Ended by a request to stop."""
        return StreamResult("interrupted", f"asked to stop ({self.request.first})")

    def _come_to_rest(self) -> None:
        """Hold first, whatever comes then; a request repeated at any time drops the torque."""
        result = self.result
        result.standing = self.pump.hold(in_place=result.status != "complete")
        if result.may_retreat and result.verified and self.pump.armed:
            if self.on_stop == "retract":
                result.standing = self._retreat()
            elif self.on_stop == "hold" and result.rule == "pressure_cap":
                result.standing = self._retreat(self.pump.limits.max_pressure)
        if result.status == "interrupted" and self.on_stop != "release" and self.pump.armed:
            wait_for_second_request(self.request, self.pump.clock)
        if self.on_stop == "release" or self.request.urgent:
            result.standing = self.pump.release()

    def _retreat(self, relief: float | None = None) -> list[FinalServoState]:
        """Draw the plungers back slowly, under all rules that still apply.

        To home, or until no inlet is above a gauge pressure [Pa].
        """
        pump = self.pump
        try:
            path = way_back(self.profile, pump.goals, pump.limits.home)
            guards = retreat_rules(pump.limits, self._reach(path))
            heard = int(self.result.status == "interrupted")
            back = PathRun(self, path, guards, heard, relief).go()
        except PumpError as error:
            back = StreamResult("stopped", str(error))
        self.result.retreat = "" if back.status == "complete" else back.reason
        return pump.hold()


class PathRun:
    """One way along a path, until its end, a stop, or one more request than was heard."""

    def __init__(
        self,
        stream: Stream,
        path: TargetPath,
        guards: list[Guard],
        heard: int = 0,
        relief: float | None = None,
    ) -> None:
        """``relief``: the way is over where no inlet is above this gauge pressure [Pa]."""
        self.stream, self.pump, self.ticks = stream, stream.pump, stream.ticks
        self.path = path
        self.watch = Watch(guards)
        self.heard = heard
        self.relief = relief
        self.relieved = False
        self.points = SetPoints(path, self.ticks.period, self.pump.limits)
        self.place = self.moment = 0.0
        """How far it is along the path, and when that was, since the first tick [s]."""

    def go(self) -> StreamResult:
        """Ticks along the path, then until the plungers are at its end."""
        self.ticks.begin()
        settled = 0
        while settled < SETTLED_READINGS and not self.relieved:
            if not self._undisturbed():
                return self.stream.interrupted()
            late = self.moment - self.place
            if self.ticks.elapsed > self.path.duration + SETTLE_TIME + late:
                if self._arrived(DEAD_BAND):
                    break
                return self._short_of_target()
            stop = self._tick()
            if stop is not None:
                return StreamResult("stopped", str(stop), stop.rule, stop.may_retreat)
            if not self.relieved:
                self.ticks.wait(self._undisturbed)
            ended = self.place >= self.path.duration
            settled = settled + 1 if ended and self._arrived(SETTLED) else 0
        if self.relief is not None and not self.relieved:
            return StreamResult("stopped", "back at home, and the pressure is still above the cap")
        return StreamResult("complete", "played to its end")

    def _undisturbed(self) -> bool:
        return self.stream.request.times <= self.heard

    def _errors(self) -> dict[int, float]:
        """By servo, from where it was last read to the end of the path [counts]."""
        ends = zip(self.path.profile.servos, self.path.profile.counts[-1], strict=True)
        return {servo: abs(float(end) - self.pump.positions[servo]) for servo, end in ends}

    def _arrived(self, within: float) -> bool:
        return self.pump.alarm is not None or max(self._errors().values()) <= within

    def _short_of_target(self) -> StreamResult:
        servo, error = max(self._errors().items(), key=lambda item: item[1])
        return StreamResult(
            "stopped",
            f"not reached: servo {servo} stays {error:.0f} counts from its last "
            "target; the plunger is blocked, or the torque limit too low for the pressure",
            "not_reached",
        )

    def _advance(self, elapsed: float) -> float:
        """Go along the path, with the time or catching up with it; how fast as planned."""
        since = min(elapsed - self.moment, self.ticks.period)
        step = min(elapsed - self.place, CATCH_UP * since)
        self.place, self.moment = self.place + step, elapsed
        self.pump.reach = self.path.reach(step)
        return max(step / since, 1.0) if since > 0.0 else 1.0

    def _tick(self) -> Stop | None:
        """Read, judge, send, report."""
        pump, period = self.pump, self.ticks.period
        states, pressure, pressed = pump.look()
        # Only now: what was read may have come late, and the goals are to be those of this moment.
        elapsed, read = self.ticks.now, pump.read_at - self.ticks.start
        commanded = self.place + min(max(read - self.moment, 0.0), period)
        ended = commanded >= self.path.duration
        self.points.learn(commanded, pump.positions, SETTLED if ended else DEAD_BAND)
        pace = self._advance(elapsed)
        goals, speeds = self.points.next(self.place, pump.goals, pump.reach)
        goals = pump.allowed(goals)
        if ended:
            speeds = dict.fromkeys(goals, SETTLE_SPEED)
        sample = Sample(
            time=pump.clock.now(),
            servos=states,
            pressure=pressure,
            wanted=self.path.expected_pressure(commanded),
            pressed=pressed,
            goals=dict(pump.goals),
            next_goals=goals,
            lag=(self.moment - self.place) / period,
        )
        if self.relief is not None:
            self.relieved = all(p is None or p <= self.relief for p in pressure)
        stop = self.watch.check(sample)
        pump.alarm = pump.alarm or stop
        if stop is None and not self.relieved and self._undisturbed():
            paces = {s: pace * speed for s, speed in self.path.paces(self.place).items()}
            pump.set_goals(goals, speeds, paces)
        if not ended or stop is not None:
            time = pump.read_at - self.stream.origin
            self.stream.observe(TickReport(time, sample, self.ticks.skipped, stop))
        return stop


def wait_for_second_request(request: StopRequest, clock: Clock) -> None:
    """Leave somebody time to ask again, which drops the torque of a pump that is held."""
    end = clock.now() + SECOND_REQUEST_TIME
    while not request.urgent and clock.now() < end:
        clock.sleep(SLICE)
