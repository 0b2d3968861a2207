"""The course of a plan whose pumps are syringes."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.planning.result import PumpCourse
from viscodesign.scene.pumps.servo import ServoPumpSpec


@dataclass(frozen=True)
class PlungerCourse(PumpCourse):
    """Motion of P plungers at T times; arrays (T, P). A position is pushed in from home [m]."""

    columns: ClassVar[dict[str, str]] = {
        "pressure_pa": "pressure",
        "given_m3": "given",
        "volume_m3": "volume",
        "flow_m3_s": "flow",
        "plunger_m": "position",
        "count": "steps",
        "torque_nm": "torque",
        "stall_share": "stall_share",
        "speed_share": "speed_share",
    }

    volume: np.ndarray  # swept by the plunger from home [m3]; `flow` is its rate
    torque: np.ndarray  # at the pinion, friction included [N m]
    stall_share: np.ndarray  # of the stall torque at the supply voltage, in size [1]
    speed_share: np.ndarray  # of the speed that is left at this torque [1]

    @property
    def count(self) -> np.ndarray:
        """Of the servo (T, P), not rounded."""
        return self.steps


def range_rows(
    course: PlungerCourse, pump: ServoPumpSpec, counts: np.ndarray
) -> list[tuple[str, str]]:
    """Range of the plungers, in ``counts``, and of the pressures, for people."""
    volume, pressure = 1e6 * course.volume, course.pressure / 1e3
    low, high = pump.travel
    return [
        (
            "plunger",
            f"{counts.min():.0f} to {counts.max():.0f} counts (travel {low} to {high}), "
            f"{volume.min():.3g} to {volume.max():.3g} mL from home",
        ),
        ("pressure", f"{pressure.min():.2f} to {pressure.max():.2f} kPa gauge"),
    ]
