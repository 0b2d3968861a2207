"""The ticks along a path: read, judge, send."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field

from viscodesign.interrupt import StopRequest
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.play.axis import Sample
from viscodesign.pump.play.guard import Guard, Stop, first_broken
from viscodesign.pump.play.path import SetPoints
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.play.stream_result import StreamResult
from viscodesign.pump.play.ticks import Ticks
from viscodesign.pump.profile import Profile

CATCH_UP = 1.5
"""A late stream goes along its path this many times as fast as planned, until it is in time."""
SETTLE_TIME = 2.0  # for the last of a following error to go, at the end of a profile [s]
SETTLED_READINGS = 2  # in succession, that show the axes at the end of their path


@dataclass
class PathRun:
    """One way along a path, until its end, a stop, or one more request than was heard."""

    pump: Pump
    ticks: Ticks
    request: StopRequest
    observe: Callable[[Sample, Stop | None], None]
    """Is given every sample, and the rule that it breaks."""
    path: Profile
    guards: list[Guard]
    heard: int = 0
    """Requests to stop that came before."""
    relief: float | None = None
    """The way is over where no inlet is above this gauge pressure [Pa]."""
    relieved: bool = field(default=False, init=False)
    place: float = field(default=0.0, init=False)
    """How far it is along the path, from its start [s]."""
    moment: float = field(default=0.0, init=False)
    """When that was, since the first tick [s]."""

    def __post_init__(self) -> None:
        self.points = SetPoints(self.path, self.ticks.period, self.pump.limits)

    def go(self) -> StreamResult:
        """Ticks along the path, then until the axes are at its end."""
        self.ticks.begin()
        settled = 0
        while settled < SETTLED_READINGS and not self.relieved:
            if not self._undisturbed():
                return StreamResult.interrupted(self.request)
            late = self.moment - self.place
            if self.ticks.elapsed > self.path.duration + SETTLE_TIME + late:
                if self._arrived(self.pump.limits.dead_band):
                    break
                return self._short_of_target()
            stop = self._tick()
            if stop is not None:
                return StreamResult("stopped", str(stop), stop.rule, stop.may_retreat)
            if not self.relieved:
                self.ticks.wait(self._undisturbed)
            ended = self.place >= self.path.duration
            settled = settled + 1 if ended and self._arrived(self.pump.limits.settled_error) else 0
        if self.relief is not None and not self.relieved:
            return StreamResult("stopped", "back at home, and the pressure is still above the cap")
        return StreamResult("complete", "played to its end")

    def _undisturbed(self) -> bool:
        return self.request.times <= self.heard

    def _errors(self) -> dict[int, float]:
        """By axis, from where it was last read to the end of the path [steps]."""
        ends = zip(self.path.axes, self.path.steps[-1], strict=True)
        return {axis: abs(float(end) - self.pump.positions[axis]) for axis, end in ends}

    def _arrived(self, within: float) -> bool:
        return self.pump.alarm is not None or max(self._errors().values()) <= within

    def _short_of_target(self) -> StreamResult:
        limits = self.pump.limits
        axis, error = max(self._errors().items(), key=lambda item: item[1])
        return StreamResult(
            "stopped",
            f"not reached: {limits.noun} {axis} stays {error:.0f} {limits.unit} from its last "
            f"target; {limits.weakness}",
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
        self.points.learn(commanded, pump.positions, pump.limits.settled_error if ended else None)
        pace = self._advance(elapsed)
        goals, speeds = self.points.next(self.place, pump.goals, pump.reach)
        goals = pump.allowed(goals)
        if ended:
            speeds = dict.fromkeys(goals, pump.limits.settle_speed)
        sample = Sample(
            time=pump.clock.now(),
            axes=states,
            pressure=pressure,
            wanted=self.path.expected_pressure(commanded),
            pressed=pressed,
            goals=dict(pump.goals),
            next_goals=goals,
            lag=(self.moment - self.place) / period,
            noun=pump.limits.noun,
        )
        if self.relief is not None:
            self.relieved = all(p is None or p <= self.relief for p in pressure)
        stop = first_broken(self.guards, sample)
        pump.alarm = pump.alarm or stop
        if stop is None and not self.relieved and self._undisturbed():
            paces = {s: pace * speed for s, speed in self.path.paces(self.place).items()}
            pump.set_goals(goals, speeds, paces)
        if not ended or stop is not None:
            self.observe(sample, stop)
        return stop
