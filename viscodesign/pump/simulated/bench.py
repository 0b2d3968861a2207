"""The pump on the bench: servos, racks, barrels and what the plungers press into."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from viscodesign.pump.bus.packets import BROADCAST, Packet
from viscodesign.pump.drive import Drive
from viscodesign.pump.simulated.access import Access
from viscodesign.pump.simulated.plant import Plant
from viscodesign.pump.simulated.servo import SimulatedServo

STEP = 2.5e-3
"""Of the servos [s]: a fraction of the time in which one settles at its goal, 16 ms."""
STEPS_PER_PLANT = 4


class SimulatedBench:
    """P servos with a plunger each.

    Time goes in fixed steps, so that what happens does not depend on when it is asked.
    """

    def __init__(
        self, servos: Sequence[SimulatedServo], drives: Sequence[Drive], plant: Plant
    ) -> None:
        self.servos = list(servos)
        self.drives = list(drives)
        self.plant = plant
        self._access = [Access(servo) for servo in self.servos]
        self._torque_per_pressure = np.array([_torque_per_pressure(d) for d in self.drives])
        self._steps: int | None = None
        self._start = 0.0
        self.pressures = plant.advance(0.0, self.positions())
        """(P,) gauge [Pa]."""

    def positions(self) -> np.ndarray:
        """(P,) plungers pushed in from home [m]."""
        pairs = zip(self.servos, self.drives, strict=True)
        return np.array([drive.position(servo.position) for servo, drive in pairs])

    def supply(self, voltage: float) -> None:
        """Another supply voltage for all servos."""
        for servo in self.servos:
            servo.supply(voltage)

    def advance(self, now: float) -> None:
        """Advance to a moment; the first call sets the start."""
        if self._steps is None:
            self._start, self._steps = now, 0
        while self._start + (self._steps + 1) * STEP <= now:
            self._steps += 1
            loads = self._torque_per_pressure * self.pressures
            for servo, load in zip(self.servos, loads, strict=True):
                servo.advance(STEP, float(load))
            if self._steps % STEPS_PER_PLANT == 0:
                self.pressures = self.plant.advance(STEPS_PER_PLANT * STEP, self.positions())

    def answer(self, packet: Packet, now: float) -> tuple[Packet, float] | None:
        """What comes back from the bus, and how long the servo waited before; or silence."""
        self.advance(now)
        replies = [(access.answer(packet), access.return_delay) for access in self._access]
        spoken = [(reply, delay) for reply, delay in replies if reply is not None]
        return spoken[0] if spoken and packet.id != BROADCAST else None


def _torque_per_pressure(drive: Drive) -> float:
    """Torque towards higher counts for a gauge pressure that drives the plunger out [m3]."""
    outwards = -1.0 if drive.pump.push == "up" else 1.0
    return outwards * drive.area * drive.pump.pinion_diameter / 2
