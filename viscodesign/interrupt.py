"""Signals that ask to stop: noted at once, obeyed where the work can be interrupted."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from types import FrameType
from typing import Any

from viscodesign.lazy_dataclass import dataclass

Handler = Callable[[int, FrameType | None], Any] | int
"""A function of the signal's number and the frame, or one of `signal.SIG_DFL`, `SIG_IGN`."""
STOP_SIGNALS = [
    getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if name in dir(signal)
]
"""Ctrl-C, termination, and a terminal that was closed."""


@dataclass
class StopRequest:
    """How often, and by which signal first, the user asked to stop."""

    times: int = 0
    first: str = ""

    @property
    def asked(self) -> bool:
        """Whether to stop."""
        return self.times > 0

    @property
    def urgent(self) -> bool:
        """Whether a second request arrived while the work was being stopped."""
        return self.times > 1

    def ask(self, who: str = "program") -> None:
        """Ask from any thread; asked twice it is urgent."""
        self.times += 1
        self.first = self.first or who

    def note(self, number: int, frame: FrameType | None) -> None:
        """Signal handler: count the request and do nothing else."""
        del frame
        self.ask(signal.Signals(number).name)


@dataclass
class _Listeners:
    """Those of the main thread that listen to requests to stop, innermost last."""

    requests: list[StopRequest]
    second: Handler | None
    """What becomes of a second Ctrl-C, while the work is being stopped; None where Ctrl-C is not
    ours to handle."""

    def obey_second(self) -> None:
        """From now on a second Ctrl-C goes where it is to go."""
        if self.second is not None:
            signal.signal(signal.SIGINT, self.second)


_open = _Listeners([], signal.SIG_DFL)


@contextmanager
def gentle_interrupt(*, second_raises: bool = False) -> Iterator[StopRequest]:
    """Note Ctrl-C instead of raising it; a second one ends the process at once.

    An exception raised while the integrator calls back is taken there for a failed
    step, which is tried again: the request would be lost. Only the main thread may
    handle signals; in any other, nothing changes. Where Ctrl-C is ignored (a shell's background
    job) it stays so, and other signals are noted all the same. Enclosing listeners are told, too,
    and what they were told before, those within know. With ``second_raises`` a second one goes
    where it went before, which in Python raises: that a notebook asks twice ends no kernel.
    """
    request = StopRequest()
    if threading.current_thread() is not threading.main_thread():
        yield request
        return
    before = _handler_of(signal.SIGINT)
    if not _open.requests:
        _open.second = before if second_raises or before is None else signal.SIG_DFL
    elif _open.requests[-1].asked:
        request.ask(_open.requests[-1].first)
    handler = _open.second if request.asked else _note_interrupt
    own = [] if before is None or handler is None else [signal.SIGINT]
    with _handled(own, handler or signal.SIG_DFL):
        _open.requests.append(request)
        try:
            yield request
        finally:
            _open.requests.pop()
    if _open.requests and _open.requests[-1].asked:
        _open.obey_second()


def _note_interrupt(number: int, frame: FrameType | None) -> None:
    """Signal handler: tell all who listen, and do nothing else."""
    for listener in _open.requests:
        listener.note(number, frame)
    _open.obey_second()


@contextmanager
def ended_like_interrupts() -> Iterator[None]:
    """Take a termination, or a terminal that was closed, as a Ctrl-C: what was computed is kept.

    The first one alone: a shell may send the same again. What the process ignores (`nohup`) it
    goes on ignoring.
    """
    numbers = [n for n in STOP_SIGNALS if n != signal.SIGINT and _handler_of(n) is not None]

    def interrupt(number: int, frame: FrameType | None) -> None:
        for each in numbers:
            signal.signal(each, signal.SIG_IGN)
        if not _open.requests:
            raise KeyboardInterrupt
        _note_interrupt(number, frame)

    with _handled(numbers, interrupt):
        yield


def _handler_of(number: int) -> Handler | None:
    """What handles a signal; None where that is not ours to change: in other threads, where it is
    ignored, or handled outside of Python."""
    if threading.current_thread() is not threading.main_thread():
        return None
    handler = signal.getsignal(number)
    return None if handler is signal.SIG_IGN else handler


@contextmanager
def stop_on_signals(request: StopRequest | None = None) -> Iterator[StopRequest]:
    """Count every signal that asks to stop, and die of none: for a pump that moves.

    Only the main thread may handle signals; in any other, ``request`` is the one way to stop.
    """
    request = request or StopRequest()
    with _handled(STOP_SIGNALS, request.note):
        yield request


@contextmanager
def _handled(numbers: Sequence[int], handler: Handler) -> Iterator[None]:
    """Signals go to the handler, in the main thread alone."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = {number: signal.signal(number, handler) for number in numbers}
    try:
        yield
    finally:
        for number, old in before.items():
            signal.signal(number, old)
