"""A planned profile as poses: what is told of it, the header, and its way onto the board."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from viscodesign.cli.confirm import confirm
from viscodesign.cli.output import complain
from viscodesign.cli.progress import progress
from viscodesign.cli.pump._session import Way, opened
from viscodesign.cli.pump._setting import Setting
from viscodesign.cli.pump._told import document_rows, ending_lines, servo_documents
from viscodesign.cli.texts.layout import table
from viscodesign.errors import InterruptedRunError
from viscodesign.interrupt import StopRequest, stop_on_signals
from viscodesign.pump.boards.arbotix import Arbotix
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.play.stream import StreamResult
from viscodesign.pump.play.torque_limit import stalling_pressure, torque_limit
from viscodesign.pump.poses.c_header import poses_h
from viscodesign.pump.poses.engine import MOST_MOVES, MOST_POSES
from viscodesign.pump.poses.fit import PoseFit, fit_poses
from viscodesign.pump.poses.fit_error import FitError, Tolerance, refuse_coarse
from viscodesign.pump.poses.player import PosePlayer, by_servo, divided, playing_speed
from viscodesign.pump.sensors.limit_switches import Switches
from viscodesign.pump.sensors.pressure_readings import PressureReadings

if TYPE_CHECKING:
    from viscodesign.pump.boards.base import Board
    from viscodesign.pump.bus.clock import Clock
    from viscodesign.pump.planning.result import PumpCourse, PumpPlan
    from viscodesign.pump.profile import Profile
    from viscodesign.scene.pump import Pump as Settings
    from viscodesign.scene.scene import Scene

FORGOTTEN = (
    "loaded, and not played. The board keeps it in RAM only: a reset, a loss of power, or an "
    "opening of the port that resets the board forgets it. Add --play or --loop to play it now, "
    "or --export poses.h for a sketch that keeps it"
)


@dataclass(frozen=True)
class Poses:
    """All that an upload is made of."""

    scene: Scene
    settings: Settings
    plan: PumpPlan
    course: PumpCourse
    lead: Profile
    fit: PoseFit
    error: FitError
    tolerance: Tolerance

    @classmethod
    def of(
        cls,
        scene: Scene,
        settings: Settings,
        plan: PumpPlan,
        course: PumpCourse,
        tolerance: Tolerance,
        *,
        loop: bool,
        quiet: bool = False,
    ) -> Poses:
        """Fit a course of a plan; raises `PumpError` where it cannot be played closely enough."""
        profile = by_servo(plan.profile(course))
        lead, main = divided(profile, course.lead_s)
        with progress(quiet, "fitting", "fitting") as advance:
            fit = fit_poses(main, loop=loop, travel=settings.travel, progress=advance)
        stiffness = [1e3 * plan.numbers[name]["kpa_per_count_fast"] for name in profile.inlets]
        volume = plan.numbers[profile.inlets[0]]["volume_per_count_m3"]
        error = FitError.of(fit, volume, stiffness)
        refuse_coarse(fit, error, tolerance)
        return cls(scene, settings, plan, course, lead, fit, error, tolerance)

    def lines(self) -> list[str]:
        """What is going to be played, each number with its unit."""
        return table(self._rows())

    def _rows(self) -> list[tuple[str, str]]:
        fit, course, limit = self.fit, self.course, torque_limit(self.settings)
        volume, pressure = 1e6 * course.volume, course.pressure / 1e3
        counts = np.array([goal[:-1] for goal in fit.sequence.goals()])
        low, high = self.settings.travel
        held = stalling_pressure(self.settings, limit) / 1e3
        loses = "; the board's clock may lose up to 1 ms at each move"
        pace = f"a round, until it is halted{loses}" if fit.looped else "once"
        return [
            ("plays", f"{self.scene.name}, {fit.duration:.4g} s {pace}"),
            (
                "plunger",
                f"{counts.min()} to {counts.max()} counts of {low} to {high}, "
                f"{volume.min():.3g} to {volume.max():.3g} mL from home",
            ),
            ("pressure", f"{pressure.min():.2f} to {pressure.max():.2f} kPa gauge"),
            (
                "torque",
                f"up to {course.stall_share.max():.0%} of stall, limited to {limit / 1023:.0%}: "
                f"it cannot hold more than {held:.0f} kPa",
            ),
            (
                "fit",
                f"{len(fit.sequence.moves)} moves of {MOST_MOVES}, {len(fit.sequence.poses)} poses "
                f"of {MOST_POSES}; off by at most {self.error} (allowed: {self.tolerance.text})",
            ),
            (
                "watched",
                "nothing while it plays but the time: this firmware reads no sensor and no "
                "switch, and a move cannot be interrupted",
            ),
        ]

    def document(self) -> dict[str, Any]:
        """The same for a program."""
        fit, error = self.fit, self.error
        return {
            "name": self.scene.name,
            "spec_sha256": self.plan.spec_sha256,
            "looped": fit.looped,
            "duration_s": fit.duration,
            "wanted_duration_s": fit.wanted_duration,
            "moves": len(fit.sequence.moves),
            "poses": len(fit.sequence.poses),
            "largest_error_counts": error.counts,
            "largest_error_m3": error.volume,
            "largest_error_pa": error.pressure,
            "tolerance": self.tolerance.text,
        }

    def header(self) -> str:
        """The text of `poses.h`."""
        fit = self.fit
        return poses_h(
            fit.sequence,
            title=f"{self.scene.name}: poses for an ArbotiX",
            facts={
                "spec sha256": self.plan.spec_sha256,
                "viscodesign": self.plan.version,
                "duration": f"{fit.duration:.3f} s" + (" a round" if fit.looped else ""),
                "largest error": str(self.error),
                "travel": f"{self.settings.travel[0]} to {self.settings.travel[1]} counts, "
                f"home {self.settings.home}",
            },
            torque_limit=torque_limit(self.settings),
            moving_speed=playing_speed(fit),
            looped=fit.looped,
        )


@dataclass(frozen=True)
class Upload:
    """Poses, and the way to the board that is to have them."""

    poses: Poses
    way: Way
    clock: Clock
    moves: bool
    """Whether it is played, not only loaded."""
    yes: bool
    quiet: bool

    def perform(self) -> StreamResult | None:
        """Connect, ask, load, go to the start, play, stand; None where it is only loaded."""
        with opened(self.way, self.clock, Setting.of(self.poses.scene)) as (board, log):
            pump = pump_with(board, self.poses, self.clock)
            found = pump.connect()
            shown = [
                *self.poses.lines(),
                f"found {pump.identity}",
                *table(document_rows(servo_documents(found))),
            ]
            log.event("found", lines=shown, fit=self.poses.document())
            if self.moves:
                quiet = self.quiet and self.yes
                confirm([] if quiet else shown, "Move the pump?", yes=self.yes)
            elif not self.quiet:
                complain("\n".join(shown))
            with stop_on_signals() as wish:
                ending = self._play(pump, wish)
            if ending is not None:
                log.event("ended", status=ending.status, reason=ending.reason)
            return ending

    def _play(self, pump: Pump, wish: StopRequest) -> StreamResult | None:
        words = ("round", "playing")
        with progress(self.quiet or not self.moves, *words) as advance:
            player = player_of(pump, self.poses, wish, lambda t: advance(self._part(t)))
            player.load()
            if not self.moves:
                return None
            if wish.asked:
                raise InterruptedRunError("stopped before anything moved")
            ending = player.approach(self.poses.lead)
            if ending.status == "complete":
                ending = player.play()
        if ending.status != "complete" or not self.quiet:
            complain("\n".join(ending_lines(ending)))
        return ending

    def _part(self, elapsed: float) -> float:
        """Of the round that plays."""
        return elapsed % self.poses.fit.duration / self.poses.fit.duration


def pump_with(board: Board, poses: Poses, clock: Clock) -> Pump:
    """The pump behind a board that reads neither sensors nor switches."""
    servos = poses.lead.servos
    nothing = PressureReadings([None] * len(servos), poses.scene.ambient_pressure)
    return Pump(board, poses.settings, servos, nothing, Switches({}), clock)


def player_of(
    pump: Pump,
    poses: Poses,
    wish: StopRequest,
    see: Callable[[float], None],
    tell: Callable[[str], None] = complain,
) -> PosePlayer:
    """What plays them on a connected pump."""
    board = pump.board
    assert isinstance(board, Arbotix)  # the command has seen to it
    return PosePlayer(pump, board, poses.fit, wish, tell, see)
