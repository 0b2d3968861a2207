"""What the functions of `viscodesign.pump` refuse at once: an argument of another type."""

from __future__ import annotations

import functools
import inspect
import os
from collections.abc import Callable
from typing import Any, ParamSpec, TypeVar

from viscodesign.errors import UsageError, described
from viscodesign.interrupt import StopRequest
from viscodesign.pump.sessions.connection import BoardAddress

P = ParamSpec("P")
R = TypeVar("R")

ADDRESS = "an address, such as pump.BoardAddress('dynamixel', '/dev/ttyUSB0')"
FILE = "a path"
NUMBER = "a number in SI units"
FUNCTION = "a function"


def typed(session: Callable[P, R]) -> Callable[P, R]:
    """A session that raises `UsageError` where an argument is not of the type that it takes.

    Scenes are judged where their pump is looked up, by `pump_of`.
    """
    signature = inspect.signature(session)

    @functools.wraps(session)
    def checked(*args: P.args, **kwargs: P.kwargs) -> R:
        given = signature.bind(*args, **kwargs).arguments
        for name, value in given.items():
            expected = _expected(name, value)
            if expected and value is not signature.parameters[name].default:
                raise UsageError(f"{name}: expected {expected}; got {described(value)}")
        return session(*args, **kwargs)

    return checked


def _expected(name: str, value: Any) -> str:
    """What an argument should be, in words, where it is not."""
    if name == "address":
        return "" if isinstance(value, BoardAddress) else ADDRESS
    if name in ("folder", "path"):
        return "" if isinstance(value, str | os.PathLike) else FILE
    if name in ("rate", "duration"):
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        return "" if is_number else NUMBER
    if name in ("confirm", "tell", "on_tick", "progress", "by_hand", "vented"):
        return "" if callable(value) else FUNCTION
    if name == "tolerance":
        return "" if isinstance(value, str) else "text with a unit, such as '1 kPa'"
    if name == "stop":
        return "" if isinstance(value, StopRequest) else "a pump.StopRequest()"
    return ""
