"""What a kind of pump must provide, and the open connection that it works on."""

from __future__ import annotations

import contextlib
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, ClassVar

from viscodesign.errors import UsageError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.boards.controller import Controller
from viscodesign.pump.bus.byte_log import ByteLog
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.bus.line import Line
from viscodesign.pump.consent import Confirm, ShowPosition, Tell
from viscodesign.pump.planning.result import PumpPlan
from viscodesign.pump.play.axis import AxisState, FinalAxisState
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.poses.upload import PoseUpload
from viscodesign.pump.sensors.base import BoardAnalog
from viscodesign.pump.sensors.phidget import Phidget
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.pump.simulated.plant import Plant
from viscodesign.scene.per_inlet import each
from viscodesign.scene.pumps.base import PumpSpec, SensorSpec
from viscodesign.scene.scene import Scene
from viscodesign.storage.cached_property import cached_property

Channels = Mapping[tuple[str, str], Callable[[AxisState, int], float | None]]
"""Quantity and unit of each axis' columns in a record, with what gives its value."""


@dataclass(frozen=True)
class Calibration:
    """Where an axis starts and how far it may go [steps]."""

    home: int
    travel: tuple[int, int]


@dataclass(frozen=True)
class CalibrationRequest:
    """What a calibration is to do, and whom it asks."""

    confirm: Confirm
    by_hand: ShowPosition | None = None
    vented: Confirm | None = None
    """Is asked before a plunger is left without force; by default ``confirm``."""
    keep: bool = False
    """Take the spec's values; measure nothing."""
    rename: tuple[int, int] | None = None
    """Id that an axis has, and the one that it is to get."""
    tell: Tell = lambda message: None


@dataclass(frozen=True)
class Connection:
    """An open board, and what is known of the pump behind it."""

    kind: PumpKind
    board: Any  # a controller of that kind
    log: ByteLog
    clock: Clock
    pump: Any  # the spec's section; None without a spec
    ambient: float
    """Absolute [Pa]."""
    names: tuple[str, ...]
    """Names of the inlets; empty where no spec names them."""

    @cached_property
    def axes(self) -> tuple[int, ...]:
        """Ids of the spec's axes; without a spec, of all that answer."""
        if self.pump is not None:
            return tuple(self.pump.axes(len(self.names)))
        return tuple(self.kind.answering(self.board))

    @property
    def inlets(self) -> tuple[str, ...]:
        """One name per axis."""
        numbered = tuple(f"{self.kind.noun}{axis}" for axis in self.axes)
        return self.names or (("inlet",) if len(self.axes) == 1 else numbered)

    def connected_pump(
        self, gauges: PressureReadings | None = None, *, switches: bool = False
    ) -> Pump:
        """The pump behind the contract of `Pump`, by default without its sensors and switches."""
        gauges = gauges or PressureReadings([None] * len(self.axes), self.ambient)
        return self.kind.pump(
            self.board, self.pump, self.axes, gauges, self.clock, switches=switches
        )

    @contextlib.contextmanager
    def gauges(self) -> Iterator[PressureReadings]:
        """What measures the inlets' pressures: sensors of the spec, or the axes themselves."""
        known = self.pump is not None and (self.board.has_pins or not self.board.simulated)
        sensors = each(self.pump.sensor if known else None, len(self.inlets))
        with contextlib.ExitStack() as opened:
            reads = [
                self.kind.own_gauge(self, axis) if sensor is None else self._source(sensor, opened)
                for axis, sensor in zip(self.axes, sensors, strict=True)
            ]
            own = [k for k, sensor in enumerate(sensors) if sensor is None]
            yield PressureReadings(reads, self.ambient, self.inlets, exact=own)

    def _source(self, sensor: SensorSpec, opened: contextlib.ExitStack) -> Callable[[], float]:
        on_board = self.board.has_pins if sensor.on == "auto" else sensor.on == "board"
        source = BoardAnalog(self.board, sensor.channel) if on_board else Phidget(sensor.channel)
        opened.callback(source.close)
        return source.absolute


class PumpKind(ABC):
    """One principle of pump; a kind is a file, and a section of the spec in `scene/pumps`.

    Its file also holds what a plan asks of its axes: a `PumpDemand` of the same name.
    """

    name: ClassVar[str]
    """Word after `pump.kind`."""
    noun: ClassVar[str]
    """What an axis is called in messages and documents."""
    pump: ClassVar[type[Pump]]
    """What moves, reads and holds its axes."""
    poses: ClassVar[type[PoseUpload] | None] = None
    """What plays a whole profile without a computer, where something does."""
    no_reply: ClassVar[str] = ""
    """What a user has to know of a board that does not stream, and does not answer a stop."""
    not_calibrated: ClassVar[str] = ""
    """Why there is nothing to calibrate, where there is not."""

    @abstractmethod
    def boards(self) -> Mapping[str, type[Controller]]:
        """Real boards by the word after `--board`."""

    @abstractmethod
    def simulated_board(self, poses: bool) -> type[Controller]:
        """The board of `--board simulated`; with ``poses``, one that plays them by itself."""

    @abstractmethod
    def simulated_line(
        self,
        pump: Any,
        inlets: int,
        clock: Clock,
        plant: Plant | None,
        ambient: float,
        *,
        poses: bool = False,
    ) -> Line:
        """A line into that board, and a pump behind it. ``ambient``: absolute [Pa].

        ``inlets``: number of inlets, so of axes; ``plant``: what the pump presses into; by
        default something closed.
        """

    @abstractmethod
    def simulated_pump(self) -> PumpSpec:
        """The section of a simulated pump that no spec describes."""

    def with_sensors(self, scene: Scene, *, simulated: bool, without: bool) -> Scene:
        """The scene with a pressure reading at every inlet, as a stream needs it.

        ``without``: the user does without sensors. Raises `UsageError` where that is not possible.
        """
        if without:
            raise UsageError(
                f"--without-sensor: a pump of kind {self.name} measures its own pressure; leave "
                "the option out"
            )
        return scene

    @abstractmethod
    def channels(self, pump: Any) -> Channels:
        """Columns of an axis in a record; ``pump``: the spec's section, None without one."""

    def own_gauge(self, link: Connection, axis: int) -> Callable[[], float] | None:
        """What reads an inlet's absolute pressure [Pa] without a sensor of the spec."""
        return None

    @abstractmethod
    def answering(self, board: Any) -> Sequence[int]:
        """Ids of the axes that answer where no spec names them; writes nothing."""

    @abstractmethod
    def motion_rows(self, plan: PumpPlan, pump: Any) -> list[tuple[str, str]]:
        """What is about to happen, for people: headings and sentences."""

    @abstractmethod
    def stop(self, link: Connection, ids: Sequence[int], release: bool) -> list[FinalAxisState]:
        """Hold every axis that answers, or release it; empty where none answers.

        Works in any state and without a spec. ``ids``: only these; by default all.
        """

    def calibrate(self, link: Connection, request: CalibrationRequest) -> Calibration:
        """Find home and travel of its axes; raises `UsageError` where it is `not_calibrated`."""
        raise UsageError(self.not_calibrated)

    def calibration_steps(self, pump: Any, request: CalibrationRequest) -> list[str]:
        """What `calibrate` would do; raises as that does."""
        raise UsageError(self.not_calibrated)
