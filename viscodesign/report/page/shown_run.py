"""What the page and the films show of a run: its arrays by name, its summary and its spec."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.trajectory import Trajectory


@dataclass(frozen=True)
class ShownRun:
    """T output times, U inlets, B bellows, Q tubes, N shapes of K points; SI, pressures gauge."""

    summary: Mapping[str, Any]
    """As `summary.json` has it."""
    spec_text: str
    inlets: tuple[str, ...]
    bellows: tuple[str, ...]
    tubes: tuple[str, ...]
    length: float
    """Actuator length [m]."""
    width: float
    """Actuator size in the direction of bending [m]."""
    time: np.ndarray
    """(T,) [s]"""
    tip: np.ndarray
    """(T, 3): x, z [m], angle [rad]."""
    inlet_pressure: np.ndarray
    """(T, U) [Pa]"""
    pressure: np.ndarray
    """(T, B) [Pa]"""
    flow: np.ndarray
    """(T, Q) [m3/s]"""
    arc: np.ndarray
    """(K,) [m]"""
    shape: np.ndarray
    """(N, K, 2): x, z of the axis [m]."""
    shape_rows: np.ndarray
    """(N,) rows of the shapes."""

    @classmethod
    def of(cls, trajectory: Trajectory) -> ShownRun:
        """A run that has just been computed, or read from its folder."""
        return cls(
            summary=trajectory.summary(),
            spec_text=trajectory.spec_text,
            inlets=trajectory.inlets,
            bellows=trajectory.bellows,
            tubes=trajectory.tubes,
            length=trajectory.length,
            width=trajectory.width,
            time=trajectory.time,
            tip=trajectory.tip,
            inlet_pressure=trajectory["inlet_pressure"],
            pressure=trajectory.pressure,
            flow=trajectory.flow,
            arc=trajectory.arc,
            shape=trajectory.shape,
            shape_rows=trajectory.shape_rows,
        )

    @property
    def status(self) -> str:
        """complete, failed or interrupted."""
        return str(self.summary["status"])

    def shapes_at(self, rows: np.ndarray) -> np.ndarray:
        """Which shapes (n,) are nearest to some rows."""
        after = np.clip(np.searchsorted(self.shape_rows, rows), 1, len(self.shape_rows) - 1)
        if len(self.shape_rows) == 1:
            return np.zeros(len(rows), dtype=int)
        nearer = rows - self.shape_rows[after - 1] <= self.shape_rows[after] - rows
        return np.asarray(after - nearer)
