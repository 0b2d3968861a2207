"""Set-points in real time: read, judge, send, once a tick; and whatever happens, come to rest."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import KW_ONLY
from functools import partial

from viscodesign.errors import PumpError
from viscodesign.interrupt import StopRequest
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.consent import Tell, ignore
from viscodesign.pump.play.axis import AxisLimits, FinalAxisState, Sample
from viscodesign.pump.play.guard import Guard, Stop
from viscodesign.pump.play.path import ROUNDING, led_in, way_back
from viscodesign.pump.play.path_run import CATCH_UP, PathRun
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.play.safety_rules import retreat_rules, stream_rules
from viscodesign.pump.play.stream_result import (
    OnStop,
    RecordingError,
    StreamResult,
    TickReport,
)
from viscodesign.pump.play.ticks import SLICE, Ticks
from viscodesign.pump.profile import Profile

MAX_LAG = 3.0  # how far a stream may fall behind its profile for longer than a moment [ticks]
SECOND_REQUEST_TIME = 3.0
"""After a held stop request, how long a second one is waited for, which releases the pump [s]."""
SECOND_REQUEST_HINT = (
    f"held; Ctrl-C again within {SECOND_REQUEST_TIME:g} s releases the pump (no torque, or vented)"
)


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
    """Rate of the ticks [Hz]."""
    lead: float = 0.0
    """Part of the profile that lies before the scene's own start [s]."""
    on_stop: OnStop = "hold"
    max_lag: float = MAX_LAG
    """The stream stops where it stays farther behind its profile than this [ticks]."""
    tell: Tell = ignore
    """Is given what a second request would do, while the pump is held after a first one."""

    def __post_init__(self) -> None:
        self.result = StreamResult()
        self.ticks = Ticks(self.pump.clock, 1.0 / self.rate)
        self.origin = 0.0  # when the scene's own time begins [s of the clock]

    def play(self) -> StreamResult:
        """Arm, go to the profile, and along it to its end, a stop or a request to stop.

        However this ends, even by an exception, the pump is held and `result` says how, or that no
        hold could be sent.
        """
        try:
            self.result = self._forward()
        except PumpError as error:
            is_sound = isinstance(error, RecordingError)
            self.result = StreamResult("stopped", str(error), error.rule, may_retreat=is_sound)
        except BaseException as error:
            reason = f"{type(error).__name__}: {error}".removesuffix(": ")
            self.result = StreamResult("stopped", reason, "exception", may_retreat=False)
            raise
        finally:
            self._come_to_rest()
        return self.result

    def _forward(self) -> StreamResult:
        if self.request.asked:
            return StreamResult.interrupted(self.request)
        (low, high), steps = self.pump.limits.travel, self.profile.steps
        if steps.min() < low - ROUNDING or steps.max() > high + ROUNDING:
            words = (
                f"the profile goes from {steps.min():.0f} to {steps.max():.0f} "
                f"{self.pump.limits.unit}, outside of travel [{low}, {high}]; nothing was sent"
            )
            return StreamResult("stopped", words, "travel", may_retreat=False)
        if not self.pump.armed:
            self.pump.arm(self.profile.top_speed)
        path = led_in(self.profile, self.pump.goals, self.pump.limits.approach_speed)
        self.origin = self.pump.clock.now() + path.begins + self.lead
        return self._along(path, partial(stream_rules, max_lag=self.max_lag))

    def _along(
        self,
        path: Profile,
        rules: Callable[[AxisLimits, int], list[Guard]],
        heard: int = 0,
        relief: float | None = None,
    ) -> StreamResult:
        guards = rules(self.pump.limits, path.reach(CATCH_UP * self.ticks.period))
        parts = self.pump, self.ticks, self.request, self._report, path, guards
        return PathRun(*parts, heard, relief).go()

    def _report(self, sample: Sample, stop: Stop | None) -> None:
        time = self.pump.read_at - self.origin
        self.observe(TickReport(time, sample, self.ticks.skipped, stop))

    def _come_to_rest(self) -> None:
        """Hold first, whatever comes then; a request repeated at any time releases the pump."""
        result = self.result
        result.standing = self.pump.hold(in_place=result.status != "complete")
        if result.may_retreat and result.verified and self.pump.armed:
            if self.on_stop == "retract":
                result.standing = self._retreat()
            elif self.on_stop == "hold" and result.rule == "pressure_cap":
                result.standing = self._retreat(self.pump.limits.max_pressure)
        try:
            if result.status == "interrupted" and self.on_stop != "release" and self.pump.armed:
                wait_for_second_request(self.request, self.pump.clock, self.tell)
        finally:
            if self.on_stop == "release" or self.request.urgent:
                result.standing = self.pump.release()

    def _retreat(self, relief: float | None = None) -> list[FinalAxisState]:
        """Draw the pump back slowly, under all rules that still apply.

        To home, or until no inlet is above a gauge pressure [Pa].
        """
        pump = self.pump
        try:
            path = way_back(self.profile, pump.goals, pump.limits.home, pump.limits.approach_speed)
            heard = int(self.result.status == "interrupted")
            back = self._along(path, retreat_rules, heard, relief)
        except PumpError as error:
            back = StreamResult("stopped", str(error))
        self.result.retreat = "" if back.status == "complete" else back.reason
        return pump.hold()


def wait_for_second_request(request: StopRequest, clock: Clock, tell: Tell) -> None:
    """Give the user time to ask again, which releases a held pump; ``tell`` says so.

    An exception that ``tell`` raises comes when the time is over: the user may ask all the same.
    """
    end = clock.now() + SECOND_REQUEST_TIME
    try:
        if request.first == "SIGINT" and not request.urgent:
            tell(SECOND_REQUEST_HINT)
    finally:
        while not request.urgent and clock.now() < end:
            clock.sleep(SLICE)
