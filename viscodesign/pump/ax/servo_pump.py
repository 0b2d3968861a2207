"""A syringe pump of AX servos."""

from __future__ import annotations

import functools
from dataclasses import replace

from viscodesign.errors import PumpError
from viscodesign.pump.ax.hold import HOLD_SPEED, NOUN, hold, release
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.servo_drive import ServoDrive
from viscodesign.pump.ax.servo_state import (
    HIGHEST_TEMPERATURE,
    LOWEST_VOLTAGE,
    ServoState,
    identify,
    read_servo,
)
from viscodesign.pump.ax.torque_limit import TorqueLimits, free_speed, torque_limit
from viscodesign.pump.boards.base import Board, Goal
from viscodesign.pump.play.axis import AxisLimits, FinalAxisState, FoundAxis
from viscodesign.pump.play.pump import Pressed, Pump, Speeds, Steps
from viscodesign.pump.sensors.limit_switches import pressed_switches
from viscodesign.scene.pumps.servo import ServoPumpSpec
from viscodesign.storage.cached_property import cached_property

SLOWEST_SPEED = registers.SPEED_UNIT * registers.COUNTS_PER_TURN
"""Counts per second of one unit of the speed register."""
COMPLIANCE_SLOPE = 32.0
"""Distance from its goal at which a servo gives its full output [counts]: the initial value of
its compliance slopes (ROBOTIS e-manual)."""
APPROACH_SPEED = 50.0
"""On the way to a start or back [counts/s]: 3.8 mm/s, half a minute for the whole rack."""
LARGEST_LEAD = 40.0
"""Most that is added to a goal for the load [counts]: beyond the slope nothing more is given."""
LIMIT_STEPS = 6  # readings in which a torque limit may be lowered at the end of a motion
ARMED_TOLERANCE = 3
"""The goal of a servo that gets its torque may be its position of a moment later [counts]."""


class ServoPump(Pump):
    """Servos of one spec on one board, each with a plunger; a step is a count."""

    board: Board

    @cached_property
    def torque_limits(self) -> TorqueLimits:
        """What is known of the limits in force; brought up to date by each reading."""
        return TorqueLimits()

    @cached_property
    def limits(self) -> AxisLimits:
        return axis_limits(self.settings)

    def inspect(self) -> tuple[str, list[FoundAxis]]:
        identity = self.board.identify()
        found = [identify(self.board, servo) for servo in self.axes]
        self.positions = {servo.id: servo.state.position for servo in found}
        return identity, [servo.axis(self.settings) for servo in found]

    def pressed(self) -> Pressed:
        settings = self.settings if self.switches else None
        return pressed_switches(self.board, settings, self.axes)

    def arm(self, speed: float = 0.0) -> None:
        """Torque on where each plunger stands; limits first, each read back."""
        if speed > free_speed(self.settings):
            raise PumpError(
                f"{speed:.0f} counts/s requested; without load the servo reaches "
                f"{free_speed(self.settings):.0f}: see `pump plan`"
            )
        # Where moves bring limits of their own along, that of a plunger at rest is enough.
        limit = torque_limit(self.settings, 0.0 if self.board.limits_torque else speed)
        self.board.hurry()
        surely = functools.partial(self.board.set, read_back=True)
        for servo in self.axes:
            state = self._healthy(servo)
            # At once: where arming fails from here on, a hold needs to know it.
            position = self.positions[servo] = state.position
            # A servo that strained against this very limit may shut itself off just now, and a
            # write would give it its torque back.
            if state.torque_limit != limit:
                surely(servo, registers.TORQUE_LIMIT, limit)
            surely(servo, registers.MOVING_SPEED, HOLD_SPEED)
            # Some firmwares switch the torque on by this, so it comes behind both limits. Without
            # torque a servo's goal follows its position, so only with it is the goal checked.
            self.armed = True
            self.board.set(servo, registers.GOAL_POSITION, position)
            surely(servo, registers.TORQUE_ENABLE, 1)
            self.goals[servo] = self.positions[servo] = self._armed_goal(servo, position, limit)

    def _healthy(self, servo: int) -> ServoState:
        """Its state; a torque limit of 0 is an alarm's, and is not overwritten unsaid."""
        state = read_servo(self.board, servo)
        if state.errors or state.torque_limit == 0:
            fault = state.complaint or "its torque limit is 0: it shut itself off"
            raise PumpError(f"servo {servo}: {fault}. See `pump status`, then switch it off and on")
        return state

    def _armed_goal(self, servo: int, position: int, limit: int) -> int:
        """The goal that an armed servo holds, checked to be its position."""
        state = self._healthy(servo)
        if (
            abs(state.goal - position) > ARMED_TOLERANCE
            or state.moving_speed != HOLD_SPEED
            or state.torque_limit != limit
        ):
            raise PumpError(
                f"servo {servo} was armed at {position} counts, with speed {HOLD_SPEED} and torque "
                f"limit {limit}, but has goal {state.goal}, speed {state.moving_speed} and torque "
                f"limit {state.torque_limit}; check its supply and cable"
            )
        return state.goal

    def _send(self, goals: Steps, speeds: Speeds, paces: Speeds | None) -> None:
        needed = {servo: torque_limit(self.settings, pace) for servo, pace in (paces or {}).items()}
        self._move(goals, {s: speed_register(speed) for s, speed in speeds.items()}, needed)

    def _move(self, goals: Steps, speeds: Steps, needed: Steps) -> bool:
        """Send goals, speed registers, and torque limits that change; whether some do.

        A servo that shut itself off, or that may be about to, keeps what it has.
        """
        limits: dict[int, int] = {}
        if needed and self.board.limits_torque:
            limits = self.torque_limits.changes(needed, self.clock.now())
        held = self.torque_limits.in_force
        self.torque_limits.sent |= {s: (held[s], limit) for s, limit in limits.items()}
        self.board.move(
            {s: Goal(g, speeds[s], limits.get(s), held.get(s)) for s, g in goals.items()}
        )
        return bool(limits)

    def _read(self) -> dict[int, ServoState]:
        before = self.clock.now()
        states = {servo: read_servo(self.board, servo) for servo in self.axes}
        self.positions = {servo: state.position for servo, state in states.items()}
        self.read_at = (before + self.clock.now()) / 2
        for servo in self.torque_limits.revived(states):
            # It shut itself off while its limit was on the way: it has to stay off.
            self.board.set(servo, registers.TORQUE_LIMIT, 0)
            states[servo] = replace(states[servo], torque_limit=0)
        self.torque_limits.update(states, self.read_at)
        return states

    def hold(self, *, in_place: bool = True) -> list[FinalAxisState]:
        """As `Pump.hold`; torque limits that a motion had raised are lowered again."""
        if not self.armed:
            return [
                FinalAxisState(s, True, "untouched: torque was never on", NOUN) for s in self.axes
            ]
        left = self._hold(None if in_place else self.goals)
        self.goals = {s: self.positions[s] if in_place else self.goals[s] for s in self.axes}
        if not all(one.verified for one in left) or not self.board.limits_torque:
            return left
        try:
            self._lower_limits()
        except PumpError as error:
            return [replace(one, verified=False, words=f"{one.words}, but {error}") for one in left]
        return self._hold(self.goals)

    def _hold(self, goals: Steps | None) -> list[FinalAxisState]:
        return hold(self.board, self.axes, self.clock, positions=self.positions, goals=goals)

    def _lower_limits(self) -> None:
        """Lower torque limits to what a plunger at rest needs, byte by byte."""
        rest = torque_limit(self.settings)
        for _ in range(LIMIT_STEPS):
            self._read()
            lowered = [
                self._move({servo: self.goals[servo]}, {servo: HOLD_SPEED}, {servo: rest})
                for servo in self.torque_limits.in_force
            ]
            if not any(lowered):
                return

    def release(self) -> list[FinalAxisState]:
        self.armed = False
        return release(self.board, self.axes, self.clock)


def axis_limits(settings: ServoPumpSpec) -> AxisLimits:
    """What the servos of a spec can do."""
    return AxisLimits(
        step=ServoDrive(settings).step,
        noun=NOUN,
        unit="counts",
        travel=settings.travel,
        home=settings.home,
        retreat_sign=-1 if settings.push == "up" else 1,
        max_pressure=settings.max_pressure,
        top_speed=free_speed(settings),
        slowest_speed=SLOWEST_SPEED,
        lead_distance=COMPLIANCE_SLOPE,
        largest_lead=LARGEST_LEAD,
        approach_speed=APPROACH_SPEED,
        settle_speed=45.0,
        following_error=60.0,  # its controller needs up to 32 to give all its torque
        weakness="the plunger is blocked, or the torque limit is too low for the requested "
        "pressure",
        dead_band=1.0,  # counts are whole, and gears have play
        settled_error=0.5,
        travel_tolerance=5,
        lowest_voltage=LOWEST_VOLTAGE,
        highest_temperature=HIGHEST_TEMPERATURE,
    )


def speed_register(speed: float) -> int:
    """The value of Moving Speed for a speed of the servo [counts/s]."""
    return registers.speed_register(speed / registers.COUNTS_PER_TURN)
