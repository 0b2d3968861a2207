"""`compare.png`: paths of tips over each other, and how far each is from the first."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.charts.coefficient_band import corners_about, draw_ellipses
from viscodesign.report.charts.tip_path import travelled
from viscodesign.report.layout.downsampling import envelope, stretches
from viscodesign.report.layout.look import look
from viscodesign.report.layout.motion_lines import line_style
from viscodesign.report.layout.style import Target, axes_at, draw_title, picture, shown, title_room
from viscodesign.results.channels import channel
from viscodesign.results.run_comparison import Comparison, TipDifference

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True)
class ComparisonLayout:
    """Lengths of the picture [inch]."""

    left: float = 0.75
    bottom: float = 0.6
    side: float = 4.4
    gap: float = 0.95
    wide: float = 3.7
    right: float = 0.25
    between: float = 0.75
    """Between the charts of distances."""
    key_line: float = 0.19
    """A line of the key."""
    least_width: float = 6.6
    """From which on these charts are on the right of the paths."""
    tall: float = 1.5
    """Their height where they are below."""
    key_column: float = 2.6
    """A column of it."""


IN = ComparisonLayout()
PATHS_PAD = 0.07
MIN_PATHS_SPAN_MM = 0.1
MAX_LABEL, MAX_IN_TITLE = 44, 30


class TipMotion(Protocol):
    """Anything with a path that has a name: a motion, or a whole run."""

    @property
    def title(self) -> str: ...

    @property
    def tip(self) -> np.ndarray: ...


def draw_comparison(found: Comparison, path: Target) -> None:
    """Paths, and distances over time (and over phase) to their right or below; png, pdf or svg."""
    frame = PanelPlaces.of(found)
    warned = _warnings(found)
    head = title_room() + 0.18 * len(warned)
    height = frame.top + head
    with picture(path, frame.width, height) as made:
        draw_title(made, shown(_title(found), 110), IN.left)
        for k, words in enumerate(reversed(warned)):
            made.text(
                IN.left / frame.width, (frame.top + 0.06 + 0.18 * k) / height,
                shown(words, int(13 * (frame.width - IN.left))),
                size=8, color=look().warning, weight="bold",
            )  # fmt: skip
        paths = axes_at(made, *frame.paths)
        draw_paths(paths, found.motions, _drawn_bands(paths, found))
        handles, labels = paths.get_legend_handles_labels()
        made.legend(
            handles, labels, loc="upper left", ncols=frame.key_columns, borderaxespad=0,
            handlelength=2.6, bbox_to_anchor=(IN.left / frame.width, (frame.top - 0.04) / height),
        )  # fmt: skip
        _draw_over_time(axes_at(made, *frame.distances[0]), found.differences)
        for place in frame.distances[1:]:
            _draw_over_phase(axes_at(made, *place), found.differences)


def _warnings(found: Comparison) -> list[str]:
    """Lines on what ended early, and on what its model does not describe."""
    broken = [m for m in found.motions if m.status != "complete"]
    outside = [f"{m.title} ({', '.join(m.outside)})" for m in found.motions if m.outside]
    ended = "; ".join(f"{m.title}: {m.failure or 'ended early'}" for m in broken)
    beyond = f"outside of the model: {'; '.join(outside)}" if outside else ""
    return [line for line in (ended, beyond) if line]


@dataclass(frozen=True)
class PanelPlaces:
    """Where the charts are: left, bottom, width, height [inch]."""

    width: float
    top: float
    key_columns: int
    paths: tuple[float, float, float, float]
    distances: tuple[tuple[float, float, float, float], ...]

    @staticmethod
    def of(found: Comparison) -> PanelPlaces:
        width = look().across(IN.left + IN.side + IN.gap + IN.wide + IN.right)
        count = 1 + any(d.phase is not None for d in found.differences)
        columns = max(1, min(2, int((width - IN.left) / IN.key_column)))
        key = 0.12 + IN.key_line * -(-len(found.motions) // columns)
        if width >= IN.least_width:
            free = width - IN.left - IN.gap - IN.right
            side = free * IN.side / (IN.side + IN.wide)
            tall, left, wide = (
                (side - IN.between * (count - 1)) / count,
                IN.left + side + IN.gap,
                free - side,
            )
            bottoms, base = [IN.bottom + side - tall, IN.bottom][:count], IN.bottom
        else:
            tall, left, wide = IN.tall, IN.left, width - IN.left - IN.right
            side = wide
            bottoms = [IN.bottom + k * (IN.tall + IN.between) for k in reversed(range(count))]
            base = IN.bottom + count * (IN.tall + IN.between)
        places = tuple((left, bottom, wide, tall) for bottom in bottoms)
        return PanelPlaces(width, base + side + key, columns, (IN.left, base, side, side), places)


def _title(found: Comparison) -> str:
    first = shown(found.motions[0].title, MAX_IN_TITLE)
    worst = max(found.differences, key=lambda d: d.max_m)
    size, label = f"{1e3 * worst.max_m:.3g} mm", shown(worst.label, MAX_IN_TITLE)
    if len(found.differences) == 1:
        told = ", within the stated errors" if worst.verdict == "within errors" else ""
        return f"{label} differs from {first} by {size} at most{told}"
    return f"{len(found.differences)} motions differ from {first} by up to {size} ({label})"


def _drawn_bands(axes: Axes, found: Comparison) -> np.ndarray:
    """Draw what the coefficients leave open; returns corners (n, 2) about it [mm]."""
    for motion in found.motions:
        if motion.band is not None:
            draw_ellipses(axes, motion.tip, motion.band)
    return np.concatenate([corners_about(motion.tip, motion.band) for motion in found.motions])


def draw_paths(axes: Axes, motions: Sequence[TipMotion], around: np.ndarray | None = None) -> None:
    """Paths [mm] at one scale, z downwards; a dot where each starts, an arrow for its sense.

    ``around``: corners (n, 2) [mm] that the frame holds, too.
    """
    corners = [] if around is None else [around]
    half = frame_about(axes, np.concatenate([*corners, *(1e3 * m.tip for m in motions)]))
    for k, motion in enumerate(motions):
        style = line_style(k)
        lines: dict[str, Any] = {"color": style.colour, "lw": 1.6, "zorder": 4}
        if style.dashes:
            lines["dashes"] = style.dashes
        for n, rows in enumerate(stretches(motion.tip)):
            label = shown(motion.title, MAX_LABEL) if n == 0 else None
            axes.plot(*(1e3 * motion.tip[rows].T), label=label, **lines)
        start = 1e3 * motion.tip[0]
        axes.plot(*start, marker="o", ms=5, mfc=look().ground, mec=style.colour, zorder=6)
        _draw_sense(axes, 1e3 * motion.tip[stretches(motion.tip)[-1]], style.colour, 2 * half, k)


def frame_about(axes: Axes, points: np.ndarray) -> float:
    """Square limits about points (n, 2) [mm], z downwards; returns half a side [mm]."""
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    half = (0.5 + PATHS_PAD) * max(float(np.ptp(points, axis=0).max()), MIN_PATHS_SPAN_MM)
    axes.set(xlim=(middle[0] - half, middle[0] + half), ylim=(middle[1] + half, middle[1] - half))
    axes.set(xlabel=channel("x").label, ylabel=f"{channel('z').label}, down from the clamp")
    axes.grid(color=look().grid, lw=0.6)
    axes.set_axisbelow(True)
    return half


def _draw_sense(axes: Axes, way: np.ndarray, colour: str, side: float, k: int) -> None:
    """An arrow head on the last round; of several paths at different places."""
    along = travelled(way)
    round_length = min(along[-1], 2.0 * float(np.sum(np.ptp(way, axis=0))))
    if round_length < 0.05 * side:
        return
    at = along[-1] - round_length * (0.72 - 0.09 * (k % 5))
    end, start = ([np.interp(s, along, way[:, i]) for i in (0, 1)] for s in (at, at - 0.004 * side))
    axes.annotate(
        "", xy=(float(end[0]), float(end[1])), xytext=(float(start[0]), float(start[1])), zorder=5,
        arrowprops={"arrowstyle": "-|>", "color": colour, "mutation_scale": 12, "lw": 0},
    )  # fmt: skip


def _draw_over_time(axes: Axes, differences: tuple[TipDifference, ...]) -> None:
    for k, found in enumerate(differences, start=1):
        time, distance = envelope(found.time, 1e3 * found.distance[:, None])
        _draw_distance(axes, time, distance[:, 0], k)
        if found.band is not None:
            label = "95 % by the coefficients"
            colour = line_style(k).colour
            axes.plot(found.time, 1e3 * found.band, color=colour, lw=0.9, ls=":", label=label)
            axes.legend(loc="upper right", fontsize=7.5)
    axes.set(xlabel=channel("time").label, ylabel="distance, same time [mm]")
    _frame(axes)
    known = [d.numerical_m for d in differences if d.numerical_m is not None]
    if not known:
        return
    level, top = 1e3 * max(known), axes.get_ylim()[1]
    if level < 0.02 * top:  # no more than the width of the axis
        return
    axes.axhspan(0, level, color=look().faint, alpha=0.35, lw=0, zorder=1)
    axes.set_ylim(0, top)
    place, upright = (level, "bottom") if level < 0.95 * top else (top, "top")
    axes.text(
        0.99, place, f"stated errors, {level:.2g} mm", color=look().note, size=7.5, ha="right",
        va=upright, transform=axes.get_yaxis_transform(),
    )  # fmt: skip


def _draw_over_phase(axes: Axes, differences: tuple[TipDifference, ...]) -> None:
    for k, found in enumerate(differences, start=1):
        if found.phase is not None:
            _draw_distance(axes, found.phase.phase, 1e3 * found.phase.distance, k)
    axes.set(xlim=(0, 1), xlabel="phase of the last period", ylabel="distance, same phase [mm]")
    _frame(axes)


def _draw_distance(axes: Axes, at: np.ndarray, distance: np.ndarray, k: int) -> None:
    style = line_style(k)
    dashes: dict[str, Any] = {"dashes": style.dashes} if style.dashes else {}
    alone: dict[str, Any] = {"marker": "o", "ms": 4} if len(at) == 1 else {}
    axes.plot(at, distance, color=style.colour, lw=1.3, zorder=3, **dashes, **alone)


def _frame(axes: Axes) -> None:
    axes.set_ylim(0, max(axes.get_ylim()[1], 1e3 * 1e-9))
    axes.margins(x=0.01)
    axes.grid(color=look().grid, lw=0.6)
    axes.set_axisbelow(True)
    axes.tick_params(color=look().grey)
