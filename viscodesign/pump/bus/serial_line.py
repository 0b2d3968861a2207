"""A serial port, or a pseudo-terminal in its place."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import serial

from viscodesign.errors import PumpError
from viscodesign.pump.bus.clock import Clock, WallClock
from viscodesign.pump.bus.line import Line

try:
    import termios
except ImportError:  # Windows, where the driver keeps DTR
    termios = None  # type: ignore[assignment]

READ_SLICE = 0.005  # of waiting [s]: a deadline is passed by no more
WRITE_TIMEOUT = 0.5  # [s]; 256 bytes take 0.27 s at 9600 baud.
CFLAG = 2  # place of the control modes among the attributes of a terminal
TERMINAL_ERRORS = () if termios is None else (termios.error,)
GONE = (OSError, serial.SerialException, *TERMINAL_ERRORS)
"""What a port raises whose cable was pulled: by what was being done, one or another."""


class SerialLine(Line):
    """Opened once, at its final speed, and for one program alone.

    Opening pulls DTR, which resets boards that are wired so; a second opening, or a change of
    the speed after the opening, would reset them again. At its closing DTR is left as it is, so
    that the next opening does not pull it (`stty -hupcl`), and what a board plays goes on.
    """

    def __init__(self, port: str, baud: int, clock: Clock | None = None) -> None:
        self.clock = clock or WallClock()
        self.port = port
        self._serial = serial.Serial(
            timeout=READ_SLICE, write_timeout=WRITE_TIMEOUT, exclusive=True
        )
        self._serial.port = port
        try:
            self._serial.baudrate = baud
            self._serial.open()
            self._keep_dtr_at_closing()
        except (ValueError, *GONE) as error:
            raise PumpError(_why_closed(port, baud, error)) from None

    def _keep_dtr_at_closing(self) -> None:
        if termios is not None:
            settings = termios.tcgetattr(self._serial)
            settings[CFLAG] &= ~termios.HUPCL
            termios.tcsetattr(self._serial, termios.TCSANOW, settings)

    def write(self, data: bytes) -> None:
        with self._port_errors():
            sent = self._serial.write(data)
        if sent != len(data):
            raise PumpError(f"{self.port}: {sent} of {len(data)} bytes were taken")

    def read(self, most: int, deadline: float) -> bytes:
        with self._port_errors():
            while not (data := self._serial.read(1)):
                if self.clock.now() >= deadline:
                    return b""
            waiting = min(self._serial.in_waiting, most - 1)
            return bytes(data + self._serial.read(waiting))

    def drain(self) -> bytes:
        with self._port_errors():
            return bytes(self._serial.read(self._serial.in_waiting))

    def close(self) -> None:
        if self._serial.is_open:
            with self._port_errors():
                self._serial.close()

    @contextmanager
    def _port_errors(self) -> Iterator[None]:
        """Raise the port's errors as errors of the pump."""
        if not self._serial.is_open:
            raise PumpError(f"{self.port}: has been closed")
        try:
            yield
        except serial.SerialTimeoutException:
            raise PumpError(
                f"{self.port}: write timed out after {WRITE_TIMEOUT} s; the adapter is not "
                "responding. Unplug it and plug it in again"
            ) from None
        except GONE as error:
            raise PumpError(
                f"{self.port}: the port is gone ({error}). Was the cable unplugged? The servo "
                "keeps its last goal: switch the pump's power off if it must not stay there"
            ) from None


def _why_closed(port: str, baud: int, error: BaseException) -> str:
    """What keeps the port from being opened, and what to do."""
    if isinstance(error, ValueError):
        return (
            f"{port}: {baud} baud is not a speed of this port ({error}); choose another baud rate"
        )
    number = error.args[0] if error.args else None
    if number == errno.ENOENT:
        return f"{port}: no such port; `viscodesign pump ports` lists the available ones"
    if number == errno.EACCES:
        return (
            f"{port}: no permission. Join the group that owns it, and log in again: "
            "sudo usermod -aG dialout $USER"
        )
    if number in (errno.EBUSY, errno.EAGAIN, errno.EWOULDBLOCK):
        users = ", ".join(users_of(port)) or "another program"
        return f"{port}: in use by {users}; close it, or wait for it to end"
    if isinstance(error.__context__, TERMINAL_ERRORS) or number == errno.ENOTTY:
        return f"{port}: not a serial port; `viscodesign pump ports` lists the available ones"
    return f"{port}: cannot be opened ({error})"


def users_of(port: str) -> list[str]:
    """Other programs that hold a port open, as far as the system lets us see (Linux)."""
    device, found = os.path.realpath(port), set()
    for link in Path("/proc").glob("[0-9]*/fd/*"):
        process = link.parent.parent
        # A process may have ended, or belong to somebody else.
        with suppress(OSError):
            if os.readlink(link) == device and process.name != str(os.getpid()):
                found.add(f"{(process / 'comm').read_text().strip()} (process {process.name})")
    return sorted(found)
