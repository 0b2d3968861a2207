"""One look for every picture: readable in print, safe for the colour-blind."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from viscodesign.report.atomic import replaced
from viscodesign.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes

RC: Any = {
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "axes.titlesize": 10,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
    "legend.fontsize": 8,
    "legend.frameon": False,
    "savefig.dpi": 200,
    "path.simplify": True,
}
INK = "#222222"
FAINT = "#b8b8b8"
ACCENT = "#d55e00"  # vermillion of the Okabe-Ito set
SEQUENTIAL = "cividis"
DIVERGING = "RdBu_r"


@contextlib.contextmanager
def picture(path: Path, width: float, height: float) -> Iterator[Figure]:
    """A figure in inches, written whole to ``path`` at the end; no global state is left."""
    with mpl.rc_context(RC):
        made = Figure(figsize=(width, height))
        FigureCanvasAgg(made)
        yield made
        kind = path.suffix.lstrip(".").lower() or "png"
        with replaced(path) as file:
            made.savefig(file, format=kind, bbox_inches="tight")


def ended_early(made: Figure, trajectory: Trajectory) -> None:
    """Mark the picture of a run that did not reach its end."""
    if trajectory.status == "complete":
        return
    text = f"{trajectory.status.upper()} at t = {trajectory.time[-1]:.4g} s"
    box = {"facecolor": ACCENT, "edgecolor": "none", "pad": 4}
    made.text(0.5, 1.03, text, ha="center", va="bottom", color="white", weight="bold", bbox=box)


def bare(axes: Axes) -> None:
    """Take frame and ticks away."""
    axes.set_axis_off()
