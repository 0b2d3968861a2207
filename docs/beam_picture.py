"""Measured and predicted swings of the beam, one pair of axes a load."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from beam_validation import BeamRun
from measured_swing import COMPARED

from viscodesign.report.layout.look import PLAIN
from viscodesign.report.layout.style import axes_at, picture
from viscodesign.results.coefficient_band import COVERAGE_FACTOR

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SHOWN = {"gravity_b": "own weight", "load52_b": "52 g, fitted", "load101_a": "102 g"}
LEFT, BOTTOM, WIDTH, HEIGHT, GAP, TOP = 0.62, 0.5, 2.1, 2.0, 0.45, 0.3
"""[inch]"""


def _draw_errors(axes: Axes, own: BeamRun, shift: float) -> None:
    """Both errors about the computed tip [mm]: by the coefficients, at 95 %, and numerical."""
    band, time, x = own.run.uncertainty, own.run.time + shift, 1e3 * own.run.tip[:, 0]
    assert band is not None
    half = 1e3 * COVERAGE_FACTOR * band.deviation[:, 0]
    error = 1e3 * (own.run.accuracy.estimated_tip_error_m or 0.0)
    for size, alpha, words in (
        (half, 0.18, "95 % by the coefficients"),
        (error, 0.45, "numerical error"),
    ):
        axes.fill_between(
            time, x - size, x + size, color=PLAIN.accent, alpha=alpha, lw=0.0, label=words
        )


def draw_beam(runs: list[BeamRun], path: Path) -> None:
    """How far down the tip is over time [mm]: measured as dots, computed with its errors."""
    chosen = [own for own in runs if own.name in SHOWN]
    total = LEFT + len(chosen) * (WIDTH + GAP)
    with picture(path, total, BOTTOM + HEIGHT + TOP) as made:
        for k, own in enumerate(chosen):
            axes = axes_at(made, LEFT + k * (WIDTH + GAP), BOTTOM, WIDTH, HEIGHT)
            shift = own.measured.rms(own.predicted)[1]
            _draw_errors(axes, own, shift)
            axes.plot(
                own.measured.time, 1e3 * own.measured.tip[:, 0], ".", color=PLAIN.ink, ms=2.5,
                label="measured",
            )  # fmt: skip
            axes.plot(
                own.predicted.time + shift, 1e3 * own.predicted.tip[:, 0], color=PLAIN.accent,
                lw=1.4, label="computed",
            )  # fmt: skip
            axes.set(xlim=(0.0, COMPARED), xlabel="time [s]", title=SHOWN[own.name])
            axes.invert_yaxis()
            if k == 0:
                axes.set_ylabel("tip below the straight beam [mm]")
                axes.legend(frameon=False, loc="lower right", fontsize=6.5)
