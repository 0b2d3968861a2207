"""A scene's timescales, verdicts and warnings as lines for people."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from viscodesign.cli.text import blocks, number, table, wrap
from viscodesign.trajectory import Classification, Notice, Verdict

TIMES = {
    "t_s": "elastic-inertial time of the solid",
    "t_f": "viscous-elastic time of the fluid",
    "t_i": "shortest swing of the inlet pressure",
    "t_net": "slowest time constant of the network",
}
RATIOS = {
    "ts_over_tf": ("t_s/t_f", "above 1: uniform pressure; below: a distribution"),
    "ts_over_ti": ("t_s/t_i", "above 1: the solid's inertia matters; below: quasi-static"),
    "tnet_over_ti": ("t_net/t_i", "far above 1: the far bellows never move; far below: uniform"),
}


def quadrant_lines(found: Classification) -> list[str]:
    """The verdict of Figure 1's plane in one paragraph."""
    return wrap(f"{found.name}: quadrant {found.quadrant}, {found.meaning}", hanging="  ")


def scale_lines(found: Classification) -> list[str]:
    """Times and ratios, one a line, with what they say."""
    scales = found.scales
    seconds = {"t_s": scales.t_s, "t_f": scales.t_f, "t_i": scales.t_i, "t_net": scales.t_net}
    rows = [(name, number(seconds[name], "s"), meaning) for name, meaning in TIMES.items()]
    for key, (name, meaning) in RATIOS.items():
        rows.append((name, number(scales.ratios[key]), meaning))
    rows.append(("cut-off", number(found.cutoff_frequency_hz, "Hz"), "order of magnitude, 10/t_f"))
    return ["timescales", *table(rows)]


def verdict_lines(effects: Sequence[Verdict]) -> list[str]:
    """Every effect: what the spec asks, what was decided, its weight; then why."""
    rows = [("effect", "mode", "verdict", "weight", "formula")]
    for v in effects:
        decision = "taken" if v.taken else "left out"
        rows.append((v.name, v.mode, decision, number(v.weight), v.formula))
    heading, *bodies = blocks(rows)
    lines = ["effects", *heading]
    for body, verdict in zip(bodies, effects, strict=True):
        lines += [*body, *wrap(verdict.reason, "      ")]
    return lines


def notice_lines(notices: Iterable[Notice]) -> list[str]:
    """Every code once, as a run may warn at many places and times; then how many more."""
    first: dict[str, Notice] = {}
    count: dict[str, int] = {}
    for notice in notices:
        first.setdefault(notice.code, notice)
        count[notice.code] = count.get(notice.code, 0) + 1
    lines: list[str] = []
    for code, notice in first.items():
        lines += wrap(f"{code}: {notice_text(notice)}{_more(count[code] - 1)}", "  ", "    ")
    return lines


def full_notice_lines(notices: Iterable[Notice]) -> list[str]:
    """Every notice in full: before a run there are few, and each says something else."""
    texts = dict.fromkeys(f"{notice.code}: {notice_text(notice)}" for notice in notices)
    return [line for text in texts for line in wrap(text, "  ", "    ")]


def notice_text(notice: Notice) -> str:
    """A notice's message, with place and time where it has them."""
    instant = f"t = {notice.time_s:.4g} s" if notice.time_s is not None else ""
    spot = ", ".join(part for part in (notice.where, instant) if part)
    return f"{notice.message} ({spot})" if spot else notice.message


def _more(others: int) -> str:
    if others <= 0:
        return ""
    return f" [and {others} more of this kind]"


def percent(part: float, whole: float) -> str:
    """A share in percent, to two digits."""
    return f"{100 * part / whole:.2g} %" if whole and math.isfinite(part) else "unknown"
