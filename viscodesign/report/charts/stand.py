"""`stand.png`: height, sway limit and stiffness of a robot by gauge pressure and by payload."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.layout.look import look
from viscodesign.report.layout.style import (
    Target,
    axes_at,
    draw_title,
    picture,
    shown,
    title_room,
)
from viscodesign.results.stand_study import StanceRow, StandStudy

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True)
class StandLayout:
    """Lengths of the picture [inch].

    Panels narrower than the least one stand one above the other.
    """

    left: float = 0.7
    bottom: float = 0.6
    panel: float = 2.4
    height: float = 2.0
    gap: float = 0.75
    right: float = 0.2
    least_panel: float = 1.4


IN = StandLayout()
QUANTITIES = (
    ("height_m", 1e3, "height of the hips [mm]"),
    ("sway_limit_n", 1.0, "weight that the legs bear [N]"),
    ("tip_stiffness_n_per_m", 1.0, "stiffness of a tip across [N/m]"),
)
"""Of a row: its name, its factor to the unit of the picture, and the label."""
BEARS = 1
"""The panel of the weight that the legs bear."""


@dataclass(frozen=True)
class _StandTable:
    """Rows of a study and what they go by."""

    rows: Sequence[StanceRow]
    name: str
    factor: float
    label: str

    def along(self, row: StanceRow) -> float:
        """Where a row is drawn."""
        return self.factor * float(getattr(row, self.name))


def draw_stand(study: StandStudy, path: Target) -> None:
    """Height, the weight from which on it sways, and stiffness of a leg's tip.

    Three panels by the gauge pressure of the legs, and three by payload.
    """
    width = look().across(IN.left + 3 * IN.panel + 2 * IN.gap + IN.right)
    panel = (width - IN.left - 2 * IN.gap - IN.right) / 3
    tables = [_by_gauge(study), _by_payload(study)]
    across = 3 if panel >= IN.least_panel else 1
    if across == 1:
        panel = width - IN.left - IN.right
    count = len(tables) * len(QUANTITIES)
    high = count // across
    step = IN.height + IN.bottom
    with picture(path, width, high * step + title_room()) as made:
        for k in range(count):
            place = (
                IN.left + k % across * (panel + IN.gap),
                IN.bottom + (high - 1 - k // across) * step,
            )
            axes = axes_at(made, *place, panel, IN.height)
            _curve(axes, study, tables[k // len(QUANTITIES)], k % len(QUANTITIES))
        words = "how it stands, by the gauge pressure of its legs and by payload"
        draw_title(made, f"{shown(study.name, 60)}: {words}", IN.left)


def _by_gauge(study: StandStudy) -> _StandTable:
    return _StandTable(study.by_gauge, "gauge_pressure_pa", 1e-3, "gauge pressure [kPa]")


def _by_payload(study: StandStudy) -> _StandTable:
    return _StandTable(study.by_payload, "payload_kg", 1e3, "payload [g]")


def _curve(axes: Axes, study: StandStudy, table: _StandTable, k: int) -> None:
    """A quantity of all rows, with the spec's own one marked."""
    name, factor, label = QUANTITIES[k]
    rows = sorted((*table.rows, study.own), key=table.along)
    places = np.array([table.along(row) for row in rows])
    values = np.array([factor * getattr(row, name) for row in rows])
    own = table.along(study.own)
    axes.axvline(own, color=look().faint, lw=0.9)
    axes.plot(places, values, color=look().ink, lw=1.6)
    at = own, factor * getattr(study.own, name)
    axes.plot(*at, "o", color=look().ink, clip_on=False)
    if k == BEARS:
        axes.plot(places, [row.weight_n for row in rows], color=look().accent, lw=1.0, ls="--")
        axes.annotate(
            "weight", (1, rows[-1].weight_n), xycoords=("axes fraction", "data"),
            ha="right", va="bottom", size=8, color=look().warning,
        )  # fmt: skip
    low = float(np.nanmin(values, initial=0.0))
    axes.set(xlabel=table.label, ylabel=label, ylim=(low, None))
