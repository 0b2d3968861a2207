"""Reading a pump that somebody else moves, or nobody."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from viscodesign.interrupt import StopRequest
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.play.axis import AxisState, Sample
from viscodesign.pump.play.ticks import Ticks
from viscodesign.pump.sensors.pressure_readings import PressureReadings


def listen(
    read: Callable[[], Mapping[int, AxisState]],
    gauges: PressureReadings,
    clock: Clock,
    request: StopRequest,
    observe: Callable[[float, Sample], None],
    *,
    rate: float,
    duration: float | None,
) -> Ticks:
    """Read at a steady rate [Hz] until the time [s] is over or a request to stop; writes nothing.

    ``observe`` is given the time from the start [s] and what was read; no pressure is expected,
    and the goals are those that the axes hold.
    """
    ticks = Ticks(clock, 1.0 / rate)
    ticks.begin()
    while not request.asked and (duration is None or ticks.elapsed <= duration):
        began = ticks.now
        states = read()
        goals = {axis: state.goal for axis, state in states.items()}
        pressure = gauges.read()
        expected = (None,) * len(pressure)
        observe(began, Sample(clock.now(), states, pressure, expected, {}, goals, goals))
        ticks.wait(lambda: not request.asked)
    return ticks
