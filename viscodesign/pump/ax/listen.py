"""Reading a pump that somebody else moves, or nobody."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from viscodesign.interrupt import StopRequest
from viscodesign.pump.ax.servo_state import read_servo
from viscodesign.pump.boards.base import Board
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.play.axis import Sample
from viscodesign.pump.play.ticks import Ticks
from viscodesign.pump.sensors.pressure_readings import PressureReadings


def listen(
    board: Board,
    servos: Sequence[int],
    gauges: PressureReadings,
    clock: Clock,
    request: StopRequest,
    see: Callable[[float, Sample], None],
    *,
    rate: float,
    duration: float | None,
) -> Ticks:
    """Read at a steady rate [Hz] until the time [s] is over or a request to stop; writes nothing.

    ``see`` is given the time from the start [s] and what was read.
    """
    ticks = Ticks(clock, 1.0 / rate)
    ticks.begin()
    while not request.asked and (duration is None or ticks.elapsed <= duration):
        see(ticks.now, look(board, servos, gauges, clock))
        ticks.wait(lambda: not request.asked)
    return ticks


def look(board: Board, servos: Sequence[int], gauges: PressureReadings, clock: Clock) -> Sample:
    """One sample; no pressure is expected, and the goals are those that the servos hold."""
    states = {servo: read_servo(board, servo) for servo in servos}
    goals = {servo: state.goal for servo, state in states.items()}
    pressure = gauges.read()
    return Sample(
        time=clock.now(),
        servos=states,
        pressure=pressure,
        wanted=(None,) * len(pressure),
        pressed={},
        goals=goals,
        next_goals=goals,
    )
