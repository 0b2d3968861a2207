"""Reading a pump that somebody else moves, or nobody."""

from __future__ import annotations

from collections.abc import Callable

from viscodesign.interrupt import StopRequest
from viscodesign.pump.play.axis import Sample
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.play.ticks import Ticks


def listen(
    pump: Pump,
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
    ticks = Ticks(pump.clock, 1.0 / rate)
    ticks.begin()
    while not request.asked and (duration is None or ticks.elapsed <= duration):
        began = ticks.now
        states, pressure, pressed = pump.look()
        goals = {axis: state.goal for axis, state in states.items()}
        expected = (None,) * len(pressure)
        now = pump.clock.now()
        observe(began, Sample(now, states, pressure, expected, pressed, goals, goals))
        ticks.wait(lambda: not request.asked)
    return ticks
