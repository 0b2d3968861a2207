"""How every motion ends: held in place or without torque, and read back.

Needs no spec, so that `pump stop` works without one.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from viscodesign.errors import PumpError
from viscodesign.pump.ax.servo_state import ServoState, read_servo, write_register
from viscodesign.pump.boards.base import Board, Goal
from viscodesign.pump.bus import registers
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.bus.transactions import ServoError
from viscodesign.pump.play.axis import FinalServoState

HOLD_SPEED = 20
"""Of a goal that is where the plunger is anyway [0.111 rpm]; never 0, which is full speed."""
HOLD_TOLERANCE = 40
"""A held plunger stands this close to its goal, or it is not held [counts]."""
RETRY_PAUSE_S = 0.02
"""Between tries [s]."""
HOLD_TIMEOUT_S = 1.0
"""To try for a verified hold [s]."""
LONGEST_MOVE_S = 40.0
"""A board that plays by itself may not listen for so long: its moves last up to 32.8 s [s]."""
HALT_INTERVAL_S = 2.0
"""Between two halts of such a board [s]."""


def hold(
    board: Board,
    servos: Sequence[int],
    clock: Clock,
    *,
    positions: dict[int, int] | None = None,
    goals: Mapping[int, int] | None = None,
    within: float = HOLD_TIMEOUT_S,
) -> list[FinalServoState]:
    """Send every servo to where it is, and read back that it holds that goal.

    ``positions`` of a moment ago, for a servo that takes commands but whose replies do not come
    through; they are brought up to date. ``goals`` that hold it where it is under its load, where
    they are known. A servo without torque is left so: nothing drives it.
    """
    where, aims = positions if positions is not None else {}, goals or {}
    return _for_each(
        servos, clock, within, lambda servo: _hold(board, servo, where, aims.get(servo))
    )


def release(
    board: Board, servos: Sequence[int], clock: Clock, *, within: float = HOLD_TIMEOUT_S
) -> list[FinalServoState]:
    """Switch torque off, and read back that it is."""
    return _for_each(servos, clock, within, lambda servo: _release(board, servo))


def _for_each(
    servos: Sequence[int], clock: Clock, within: float, attempt: Callable[[int], FinalServoState]
) -> list[FinalServoState]:
    """Try each servo in turns until it is verified or the time is over; at least once."""
    deadline = clock.now() + within
    left: dict[int, FinalServoState] = {}
    waiting = list(servos)
    while waiting:
        for servo in waiting:
            left[servo] = attempt(servo)
        waiting = [servo for servo in waiting if not left[servo].verified]
        if clock.now() >= deadline:
            break
        if waiting:
            clock.sleep(RETRY_PAUSE_S)
    return [left[servo] for servo in servos]


def _hold(board: Board, servo: int, last: dict[int, int], aim: int | None) -> FinalServoState:
    """One attempt; the position is read first, so that no goal is far from the plunger."""
    try:
        state = read_servo(board, servo)
    except PumpError as error:
        return _hold_unseen(board, servo, last.get(servo), error)
    last[servo] = state.position
    if not state.torque:
        return FinalServoState(servo, True, f"torque is off, at {state.position} counts")
    if state.torque_limit == 0:
        return FinalServoState(
            servo, True, f"shut itself off ({state.complaint or 'torque limit 0'})"
        )
    near = aim is not None and abs(aim - state.position) <= HOLD_TOLERANCE
    goal = aim if aim is not None and near else state.position
    try:
        board.move({servo: Goal(goal, HOLD_SPEED)})
    except PumpError as error:
        return FinalServoState(servo, False, f"no hold could be sent: {error}")
    try:
        return _verified(servo, goal, read_servo(board, servo))
    except PumpError as error:
        return FinalServoState(servo, False, f"hold sent, but not verified: {error}")


def _verified(servo: int, goal: int, state: ServoState) -> FinalServoState:
    if not state.torque or state.goal != goal:
        return FinalServoState(
            servo, False, f"hold at {goal} counts was sent, but it did not take it"
        )
    if abs(state.position - goal) > HOLD_TOLERANCE:
        return FinalServoState(servo, False, f"holds {goal} counts, but is at {state.position}")
    told = f"holds at {goal} counts, verified"
    return FinalServoState(
        servo, True, f"{told}; it reports: {state.complaint}" if state.errors else told
    )


def _hold_unseen(
    board: Board, servo: int, position: int | None, error: PumpError
) -> FinalServoState:
    """Hold at the last known position; repeating an absolute goal is harmless."""
    if position is None:
        return FinalServoState(servo, False, f"no hold could be sent: {error}")
    try:
        board.move({servo: Goal(position, HOLD_SPEED)})
    except PumpError as failure:
        return FinalServoState(servo, False, f"no hold could be sent: {failure}")
    return FinalServoState(servo, False, f"sent to {position} counts unseen; no reply: {error}")


def _release(board: Board, servo: int) -> FinalServoState:
    try:
        write_register(board, servo, registers.TORQUE_ENABLE, 0)
    except ServoError as fault:
        return FinalServoState(servo, False, f"torque off was sent; {fault}")
    except PumpError as error:
        return FinalServoState(servo, False, f"torque off is not verified: {error}")
    return FinalServoState(servo, True, "torque is off, verified")


def stop_all(
    board: Board, ids: Sequence[int], clock: Clock, *, release: bool = False
) -> list[FinalServoState]:
    """Halt the board's own program, then hold (or release) each servo that is found.

    Each is told as soon as it is found: others that are not there would cost time. Empty where
    none answers; a board that plays by itself is asked again until its move must be over.
    """
    board.halt()
    deadline = clock.now() + (0.0 if board.streams else LONGEST_MOVE_S)
    while not (left := _each(board, ids, clock, release)) and clock.now() < deadline:
        clock.sleep(HALT_INTERVAL_S)
        board.halt()
    return left


def _each(board: Board, ids: Sequence[int], clock: Clock, drop: bool) -> list[FinalServoState]:
    act = release if drop else hold
    return [one for servo in ids if _is_there(board, servo) for one in act(board, [servo], clock)]


def _is_there(board: Board, servo: int) -> bool:
    """Also where what comes from it is broken: then it is reported all the same."""
    try:
        return board.answers(servo)
    except PumpError:
        return False
