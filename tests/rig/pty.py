"""A computed device behind a pseudo-terminal, for programs that want a port."""

from __future__ import annotations

import os
import select
import threading
import tty
from types import TracebackType

from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.simulated.device import Device, UnpluggedError

LONGEST_WAIT = 0.01
"""[s]"""


class PtyServer:
    """Serves a device in a thread of its own until it is closed, which pulls the cable."""

    def __init__(self, device: Device, clock: Clock) -> None:
        self.device = device
        self.clock = clock
        self._host, self._end = os.openpty()
        tty.setraw(self._end)
        os.set_blocking(self._host, False)
        self.port = os.ttyname(self._end)
        """Name to open."""
        self.lock = threading.Lock()
        """Held while the device works; take it to look at the device from outside."""
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._serve, daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Stop, and take the port away under those who use it."""
        self._stop.set()
        self._thread.join()

    def __enter__(self) -> PtyServer:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def _serve(self) -> None:
        try:
            while not self._stop.is_set():
                self._turn()
        except UnpluggedError:
            pass
        finally:
            os.close(self._host)
            os.close(self._end)

    def _turn(self) -> None:
        """What came goes in; what is due goes out."""
        wait = min(max(self.device.due() - self.clock.now(), 0.0), LONGEST_WAIT)
        ready, _, _ = select.select([self._host], [], [], wait)
        with self.lock:
            if ready:
                self.device.feed(os.read(self._host, 4096), self.clock.now())
            data = self.device.take(self.clock.now())
        while data and not self._stop.is_set():
            _, ready, _ = select.select([], [self._host], [], LONGEST_WAIT)
            data = data[os.write(self._host, data) :] if ready else data
