"""Set-points in real time: read, judge, send, once a tick; and whatever happens, stand."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

from viscodesign.errors import PumpError
from viscodesign.interrupt import StopRequest
from viscodesign.pump.play.hold import FinalServoState
from viscodesign.pump.play.path import Course, led_in, top_speed, way_back
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.play.safety_rules import Guard, Stop, Watch, retreat_rules, stream_rules
from viscodesign.pump.play.servo_state import Sample
from viscodesign.pump.play.setpoints import SetPoints
from viscodesign.pump.play.ticks import Ticks
from viscodesign.pump.play.torque_limit import free_speed
from viscodesign.pump.profile import Profile
from viscodesign.scene.pump import PumpSpec as Settings

OnStop = Literal["hold", "release", "retract"]
Status = Literal["complete", "interrupted", "stopped"]


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
    """Why drawing the plunger back did not go to its end, where it did not."""

    @property
    def sure(self) -> bool:
        """Whether every servo was read back as it was left."""
        return bool(self.standing) and all(one.sure for one in self.standing)


class Stream:
    """One profile, streamed once by a connected pump."""

    def __init__(
        self,
        pump: Pump,
        profile: Profile,
        wish: StopRequest,
        see: Callable[[TickReport], None],
        *,
        rate: float,
        lead: float = 0.0,
        on_stop: OnStop = "hold",
    ) -> None:
        """``rate`` of the ticks [Hz]; ``see`` is given every tick after its goals are sent.

        ``lead``: part of the profile that lies before the scene's own start [s].
        """
        self.pump = pump
        self.profile = profile
        self.lead = lead
        self.wish = wish
        self.see = see
        self.on_stop = on_stop
        self.ending = StreamResult()
        self.ticks = Ticks(pump.clock, 1.0 / rate)
        self.origin = 0.0
        """When the scene's own time begins [s of the clock]."""

    def play(self) -> StreamResult:
        """Arm, go to the profile, and along it to its end, a stop or a wish.

        However this is left, by an exception too, the pump stands (or it is said that no hold
        could be sent) and `ending` tells how.
        """
        try:
            self.ending = self._forward()
        except PumpError as error:
            self.ending = StreamResult("stopped", str(error), "replies", may_retreat=False)
        except BaseException as error:
            told = f"{type(error).__name__}: {error}".removesuffix(": ")
            self.ending = StreamResult("stopped", told, "exception", may_retreat=False)
            raise
        finally:
            self._stand()
        return self.ending

    def _forward(self) -> StreamResult:
        if self.wish.asked:
            return self._interrupted()
        if not self.pump.armed:
            self.pump.arm(top_speed(self.profile))
        course = led_in(self.profile, self.pump.goals, self.lead)
        self.origin = self.pump.clock.now() + course.zero
        return self._run(course, self._watch(course, stream_rules), 0)

    def _watch(self, course: Course, rules: Callable[[Settings, int], list[Guard]]) -> Watch:
        return Watch(rules(self.pump.settings, course.reach(self.ticks.period)))

    def _run(self, course: Course, watch: Watch, heard: int) -> StreamResult:
        """Ticks until the course is over, a rule is broken, or one more wish than was heard."""
        self.pump.reach = course.reach(self.ticks.period)
        free = free_speed(self.pump.settings)
        points = SetPoints(course, self.ticks.period, free)
        self.ticks.begin()
        while self.ticks.elapsed <= course.duration:
            if not self._untouched(heard):
                return self._interrupted()
            stop = self._tick(course, points, watch, heard)
            if stop is not None:
                return StreamResult("stopped", str(stop), stop.rule, stop.may_retreat)
            self.ticks.wait(lambda: self._untouched(heard))
        return StreamResult("complete", "played to its end")

    def _interrupted(self) -> StreamResult:
        return StreamResult("interrupted", f"asked to stop ({self.wish.first})")

    def _untouched(self, heard: int) -> bool:
        return self.wish.times <= heard

    def _tick(self, course: Course, points: SetPoints, watch: Watch, heard: int) -> Stop | None:
        """Read, judge, send, show."""
        states, pressure, pressed = self.pump.look()
        # Only now: what was read may have come late, and the goals are to be those of this moment.
        elapsed, read = self.ticks.now, self.pump.read_at - self.ticks.start
        reach = self._reach(course, self.ticks.period)
        points.learn(read, self.pump.positions)
        goals, speeds = points.next(elapsed, self.pump.goals, reach)
        goals = self.pump.allowed(goals)
        sample = Sample(
            time=self.pump.clock.now(),
            servos=states,
            pressure=pressure,
            wanted=course.wanted(read),
            pressed=pressed,
            goals=dict(self.pump.goals),
            next_goals=goals,
        )
        stop = watch.check(sample)
        self.pump.alarm = self.pump.alarm or stop
        if stop is None and self._untouched(heard):
            self.pump.set_goals(goals, speeds, course.paces(elapsed))
        time = self.pump.read_at - self.origin
        self.see(TickReport(time, sample, self.ticks.skipped, stop))
        return stop

    def _reach(self, course: Course, period: float) -> int:
        """One tick's travel, or what there was time for where the last goals were sent late."""
        since = self.pump.clock.now() - self.pump.sent_at
        return course.reach(min(since, period))

    def _stand(self) -> None:
        """Stand first, whatever comes then; a wish repeated meanwhile drops the torque."""
        ending = self.ending
        ending.standing = self.pump.hold()
        if self.on_stop == "retract" and ending.may_retreat and ending.sure and self.pump.armed:
            ending.standing = self._go_back()
        if self.on_stop == "release" or self.wish.urgent:
            ending.standing = self.pump.release()

    def _go_back(self) -> list[FinalServoState]:
        """Draw the plungers back to home, slowly and under all rules that still make sense."""
        pump = self.pump
        try:
            course = way_back(self.profile, pump.goals, pump.settings.home)
            heard = 1 if self.ending.status == "interrupted" else 0
            back = self._run(course, self._watch(course, retreat_rules), heard)
        except PumpError as error:
            back = StreamResult("stopped", str(error))
        self.ending.retreat = "" if back.status == "complete" else back.reason
        return pump.hold()
