"""The pump on the bench: servos, racks, barrels and what the plungers press into."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from viscodesign.pump.ax.protocol.packets import BROADCAST, Packet
from viscodesign.pump.drive import PlungerDrive
from viscodesign.pump.simulated.plant import AMBIENT, Plant
from viscodesign.pump.simulated.servo import SimulatedServo

STEP = 2.5e-3  # of the servos [s]: a fraction of the time in which one settles at its goal, 16 ms
STEPS_PER_PLANT = 4


class ClosedGas(Plant):
    """Each barrel and its dead volume closed, filled with gas that keeps its temperature.

    p V = const (Boyle), at ambient pressure with the plunger at home. An empty barrel leaves the
    dead volume, or a little where there is none.
    """

    def __init__(self, drives: Sequence[PlungerDrive], ambient: float = AMBIENT) -> None:
        self.ambient = ambient
        self._areas = np.array([drive.area for drive in drives])
        filled = np.array([drive.filled_at_home for drive in drives])
        dead = np.array([drive.pump.dead_volume for drive in drives])
        self._volumes = self._areas * filled + dead
        self._least = np.maximum(dead, 1e-3 * self._volumes)

    def advance(self, seconds: float, positions: np.ndarray) -> np.ndarray:
        left = np.maximum(self._volumes - self._areas * positions, self._least)
        pressures: np.ndarray = self.ambient * (self._volumes / left - 1.0)
        return pressures


class SimulatedBench:
    """P servos with a plunger each.

    Time advances in fixed steps, so that the motion does not depend on when it is queried.
    """

    def __init__(
        self, servos: Sequence[SimulatedServo], drives: Sequence[PlungerDrive], plant: Plant
    ) -> None:
        self.servos = list(servos)
        self.drives = list(drives)
        self.plant = plant
        outwards = np.array([-1.0 if drive.pump.push == "up" else 1.0 for drive in drives])
        levers = np.array([drive.area * drive.load.per_newton for drive in drives])
        self._torque_per_pressure = outwards * levers  # towards higher counts [m3]
        self._steps: int | None = None
        self._start = 0.0
        self.pressures = plant.advance(0.0, self.positions())  # (P,) gauge [Pa]

    def positions(self) -> np.ndarray:
        """(P,) plungers pushed in from home [m]."""
        pairs = zip(self.servos, self.drives, strict=True)
        return np.array([drive.position(servo.position) for servo, drive in pairs])

    def supply(self, voltage: float) -> None:
        """Change the supply voltage of all servos."""
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
        """The reply from the bus and how long the servo waited before it; None for silence."""
        self.advance(now)
        replies = [(servo.answer(packet), servo.return_delay) for servo in self.servos]
        spoken = [(reply, delay) for reply, delay in replies if reply is not None]
        return spoken[0] if spoken and packet.id != BROADCAST else None
