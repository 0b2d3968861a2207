"""The barrel in front of a plunger: what it holds at a pressure, in closed form."""

from __future__ import annotations

from typing import Any

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.physics import gas
from viscodesign.pump.drive import PlungerDrive
from viscodesign.pump.planning.demand import FeedLine
from viscodesign.scene.inputs.syringe import SyringeInput
from viscodesign.scene.scene import Scene

KEPT_FREE = 1e-6
"""Share of the filled length that a plunger in a spec must leave."""


@dataclass(frozen=True)
class Barrel:
    """Everything between plunger and network, filled at the baseline with the plunger at home.

    A gas fills barrel and dead volume alike. Beside a liquid the dead volume is a cushion of
    gas at constant temperature. Pressures are gauge [Pa].
    """

    scene: Scene
    drive: PlungerDrive
    line: FeedLine

    @property
    def full_volume(self) -> float:
        """In front of the plunger at home, dead volume included [m3]."""
        return self.drive.area * self.drive.filled_at_home + float(self.drive.pump.dead_volume)

    def density(self, pressure: Any) -> Any:
        """Density of the fluid, relative to that at ambient pressure [1]."""
        fluid, ambient = self.scene.fluid, self.scene.ambient_pressure
        if fluid.is_gas:
            return gas.density_ratio(pressure, ambient, fluid.polytropic_exponent)
        return 1 + pressure / fluid.bulk_modulus if fluid.bulk_modulus else 1 + 0 * pressure

    def cushion(self, pressure: Any) -> Any:
        """Volume of the gas beside a liquid [m3]."""
        scene = self.scene
        if scene.fluid.is_gas:
            return 0.0 * pressure
        filled = gas.density_ratio(scene.gauge_pressure, scene.ambient_pressure, 1.0)
        now = gas.density_ratio(pressure, scene.ambient_pressure, 1.0)
        return self.drive.pump.dead_volume * filled / now

    def _line(self, pressure: Any) -> Any:
        """What the line holds [m3 at ambient density]."""
        volume = self.line.volume + self.line.compliance * pressure
        return volume * self.density(pressure) if self.line.compressible else volume

    def held(self, pressure: Any, position: Any) -> Any:
        """Fluid in barrel and line with the plunger at a position [m3 at ambient density]."""
        space = self.full_volume - self.drive.area * position - self.cushion(pressure)
        return space * self.density(pressure) + self._line(pressure)

    def position(self, pressure: Any, given: Any) -> Any:
        """Plunger position from home [m] that makes a pressure, with so much given.

        ``given`` to the network since it was filled [m3 at ambient density].
        """
        left = self.held(self.scene.gauge_pressure, 0.0) - given - self._line(pressure)
        space = left / self.density(pressure)
        return (self.full_volume - self.cushion(pressure) - space) / self.drive.area

    def compliance(self, pressure: float, position: float) -> float:
        """Plunger volume per unit of pressure while no fluid is delivered [m3/Pa]."""
        step = 1e-4 * self.scene.ambient_pressure
        held = [self.held(pressure + sign * step, position) for sign in (-1.0, 1.0)]
        return float((held[1] - held[0]) / (2 * step) / self.density(pressure))

    def within(self, position: np.ndarray) -> np.ndarray:
        """Positions kept within the barrel [m]."""
        return np.asarray(np.minimum(position, (1 - KEPT_FREE) * self.drive.filled_at_home))

    def syringe(self, time: np.ndarray, position: np.ndarray) -> SyringeInput:
        """The plunger's motion as an input of a scene, kept within the barrel."""
        pump, filled, is_gas = self.drive.pump, self.drive.filled_at_home, self.scene.fluid.is_gas
        kept = self.within(position)
        return SyringeInput(
            kind="syringe",
            diameter=pump.syringe_diameter,
            start=filled,
            dead_volume=pump.dead_volume if is_gas else 0.0,
            cushion=0.0 if is_gas else pump.dead_volume,
            rows=tuple(zip(time.tolist(), kept.tolist(), strict=True)),
        )
