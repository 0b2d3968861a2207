"""`plan.png`: what is wanted of a pump, what it can do, and the tip's path with both."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.lines import Line2D

from viscodesign.pump.planning.result import PumpPlan
from viscodesign.report.layout.style import (
    ACCENT,
    GREY,
    INK,
    axes_at,
    head,
    head_room,
    picture,
    shown,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLOURS = ("#0072b2", "#e69f00", "#009e73", "#cc79a7")
"""Okabe-Ito; inlets beyond the fourth take them again, dashed."""
DASHES = ("-", "--", ":", "-.")
LEFT, BOTTOM, WIDE, TALL, GAP = 0.78, 0.5, 4.0, 1.25, 0.16
SQUARE_LEFT = LEFT + WIDE + 0.95
SQUARE = 2.9
WIDTH = SQUARE_LEFT + SQUARE + 0.2
LEGEND = 0.28
HEIGHT = BOTTOM + 4 * TALL + 3 * GAP + LEGEND
"""All in inches."""
LEAD_SHOWN = 0.2
"""Of the run: the part of a lead-in that is drawn at most."""
WANTED: dict[str, Any] = {"lw": 3.2, "alpha": 0.4, "solid_capstyle": "butt"}
DONE: dict[str, Any] = {"lw": 1.2}
BEYOND = 0.25
"""How far, in parts of a limit's range, a curve is followed beyond it."""


@dataclass(frozen=True)
class Panel:
    """One quantity against time."""

    label: str
    field: str
    factor: float
    marks: tuple[tuple[str, float], ...]
    """Levels with their names."""
    most: tuple[float, float] | None = None
    """Range beyond which nothing is drawn."""
    shows: float = 0.0
    """A mark is brought into the picture where a curve comes to this part of it."""


def draw_plan(plan: PumpPlan, path: Path) -> None:
    """Four panels against time; beside them the tip's paths."""
    panels = _panels(plan)
    room = head_room(plan.wanted_run, WIDTH)
    with picture(path, WIDTH, HEIGHT + room) as made:
        for k, panel in enumerate(panels):
            bottom = BOTTOM + (len(panels) - 1 - k) * (TALL + GAP)
            axes = axes_at(made, LEFT, bottom, WIDE, TALL)
            _draw_panel(axes, plan, panel)
            axes.tick_params(labelbottom=k == len(panels) - 1)
            if k == len(panels) - 1:
                axes.set_xlabel("time [s], lead-in before 0")
        top = BOTTOM + 4 * TALL + 3 * GAP
        _draw_tips(axes_at(made, SQUARE_LEFT, top - SQUARE, SQUARE, SQUARE), plan)
        _draw_words(made, plan, top - SQUARE - 0.62)
        _draw_legend(made, plan, top)
        head(made, plan.wanted_run, f"pump plan, {_judgement(plan)}", LEFT)


def _judgement(plan: PumpPlan) -> str:
    faults = list(dict.fromkeys(v.name for v in plan.verdicts if v.severity == "infeasible"))
    return f"infeasible ({', '.join(faults)})" if faults else "feasible"


def _panels(plan: PumpPlan) -> tuple[Panel, ...]:
    limits, numbers = plan.limits, list(plan.numbers.values())
    low, high = limits["travel_low_counts"], limits["travel_high_counts"]
    margin = BEYOND * (high - low)
    flow = 1e6 * max(n["no_load_flow_m3_s"] for n in numbers)
    cap = limits["cap_pa_gauge"] / 1e3
    return (
        Panel("pressure\n[kPa gauge]", "pressure", 1e-3, (("cap", cap),)),
        Panel(
            "servo\n[counts]",
            "count",
            1.0,
            (("travel", low), ("travel", high)),
            (low - margin, high + margin),
        ),
        Panel("flow of the\nplunger [mL/s]", "flow", 1e6, (), (-1.2 * flow, 1.2 * flow)),
        Panel(
            "torque [% of\nits stall]",
            "stall_share",
            100.0,
            (("a fifth: advice", 20.0), ("stall", 100.0)),
            (0.0, 160.0),
            0.5,
        ),
    )


def _draw_panel(axes: Axes, plan: PumpPlan, panel: Panel) -> None:
    begin, end = _span(plan)
    low, high = np.inf, -np.inf
    for course, style in ((plan.wanted, WANTED), (plan.achievable, DONE)):
        time = course.time - course.lead_s
        inside = time >= begin
        values = getattr(course, panel.field) * panel.factor
        for k in range(len(plan.inlets)):
            _curve(axes, time, values[:, k], k, panel.field == "flow", style)
        low, high = min(low, values[inside].min()), max(high, values[inside].max())
    if panel.most is not None:
        low, high = max(low, panel.most[0]), min(high, panel.most[1])
    for _, level in panel.marks:
        if panel.shows and high >= panel.shows * level:
            high = max(high, level)
    margin = 0.08 * (high - low) or 0.1 * abs(high) or 1.0
    axes.set(xlim=(begin, end), ylim=(low - margin, high + margin))
    axes.set_ylabel(panel.label, fontsize=8, labelpad=4)
    axes.yaxis.set_label_coords(-0.115, 0.5)
    axes.grid(color="#e6e6e6", lw=0.6)
    axes.set_axisbelow(True)
    if begin < 0.0:
        axes.axvspan(begin, 0.0, color="#f2f2f2", zorder=0)
    for name, level in panel.marks:
        _mark(axes, name, level, (low - margin, high + margin))


def _span(plan: PumpPlan) -> tuple[float, float]:
    """Times that are drawn, from the end of the lead-in on and a part of it [s]."""
    duration = float(plan.wanted_run.time[-1])
    return -min(plan.wanted.lead_s, LEAD_SHOWN * duration), duration


def _curve(
    axes: Axes,
    time: np.ndarray,
    values: np.ndarray,
    k: int,
    stepped: bool,
    style: dict[str, Any],
) -> None:
    axes.plot(
        time, values, color=COLOURS[k % len(COLOURS)],
        ls=DASHES[k // len(COLOURS) % len(DASHES)],
        drawstyle="steps-post" if stepped else "default", **style,
    )  # fmt: skip


def _mark(axes: Axes, name: str, level: float, limits: tuple[float, float]) -> None:
    """A level with its name, where it is in the picture."""
    if not limits[0] < level < limits[1]:
        return
    axes.axhline(level, color=ACCENT, lw=0.9, ls=(0, (6, 2)), zorder=4)
    upper = level > (limits[0] + limits[1]) / 2
    axes.annotate(
        name, xy=(1, level), xycoords=("axes fraction", "data"),
        xytext=(-2, -1.5 if upper else 1.5), textcoords="offset points", ha="right",
        va="top" if upper else "bottom", fontsize=7, color="#8a3d00",
        bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.7, "pad": 0.5}, zorder=5,
    )  # fmt: skip


def _draw_tips(axes: Axes, plan: PumpPlan) -> None:
    """Both paths in mm with equal axes, z downwards as the actuator hangs."""
    paths = [1e3 * run.tip[:, :2] for run in (plan.wanted_run, plan.achievable_run)]
    styles: tuple[dict[str, Any], ...] = (
        {"lw": 4.0, "alpha": 0.45, "color": GREY},
        {"lw": 1.3, "color": INK},
    )
    for points, style in zip(paths, styles, strict=True):
        axes.plot(*points.T, solid_joinstyle="round", **style)
        axes.plot(*points[0], marker="o", ms=4, color=style["color"], zorder=4)
    both = np.concatenate(paths)
    centre = (both.min(axis=0) + both.max(axis=0)) / 2
    half = max(float(np.max(np.ptp(both, axis=0))) * 0.56, 0.5)
    axes.set(xlim=(centre[0] - half, centre[0] + half), ylim=(centre[1] + half, centre[1] - half))
    axes.set(xlabel="x of the tip [mm]", ylabel="z of the tip [mm], down from the clamp")
    axes.grid(color="#e6e6e6", lw=0.6)
    axes.set_axisbelow(True)
    axes.ticklabel_format(style="plain", useOffset=False)


def _draw_words(made: Figure, plan: PumpPlan, top: float) -> None:
    """How far the paths are apart, and how accurate that is."""
    error = plan.error_m
    total = "unknown" if error is None else f"{1e3 * error:.2g} mm"
    lines = [
        f"tips apart by up to {1e3 * plan.deviation_m:.3g} mm",
        f"(errors of both runs: {total})",
        f"dots: t = 0, after {plan.wanted.lead_s:.4g} s of lead-in from home",
        *(f"cut off: {words}" for words in plan.clipped),
    ]
    across, up = made.get_size_inches()
    text = "\n".join(shown(line, 58) for line in lines[:6])
    made.text((SQUARE_LEFT - 0.45) / across, top / up, text, size=8, va="top", linespacing=1.35)


def _draw_legend(made: Figure, plan: PumpPlan, top: float) -> None:
    handles = [
        Line2D([], [], color=COLOURS[0], label="wanted", **WANTED),
        Line2D([], [], color=COLOURS[0], label="achievable", **DONE),
    ]
    if len(plan.inlets) > 1:
        handles += [
            Line2D(
                [], [], color=COLOURS[k % len(COLOURS)], lw=2,
                ls=DASHES[k // len(COLOURS) % len(DASHES)], label=shown(name, 14),
            )
            for k, name in enumerate(plan.inlets)
        ]  # fmt: skip
    width, height = made.get_size_inches()
    made.legend(
        handles=handles[:8], loc="lower left", ncols=8, handlelength=2.2, borderaxespad=0,
        columnspacing=1.4, bbox_to_anchor=(LEFT / width, (top + 0.07) / height),
    )  # fmt: skip
