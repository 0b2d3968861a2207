"""What belongs to none of several actuators that share fluid: sources, junctions, tubes."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.channels import channel


@dataclass(frozen=True)
class CoupledMotion:
    """What actuators share that were solved as one system, over its T output times."""

    actuators: tuple[str, ...]
    time: np.ndarray
    """(T,) [s]."""
    inflow: Mapping[str, np.ndarray]
    """By input: volume at ambient density that it has delivered to all (T,) [m3]."""
    inlet_pressure: Mapping[str, np.ndarray]
    """By input, (T,) gauge [Pa]."""
    junction_pressure: Mapping[str, np.ndarray]
    """By junction between actuators, (T,) gauge [Pa]."""
    flow: Mapping[str, np.ndarray]
    """By tube between actuators, from its first end to its second (T,) [m3/s]."""

    def columns(self) -> dict[str, np.ndarray]:
        """Its columns in a table, by name."""
        return {
            channel(quantity).column(member): values
            for quantity in ("inlet_pressure", "junction_pressure", "flow")
            for member, values in getattr(self, quantity).items()
        }
