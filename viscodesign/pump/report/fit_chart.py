"""A profile and the poses that stand for it: requested, played, and the error between them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.poses.engine import FRAME
from viscodesign.pump.poses.fit import PoseFit
from viscodesign.pump.report.plan_chart import pump_colours
from viscodesign.report.layout.look import look
from viscodesign.report.layout.style import axes_at, head, head_room, picture
from viscodesign.results.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True)
class PoseFitLayout:
    """Lengths of the picture [inch]."""

    left: float = 0.8
    bottom: float = 0.5
    wide: float = 6.0
    tall: float = 2.4
    short: float = 1.2
    gap: float = 0.16
    right: float = 0.2


IN = PoseFitLayout()


def draw_fit(fit: PoseFit, run: Trajectory, path: Path) -> None:
    """Counts against time, and below them the error; ``run`` is what the fit is for."""
    width, top = (
        look().across(IN.left + IN.wide + IN.right),
        IN.bottom + IN.short + IN.gap + IN.tall,
    )
    wide = width - IN.left - IN.right
    with picture(path, width, top + head_room(run, width)) as made:
        counts = axes_at(made, IN.left, top - IN.tall, wide, IN.tall)
        _draw_counts(counts, fit)
        counts.tick_params(labelbottom=False)
        _draw_error(axes_at(made, IN.left, IN.bottom, wide, IN.short), fit)
        how = "poses of a loop" if fit.looped else "poses"
        head(made, run, f"{how}, off by at most {fit.largest_error:.2f} counts", IN.left)


def _draw_counts(axes: Axes, fit: PoseFit) -> None:
    moments = np.cumsum([0, *fit.move_frames[1:]]) * FRAME
    goals = np.array([goal[:-1] for goal in fit.sequence.goals()])
    for k, colour in enumerate(pump_colours()[: fit.played.shape[1]]):
        axes.plot(fit.time, fit.requested[:, k], color=colour, lw=4.0, alpha=0.35)
        axes.plot(fit.time, fit.played[:, k], color=look().ink, lw=0.9)
        axes.plot(moments, goals[:, k], "o", color=colour, ms=3.5, mec=look().ink, mew=0.5)
    axes.set(xlim=(0.0, fit.duration), ylabel="servo [counts]")
    axes.legend(["requested", "played", "goals of the moves"], loc="best")


def _draw_error(axes: Axes, fit: PoseFit) -> None:
    for k, colour in enumerate(pump_colours()[: fit.played.shape[1]]):
        axes.plot(fit.time, fit.error[:, k], color=colour, lw=0.9)
    for level in (-fit.largest_error, fit.largest_error):
        axes.axhline(level, color=look().accent, lw=0.8, ls="--")
    axes.axhline(0.0, color=look().ink, lw=0.5)
    axes.set(xlim=(0.0, fit.duration), xlabel="time [s]", ylabel="error [counts]")
