"""How every motion ends: held in place or without torque, and read back.

Needs no spec, so that `pump stop` works without one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from viscodesign.errors import PumpError
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.protocol.transactions import ServoError
from viscodesign.pump.ax.servo_state import read_servo
from viscodesign.pump.boards.base import Board, Goal
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.play.axis import FinalAxisState, until_verified

NOUN = "servo"  # what an axis is called in messages
HOLD_SPEED = 20
"""Speed to a goal that is where the plunger is anyway [0.111 rpm]; never 0, which is full speed."""
HOLD_TOLERANCE = 40  # A held plunger stands this close to its goal, or it is not held [counts]
LONGEST_MOVE_S = 40.0
"""A board that plays by itself may not listen for so long: its moves last up to 32.8 s [s]."""
HALT_INTERVAL_S = 2.0  # between two halts of such a board [s]


def hold(
    board: Board,
    servos: Sequence[int],
    clock: Clock,
    *,
    positions: dict[int, int] | None = None,
    goals: Mapping[int, int] | None = None,
) -> list[FinalAxisState]:
    """Send every servo to where it is, and read back that it holds that goal.

    ``positions`` of a moment ago serve where a servo takes commands but its replies do not come
    through; they are brought up to date. ``goals`` hold it where it is under its load, where they
    are known. A servo without torque is left so: nothing drives it.
    """
    last, aims = positions if positions is not None else {}, goals or {}
    return until_verified(
        servos, clock, NOUN, lambda servo: _hold(board, servo, last, aims.get(servo))
    )


def release(board: Board, servos: Sequence[int], clock: Clock) -> list[FinalAxisState]:
    """Switch torque off, and read back that it is."""
    return until_verified(servos, clock, NOUN, lambda servo: _release(board, servo))


def _hold(board: Board, servo: int, last: dict[int, int], aim: int | None) -> str:
    """One attempt; the position is read first, so that no goal is far from the plunger."""
    try:
        state = read_servo(board, servo)
    except PumpError as error:
        if servo not in last:
            raise PumpError(f"no hold could be sent: {error}") from None
        # Repeating an absolute goal is harmless.
        _send(board, servo, last[servo])
        raise PumpError(f"sent to {last[servo]} counts unseen; no reply: {error}") from None
    last[servo] = state.position
    if not state.driven:
        return f"torque is off, at {state.position} counts"
    if state.torque_limit == 0:
        return f"shut itself off ({state.complaint or 'torque limit 0'})"
    goal = state.position if aim is None or abs(aim - state.position) > HOLD_TOLERANCE else aim
    _send(board, servo, goal)
    try:
        state = read_servo(board, servo)
    except PumpError as error:
        raise PumpError(f"hold sent, but not verified: {error}") from None
    if not state.driven or state.goal != goal:
        raise PumpError(f"hold at {goal} counts was sent, but it did not take it")
    if abs(state.position - goal) > HOLD_TOLERANCE:
        raise PumpError(f"holds {goal} counts, but is at {state.position}")
    reports = f"; it reports: {state.complaint}" if state.errors else ""
    return f"holds at {goal} counts, verified{reports}"


def _send(board: Board, servo: int, goal: int) -> None:
    try:
        board.move({servo: Goal(goal, HOLD_SPEED)})
    except PumpError as error:
        raise PumpError(f"no hold could be sent: {error}") from None


def _release(board: Board, servo: int) -> str:
    try:
        board.set(servo, registers.TORQUE_ENABLE, 0, read_back=True)
    except ServoError as fault:
        raise PumpError(f"torque off was sent; {fault}") from None
    except PumpError as error:
        raise PumpError(f"torque off is not verified: {error}") from None
    return "torque is off, verified"


def stop_all(
    board: Board, ids: Sequence[int], clock: Clock, *, release: bool = False
) -> list[FinalAxisState]:
    """Halt the board's own program, then hold (or release) each servo as soon as it is found.

    Empty where none answers; a board that plays by itself is asked again until its move must be
    over.
    """
    deadline = clock.now() + (0.0 if board.streams else LONGEST_MOVE_S)
    while True:
        board.halt()
        left = [one for servo in ids for one in _stop(board, servo, clock, release)]
        if left or clock.now() >= deadline:
            return left
        clock.sleep(HALT_INTERVAL_S)


def _stop(board: Board, servo: int, clock: Clock, drop: bool) -> list[FinalAxisState]:
    try:
        there = board.answers(servo)
    except PumpError:  # what comes from it is broken: it may be there
        there = False
    if not there:
        return []
    return release(board, [servo], clock) if drop else hold(board, [servo], clock)
