"""A sequence of poses on an ArbotiX: loaded, approached slowly, played, and ended.

While the board plays it accepts nothing but a halt, and only between two moves; nothing is
monitored then but the time.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from viscodesign.errors import PumpError
from viscodesign.interrupt import StopRequest
from viscodesign.pump.ax.hold import HOLD_SPEED, HOLD_TOLERANCE, NOUN
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.protocol.transactions import NoReplyError
from viscodesign.pump.ax.servo_pump import ServoPump, speed_register
from viscodesign.pump.ax.servo_state import read_servo
from viscodesign.pump.boards.arbotix import Arbotix
from viscodesign.pump.play.axis import FinalAxisState
from viscodesign.pump.play.stream import Stream, wait_for_second_request
from viscodesign.pump.play.stream_result import StreamResult, TickReport
from viscodesign.pump.play.ticks import SLICE
from viscodesign.pump.poses.engine import FRAME, LOOP, PLAY, loading, size_pose
from viscodesign.pump.poses.fit import PoseFit
from viscodesign.pump.profile import Profile

LEAD_RATE = 8.0
"""Ticks of the way to the start [Hz]: single writes and reads at 38400 baud take their time."""
LEAD_SETTLE = 0.5
"""At the start before the board takes over [s]."""
FASTER = 1.5
"""Moving speed over that of the fastest move: so a servo keeps up, and no wrong goal is a jump."""
HANDOVER = 2e-3
"""Time that the board may lose at each move [s]: a millisecond's rounding, and its writing."""
ANSWER = 1.0
"""How long to wait for a reply once it should be idle [s]."""
HALT_TRIES = 3


def by_servo(profile: Profile) -> Profile:
    """The profile with its columns in the order of the servos' ids, which must be 1, 2, ..."""
    order = np.argsort(profile.axes)
    ids = [profile.axes[k] for k in order]
    if ids != list(range(1, len(ids) + 1)):
        raise PumpError(
            f"servo ids {', '.join(map(str, sorted(ids)))}; the PyPose firmware takes poses of the "
            f"servos 1 to {len(ids)} only. `pump calibrate` sets ids; then correct pump.servo_id"
        )
    return replace(
        profile,
        inlets=tuple(profile.inlets[k] for k in order),
        axes=tuple(ids),
        steps=profile.steps[:, order],
        pressure=profile.pressure[:, order],
    )


def split_at(profile: Profile, moment: float) -> tuple[Profile, Profile]:
    """The profile before a moment [s], and after it with times from 0 on."""
    before, after = profile.time < moment - 1e-9, profile.time > moment + 1e-9
    lead = _resampled(profile, np.append(profile.time[before], moment))
    rest = _resampled(profile, np.append(moment, profile.time[after]))
    return lead, replace(rest, time=rest.time - moment)


def _resampled(profile: Profile, time: np.ndarray) -> Profile:
    """The profile at other times (T,) [s]; held behind its end."""

    def columns(values: np.ndarray) -> np.ndarray:
        return np.stack([np.interp(time, profile.time, column) for column in values.T], -1)

    counts, pressure = columns(profile.steps), columns(profile.pressure)
    return replace(profile, time=time, steps=counts, pressure=pressure)


def playing_speed(fit: PoseFit) -> int:
    """Moving speed register with which servos keep up with a fit, and hardly more."""
    return max(speed_register(FASTER * fit.fastest), HOLD_SPEED)


class PosePlayer:
    """One fit, played by the board of a connected pump."""

    def __init__(
        self,
        pump: ServoPump,
        board: Arbotix,
        fit: PoseFit,
        request: StopRequest,
        tell: Callable[[str], None],
        see: Callable[[float], None] = lambda elapsed: None,
    ) -> None:
        """``tell`` receives messages for the user, ``see`` the time since the start [s]."""
        self.pump = pump
        self.board = board
        self.fit = fit
        self.request = request
        self.tell = tell
        self.see = see
        self.servos = len(fit.sequence.poses[0])
        """Number of servos in a pose, the phantom included; it has the last id."""
        self._move_ends = FRAME * np.cumsum(fit.move_frames)
        """From the start of a round [s]."""
        self._began: float | None = None
        """When the board was started [s of the clock]; None while nothing plays."""

    def load(self) -> None:
        """Load poses and moves onto the board; nothing moves."""
        self._refuse_a_real_phantom()
        size, *rest = loading(self.fit.sequence)
        self.board.size_pose(size)
        for packet in rest:
            self.board.tell(packet)

    def _refuse_a_real_phantom(self) -> None:
        try:
            read_servo(self.board, self.servos)
        except NoReplyError:
            return
        raise PumpError(
            f"a servo answers with id {self.servos}, which must stay free: it would swing "
            "through its whole range to keep time. Remove it from the bus, or give it another id"
        )

    def approach(
        self, lead: Profile, see: Callable[[TickReport], None] = lambda shown: None
    ) -> StreamResult:
        """Torque on, then from where the plungers are to the lead's end, under all safety rules."""
        rested = _resampled(lead, np.append(lead.time, lead.duration + LEAD_SETTLE))
        return Stream(
            self.pump, rested, self.request, see,
            rate=LEAD_RATE, lead=lead.duration, tell=self.tell,
        ).play()  # fmt: skip

    def play(self) -> StreamResult:
        """Play once, or loop until a request to stop; however this ends, nothing plays then.

        The board reads the plungers' positions again first, or its first move would start
        from the old ones.
        """
        result = StreamResult()
        try:
            self.board.size_pose(size_pose(self.servos))
            for servo in self.pump.axes:
                self.board.set(servo, registers.MOVING_SPEED, playing_speed(self.fit))
            result = self._played()
        except PumpError as error:
            result = StreamResult("stopped", str(error), error.rule, may_retreat=False)
        finally:
            result.standing = self._come_to_rest()
        return result

    def _played(self) -> StreamResult:
        clock, looped = self.pump.clock, self.fit.looped
        if self.request.asked:
            return StreamResult.interrupted(self.request)
        # From the sending on it may be playing, whatever is answered.
        self._began = clock.now()
        self.board.start(LOOP if looped else PLAY)
        self._began = clock.now()
        end = self._began + self._move_ends[-1]
        while looped or clock.now() < end:
            if self.request.asked:
                return StreamResult.interrupted(self.request)
            clock.sleep(SLICE if looped else min(SLICE, end - clock.now()))
            self.see(clock.now() - self._began)
        if not self.board.is_idle(ANSWER + HANDOVER * len(self.fit.sequence.moves)):
            return StreamResult(
                "stopped", "the board did not report that it has finished", "replies"
            )
        self._began = None
        return self._arrived()

    def _arrived(self) -> StreamResult:
        """Whether the plungers reach the end of the last move, with no errors reported."""
        last = self.fit.sequence.goals()[-1]
        for servo, goal in zip(sorted(self.pump.axes), last, strict=False):
            state = read_servo(self.board, servo)
            if state.errors:
                return StreamResult(
                    "stopped", f"servo {servo} reports: {state.complaint}", "servo_alarm"
                )
            if abs(state.position - goal) > HOLD_TOLERANCE:
                return StreamResult(
                    "stopped",
                    f"servo {servo} is at {state.position} counts, not at {goal}: it did not "
                    "follow. The plunger is blocked, or the torque limit is too low for the "
                    "pressure",
                    "following",
                )
        return StreamResult("complete", "played to its end")

    def _come_to_rest(self) -> list[FinalAxisState]:
        """Halt what may be playing, then hold; release the torque after a second stop request.

        If the board does not respond, only that is reported.
        """
        if self._began is not None and not self._halted():
            words = "the board is still playing or not responding; switch its power off"
            return [FinalAxisState(servo, False, words, NOUN) for servo in self.pump.axes]
        left = [] if self.request.urgent else self.pump.hold()
        try:
            if self.request.asked:
                wait_for_second_request(self.request, self.pump.clock, self.tell)
        finally:
            if self.request.urgent:
                left = self.pump.release()
        return left

    def _halted(self) -> bool:
        """Halt; repeated, since a halt may be lost on the way, and never anything before it."""
        left = self._left_of_move()
        try:
            self.board.halt()
        finally:
            self.tell(
                f"halting: the current move cannot be interrupted and ends in about {left:.1f} s; "
                "only the power switch can stop it now"
            )
        longest = FRAME * max(self.fit.move_frames)
        for attempt in range(HALT_TRIES):
            if attempt > 0:
                self.board.halt()
            if self.board.is_idle(longest + ANSWER):
                self._began = None
                return True
        return False

    def _left_of_move(self) -> float:
        """Time left of the current move, by our clock [s]."""
        elapsed = self.pump.clock.now() - (self._began or 0.0)
        if self.fit.looped:
            elapsed %= self._move_ends[-1]
        running = self._move_ends[self._move_ends > elapsed]
        return float(running[0] - elapsed) if len(running) else 0.0
