"""`shapes.png`: snapshots of the actuator, every bellow coloured by its gauge pressure."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Colormap, Normalize
from matplotlib.patches import Rectangle

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.ground_outline import feet, ground_outline, ground_words
from viscodesign.report.layout.bellow_blocks import bellow_blocks, section_widths
from viscodesign.report.layout.label_placement import POINTS_PER_INCH
from viscodesign.report.layout.look import look
from viscodesign.report.layout.pressure_colours import pressure_colours
from viscodesign.report.layout.snapshots import clamp_strokes, spread_instants
from viscodesign.report.layout.strip import Frame, Strip, arrange
from viscodesign.report.layout.style import (
    NOTE_ROOM,
    Target,
    axes_at,
    draw_note,
    head,
    head_room,
    picture,
)
from viscodesign.report.layout.tube_lines import MAX_TUBE_LINES, inlet_places, tube_lines
from viscodesign.report.page.page_data import tube_ends
from viscodesign.report.page.sketch_numbers import ground_of, scene_of
from viscodesign.results.channels import channel
from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.disk_arrays import extremes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MAX_SNAPSHOTS, NARROW_SNAPSHOTS = 8, 4
"""The second where the picture is narrow: more would be too small."""
INLET_MARK = 0.16
"""Half the size of an inlet, of half the width of the clamp."""
MAX_EDGED_SECTIONS = 24
"""With more sections than this a bellow's edge would hide its colour."""


@dataclass(frozen=True)
class ShapesLayout:
    """Lengths of the picture [inch]."""

    width: float = 6.6
    side: float = 0.2
    foot_height: float = 0.62
    least_width: float = 4.6


IN = ShapesLayout()


@dataclass(frozen=True)
class Snapshots:
    """What the strip shows, in mm and kPa: N instants, B bellows, K points of the axis."""

    labels: list[str]
    axis: np.ndarray
    """(N, K, 2)"""
    blocks: np.ndarray
    """(N, B, 4, 2)"""
    pressure: np.ndarray
    """(N, B) gauge."""
    tubes: list[list[np.ndarray]]
    """(N,) lines (n, 2) each."""
    inlets: np.ndarray
    """(I, 2)"""
    inlet_names: Sequence[str]
    inlet_pressure: np.ndarray
    """(N, I) gauge."""
    clamp: tuple[float, float]
    """Half width and height."""
    ground: np.ndarray | None
    """(n, 2) the line that may be touched."""
    feet: np.ndarray
    """(N, k, 2) the round feet that touch it; none where the tip is a point."""


def draw_shapes(trajectory: Trajectory, path: Target) -> None:
    """Instants at one scale with bellows, tubes and inlets, a scale bar and a colour bar."""
    width = look().across(IN.width)
    foot = IN.foot_height + (0.0 if width >= IN.least_width else 0.24)
    snapshots = _snapshots(
        trajectory, MAX_SNAPSHOTS if width >= IN.least_width else NARROW_SNAPSHOTS
    )
    strip = arrange(_frames(snapshots), 1e3 * trajectory.length, width - 2 * IN.side)
    ground = ground_of(trajectory)
    note = 0.0 if ground is None else NOTE_ROOM
    height = foot + strip.height + note + head_room(trajectory, width)
    with picture(path, width, height) as made:
        axes = axes_at(made, IN.side, foot, width - 2 * IN.side, strip.height)
        wide, high = (width - 2 * IN.side) / strip.scale, strip.height / strip.scale
        axes.set(xlim=(0, wide), ylim=(high, 0))
        axes.set_axis_off()
        colours, norm, occurring = pressure_colours(
            np.hstack([extremes(trajectory.pressure), extremes(trajectory["inlet_pressure"])])
        )
        _draw_tubes(axes, snapshots, strip, colours, norm)
        _draw_snapshots(axes, snapshots, strip, colours, norm)
        _draw_ground(axes, snapshots, strip)
        _draw_labels(axes, snapshots, strip)
        _draw_sides(axes, snapshots, strip)
        _draw_scale(made, strip)
        _draw_bar(made, ScalarMappable(norm, colours), occurring, width)
        if ground is not None:
            level = foot + strip.height + 0.08
            draw_note(made, f"dashed: {ground_words(ground)}", IN.side, level)
        head(made, trajectory, "shapes and gauge pressures", IN.side)


def _snapshots(trajectory: Trajectory, count: int) -> Snapshots:
    instants = spread_instants(trajectory, count, pressures=True)
    axis, rows = trajectory.shape[instants] * 1e3, trajectory.shape_rows[instants]
    widths = 1e3 * section_widths(trajectory)
    width = float(widths.max())
    blocks = bellow_blocks(axis, trajectory.arc, trajectory.bellows, widths)
    tubes = tube_ends(trajectory, scene_of(trajectory))
    inlets = inlet_places(trajectory.inlets, tubes, width)
    drawn = tubes if len(tubes) <= MAX_TUBE_LINES else []
    ground, reach = ground_of(trajectory), float(np.ptp(axis)) + width
    return Snapshots(
        time_labels(trajectory.time[rows]),
        axis,
        blocks,
        trajectory.pressure[rows] / 1e3,
        [tube_lines(own, trajectory.bellows, inlets, drawn, width) for own in blocks],
        np.array(list(inlets.values())),
        trajectory.inlets,
        trajectory["inlet_pressure"][rows] / 1e3,
        (0.7 * width, 0.14 * width),
        None if ground is None else 1e3 * ground_outline(ground, 1e-3 * reach),
        np.zeros((0, 2, 2)) if ground is None else 1e3 * feet(ground, 1e-3 * axis[:, -1]),
    )


def _frames(snapshots: Snapshots) -> list[Frame]:
    """The room that each snapshot takes about the middle of its clamp."""
    half, hatch = snapshots.clamp
    found = []
    for blocks, tubes in zip(snapshots.blocks, snapshots.tubes, strict=True):
        points = np.concatenate([blocks.reshape(-1, 2), *tubes, snapshots.inlets])
        low = np.minimum(points.min(axis=0), (-half, -hatch)) - (0.0, INLET_MARK * half)
        high = np.maximum(points.max(axis=0), (half, 0.0))
        found.append(Frame(*low.tolist(), *high.tolist()))
    return found


def time_labels(times: np.ndarray) -> list[str]:
    """Times with as few equal decimals as tell them apart and round off little."""
    for decimals in range(4):
        labels = [f"{time:.{decimals}f}" for time in times]
        close = np.abs(np.array([float(label) for label in labels]) - times)
        if len(set(labels)) == len(labels) and np.all(close <= 0.002 * np.ptp(times)):
            return [f"t = {label} s" for label in labels]
    enough = (n for n in range(3, 17) if len({f"{t:.{n}g}" for t in times}) == len(times))
    digits = next(enough, 17)
    return [f"t = {time:.{digits}g} s" for time in times]


def _draw_tubes(
    axes: Axes, snapshots: Snapshots, strip: Strip, colours: Colormap, norm: Normalize
) -> None:
    """Tubes as lines behind the bellows, inlets as triangles; the first ones are named."""
    origin = np.array(strip.origins)
    lines = [own + origin[n] for n, tubes in enumerate(snapshots.tubes) for own in tubes]
    axes.add_collection(
        LineCollection(lines, colors=look().ink, linewidths=0.6, zorder=0.9, clip_on=False)
    )
    places = (snapshots.inlets + origin[:, None]).reshape(-1, 2)
    size = 2 * INLET_MARK * snapshots.clamp[0] * strip.scale * POINTS_PER_INCH
    axes.scatter(
        places[:, 0], places[:, 1], c=snapshots.inlet_pressure.ravel(), cmap=colours, norm=norm,
        marker="v", s=size**2, edgecolors=look().ink, linewidths=0.5, zorder=3, clip_on=False,
    )  # fmt: skip
    if len(snapshots.inlets) > 1:
        return
    (x, z), half = places[0], snapshots.clamp[0]
    side = 1.0 if snapshots.inlets[0, 0] > 0 else -1.0
    axes.annotate(
        "inlet", (x + side * INLET_MARK * half, z), (2 * side, 0), textcoords="offset points",
        ha="left" if side > 0 else "right", va="center", fontsize=6.5, color=look().note,
    )  # fmt: skip


def _draw_snapshots(
    axes: Axes, snapshots: Snapshots, strip: Strip, colours: Colormap, norm: Normalize
) -> None:
    origin = np.array(strip.origins)
    many = snapshots.blocks.shape[1] > 2 * MAX_EDGED_SECTIONS
    blocks = (snapshots.blocks + origin[:, None, None]).reshape(-1, 4, 2)
    shown = PolyCollection(
        list(blocks),
        cmap=colours,
        norm=norm,
        edgecolors="face" if many else look().ink,
        linewidths=0.3,
    )
    shown.set_clip_on(False)
    shown.set_array(snapshots.pressure.ravel())
    axes.add_collection(shown)
    half, hatch = snapshots.clamp
    strokes = (clamp_strokes(half, hatch, 9) + origin[:, None, None]).reshape(-1, 2, 2)
    plates = origin[:, None] + np.array([(-half, 0.0), (half, 0.0)])
    bent = snapshots.axis + origin[:, None]
    for lines, pen in ((strokes, 0.5), (plates, 1.4), (bent, 0.9)):
        axes.add_collection(
            LineCollection(list(lines), colors=look().ink, linewidths=pen, clip_on=False)
        )


def _draw_ground(axes: Axes, snapshots: Snapshots, strip: Strip) -> None:
    """The part of the ground's line that lies within the room of each snapshot."""
    if snapshots.ground is None:
        return
    for frame, origin in zip(_frames(snapshots), strip.origins, strict=True):
        shifted = snapshots.ground + np.array(origin)
        line = axes.plot(*shifted.T, color=look().accent, lw=1.0, ls=(0, (6, 2)), zorder=4)[0]
        corner = (origin[0] + frame.left, origin[1] + frame.top)
        size = (frame.right - frame.left, frame.bottom - frame.top)
        line.set_clip_path(Rectangle(corner, *size, transform=axes.transData))
    rings = [own + np.array(at) for own, at in zip(snapshots.feet, strip.origins, strict=False)]
    axes.add_collection(
        LineCollection(rings, colors=look().accent, linewidths=0.9, zorder=4.5, clip_on=False)
    )


def _draw_labels(axes: Axes, snapshots: Snapshots, strip: Strip) -> None:
    for label, (x, _), top in zip(snapshots.labels, strip.origins, strip.label_levels, strict=True):
        axes.text(x, top, label, ha="center", va="center", fontsize=8.5)


def _draw_sides(axes: Axes, snapshots: Snapshots, strip: Strip) -> None:
    """Name the columns of the first snapshot."""
    axis = snapshots.axis[0]
    along = axis[-1] - axis[-2]
    along = along / max(float(np.hypot(*along)), 1e-300)
    across = np.array((along[1], -along[0]))
    step = 0.09 / strip.scale
    for name, sign in (("L", -1.0), ("R", 1.0)):
        place = axis[-1] + along * step + sign * across * snapshots.clamp[0] * 0.4
        x, z = place + strip.origins[0]
        axes.text(x, z, name, ha="center", va="center", fontsize=7, color=look().note)


def _draw_scale(made: Figure, strip: Strip) -> None:
    """A bar of 20 mm, or of another round length where that is out of proportion."""
    length = scale_length(strip.scale)
    axes = axes_at(made, IN.side, 0.2, 2.0, 0.3)
    axes.set(xlim=(0, 2.0 / strip.scale), ylim=(0, 1))
    axes.set_axis_off()
    axes.plot([0, length], [0.25, 0.25], color=look().ink, lw=2.4, solid_capstyle="butt")
    axes.text(0, 0.4, f"{length:g} mm", fontsize=8, va="bottom")


def scale_length(scale: float) -> float:
    """20 mm if that is between 0.2 and 1.2 inch at ``scale`` [inch/mm], else near 0.6 inch."""
    if 0.2 <= 20 * scale <= 1.2:
        return 20.0
    rounds: Sequence[float] = [m * 10.0**e for e in range(-6, 7) for m in (1, 2, 5)]
    return min(rounds, key=lambda length: abs(np.log(length * scale / 0.6)))


def _draw_bar(
    made: Figure, mapped: ScalarMappable, occurring: tuple[float, float], width: float
) -> None:
    """The part of the colours that occurs, lying in the foot."""
    words = channel("pressure").label
    left = 2.6 if width >= IN.least_width else 1.35
    cax = axes_at(made, left, 0.38, width - left - IN.side - 0.1, 0.11)
    bar = made.colorbar(mapped, cax=cax, orientation="horizontal")
    cax.set_xlim(*occurring)
    cax.tick_params(labelsize=7.5, length=2.5, pad=1.5)
    cax.locator_params(axis="x", nbins=max(3, int(2 * (width - left))))
    bar.outline.set_visible(False)
    high = made.get_figheight()
    if width >= IN.least_width:
        made.text(2.5 / width, 0.435 / high, words, ha="right", va="center", fontsize=8)
    else:
        made.text(left / width, 0.55 / high, words, fontsize=8)
