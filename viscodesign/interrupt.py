"""Signals that ask to stop: noted at once, obeyed where the work can be interrupted."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from types import FrameType

from viscodesign.lazy_dataclass import dataclass

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


_open: list[StopRequest] = []
"""Those of the main thread that listen to Ctrl-C, innermost last."""


@contextmanager
def gentle_interrupt() -> Iterator[StopRequest]:
    """Note Ctrl-C instead of raising it; a second one ends the process at once.

    An exception raised while the integrator calls back is taken there for a failed
    step, which is tried again: the request would be lost. Only the main thread may
    handle signals; in any other, nothing changes. Enclosing listeners are told, too.
    """
    request = StopRequest()

    def note_once(number: int, frame: FrameType | None) -> None:
        for listener in _open:
            listener.note(number, frame)
        signal.signal(signal.SIGINT, signal.SIG_DFL)

    with _handled([signal.SIGINT], note_once) as handled:
        if not handled:
            yield request
            return
        _open.append(request)
        try:
            yield request
        finally:
            _open.pop()


@contextmanager
def stop_on_signals(request: StopRequest | None = None) -> Iterator[StopRequest]:
    """Count every signal that asks to stop, and die of none: for a pump that moves.

    Only the main thread may handle signals; in any other, ``request`` is the one way to stop.
    """
    request = request or StopRequest()
    with _handled(STOP_SIGNALS, request.note):
        yield request


@contextmanager
def _handled(
    numbers: Sequence[int], handler: Callable[[int, FrameType | None], None]
) -> Iterator[bool]:
    """Signals go to the handler, in the main thread alone; whether they do."""
    if threading.current_thread() is not threading.main_thread():
        yield False
        return
    before = {number: signal.signal(number, handler) for number in numbers}
    try:
        yield True
    finally:
        for number, old in before.items():
            signal.signal(number, old)
