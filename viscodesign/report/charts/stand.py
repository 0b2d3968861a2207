"""`stand.png`: height, sway limit and stiffness of a robot against its gauge pressure."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from viscodesign.report.layout.look import look
from viscodesign.report.layout.style import (
    Target,
    axes_at,
    draw_title,
    picture,
    shown,
    title_room,
)
from viscodesign.results.stand_study import StandStudy

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LEFT, BOTTOM, PANEL, HEIGHT, GAP, RIGHT, LEAST_PANEL = 0.7, 0.6, 2.4, 2.4, 0.75, 0.2, 1.4
"""All in inches; panels narrower than the least one stand one above the other."""


def draw_stand(study: StandStudy, path: Target) -> None:
    """Three panels: height, the weight from which on it sways, stiffness of a leg's tip."""
    width = look().across(LEFT + 3 * PANEL + 2 * GAP + RIGHT)
    panel = (width - LEFT - 2 * GAP - RIGHT) / 3
    places = [(LEFT + k * (panel + GAP), BOTTOM) for k in range(3)]
    if panel < LEAST_PANEL:
        panel = width - LEFT - RIGHT
        places = [(LEFT, BOTTOM + k * (HEIGHT + BOTTOM)) for k in (2, 1, 0)]
    with picture(path, width, places[0][1] + HEIGHT + title_room()) as made:
        panels = [axes_at(made, *place, panel, HEIGHT) for place in places]
        _curve(panels[0], study, "height_m", 1e3, "height of the hips [mm]")
        _curve(panels[1], study, "sway_limit_n", 1.0, "weight that the legs bear [N]")
        _curve(panels[2], study, "tip_stiffness_n_per_m", 1.0, "stiffness of a tip across [N/m]")
        panels[1].axhline(study.own.weight_n, color=look().accent, lw=1.0, ls="--")
        panels[1].annotate(
            "weight", (1, study.own.weight_n), xycoords=("axes fraction", "data"),
            ha="right", va="bottom", size=8, color=look().warning,
        )  # fmt: skip
        words = "how it stands, by the gauge pressure of its legs"
        draw_title(made, f"{shown(study.name, 60)}: {words}", LEFT)


def _curve(axes: Axes, study: StandStudy, name: str, factor: float, label: str) -> None:
    rows = sorted((*study.by_gauge, study.own), key=lambda row: row.gauge_pressure_pa)
    gauge = np.array([1e-3 * row.gauge_pressure_pa for row in rows])
    values = np.array([factor * getattr(row, name) for row in rows])
    axes.axvline(1e-3 * study.own.gauge_pressure_pa, color=look().faint, lw=0.9)
    axes.plot(gauge, values, color=look().ink, lw=1.6)
    axes.plot(
        1e-3 * study.own.gauge_pressure_pa, factor * getattr(study.own, name), "o", color=look().ink
    )
    low = float(np.nanmin(values, initial=0.0))
    axes.set(xlabel="gauge pressure [kPa]", ylabel=label, ylim=(low, None))
