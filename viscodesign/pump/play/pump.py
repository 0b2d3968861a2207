"""The pump: servos that may only move a little at a time, and always can be told to stand."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from viscodesign.errors import PumpError
from viscodesign.pump.boards.base import Board, Goal
from viscodesign.pump.bus import registers
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.drive import COUNTS_PER_TURN, Drive
from viscodesign.pump.play.hold import HOLD_SPEED, FinalServoState, hold, release
from viscodesign.pump.play.preflight import FoundServo, blocking_faults, identify
from viscodesign.pump.play.safety_rules import Stop
from viscodesign.pump.play.servo_state import ServoState, read_servo, write_register
from viscodesign.pump.play.torque_limit import (
    TorqueLimits,
    free_speed,
    torque_limit,
)
from viscodesign.pump.sensors.limit_switches import Switches
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.scene.pump import PumpSpec as Settings

SPEED = registers.SPEED_UNIT * COUNTS_PER_TURN
"""Counts per second of one unit of the speed register."""
TOP_SPEED = 1023
Pressed = dict[int, frozenset[str]]
"""Ends whose switch is pressed, by servo."""
LIMIT_STEPS = 6
"""Readings in which a torque limit may be lowered at the end of a motion."""
TAKEN = 3
"""The goal of a servo that gets its torque may be its position of a moment later [counts]."""


class Pump:
    """Servos of one spec on one board; all that moves them goes through here.

    In order: `connect` (reads only), `arm` (torque on, where it stands), `set_goals` and `look`
    in turns, `hold` or `release`. After an alarm goals are refused until a new command begins.
    """

    def __init__(
        self,
        board: Board,
        settings: Settings,
        servos: Sequence[int],
        gauges: PressureReadings,
        switches: Switches,
        clock: Clock,
    ) -> None:
        self.board = board
        self.settings = settings
        self.servos = tuple(servos)
        self.gauges = gauges
        self.switches = switches
        self.clock = clock
        self.drive = Drive(settings)
        self.identity = ""
        """What the board said of itself."""
        self.armed = False
        self.alarm: Stop | None = None
        self.goals: dict[int, int] = {}
        """Goals in force [counts]."""
        self.positions: dict[int, int] = {}
        """Last read [counts]."""
        self.limits = TorqueLimits()
        self.read_at = -math.inf
        """When, about: between question and answer [s of the clock]."""
        self.sent_at = -math.inf
        """When the goals in force were sent [s of the clock]."""
        self.reach = 1
        """Farthest that a goal may lie from the one before [counts]: one tick's travel."""

    def connect(self) -> list[FoundServo]:
        """Identify the board and all servos; raises `PumpError` where they must not move."""
        self.identity = self.board.identify()
        found = [identify(self.board, servo) for servo in self.servos]
        self.positions = {servo.id: servo.state.position for servo in found}
        wrong = [reason for servo in found for reason in blocking_faults(servo, self.settings)]
        if wrong:
            raise PumpError("\n".join(["nothing has moved:", *wrong]))
        return found

    def arm(self, speed: float = 0.0) -> None:
        """Torque on where each plunger stands; limits first, each read back.

        ``speed``: the fastest that is going to be asked for [counts/s]; raises `PumpError` where
        the servo is not that fast.
        """
        if speed > free_speed(self.settings):
            raise PumpError(
                f"{speed:.0f} counts/s are asked for; without any load the servo makes "
                f"{free_speed(self.settings):.0f}: see `pump plan`"
            )
        # Where moves bring limits of their own along, that of a plunger at rest is enough.
        limit = torque_limit(self.settings, 0.0 if self.board.limits_torque else speed)
        self.board.hurry()
        for servo in self.servos:
            state = self._healthy(servo)
            position = state.position
            # A servo that strained against this very limit may shut itself off just now, and a
            # write would give it its torque back.
            if state.torque_limit != limit:
                write_register(self.board, servo, registers.TORQUE_LIMIT, limit)
            write_register(self.board, servo, registers.MOVING_SPEED, HOLD_SPEED)
            # Some firmwares switch the torque on by this, so it comes behind both limits. Without
            # torque they give the present position as their goal: read back when it is on.
            self.armed = True
            goal = registers.GOAL_POSITION
            self.board.write(servo, goal.address, goal.encode(position))
            write_register(self.board, servo, registers.TORQUE_ENABLE, 1)
            self.goals[servo] = self._standing(servo, position, limit)
            self.positions[servo] = self.goals[servo]

    def _healthy(self, servo: int) -> ServoState:
        """Its state; a torque limit of 0 is an alarm's, and is not overwritten unsaid."""
        state = read_servo(self.board, servo)
        if state.errors or state.torque_limit == 0:
            told = state.complaint or "its torque limit is 0: it shut itself off"
            raise PumpError(f"servo {servo}: {told}. See `pump status`, then switch it off and on")
        return state

    def _standing(self, servo: int, position: int, limit: int) -> int:
        """The goal that an armed servo holds, checked to be where it stands."""
        state = self._healthy(servo)
        wrong = (
            abs(state.goal - position) > TAKEN
            or state.moving_speed != HOLD_SPEED
            or state.torque_limit != limit
        )
        if wrong:
            raise PumpError(
                f"servo {servo} was armed at {position} counts, with speed {HOLD_SPEED} and torque "
                f"limit {limit}, but has goal {state.goal}, speed {state.moving_speed} and torque "
                f"limit {state.torque_limit}; check its supply and cable"
            )
        return state.goal

    def set_goals(
        self,
        goals: Mapping[int, int],
        speeds: Mapping[int, float],
        paces: Mapping[int, float] | None = None,
    ) -> None:
        """Send the next goals, one transaction for all.

        ``speeds``: of each servo [counts/s]; the register is rounded up, and never 0.
        ``paces``: what the plan asks of each servo about now [counts/s]; its torque is limited
        to that and the pressure cap, where the board can. Nothing it does may loosen it.
        """
        self._refuse(goals)
        needed = {servo: torque_limit(self.settings, pace) for servo, pace in (paces or {}).items()}
        self._send(goals, {s: speed_register(speed) for s, speed in speeds.items()}, needed)
        self.goals |= goals
        self.sent_at = self.clock.now()

    def allowed(self, goals: Mapping[int, int]) -> dict[int, int]:
        """The same goals within travel; after an alarm a plunger that would not draw back stays.

        So one that is drawn out beyond home keeps no other one from being drawn back to it.
        """
        low, high = self.settings.travel
        if self.alarm is None:
            return {s: min(max(goal, low), high) for s, goal in goals.items()}
        kept = self.goals
        return {
            s: goal if self._draws_back(goal - kept[s]) else kept[s] for s, goal in goals.items()
        }

    def _send(
        self, goals: Mapping[int, int], speeds: Mapping[int, int], needed: Mapping[int, int]
    ) -> bool:
        """Goals [counts], speeds (registers) and torque limits that change; whether some do.

        A servo that shut itself off, or that may be about to, keeps what it has.
        """
        limits: dict[int, int] = {}
        if needed and self.board.limits_torque:
            limits = self.limits.changes(needed, self.clock.now())
        held = self.limits.in_force
        self.limits.sent |= {servo: (held[servo], limit) for servo, limit in limits.items()}
        self.board.move(
            {s: Goal(g, speeds[s], limits.get(s), held.get(s)) for s, g in goals.items()}
        )
        return bool(limits)

    def _refuse(self, goals: Mapping[int, int]) -> None:
        low, high = self.settings.travel
        if not self.armed:
            raise PumpError("the pump is not armed; nothing is sent")
        for servo, goal in goals.items():
            step = goal - self.goals[servo]
            if self.alarm is not None and not self._draws_back(step):
                raise PumpError(f"locked by an alarm ({self.alarm}); a new command begins anew")
            if not low <= goal <= high:
                raise PumpError(f"servo {servo}: goal {goal} is outside of travel [{low}, {high}]")
            if abs(step) > self.reach:
                raise PumpError(
                    f"servo {servo}: goal {goal} is {abs(step)} counts from the last one; one "
                    f"tick's travel is {self.reach}"
                )

    def _draws_back(self, step: int) -> bool:
        """Whether an alarm lets this step pass: none, or one that makes room."""
        if self.alarm is None or not self.alarm.may_retreat:
            return step == 0
        return self.drive.position(self.settings.home + step) <= 0.0

    def look(self) -> tuple[dict[int, ServoState], tuple[float | None, ...], Pressed]:
        """Servos, pressures [Pa gauge] and pressed switches, read now."""
        states = self._read()
        return states, self.gauges.read(), self.switches.read(self.board)

    def _read(self) -> dict[int, ServoState]:
        before = self.clock.now()
        states = {servo: read_servo(self.board, servo) for servo in self.servos}
        self.positions = {servo: state.position for servo, state in states.items()}
        self.read_at = (before + self.clock.now()) / 2
        for servo in self.limits.revived(states):
            # It shut itself off while its limit was on the way: it has to stay off.
            self.board.set(servo, registers.TORQUE_LIMIT, 0)
            states[servo] = replace(states[servo], torque_limit=0)
        self.limits.sent = {}
        self.limits.update(states, self.read_at)
        return states

    def hold(self, *, in_place: bool = True) -> list[FinalServoState]:
        """Stand where it is, read back; nothing is sent where the torque was never on.

        Unless ``in_place``, the goals in force are kept: those that a load asks for. Torque
        limits that a motion had raised are lowered again.
        """
        if not self.armed:
            return [
                FinalServoState(s, True, "untouched: its torque was never on") for s in self.servos
            ]
        goals = None if in_place else self.goals
        left = hold(self.board, self.servos, self.clock, positions=self.positions, goals=goals)
        self.goals = {s: self.positions[s] if in_place else self.goals[s] for s in self.servos}
        if not all(one.verified for one in left) or not self.board.limits_torque:
            return left
        try:
            self._lower_limits()
        except PumpError as error:
            return [replace(one, verified=False, words=f"{one.words}, but {error}") for one in left]
        return hold(self.board, self.servos, self.clock, positions=self.positions, goals=self.goals)

    def _lower_limits(self) -> None:
        """To what a plunger at rest needs, byte by byte."""
        rest = torque_limit(self.settings)
        for _ in range(LIMIT_STEPS):
            self._read()
            sent = [
                self._send({servo: self.goals[servo]}, {servo: HOLD_SPEED}, {servo: rest})
                for servo in self.limits.in_force
            ]
            if not any(sent):
                return

    def release(self) -> list[FinalServoState]:
        """Torque off, read back; pressure may push the plunger back then."""
        self.armed = False
        return release(self.board, self.servos, self.clock)


def speed_register(speed: float) -> int:
    """Smallest value that is at least as fast [counts/s]; never 0, which is full speed."""
    return min(max(math.ceil(speed / SPEED), 1), TOP_SPEED)
