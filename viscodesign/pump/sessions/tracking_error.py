"""How closely a measured pressure follows the planned one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from viscodesign.pump.play.stream import TickReport


@dataclass
class TrackingError:
    """Measured minus planned pressure, over all samples that have both."""

    samples: int = 0
    sum_of_squares: float = 0.0
    largest: float = 0.0
    """[Pa]"""

    def update(self, shown: TickReport) -> None:
        pairs = zip(shown.sample.pressure, shown.sample.wanted, strict=True)
        for measured, wanted in pairs:
            if measured is not None and wanted is not None:
                self.samples += 1
                self.sum_of_squares += (measured - wanted) ** 2
                self.largest = max(self.largest, abs(measured - wanted))

    def document(self) -> dict[str, Any]:
        """Under names with units; empty where nothing was measured."""
        if not self.samples:
            return {}
        rms = (self.sum_of_squares / self.samples) ** 0.5
        return {"largest_pa": self.largest, "rms_pa": rms, "samples": self.samples}
