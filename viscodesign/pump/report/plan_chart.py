"""`plan.png`: what is wanted of a pump, what it can do, and the tip's path with both."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from viscodesign.pump.planning.result import Panel, PumpPlan
from viscodesign.report.charts.compare import frame_about
from viscodesign.report.layout.look import look
from viscodesign.report.layout.motion_lines import LINE_STYLES
from viscodesign.report.layout.style import axes_at, head, head_room, picture, shown
from viscodesign.results.channels import channel

# isort: split
from matplotlib.lines import Line2D

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LEFT, BOTTOM, WIDE, GAP, SQUARE = 0.78, 0.5, 4.0, 0.16, 2.9
BETWEEN, RIGHT, WORDS, LEGEND = 0.95, 0.2, 1.2, 0.28
PANELS = 5.48
MIN_WIDTH = 6.4
"""All in inches: the least width with the tip's paths on the right; else they are below."""
MAX_ENTRIES = 8
"""Largest number of entries of the key."""
SAME_PATH_MM = 1e-3
"""Distance of tips up to which two actuators move alike."""
LEAD_SHOWN = 0.2
"""Largest part of a lead-in that is drawn, as a share of the run."""
WANTED: dict[str, Any] = {"lw": 3.2, "alpha": 0.4, "solid_capstyle": "butt"}
DONE: dict[str, Any] = {"lw": 1.2}


def draw_plan(plan: PumpPlan, path: Path) -> None:
    """Panels against time; beside them the tip's paths."""
    width = look().across(LEFT + WIDE + BETWEEN + SQUARE + RIGHT)
    free = width - LEFT - RIGHT
    if width >= MIN_WIDTH:
        wide, base = (free - BETWEEN) * WIDE / (WIDE + SQUARE), BOTTOM
        side = min(free - BETWEEN - wide, PANELS - WORDS)
        wide = free - BETWEEN - side
        left, bottom = LEFT + wide + BETWEEN, BOTTOM + PANELS - side
    else:
        wide, side, left, bottom = free, min(SQUARE, free), LEFT, WORDS + BOTTOM
        base = bottom + side + 2 * GAP + BOTTOM
    top, columns = base + PANELS, min(8, int(free))
    legend = LEGEND * -(-(2 + len(_named_inlets(plan))) // columns)
    with picture(path, width, top + legend + head_room(plan.wanted_run, width)) as made:
        panels = plan.panels
        tall = (PANELS + GAP) / len(panels) - GAP
        for k, panel in enumerate(panels):
            axes = axes_at(made, LEFT, top - (k + 1) * tall - k * GAP, wide, tall)
            _draw_panel(axes, plan, panel)
            axes.yaxis.set_label_coords(-0.46 / wide, 0.5)
            axes.tick_params(labelbottom=k == len(panels) - 1)
        axes.set_xlabel("time [s], lead-in before 0")
        _draw_tips(axes_at(made, left, bottom, side, side), plan)
        _draw_words(made, plan, left - 0.45, bottom - 0.62)
        _draw_legend(made, plan, top + 0.07, columns)
        faults = ", ".join(dict.fromkeys(v.name for v in plan.infeasible))
        judgement = f"infeasible ({faults})" if faults else "feasible"
        head(made, plan.wanted_run, f"pump plan, {judgement}", LEFT)


def pump_colours() -> tuple[str, ...]:
    """Colours of inlets; those beyond the fourth take them again, dashed."""
    return look().models[:4]


def _draw_panel(axes: Axes, plan: PumpPlan, panel: Panel) -> None:
    end = float(plan.wanted_run.time[-1])
    begin = -min(plan.wanted.lead_s, LEAD_SHOWN * end)
    drawn = []
    for course, style in ((plan.wanted, WANTED), (plan.achievable, DONE)):
        time, values = course.time - course.lead_s, course.columns[panel.column] * panel.factor
        steps = "steps-post" if panel.column == "flow_m3_s" else "default"
        for k, column in enumerate(values.T):
            axes.plot(time, column, drawstyle=steps, **_line(k), **style)
        drawn.append(values[time >= begin])
    low, high = np.clip([np.min(drawn), np.max(drawn)], *panel.limits)
    high = max([high, *(level for _, level in panel.marks if high >= panel.shows * level)])
    margin = 0.08 * (high - low) or 0.1 * abs(high) or 1.0
    axes.set(xlim=(begin, end), ylim=(low - margin, high + margin))
    axes.set_ylabel(panel.label, fontsize=8, labelpad=4)
    axes.grid(color=look().grid, lw=0.6)
    axes.set_axisbelow(True)
    if begin < 0.0:
        axes.axvspan(begin, 0.0, color=look().shade, zorder=0)
    for name, level in panel.marks:
        if low - margin < level < high + margin:
            _mark(axes, name, level, upper=level > (low + high) / 2)


def _line(k: int) -> dict[str, Any]:
    """Colour and dashes of an inlet."""
    turn, k = divmod(k, len(pump_colours()))
    return {"color": pump_colours()[k], "ls": LINE_STYLES[turn % len(LINE_STYLES)]}


def _shared_colour(plan: PumpPlan) -> Any:
    """Colour of what belongs to no inlet of several: in the key, and of the tips."""
    return look().ink if len(plan.inlets) > 1 else pump_colours()[0]


def _mark(axes: Axes, name: str, level: float, *, upper: bool) -> None:
    """A level with its name."""
    axes.axhline(level, color=look().accent, lw=0.9, ls=(0, (6, 2)), zorder=4)
    axes.annotate(
        name, xy=(1, level), xycoords=("axes fraction", "data"),
        xytext=(-2, -1.5 if upper else 1.5), textcoords="offset points", ha="right",
        va="top" if upper else "bottom", fontsize=7, color=look().warning,
        bbox={"facecolor": look().ground, "edgecolor": "none", "alpha": 0.7, "pad": 0.5}, zorder=5,
    )  # fmt: skip


def _draw_tips(axes: Axes, plan: PumpPlan) -> None:
    """Both paths in mm with equal axes, z downwards as the actuator hangs."""
    colour, drawn = _shared_colour(plan), []
    for run, style in ((plan.wanted_run, WANTED), (plan.achievable_run, DONE)):
        for tip in plan.tips(run).values():
            drawn.append(1e3 * tip[:, :2])
            axes.plot(*drawn[-1].T, solid_joinstyle="round", color=colour, **style)
            alpha = style.get("alpha")
            axes.plot(*drawn[-1][0], marker="o", ms=4, color=colour, alpha=alpha, zorder=4)
    frame_about(axes, np.concatenate(drawn))
    down = f"{channel('tip_z').label}, down from the clamp"
    axes.set(xlabel=channel("tip_x").label, ylabel=down)
    axes.ticklabel_format(style="plain", useOffset=False)
    if plan.actuators:
        _name_paths(axes, dict(zip(plan.actuators, drawn, strict=False)))


def _name_paths(axes: Axes, paths: Mapping[str, np.ndarray]) -> None:
    """The names of several actuators, those of equal paths [mm] together, each at its own end."""
    named: dict[str, list[str]] = {}
    for name, points in paths.items():
        alike = (own for own in named if np.allclose(points, paths[own], atol=SAME_PATH_MM))
        named.setdefault(next(alike, name), []).append(name)
    for k, (first, names) in enumerate(named.items()):
        points, sign, axis = paths[first], (1, -1)[k % 2], k // 2 % 2
        end = points[int(np.argmax(sign * points[:, axis]))]
        axes.annotate(
            ", ".join(names), end, xytext=(0, 7 * (1 + k // 4)), textcoords="offset points",
            ha="right" if sign > 0 else "left", fontsize=7,
        )  # fmt: skip


def _draw_words(made: Figure, plan: PumpPlan, left: float, top: float) -> None:
    """How far the paths are apart, and how accurate that is."""
    total = "unknown" if plan.error_m is None else f"{1e3 * plan.error_m:.2g} mm"
    if plan.validity == "outside":
        total += ", outside of the model"
    lines = [
        f"tips apart by up to {1e3 * plan.deviation_m:.3g} mm",
        f"(errors of both runs: {total})",
        f"dots: t = 0, after {plan.wanted.lead_s:.4g} s of lead-in from home",
        *(f"cut off: {words}" for words in plan.clipped),
    ]
    text = "\n".join(shown(line, 58) for line in lines[:6])
    place = np.array([left, top]) / made.get_size_inches()
    made.text(place[0], place[1], text, size=8, va="top", linespacing=1.35)


def _named_inlets(plan: PumpPlan) -> tuple[str, ...]:
    """The inlets that the key names: as many as it holds, where there are several."""
    return plan.inlets[: MAX_ENTRIES - 2] if len(plan.inlets) > 1 else ()


def _draw_legend(made: Figure, plan: PumpPlan, bottom: float, columns: int) -> None:
    handles = [
        Line2D([], [], color=_shared_colour(plan), label="wanted", **WANTED),
        Line2D([], [], color=_shared_colour(plan), label="achievable", **DONE),
        *(
            Line2D([], [], lw=2, label=shown(name, 14), **_line(k))
            for k, name in enumerate(_named_inlets(plan))
        ),
    ]
    made.legend(
        handles=handles, loc="lower left", ncols=columns, handlelength=2.2, borderaxespad=0,
        columnspacing=1.4, bbox_to_anchor=tuple(np.array([LEFT, bottom]) / made.get_size_inches()),
    )  # fmt: skip
