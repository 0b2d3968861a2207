"""A simulated pressure regulator, down to the bytes of its line."""

from __future__ import annotations

import math

import numpy as np

from viscodesign.pump.simulated.device import BITS_PER_BYTE, Device
from viscodesign.pump.simulated.plant import Plant
from viscodesign.scene.pumps.regulator import HIGHEST_SET_POINT, RegulatorSpec

REGULATOR_BAUD = 9_600
THINKING_S = 2e-3  # between a command and its reply (assumed) [s]
LONGEST_STEP_S = 0.01  # of the outlet and what is behind it [s]


class SimulatedRegulator(Device):
    """Its outlet follows its set-point with one time constant; a supply that never fails.

    What is behind it takes no notable flow (assumed), and is told the outlet's pressure.
    """

    def __init__(self, spec: RegulatorSpec, plant: Plant | None = None) -> None:
        super().__init__()
        self.spec = spec
        self.plant = plant or Plant()
        self.pressure = 0.0  # of the outlet, gauge [Pa]
        self.set_point = 0
        self.pending = b""
        self.moment: float | None = None  # up to which it was computed [s]

    def feed(self, data: bytes, now: float) -> None:
        arrived = now + len(data) * BITS_PER_BYTE / REGULATOR_BAUD
        *lines, self.pending = (self.pending + data).split(b"\n")
        for line in lines:
            self.advance(arrived)
            reply = self.answer(line.decode("ascii", "replace").strip()).encode() + b"\r\n"
            self.outbox.put(
                reply, arrived + THINKING_S + len(reply) * BITS_PER_BYTE / REGULATOR_BAUD
            )

    def answer(self, command: str) -> str:
        """The reply to a command; a set-point is in force when it is given."""
        word, _, number = command.partition(" ")
        if command == "MON":
            return str(min(max(round(self.pressure / self.spec.step), 0), HIGHEST_SET_POINT))
        if command == "REQ":
            return str(self.set_point)
        if word != "SET" or not number.isdecimal():
            return "UNKNOWN COMMAND"
        if int(number) > HIGHEST_SET_POINT:
            return "OUT OF RANGE"
        self.set_point = int(number)
        return number

    def advance(self, now: float) -> None:
        """Advance to a moment; the first call sets the start."""
        before = now if self.moment is None else self.moment
        self.moment = now
        count = max(math.ceil((now - before) / LONGEST_STEP_S), 1)
        for _ in range(count):
            self._step((now - before) / count)

    def _step(self, seconds: float) -> None:
        response_time = self.spec.response_time
        share = 1.0 if response_time == 0.0 else -math.expm1(-seconds / response_time)
        self.pressure += share * (self.set_point * self.spec.step - self.pressure)
        if seconds > 0.0:
            self.plant.advance(seconds, np.array([self.pressure]))
