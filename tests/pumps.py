"""A pump on the bench for tests: what it is, and lines into it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tests.rig.full import FullServo
from viscodesign.pump.ax.servo_drive import ServoDrive
from viscodesign.pump.bus.clock import SteppedClock
from viscodesign.pump.simulated.bench import ClosedGas, SimulatedBench
from viscodesign.pump.simulated.plant import Plant
from viscodesign.scene.pumps.servo import ServoPumpSpec

HOME = 200


def pump(**settings: Any) -> ServoPumpSpec:
    given = {"syringe_diameter": 0.0349, "home": HOME, "sensor": {"channel": 0}}
    return ServoPumpSpec.model_validate(given | settings)


def bench(*ids: int, plant: Plant | None = None, **settings: Any) -> SimulatedBench:
    """Plungers at home; each barrel closed where no plant is given."""
    drives = [ServoDrive(pump(**settings)) for _ in ids]
    servos = [FullServo(id, position=HOME) for id in ids]
    return SimulatedBench(servos, drives, plant or ClosedGas(drives))


@dataclass
class Weights(Plant):
    """Pressures that somebody sets."""

    pressures: Any

    def advance(self, seconds: float, positions: Any) -> Any:
        return self.pressures


def stepped() -> SteppedClock:
    return SteppedClock()
