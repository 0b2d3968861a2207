"""The course of a plan whose pumps are syringes."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.planning.result import PumpCourse


@dataclass(frozen=True)
class PlungerCourse(PumpCourse):
    """Motion of P plungers at T times; arrays (T, P). A position is pushed in from home [m]."""

    columns: ClassVar[dict[str, str]] = {
        "pressure_pa": "pressure",
        "given_m3": "given",
        "volume_m3": "volume",
        "flow_m3_s": "flow",
        "plunger_m": "position",
        "step": "steps",
        "force_n": "force",
        "stall_share": "stall_share",
        "speed_share": "speed_share",
    }

    volume: np.ndarray  # swept by the plunger from home [m3]; `flow` is its rate
    force: np.ndarray  # of the drive on the plunger, friction included [N]
    stall_share: np.ndarray  # of the load at which the drive stalls, in size [1]
    speed_share: np.ndarray  # of the speed that is left at this force [1]


def range_rows(
    course: PlungerCourse, pump: Any, steps: np.ndarray, unit: str
) -> list[tuple[str, str]]:
    """Range of the plungers, in ``steps`` of a ``unit``, and of the pressures, for people."""
    volume, pressure = 1e6 * course.volume, course.pressure / 1e3
    low, high = pump.travel
    return [
        (
            "plunger",
            f"{steps.min():.0f} to {steps.max():.0f} {unit} (travel {low} to {high}), "
            f"{volume.min():.3g} to {volume.max():.3g} mL from home",
        ),
        ("pressure", f"{pressure.min():.2f} to {pressure.max():.2f} kPa gauge"),
    ]
