"""`walk.png`: the body's way, what the feet do and bear, and the pumps, over the last cycles."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.layout.look import look
from viscodesign.report.layout.motion_lines import LINE_STYLES
from viscodesign.report.layout.style import (
    Target,
    axes_at,
    draw_title,
    picture,
    shown,
    title_room,
)
from viscodesign.results.robot_motion import RobotMotion
from viscodesign.results.walk_study import WalkStudy

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True)
class WalkLayout:
    """Lengths of the picture [inch]."""

    left: float = 0.8
    bottom: float = 0.55
    width: float = 6.4
    panel: float = 1.15
    gap: float = 0.16
    right: float = 0.9


IN = WalkLayout()
SHOWN_CYCLES = 2


def leg_colours(motion: RobotMotion) -> dict[str, str]:
    """A colour for each leg."""
    curves = look().curves
    return {name: curves[k % len(curves)] for k, name in enumerate(motion.legs)}


def draw_walk(study: WalkStudy, path: Target) -> None:
    """Panels one above the other, with a common time."""
    panels: tuple[Callable[[Axes, RobotMotion, slice], None], ...] = (
        *(_advance, _gaps, _normal_forces, _friction, _pumps),
    )
    width = look().across(IN.left + IN.width + IN.right)
    height = IN.bottom + len(panels) * (IN.panel + IN.gap) + title_room()
    with picture(path, width, height) as made:
        motion = study.motion
        rows = _last_cycles(motion)
        for k, draw in enumerate(panels):
            bottom = IN.bottom + (len(panels) - 1 - k) * (IN.panel + IN.gap)
            axes = axes_at(made, IN.left, bottom, width - IN.left - IN.right, IN.panel)
            draw(axes, motion, rows)
            axes.set_xlim(motion.time[rows][0], motion.time[rows][-1])
            axes.tick_params(labelbottom=k == len(panels) - 1)
        axes.set_xlabel("time [s]")
        draw_title(made, f"{shown(study.name, 40)}: {_words(study)}", IN.left)


def _words(study: WalkStudy) -> str:
    if study.refusal:
        return "no speed is stated"
    way = "forward" if study.advance_per_cycle_m > 0 else "backward"
    advance = f"{1e3 * abs(study.advance_per_cycle_m):.3g} mm a cycle {way}"
    return f"{advance}, {study.speed_body_lengths_per_s:.2g} body lengths a second"


def _last_cycles(motion: RobotMotion) -> slice:
    begin = motion.time[-1] - SHOWN_CYCLES * motion.period * (1 + 1e-9)
    return slice(int(np.searchsorted(motion.time, begin)), None)


def _advance(axes: Axes, motion: RobotMotion, rows: slice) -> None:
    axes.plot(motion.time[rows], 1e3 * motion.body[rows, 0], color=look().ink, lw=1.5)
    axes.set_ylabel("body x [mm]")


def _gaps(axes: Axes, motion: RobotMotion, rows: slice) -> None:
    _by_leg(axes, motion, rows, 1e3 * motion.feet[:, :, 1])
    axes.set_ylabel("lift [mm]")
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))


def _normal_forces(axes: Axes, motion: RobotMotion, rows: slice) -> None:
    _by_leg(axes, motion, rows, motion.normal)
    axes.set_ylabel("normal [N]")


def _friction(axes: Axes, motion: RobotMotion, rows: slice) -> None:
    _by_leg(axes, motion, rows, motion.friction)
    axes.axhline(0.0, color=look().grey, lw=0.8)
    axes.set_ylabel("friction [N]")


def _by_leg(axes: Axes, motion: RobotMotion, rows: slice, values: np.ndarray) -> None:
    for k, (name, colour) in enumerate(leg_colours(motion).items()):
        axes.plot(motion.time[rows], values[rows, k], color=colour, lw=1.1, label=shown(name, 10))


def _pumps(axes: Axes, motion: RobotMotion, rows: slice) -> None:
    for k, name in enumerate(motion.sources):
        style, volume = LINE_STYLES[k % len(LINE_STYLES)], 1e6 * motion.barrel[rows, k]
        axes.plot(motion.time[rows], volume, color=look().accent, ls=style, label=shown(name, 10))
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    axes.set_ylabel("barrel [mL]")
