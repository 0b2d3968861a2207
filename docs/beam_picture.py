"""Measured and predicted swings of the beam, one pair of axes a load."""

from __future__ import annotations

from pathlib import Path

from beam_validation import BeamRun
from measured_swing import COMPARED

from viscodesign.report.layout.look import PLAIN
from viscodesign.report.layout.style import axes_at, picture

SHOWN = {"gravity_b": "own weight", "load52_b": "52 g, fitted", "load101_a": "102 g"}
LEFT, BOTTOM, WIDTH, HEIGHT, GAP, TOP = 0.62, 0.5, 2.1, 2.0, 0.45, 0.3
"""[inch]"""


def draw_beam(runs: list[BeamRun], path: Path) -> None:
    """How far down the tip is over time [mm]: measured as dots, predicted as a line."""
    chosen = [own for own in runs if own.name in SHOWN]
    total = LEFT + len(chosen) * (WIDTH + GAP)
    with picture(path, total, BOTTOM + HEIGHT + TOP) as made:
        for k, own in enumerate(chosen):
            axes = axes_at(made, LEFT + k * (WIDTH + GAP), BOTTOM, WIDTH, HEIGHT)
            shift = own.measured.rms(own.predicted)[1]
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
                axes.legend(frameon=False, loc="lower right")
