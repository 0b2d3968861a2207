"""Samples of a pump, with only what a test is about set."""

from __future__ import annotations

from typing import Any

from viscodesign.pump.ax.protocol.packets import ErrorBits
from viscodesign.pump.ax.servo_state import ServoState
from viscodesign.pump.play.axis import Sample


def servo(position: int = 500, **changes: Any) -> ServoState:
    """A healthy servo that holds where it is."""
    fields: dict[str, Any] = {
        "driven": True,
        "goal": position,
        "moving_speed": 20,
        "torque_limit": 300,
        "position": position,
        "load": 0.0,
        "voltage": 11.1,
        "temperature": 30.0,
        "errors": ErrorBits(0),
    }
    return ServoState(**(fields | changes))


def sample(
    *,
    time: float = 0.0,
    state: ServoState | None = None,
    pressure: float | None = 10e3,
    wanted: float | None = 10e3,
    pressed: str = "",
    step: int = 0,
) -> Sample:
    """One servo, id 1; ``pressed``: ends in words; ``step``: of the next goal [counts]."""
    state = state or servo()
    return Sample(
        time=time,
        axes={1: state},
        pressure=(pressure,),
        wanted=(wanted,),
        pressed={1: frozenset(pressed.split())},
        goals={1: state.goal},
        next_goals={1: state.goal + step},
        noun="servo",
    )
