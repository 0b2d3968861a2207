"""A planned profile as poses that an ArbotiX plays by itself."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal, get_args

import numpy as np

from viscodesign.errors import InterruptedRunError, UsageError
from viscodesign.interrupt import StopRequest, stop_on_signals
from viscodesign.pump.ax.servo_pump import ServoPump
from viscodesign.pump.ax.torque_limit import stalling_pressure, torque_limit
from viscodesign.pump.boards.arbotix import Arbotix
from viscodesign.pump.planning.plan import plan as plan_pump
from viscodesign.pump.planning.result import refuse_infeasible
from viscodesign.pump.planning.scene_variants import pump_of
from viscodesign.pump.planning.simulated_actuator import ActuatorPlant
from viscodesign.pump.play.stream_result import StreamResult
from viscodesign.pump.poses.c_header import poses_h
from viscodesign.pump.poses.engine import MOST_MOVES, MOST_POSES
from viscodesign.pump.poses.fit import fit_poses
from viscodesign.pump.poses.fit_error import FitError, Tolerance
from viscodesign.pump.poses.player import PosePlayer, by_servo, playing_speed, split_at
from viscodesign.pump.sessions import reports
from viscodesign.pump.sessions.connection import (
    SIMULATED,
    BoardAddress,
    Confirm,
    Tell,
    connected,
    ignore,
    unmonitored_pump,
)
from viscodesign.pump.sessions.open_board import board_kind
from viscodesign.pump.sessions.reports import PlaybackReport
from viscodesign.scene.scene import Scene
from viscodesign.simulation.solve_once import Progress

Playback = Literal["none", "once", "loop"]
"""What the board does with the poses once it has them."""


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
    thread, as Ctrl-C is. Raises `PumpError` where the fit is too coarse or the board does not
    answer.
    """
    refuse_board(address.board)
    session = UploadSession(scene, tolerance, playback, achievable, progress)
    return session.perform(address, confirm=confirm, tell=tell, stop=stop)


def refuse_board(name: str) -> None:
    """Raise `UsageError` where a board does not play poses; a simulated one does both."""
    kind = board_kind(name)
    if not (kind.simulated or issubclass(kind, Arbotix)):
        raise UsageError(
            f"--board {name} takes no poses; those go to --board {Arbotix.name}. "
            "`pump stream` sends this one set-points in real time"
        )


class UploadSession:
    """One profile, fitted and ready to be loaded."""

    def __init__(
        self,
        scene: Scene,
        tolerance: str = "1 kPa",
        playback: Playback = "none",
        achievable: bool = False,
        progress: Progress | None = None,
    ) -> None:
        """Plan and fit; opens no port. `PumpError` where the fit is too coarse."""
        if playback not in get_args(Playback):
            allowed = ", ".join(get_args(Playback))
            raise UsageError(f"playback must be one of {allowed}; got {playback!r}")
        self.scene, self.settings, self.playback = scene, pump_of(scene), playback
        self.tolerance = Tolerance.of(tolerance)
        self.plan = plan = plan_pump(scene, progress=progress)
        refuse_infeasible(plan, achievable)
        self.course = plan.wanted if plan.is_feasible else plan.achievable
        profile = by_servo(plan.profile(self.course))
        # The lead goes from home to the start.
        self.lead, main = split_at(profile, self.course.lead_s)
        self.fit = fit_poses(
            main,
            loop=playback == "loop",
            travel=self.settings.travel,
            progress=progress or (lambda part: None),
        )
        numbers = [plan.numbers[name] for name in profile.inlets]
        stiffness = [1e3 * each["kpa_per_count_fast"] for each in numbers]
        self.error = FitError.of(self.fit, numbers[0]["volume_per_count_m3"], stiffness)
        self.tolerance.refuse(self.fit, self.error)

    def description(self) -> list[str]:
        """What is about to be played, each number with its unit."""
        fit, course, limit = self.fit, self.course, torque_limit(self.settings)
        counts = np.array([goal[:-1] for goal in fit.sequence.goals()])
        drift = "; the board's clock may lose up to 1 ms at each move"
        pace = f"per round, until halted{drift}" if fit.looped else "once"
        rows = [
            ("plays", f"{self.scene.name}, {fit.duration:.4g} s {pace}"),
            *reports.motion_rows(course, self.settings, counts),
            (
                "torque",
                f"up to {course.stall_share.max():.0%} of stall; limited to {limit / 1023:.0%}, "
                f"which holds at most {stalling_pressure(self.settings, limit) / 1e3:.0f} kPa",
            ),
            (
                "fit",
                f"{len(fit.sequence.moves)} of {MOST_MOVES} moves, {len(fit.sequence.poses)} of "
                f"{MOST_POSES} poses; off by at most {self.error} (allowed: {self.tolerance.text})",
            ),
            (
                "monitored",
                "only the elapsed time: while it plays, this firmware reads no sensors or "
                "switches, and a move cannot be interrupted",
            ),
        ]
        return reports.aligned(rows)

    def document(self) -> dict[str, Any]:
        """The same for a program."""
        fit, error = self.fit, self.error
        return {
            "name": self.scene.name,
            "spec_sha256": self.plan.spec_sha256,
            "looped": fit.looped,
            "duration_s": fit.duration,
            "wanted_duration_s": fit.requested_duration,
            "moves": len(fit.sequence.moves),
            "poses": len(fit.sequence.poses),
            "largest_error_counts": error.counts,
            "largest_error_m3": error.volume,
            "largest_error_pa": error.pressure,
            "tolerance": self.tolerance.text,
        }

    def header(self) -> str:
        """The text of `poses.h`, for a sketch that needs no computer."""
        fit, (low, high) = self.fit, self.settings.travel
        return poses_h(
            fit.sequence,
            title=f"{self.scene.name}: poses for an ArbotiX",
            facts={
                "spec sha256": self.plan.spec_sha256,
                "viscodesign": self.plan.version,
                "duration": f"{fit.duration:.3f} s" + (" per round" if fit.looped else ""),
                "largest error": str(self.error),
                "travel": f"{low} to {high} counts, home {self.settings.home}",
            },
            torque_limit=torque_limit(self.settings),
            moving_speed=playing_speed(fit),
            looped=fit.looped,
        )

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
        with connected(address, self.scene, plant, tell, poses=True) as link:
            pump = unmonitored_pump(link.board, self.settings, self.lead.axes, link.clock)
            servos = pump.connect()
            lines = [*self.description(), *reports.found_lines(pump.identity, servos)]
            link.log.event("found", lines=lines, fit=self.document())
            if self.playback == "none":
                tell("\n".join(lines))
            else:
                address.require_consent(confirm, "\n".join([*lines, "Move the pump?"]))
            with stop_on_signals(stop) as request:
                round_s = self.fit.duration
                result = self.play_on(
                    pump, request, tell, lambda elapsed: on_round(elapsed % round_s / round_s)
                )
            if result is not None:
                link.log.event("ended", status=result.status, reason=result.reason)
                if result.status != "complete":
                    tell("\n".join(reports.result_lines(result)))
            return PlaybackReport(self.scene.name, result, self.document())

    def play_on(
        self, pump: ServoPump, request: StopRequest, tell: Tell, see: Callable[[float], None]
    ) -> StreamResult | None:
        """Load the poses on a connected pump and play them, unless they are to be loaded only.

        ``see`` is given the time that has been played [s].
        """
        assert isinstance(pump.board, Arbotix)  # as `refuse_board` sees to
        player = PosePlayer(pump, pump.board, self.fit, request, tell, see)
        player.load()
        if self.playback == "none":
            return None
        if request.asked:
            raise InterruptedRunError("interrupted before anything moved")
        result = player.approach(self.lead)
        return player.play() if result.status == "complete" else result
