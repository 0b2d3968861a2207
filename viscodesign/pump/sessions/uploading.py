"""A planned profile as poses that a board plays by itself."""

from __future__ import annotations

from viscodesign.errors import UsageError
from viscodesign.interrupt import StopRequest, stop_on_signals
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.consent import Confirm, Tell, ignore
from viscodesign.pump.kinds.base import ProfileUpload, PumpKind
from viscodesign.pump.planning.demand_kinds import pump_of
from viscodesign.pump.planning.plan import plan as plan_pump
from viscodesign.pump.planning.simulated_actuator import ActuatorPlant
from viscodesign.pump.profile import Playback
from viscodesign.pump.sessions import reports
from viscodesign.pump.sessions.arguments import typed
from viscodesign.pump.sessions.board_names import board_kind, boards, kind_of
from viscodesign.pump.sessions.connection import SIMULATED, BoardAddress, connected
from viscodesign.pump.sessions.reports import PlaybackReport
from viscodesign.scene.scene import Scene
from viscodesign.simulation.solve_once import Progress


@typed
def upload(
    scene: Scene,
    address: BoardAddress = SIMULATED,
    *,
    playback: Playback = "none",
    tolerance: str = "1 kPa",
    achievable: bool = False,
    confirm: Confirm | None = None,
    tell: Tell = ignore,
    stop: StopRequest | None = None,
    progress: Progress | None = None,
) -> PlaybackReport:
    """Plan a scene's pressures, fit them to 30 poses and 46 moves, and load these onto a board.

    ``tolerance``: the largest error allowed, like '1 kPa', '0.1 mL' or '2 counts'.
    ``playback``: only load, play ``once``, or ``loop`` until Ctrl-C; then ``confirm`` is given
    the plan before anything moves and has to return True, and ``stop`` may be asked from another
    thread, as Ctrl-C is. Raises `UsageError` where the pump or the board plays no poses, and
    `PumpError` where the fit is too coarse or the board does not answer.
    """
    refuse_board(address.board, scene)
    session = UploadSession(scene, tolerance, playback, achievable, progress)
    return session.perform(address, confirm=confirm, tell=tell, stop=stop)


def refuse_board(name: str, scene: Scene) -> None:
    """Raise `UsageError` where a pump or a board plays no poses; a simulated board does both."""
    _poses_of(kind_of(scene))
    board = board_kind(name)
    if not (board.simulated or board.plays_poses):
        able = ", ".join(name for name, kind in boards().items() if kind.plays_poses)
        raise UsageError(
            f"the board {name} takes no poses; those go to {able}. "
            "`pump stream` sends this one set-points in real time"
        )


def _poses_of(kind: PumpKind) -> type[ProfileUpload]:
    if kind.poses is None:
        raise UsageError(
            f"a pump of kind {kind.name} plays no profile by itself, so there is nothing to upload "
            "to; `pump stream` sends it set-points in real time"
        )
    return kind.poses


@dataclass
class UploadSession:
    """One profile, planned, fitted and ready to be loaded; opens no port. Fields as for `upload`.

    Raises `PumpError` where the fit is too coarse.
    """

    scene: Scene
    tolerance: str = "1 kPa"
    playback: Playback = "none"
    achievable: bool = False
    progress: Progress | None = None

    def __post_init__(self) -> None:
        fitted = _poses_of(kind_of(self.scene))
        plan = plan_pump(self.scene, progress=self.progress)
        how = self.tolerance, self.playback, self.achievable, self.progress
        self.poses = fitted(plan, pump_of(self.scene), *how)

    def description(self) -> list[str]:
        """What is about to be played, each number with its unit."""
        return reports.aligned(self.poses.rows())

    def perform(
        self,
        address: BoardAddress,
        *,
        confirm: Confirm | None = None,
        tell: Tell = ignore,
        on_round: Progress = lambda part: None,
        stop: StopRequest | None = None,
    ) -> PlaybackReport:
        """Connect, ask, load, go to the start, play, come to rest.

        ``on_round`` is given the part of the round that has been played.
        """
        plant = ActuatorPlant(self.scene) if address.simulated else None
        document = self.poses.document()
        with connected(address, self.scene, plant, tell, poses=True) as link:
            pump = link.connected_pump()
            found = pump.connect()
            lines = [*self.description(), *reports.found_lines(pump.identity, found)]
            link.log.event("found", lines=lines, fit=document)
            if self.poses.playback == "none":
                tell("\n".join(lines))
            else:
                address.require_consent(confirm, "\n".join([*lines, "Move the pump?"]))
            with stop_on_signals(stop) as request:
                round_s = self.poses.duration
                see = lambda elapsed: on_round(elapsed % round_s / round_s)  # noqa: E731
                result = self.poses.play_on(pump, request, tell, see)
            if result is not None:
                link.log.event("ended", status=result.status, reason=result.reason)
                if result.status != "complete":
                    tell("\n".join(reports.result_lines(result)))
            return PlaybackReport(self.scene.name, result, document, link.kind.noun)
