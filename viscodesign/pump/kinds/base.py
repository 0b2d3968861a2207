"""What a kind of pump must provide."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from typing import Any, ClassVar, Protocol

from viscodesign.errors import UsageError
from viscodesign.interrupt import StopRequest
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.boards.controller import Controller
from viscodesign.pump.consent import Confirm, ShowPosition, Tell
from viscodesign.pump.kinds.connection import Connection
from viscodesign.pump.planning.result import PumpPlan
from viscodesign.pump.play.axis import AxisState, FinalAxisState
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.play.stream_result import StreamResult
from viscodesign.pump.profile import Playback
from viscodesign.pump.simulated.device import Device
from viscodesign.pump.simulated.plant import Plant
from viscodesign.scene.pumps.base import PumpSpec
from viscodesign.scene.scene import Scene
from viscodesign.simulation.solve_once import Progress

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


class ProfileUpload(Protocol):
    """One profile, fitted to what a board plays by itself, and ready to be loaded."""

    fit: Any
    """The fit, as `viscodesign.pump.report.fit_chart` draws it."""
    plan: PumpPlan
    playback: Playback

    def __init__(
        self,
        plan: PumpPlan,
        settings: Any,
        tolerance: str,
        playback: Playback,
        achievable: bool,
        progress: Progress | None,
    ) -> None:
        """Fit a plan; opens no port. `PumpError` where the fit is too coarse.

        ``settings``: the pump's section; ``tolerance`` as for `viscodesign.pump.upload`.
        """

    @property
    def duration(self) -> float:
        """From the start of the profile to its end, or of one round [s]."""

    def rows(self) -> list[tuple[str, str]]:
        """What is about to be played, for people: headings and sentences."""

    def document(self) -> dict[str, Any]:
        """The same for a program."""

    def header(self) -> str:
        """The text of a C header, for a sketch that needs no computer."""

    def play_on(
        self, pump: Pump, request: StopRequest, tell: Tell, see: Callable[[float], None]
    ) -> StreamResult | None:
        """Load it with a connected pump and play it; None where it is to be loaded only.

        ``see`` is given the time that has been played [s].
        """

    def sent_lines(self, sent: Sequence[bytes]) -> list[str]:
        """What went over the line, for people."""


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
    poses: ClassVar[type[ProfileUpload] | None] = None
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
    def simulated_device(
        self, pump: Any, inlets: int, plant: Plant | None, ambient: float, *, poses: bool = False
    ) -> Device:
        """What that board talks to, and a pump behind it. ``ambient``: absolute [Pa].

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
                f"without_sensor (--without-sensor): a pump of kind {self.name} measures its own "
                "pressure; leave the option out"
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
