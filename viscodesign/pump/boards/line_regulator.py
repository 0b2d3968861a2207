"""`--board regulator`: an electro-pneumatic regulator with a serial line of its own.

Lines of ASCII that end in CR LF, as SMC's ITV1000 to ITV3000 with RS-232C (order code RC) take
them. ``SET n`` gives the set-point, n = 0 to 1023 over the full scale, and is answered by n;
``MON`` asks for the outlet and ``REQ`` for the set-point; all else is answered in words. There is
no id, no checksum, no watchdog, and no name to ask for. Source: two published drivers that agree
(of an ITV1050-RC2N and of an ITV1050-RCF2N); never tried on a device.
"""

from __future__ import annotations

from viscodesign.errors import PumpError
from viscodesign.pump.boards.controller import Controller
from viscodesign.scene.pumps.regulator import HIGHEST_SET_POINT

PATIENCE = 0.05  # for a reply [s]: it takes up to 15 ms on the line, and an adapter's latency
READ_TRIES = 2  # together shorter than the silence that stops a pump


class LineRegulator(Controller):
    """The device at the end of its line; a step is one of its set-point."""

    name = "regulator"
    baud = 9_600

    output = 0  # outlet as last read [steps]

    def _identity(self) -> str:
        return f"a regulator, whose set-point is {self.set_point()} of {HIGHEST_SET_POINT}"

    @staticmethod
    def sets(request: bytes) -> bool:
        return request.startswith(b"SET")

    @staticmethod
    def shown(request: bytes) -> str:
        return request.decode("ascii", "replace").strip()

    def outlet(self) -> int:
        """Outlet now [steps]."""
        self.output = self._ask("MON")
        return self.output

    def set_point(self) -> int:
        """The set-point that it holds [steps]."""
        return self._ask("REQ")

    def set(self, step: int) -> None:
        """Give it a set-point [steps], and see that it repeats it."""
        if not 0 <= step <= HIGHEST_SET_POINT:
            raise PumpError(f"a set-point of {step}; a regulator takes 0 to {HIGHEST_SET_POINT}")
        if (taken := self._ask(f"SET {step}")) != step:
            raise PumpError(f"the regulator was sent SET {step} and repeats {taken}")

    def _ask(self, command: str) -> int:
        """The number in its reply; what is absolute may be sent twice."""
        said = ""
        for _ in range(READ_TRIES):
            self.line.drain()
            self.line.write(f"{command}\r\n".encode())
            if (said := self._reply()).isdecimal() and int(said) <= HIGHEST_SET_POINT:
                return int(said)
            # A reply does not say what it answers: one that is late must not answer the next.
            self.line.clock.sleep(PATIENCE)
        words = f"answers {said!r} to {command}" if said else f"does not answer {command}"
        raise PumpError(
            f"the regulator {words}. Is it powered, on this port and at {self.baud} baud?"
        )

    def _reply(self) -> str:
        """One line without its end; empty where none came in time."""
        deadline, reply = self.line.clock.now() + PATIENCE, b""
        while not reply.endswith(b"\n"):
            if not (part := self.line.read(64, deadline)):
                return ""
            reply += part
        return reply.decode("ascii", "replace").strip()


class SimulatedLineRegulator(LineRegulator):
    """A computed regulator at the end of a line."""

    simulated = True
