"""A planned profile as poses that an ArbotiX plays by itself."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from typing import Any, get_args

import numpy as np

from viscodesign.errors import InterruptedRunError, UsageError
from viscodesign.interrupt import StopRequest
from viscodesign.pump.ax.protocol.packets import Instruction, shown
from viscodesign.pump.ax.protocol.transactions import ARBOTIX
from viscodesign.pump.ax.servo_pump import ServoPump
from viscodesign.pump.ax.torque_limit import share_of_stall, stalling_pressure, torque_limit
from viscodesign.pump.boards.arbotix import HALT, Arbotix
from viscodesign.pump.consent import Tell
from viscodesign.pump.planning.result import PumpPlan, refuse_infeasible
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.play.stream_result import StreamResult
from viscodesign.pump.plunger.plunger_numbers import range_rows
from viscodesign.pump.poses.c_header import poses_h
from viscodesign.pump.poses.engine import MAX_MOVES, MAX_POSES
from viscodesign.pump.poses.fit import fit_poses
from viscodesign.pump.poses.fit_error import FitError, Tolerance
from viscodesign.pump.poses.player import PosePlayer, by_servo, playing_speed, split_at
from viscodesign.pump.profile import Playback
from viscodesign.scene.pumps.servo import ServoPumpSpec
from viscodesign.simulation.solve_once import Progress


class PoseUpload:
    """One profile, fitted and ready to be loaded."""

    def __init__(
        self,
        plan: PumpPlan,
        settings: ServoPumpSpec,
        tolerance: str = "1 kPa",
        playback: Playback = "none",
        achievable: bool = False,
        progress: Progress | None = None,
    ) -> None:
        """Fit a plan; opens no port. `PumpError` where the fit is too coarse."""
        if playback not in get_args(Playback):
            allowed = ", ".join(get_args(Playback))
            raise UsageError(f"playback must be one of {allowed}; got {playback!r}")
        self.plan, self.settings, self.playback = plan, settings, playback
        self.tolerance = Tolerance.of(tolerance)
        refuse_infeasible(plan, achievable)
        self.course = plan.wanted if plan.is_feasible else plan.achievable
        profile = by_servo(plan.profile(self.course))
        # The lead goes from home to the start.
        self.lead, main = split_at(profile, self.course.lead_s)
        self.fit = fit_poses(
            main,
            loop=playback == "loop",
            travel=settings.travel,
            progress=progress or (lambda part: None),
        )
        numbers = [plan.numbers[name] for name in profile.inlets]
        stiffness = [1e3 * each["kpa_per_count_fast"] for each in numbers]
        self.error = FitError.of(self.fit, numbers[0]["volume_per_count_m3"], stiffness)
        self.tolerance.refuse(self.fit, self.error)

    @property
    def duration(self) -> float:
        """From the start of the profile to its end, or of one round [s]."""
        return self.fit.duration

    def rows(self) -> list[tuple[str, str]]:
        """What is about to be played, each number with its unit."""
        fit, limit = self.fit, torque_limit(self.settings)
        stall = self.course.columns["stall_share"].max()
        held = stalling_pressure(self.settings, limit) / 1e3
        counts = np.array([goal[:-1] for goal in fit.sequence.goals()])
        drift = "; the board's clock may lose up to 1 ms at each move"
        pace = f"per round, until halted{drift}" if fit.looped else "once"
        return [
            ("plays", f"{self.plan.name}, {fit.duration:.4g} s {pace}"),
            *range_rows(self.course, self.settings, counts, self.plan.unit),
            (
                "torque",
                f"up to {stall:.0%} of stall; limited to "
                f"{share_of_stall(limit):.0%}, which holds at most {held:.0f} kPa",
            ),
            (
                "fit",
                f"{len(fit.sequence.moves)} of {MAX_MOVES} moves, {len(fit.sequence.poses)} of "
                f"{MAX_POSES} poses; off by at most {self.error} (allowed: {self.tolerance.text})",
            ),
            (
                "monitored",
                "only the elapsed time: while it plays, this firmware reads no sensors or "
                "switches, and a move cannot be interrupted",
            ),
        ]

    def document(self) -> dict[str, Any]:
        """The same for a program."""
        fit, error = self.fit, self.error
        return {
            "name": self.plan.name,
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
            title=f"{self.plan.name}: poses for an ArbotiX",
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

    def play_on(
        self,
        pump: Pump,
        request: StopRequest,
        tell: Tell,
        see: Callable[[float], None],
    ) -> StreamResult | None:
        """Load the poses on a connected pump and play them, unless they are to be loaded only.

        ``see`` is given the time that has been played [s].
        """
        assert isinstance(pump, ServoPump), "poses are a servo's"
        assert isinstance(pump.board, Arbotix), "as `Controller.plays_poses` says"
        player = PosePlayer(pump, pump.board, self.fit, request, tell, see)
        player.load()
        if self.playback == "none":
            return None
        if request.asked:
            raise InterruptedRunError("interrupted before anything moved")
        result = player.approach(self.lead)
        return player.play() if result.status == "complete" else result

    def sent_lines(self, sent: Sequence[bytes]) -> list[str]:
        """What went to the board, for people; what went to the servos is only counted."""
        own = [data for data in sent if data[2:3] == bytes([ARBOTIX]) or data.startswith(HALT)]
        others = Counter(Instruction(data[4]).name.lower() for data in sent if data not in own)
        return [
            "would send to the servos, starting at home: "
            + ", ".join(f"{number} {kind}s" for kind, number in sorted(others.items())),
            f"would send to the board, {len(own)} packets:",
            *(f"  {shown(data)}" for data in own),
        ]
