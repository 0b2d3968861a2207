"""One stream from the open port to the closed record."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from viscodesign.cli.confirm import confirm
from viscodesign.cli.output import complain
from viscodesign.cli.pump._session import Way, gauges, opened
from viscodesign.cli.pump._setting import Setting
from viscodesign.cli.pump._told import (
    document_rows,
    ending_lines,
    plan_rows,
    servo_documents,
)
from viscodesign.cli.texts.layout import table
from viscodesign.interrupt import StopRequest, stop_on_signals
from viscodesign.pump.bus.byte_log import ByteLog
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.play.stream import OnStop, Stream, StreamResult, TickReport
from viscodesign.pump.sensors.limit_switches import Switches
from viscodesign.pump.sessions.live_view import LiveView
from viscodesign.pump.sessions.outlet import Outlet
from viscodesign.pump.sessions.record import Record, recorded

if TYPE_CHECKING:
    from viscodesign.pump.boards.base import Board
    from viscodesign.pump.bus.clock import Clock
    from viscodesign.pump.planning.result import PumpPlan
    from viscodesign.pump.planning.simulated_actuator import ActuatorPlant
    from viscodesign.pump.sensors.pressure_readings import PressureReadings
    from viscodesign.scene.pump import Pump as Settings
    from viscodesign.scene.scene import Scene


@dataclass
class Agreement:
    """How far the measured pressure was from the model's, over all samples that have both."""

    samples: int = 0
    squares: float = 0.0
    largest: float = 0.0

    def note(self, shown: TickReport) -> None:
        pairs = zip(shown.sample.pressure, shown.sample.wanted, strict=True)
        for measured, wanted in pairs:
            if measured is not None and wanted is not None:
                self.samples += 1
                self.squares += (measured - wanted) ** 2
                self.largest = max(self.largest, abs(measured - wanted))

    def document(self) -> dict[str, Any]:
        """Under names with units; empty where nothing was measured."""
        if not self.samples:
            return {}
        rms = (self.squares / self.samples) ** 0.5
        return {"largest_pa": self.largest, "rms_pa": rms, "samples": self.samples}


@dataclass
class Performance:
    """All that a stream is made of."""

    scene: Scene
    settings: Settings
    plan: PumpPlan
    way: Way
    clock: Clock
    plant: ActuatorPlant | None
    """What a simulated pump presses into."""
    rate: float
    on_stop: OnStop
    table: Path
    """Where the record goes."""
    yes: bool
    quiet: bool
    agreement: Agreement = field(default_factory=Agreement)
    told: dict[str, Any] = field(default_factory=dict)
    """What the record's JSON says, in the end."""

    def lines(self) -> list[str]:
        """The plan, to be read before it is agreed to."""
        rows = plan_rows(self.plan, self.settings, self.rate, self.on_stop)
        return [f"{self.way.label}to be played on the board {self.way.board}", *table(rows)]

    def perform(self) -> StreamResult:
        """Connect, show, ask, stream, stand; raises `PumpError` where it does not begin."""
        with (
            opened(self.way, self.clock, Setting.of(self.scene), self.plant) as (board, log),
            self._gauges(board) as sensors,
        ):
            pump = self._pump(board, sensors)
            shown = self._connect(pump)
            log.event("found", lines=shown, calibration=self._calibration())
            confirm(shown if not (self.quiet and self.yes) else [], "Move the pump?", yes=self.yes)
            with stop_on_signals() as wish, self._record(board) as record:
                return self._stream(pump, wish, record, log)

    def _gauges(self, board: Board) -> AbstractContextManager[PressureReadings]:
        ambient = self.scene.ambient_pressure
        return gauges(board, self.settings, ambient, self.plan.inlets)

    def _pump(self, board: Board, sensors: PressureReadings) -> Pump:
        switches = Switches.of(self.settings, self.plan.servos)
        return Pump(board, self.settings, self.plan.servos, sensors, switches, self.clock)

    def _connect(self, pump: Pump) -> list[str]:
        """Identify all that is there, moving nothing; what a user should read of it."""
        found = pump.connect()
        told = pump.gauges.zero()
        told += _unwatched(self.plan.inlets, pump.look()[1])
        return [
            *self.lines(),
            f"found {pump.identity}",
            *table(document_rows(servo_documents(found))),
            *told,
            *self.way.hints,
        ]

    def _calibration(self) -> dict[str, Any]:
        return {"home_counts": self.settings.home, "travel_counts": list(self.settings.travel)}

    def _record(self, board: Board) -> AbstractContextManager[Record]:
        facts = {
            "board": self.way.board,
            "simulated": board.simulated,
            "name": self.scene.name,
            "spec_sha256": self.plan.spec_sha256,
            "calibration": self._calibration(),
            "ambient_pressure_pa_abs": self.scene.ambient_pressure,
        }
        return recorded(self.table, self.plan.inlets, facts, self._tip())

    def _tip(self) -> dict[str, Callable[[], float]]:
        """Of the simulated actuator, where there is one: under the simulator's names."""
        plant = self.plant
        if plant is None:
            return {}
        names = ("tip_x_m", "tip_z_m", "tip_angle_rad")
        return {name: lambda k=k: float(plant.tip[k]) for k, name in enumerate(names)}  # type: ignore[misc]

    def _stream(self, pump: Pump, wish: StopRequest, record: Record, log: ByteLog) -> StreamResult:
        outlet, view = self._view()
        stream = Stream(
            pump,
            self.plan.profile(self.plan.achievable),
            wish,
            self._seen_by(record, log, view),
            rate=self.rate,
            lead=self.plan.achievable.lead_s,
            on_stop=self.on_stop,
        )
        try:
            stream.play()
        finally:
            # By an exception too: the pump stands, and everybody has to hear how.
            outlet.close()
            self.told = {
                "reason": stream.ending.reason,
                "rule": stream.ending.rule,
                "hold_verified": stream.ending.sure,
                "standing": [str(one) for one in stream.ending.standing],
                "ticks": stream.ticks.document(),
                "measured_against_plan": self.agreement.document(),
            }
            log.event("ended", status=stream.ending.status, **self.told)
            if stream.ending.status != "complete" or not self.quiet:
                complain("\n".join(ending_lines(stream.ending)))
            record.state(stream.ending.status, **self.told)
        return stream.ending

    def _view(self) -> tuple[Outlet, LiveView]:
        import sys

        outlet = Outlet(sys.stderr)
        course = self.plan.achievable
        duration = float(course.time[-1]) - course.lead_s
        span = (min(float(course.pressure.min()), 0.0), self.settings.max_pressure)
        return outlet, LiveView(self.plan.inlets, span, duration, self.way.simulated, outlet)

    def _seen_by(
        self, record: Record, log: ByteLog, view: LiveView
    ) -> Callable[[TickReport], None]:
        def see(shown: TickReport) -> None:
            sample = shown.sample
            record.add(shown.time, sample)
            self.agreement.note(shown)
            log.event(
                "tick",
                time_s=shown.time,
                goals_counts=sample.next_goals,
                positions_counts={s: state.position for s, state in sample.servos.items()},
                pressure_pa_gauge=sample.pressure,
                wanted_pa_gauge=sample.wanted,
            )
            if not self.quiet:
                view.show(shown)

        return see


def _unwatched(inlets: Sequence[str], pressure: Sequence[float | None]) -> list[str]:
    """Inlets whose pressure nobody measures."""
    blind = [name for name, value in zip(inlets, pressure, strict=True) if value is None]
    return [f"{name} has no pressure sensor: only its torque limit guards it" for name in blind]
