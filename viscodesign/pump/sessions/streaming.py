"""A profile streamed set-point by set-point, from the open port to the closed record."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any, get_args

from viscodesign.errors import UsageError, not_among
from viscodesign.interrupt import StopRequest, stop_on_signals
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.bus.byte_log import ByteLog
from viscodesign.pump.consent import Confirm, Tell, ignore
from viscodesign.pump.kinds.base import PumpKind
from viscodesign.pump.planning.demand_kinds import pump_of
from viscodesign.pump.planning.plan import plan as plan_pump
from viscodesign.pump.planning.result import refuse_infeasible
from viscodesign.pump.planning.simulated_actuator import ActuatorPlant
from viscodesign.pump.play import link_rate
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.play.stream import Stream
from viscodesign.pump.play.stream_result import OnStop, TickReport
from viscodesign.pump.sessions import reports
from viscodesign.pump.sessions.arguments import typed
from viscodesign.pump.sessions.board_names import board_kind, boards_of, kind_behind
from viscodesign.pump.sessions.connection import SIMULATED, BoardAddress, connected, refuse_port
from viscodesign.pump.sessions.record_file import Record, recorded
from viscodesign.pump.sessions.record_folder import TABLE, attempt, refuse_measured
from viscodesign.pump.sessions.reports import PlaybackReport
from viscodesign.results.channels import TIP_COLUMNS
from viscodesign.scene.scene import Scene
from viscodesign.simulation.solve_once import Progress

OnTick = Callable[[TickReport], None]


@typed
def stream(
    scene: Scene,
    folder: str | Path,
    address: BoardAddress = SIMULATED,
    *,
    rate: float = 30.0,
    on_stop: OnStop = "hold",
    achievable: bool = False,
    without_sensor: bool = False,
    force: bool = False,
    confirm: Confirm | None = None,
    tell: Tell = ignore,
    on_tick: OnTick | None = None,
    stop: StopRequest | None = None,
    progress: Progress | None = None,
) -> PlaybackReport:
    """Plan a scene's pressures and stream them to a pump, monitored at every tick.

    Writes `record.csv`, `record.json` and `log.jsonl` to ``folder``. ``rate`` [Hz]; ``on_stop``
    is what the plunger does at any end. ``achievable`` plays what the pump can do where it
    cannot do all of it; ``without_sensor`` moves inlets whose pressure is not measured.
    ``force`` replaces a record of a real pump in the folder, which is refused otherwise; one of
    the simulated board is always replaced.
    ``confirm`` is given the plan before anything moves and has to return True (a simulated
    board needs none); ``on_tick`` is given every tick, and an exception that it raises ends the
    stream in a hold; ``stop`` may be asked from another thread, as Ctrl-C is. A stream that a
    rule or a request ended is a report with that status, not an exception; what does not begin
    raises `UsageError`, `SpecError` or `PumpError`.
    """
    refuse_measured(Path(folder) / TABLE, force=force)
    session = StreamSession(scene, address, rate, on_stop, achievable, without_sensor, progress)
    return session.perform(Path(folder), confirm=confirm, tell=tell, on_tick=on_tick, stop=stop)


@dataclass
class StreamSession:
    """One profile, planned and ready to be streamed to one board. Fields as for `stream`.

    Checks what was asked for and plans it; opens no port.
    """

    scene: Scene
    address: BoardAddress = SIMULATED
    rate: float = 30.0
    on_stop: OnStop = "hold"
    achievable: bool = False
    without_sensor: bool = False
    progress: Progress | None = None
    rehearsed: bool = False
    """Whether it is not to be played, so that it needs no port."""

    def __post_init__(self) -> None:
        self.kind = kind_behind(self.address.board, self.scene)
        _refuse_options(self.kind, self.address, self.rate, self.on_stop)
        if not self.rehearsed:
            refuse_port(self.address)
        self.scene = self.kind.with_sensors(
            self.scene, simulated=self.address.simulated, without=self.without_sensor
        )
        self.settings = pump_of(self.scene)
        self.plan = plan_pump(self.scene, progress=self.progress)
        refuse_infeasible(self.plan, self.achievable)

    def description(self) -> list[str]:
        """The plan, to be read before it is agreed to."""
        course = self.plan.achievable
        rows = [
            (
                "plays",
                f"{self.plan.name}, {float(course.time[-1]) - course.lead_s:.4g} s at "
                f"{self.rate:g} Hz, after a lead-in of {course.lead_s:.3g} s",
            ),
            *self.kind.motion_rows(self.plan, self.settings),
            ("on stop", self.on_stop),
        ]
        heading = f"{self.address.label}to be played on the board {self.address.board}"
        return [heading, *reports.aligned(rows)]

    def perform(
        self,
        folder: Path,
        *,
        confirm: Confirm | None = None,
        tell: Tell = ignore,
        hint: Tell | None = None,
        on_tick: OnTick | None = None,
        stop: StopRequest | None = None,
    ) -> PlaybackReport:
        """Connect, show, ask, stream, come to rest; raises `PumpError` where it does not begin.

        ``hint`` is given what the user may do next while the pump is held; by default ``tell``.
        """
        address = self.address
        plant = ActuatorPlant(self.scene) if address.simulated else None
        tip = {} if plant is None else {name: _tip(plant, k) for k, name in enumerate(TIP_COLUMNS)}
        with (
            attempt(folder, address.log) as begun,
            connected(replace(address, log=begun.log), self.scene, plant, tell) as link,
            link.gauges() as gauges,
        ):
            pump = link.connected_pump(gauges, switches=True)
            unit, limits = pump.limits.unit, pump.limits
            calibration = {f"home_{unit}": limits.home, f"travel_{unit}": list(limits.travel)}
            lines = self._connect(pump)
            link.log.event("found", lines=lines, calibration=calibration)
            address.require_consent(confirm, "\n".join([*lines, "Move the pump?"]))
            facts = {
                "board": address.board,
                "simulated": address.simulated,
                "name": self.scene.name,
                "spec_sha256": self.plan.spec_sha256,
                "resolved_sha256": self.plan.resolved_sha256,
                "ambient_pressure_pa_abs": self.scene.ambient_pressure,
                "calibration": calibration,
            }
            channels, path = self.kind.channels(self.settings), folder / TABLE
            with (
                stop_on_signals(stop) as request,
                recorded(path, self.plan.inlets, facts, channels, tip) as record,
            ):
                begun.recording = True
                return self._stream(pump, request, record, link.log, tell, hint or tell, on_tick)

    def stream_on(
        self, pump: Pump, request: StopRequest, on_tick: OnTick, hint: Tell = ignore
    ) -> Stream:
        """The stream of this session, not begun."""
        course = self.plan.achievable
        return Stream(
            pump, self.plan.profile(course), request, on_tick,
            rate=self.rate, lead=course.lead_s, on_stop=self.on_stop, tell=hint,
        )  # fmt: skip

    def _connect(self, pump: Pump) -> list[str]:
        """Identify all that is there, moving nothing; what a user should read of it.

        The rate is lowered to what the link sustains.
        """
        found = pump.connect()
        trip = link_rate.measure_round_trip(pump.look, pump.clock)
        self.rate, lowered = link_rate.sustainable_rate(self.rate, trip, pump.reading_share)
        notes = [*([lowered] if lowered else []), *pump.gauges.zero()]
        notes += [
            f"{name} has no pressure sensor: only the torque limit protects it"
            for name, pressure in zip(self.plan.inlets, pump.look()[1], strict=True)
            if pressure is None
        ]
        there = reports.found_lines(pump.identity, found)
        return [*self.description(), *there, *notes, *self.address.hints]

    def _stream(
        self,
        pump: Pump,
        request: StopRequest,
        record: Record,
        log: ByteLog,
        tell: Tell,
        hint: Tell,
        on_tick: OnTick | None,
    ) -> PlaybackReport:
        unit = pump.limits.unit

        def observe(tick: TickReport) -> None:
            sample = tick.sample
            record.add(tick.time, sample)
            moved = {
                f"goals_{unit}": sample.next_goals,
                f"positions_{unit}": {axis: own.position for axis, own in sample.axes.items()},
            }
            pressures = {"pressure_pa_gauge": sample.pressure, "wanted_pa_gauge": sample.wanted}
            log.event("tick", time_s=tick.time, **moved, **pressures)
            if on_tick is not None:
                on_tick(tick)

        stream = self.stream_on(pump, request, observe, hint)
        facts: dict[str, Any] = {}
        try:
            stream.play()
        finally:
            # After an exception too: the pump has come to rest, and everybody has to hear how.
            result = stream.result
            facts["standing"] = [str(one) for one in result.standing]
            facts["ticks"] = stream.ticks.document()
            facts["measured_against_plan"] = record.tracking_error()
            log.event("ended", status=result.status, **result.outcome(), **facts)
            if result.status != "complete":
                tell("\n".join(reports.result_lines(result)))
            record.state(result.status, **result.outcome(), **facts)
        kept = f"the record so far is in {record.path.parent}"
        return PlaybackReport(self.scene.name, result, facts, self.kind.noun, kept)


def _refuse_options(kind: PumpKind, address: BoardAddress, rate: float, on_stop: str) -> None:
    if not board_kind(address.board).streams:
        able = ", ".join(name for name, board in boards_of(kind).items() if board.streams)
        raise UsageError(
            f"the board {address.board} takes no set-points in real time; those that do: {able}. "
            "`pump upload` gives it a whole profile"
        )
    low, high = link_rate.LOWEST_RATE, link_rate.HIGHEST_RATE
    if not low <= rate <= high:
        raise UsageError(f"rate must be {low:g} to {high:g} Hz; got {rate:g}")
    if on_stop not in get_args(OnStop):
        raise UsageError(f"on_stop (--on-stop) {not_among(on_stop, get_args(OnStop))}")
    address.clock()


def _tip(plant: ActuatorPlant, k: int) -> Callable[[], float]:
    return lambda: float(plant.tip[k])
