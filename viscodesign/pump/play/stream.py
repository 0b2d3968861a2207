"""Set-points in real time: read, judge, send, once a tick; and whatever happens, come to rest."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

from viscodesign.errors import PumpError
from viscodesign.interrupt import StopRequest
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.play.axis import FinalServoState, Sample
from viscodesign.pump.play.path import TargetPath, led_in, top_speed, way_back
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.play.safety_rules import (
    Guard,
    InSuccession,
    Stop,
    Watch,
    retreat_rules,
    stream_rules,
)
from viscodesign.pump.play.setpoints import (
    CATCH_UP,
    DEAD_BAND,
    SETTLE_SPEED,
    SETTLED,
    PathProgress,
    SetPoints,
)
from viscodesign.pump.play.ticks import SLICE, Ticks
from viscodesign.pump.profile import Profile

MAX_LAG = 3.0
"""How far a stream may fall behind its profile for longer than a moment [ticks]."""
SETTLE_TIME = 2.0
"""For the last of a following error to go, at the end of a profile [s]."""
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


class Stream:
    """One profile, streamed once by a connected pump."""

    def __init__(
        self,
        pump: Pump,
        profile: Profile,
        request: StopRequest,
        observe: Callable[[TickReport], None],
        *,
        rate: float,
        lead: float = 0.0,
        on_stop: OnStop = "hold",
        max_lag: float = MAX_LAG,
    ) -> None:
        """``rate`` of the ticks [Hz]; ``observe`` is given every tick after its goals are sent.

        ``lead``: part of the profile that lies before the scene's own start [s]. ``max_lag``: the
        stream stops where it stays farther behind its profile than this [ticks].
        """
        self.pump = pump
        self.profile = profile
        self.lead = lead
        self.request = request
        self.observe = observe
        self.on_stop = on_stop
        self.max_lag = max_lag
        self.result = StreamResult()
        self.ticks = Ticks(pump.clock, 1.0 / rate)
        self.origin = 0.0
        """When the scene's own time begins [s of the clock]."""

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
            return self._interrupted()
        self._refuse_targets()
        if not self.pump.armed:
            self.pump.arm(top_speed(self.profile))
        path = led_in(self.profile, self.pump.goals, self.lead)
        self.origin = self.pump.clock.now() + path.zero
        guards = stream_rules(self.pump.limits, self._reach(path), self.max_lag)
        return PathRun(self, path, guards, 0).go()

    def _refuse_targets(self) -> None:
        low, high = self.pump.limits.travel
        counts = self.profile.counts
        if counts.min() < low - DEAD_BAND or counts.max() > high + DEAD_BAND:
            raise PumpError(
                f"the profile goes from {counts.min():.0f} to {counts.max():.0f} counts, outside "
                f"of travel [{low}, {high}]; nothing was sent"
            )

    def _reach(self, path: TargetPath) -> int:
        return path.reach(CATCH_UP * self.ticks.period)

    def _interrupted(self) -> StreamResult:
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

    def _retreat(self, pressure: float | None = None) -> list[FinalServoState]:
        """Draw the plungers back slowly, under all rules that still apply.

        To home, or until no inlet is above a gauge ``pressure`` [Pa].
        """
        pump = self.pump
        try:
            path = way_back(self.profile, pump.goals, pump.limits.home)
            heard = 1 if self.result.status == "interrupted" else 0
            guards = retreat_rules(pump.limits, self._reach(path))
            back = PathRun(self, path, guards, heard, pressure).go()
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
        heard: int,
        relief: float | None = None,
    ) -> None:
        """``relief``: the way is over where no inlet is above this gauge pressure [Pa]."""
        self.stream = stream
        self.pump = stream.pump
        self.ticks = stream.ticks
        self.path = path
        self.watch = Watch(guards)
        self.heard = heard
        self.relief = relief
        self.progress = PathProgress(self.ticks.period)
        self.points = SetPoints(path, self.ticks.period, self.pump.limits)
        self.relieved = False
        self.settled = InSuccession()

    def go(self) -> StreamResult:
        """Ticks along the path, then until the plungers are at its end."""
        self.ticks.begin()
        while self.progress.place < self.path.duration or not self.settled.note(self._arrived()):
            if not self._undisturbed():
                return self.stream._interrupted()
            if self.ticks.elapsed > self.path.duration + self._patience():
                if self._arrived(DEAD_BAND):
                    break
                return self._short_of_target()
            stop = self._tick()
            if stop is not None:
                return StreamResult("stopped", str(stop), stop.rule, stop.may_retreat)
            if self.relieved:
                break
            self.ticks.wait(self._undisturbed)
        if self.relief is not None and not self.relieved:
            return StreamResult("stopped", "back at home, and the pressure is still above the cap")
        return StreamResult("complete", "played to its end")

    def _patience(self) -> float:
        """After the end of the path [s]."""
        return SETTLE_TIME + self.progress.lag * self.ticks.period

    def _undisturbed(self) -> bool:
        return self.stream.request.times <= self.heard

    def _errors(self) -> dict[int, float]:
        """By servo, from where it was last read to the end of the path [counts]."""
        targets = zip(self.path.profile.servos, self.path.goals(self.path.duration), strict=True)
        return {
            servo: float(target) - self.pump.positions[servo]
            for servo, target in targets
            if self.pump.alarm is None
        }

    def _arrived(self, within: float = SETTLED) -> bool:
        return all(abs(error) <= within for error in self._errors().values())

    def _short_of_target(self) -> StreamResult:
        errors = self._errors()
        servo = max(errors, key=lambda one: abs(errors[one]))
        return StreamResult(
            "stopped",
            f"not reached: servo {servo} stays {abs(errors[servo]):.0f} counts from its last "
            "target; the plunger is blocked, or the torque limit too low for the pressure",
            "not_reached",
        )

    def _tick(self) -> Stop | None:
        """Read, judge, send, report."""
        states, pressure, pressed = self.pump.look()
        # Only now: what was read may have come late, and the goals are to be those of this moment.
        elapsed, read = self.ticks.now, self.pump.read_at - self.ticks.start
        commanded = self.progress.commanded(read)
        ended = commanded >= self.path.duration
        self.points.learn(commanded, self.pump.positions, SETTLED if ended else DEAD_BAND)
        before = self.progress.place
        place = self.progress.advance(elapsed)
        self.pump.reach = self.path.reach(place - before)
        goals, speeds = self.points.next(place, self.pump.goals, self.pump.reach)
        goals = self.pump.allowed(goals)
        if ended:
            speeds = dict.fromkeys(goals, SETTLE_SPEED)
        sample = Sample(
            time=self.pump.clock.now(),
            servos=states,
            pressure=pressure,
            wanted=self.path.wanted(commanded),
            pressed=pressed,
            goals=dict(self.pump.goals),
            next_goals=goals,
            lag=self.progress.lag,
        )
        self.relieved = self.relief is not None and _all_below(pressure, self.relief)
        stop = self.watch.check(sample)
        self.pump.alarm = self.pump.alarm or stop
        if stop is None and not self.relieved and self._undisturbed():
            paces = self.path.paces(place)
            self.pump.set_goals(
                goals, speeds, {s: self.progress.pace * p for s, p in paces.items()}
            )
        time = self.pump.read_at - self.stream.origin
        if not ended or stop is not None:
            self.stream.observe(TickReport(time, sample, self.ticks.skipped, stop))
        return stop


def _all_below(pressure: tuple[float | None, ...], cap: float) -> bool:
    return all(p is None or p <= cap for p in pressure)


def wait_for_second_request(request: StopRequest, clock: Clock) -> None:
    """Leave somebody time to ask again, which drops the torque of a pump that is held."""
    end = clock.now() + SECOND_REQUEST_TIME
    while not request.urgent and clock.now() < end:
        clock.sleep(SLICE)
