"""Motions with exact distances: a tip on a circle."""

from __future__ import annotations

import numpy as np

from viscodesign.comparison.measured_motion import tip_metrics
from viscodesign.results.run_comparison import ComparedMotion

RADIUS, PERIOD = 0.02, 2.0


def circle(
    label: str, time: np.ndarray, late: float = 0.0, stated: float | None = None, **changes: object
) -> ComparedMotion:
    """Rounds of 2 s, some seconds late."""
    angle = 2 * np.pi * (time - late) / PERIOD
    tip = RADIUS * np.column_stack((np.cos(angle), np.sin(angle))) + (0.0, 0.1)
    known = {"period": PERIOD, "stated_error_m": stated, "source": ""}
    metrics = tip_metrics(time, tip, PERIOD)
    return ComparedMotion(
        label=label, origin="run", time=time, tip=tip, metrics=metrics, **{**known, **changes}
    )  # type: ignore[arg-type]


def chord(late: float) -> float:
    """Distance of two such tips at the same time [m]."""
    return float(2 * RADIUS * np.sin(np.pi * late / PERIOD))
