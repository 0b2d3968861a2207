"""What a stream would send, found out without a port: on the computed pump, at once."""

from __future__ import annotations

from viscodesign.cli.pump._performance import Performance
from viscodesign.cli.pump._told import ending_lines
from viscodesign.interrupt import StopRequest
from viscodesign.pump.boards.simulated import Simulated
from viscodesign.pump.bus.clock import SteppedClock
from viscodesign.pump.bus.packets import Instruction, shown
from viscodesign.pump.bus.recording_line import RecordingLine
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.play.stream import Stream
from viscodesign.pump.sensors.limit_switches import Switches
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.pump.sessions.open_board import simulated_line

FIRST = 10
"""Packets that are printed."""


def rehearsed(performance: Performance) -> list[str]:
    """The plan, and the packets that would set something; no port is opened for it."""
    plan, settings = performance.plan, performance.settings
    clock = SteppedClock()
    ambient = performance.scene.ambient_pressure
    line = RecordingLine(simulated_line(settings, clock, performance.plant, ambient))
    board = Simulated(line, plan.servos)
    # Nothing is measured here: a closed barrel would show another pressure than the actuator's.
    gauges = PressureReadings([None] * len(plan.servos), ambient)
    pump = Pump(board, settings, plan.servos, gauges, Switches({}), clock)
    stream = Stream(
        pump,
        plan.profile(plan.achievable),
        StopRequest(),
        lambda tick: None,
        rate=performance.rate,
        lead=plan.achievable.lead_s,
        on_stop=performance.on_stop,
    )
    pump.connect()
    ending = stream.play()
    setting = (Instruction.WRITE, Instruction.SYNC_WRITE)
    packets = [data for data in line.sent if data[4] in setting]
    return [
        "[dry run] no port is opened, nothing moves",
        *performance.lines(),
        f"would send {len(packets)} packets that set something; the first {FIRST}, the last:",
        *(f"  {shown(packet)}" for packet in packets[:FIRST]),
        "  ...",
        f"  {shown(packets[-1])}",
        *(f"[dry run] {line}" for line in ending_lines(ending)[:1]),
    ]
