"""A scene's timescales, verdicts and warnings as lines for people."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from viscodesign.cli.texts.layout import blocks, number, table, wrap
from viscodesign.results.findings import Classification, EffectAblation, Notice, Verdict

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

SMALLEST_MM = 1e-6
SMALLEST_PERCENT = 0.001
LARGEST_PERCENT = 1000
"""Beyond them a number is told by its bound."""


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
    """A table of the decisions, one effect a line; then every reason.

    Taken ones come first, those that do nothing to the tip last.
    """
    told = sorted(effects, key=lambda v: (not v.taken, v.contribution_m == 0.0))
    rows = [("effect", "verdict", "mode", "tip [mm]", "of budget", "weight")]
    rows += [
        (v.name, decision(v), v.mode, millimetres(v.contribution_m), share(v.budget_share),
         number(v.weight)) for v in told
    ]  # fmt: skip
    caption = "effects: how far each alone moves the tip, also in parts of the error asked for"
    return [*wrap(caption, hanging="  "), *table(rows), "", "why", *_reason_lines(told)]


def _reason_lines(effects: Sequence[Verdict]) -> list[str]:
    heads = blocks([(v.name, f"weight = {v.formula}") for v in effects])
    lines: list[str] = []
    for head, verdict in zip(heads, effects, strict=True):
        lines += [*head, *wrap(verdict.reason, "      ")]
    return lines


def decision(found: Verdict | EffectAblation) -> str:
    """Whether a run has the effect."""
    if isinstance(found, Verdict) and not found.present:
        return "absent"
    return "taken" if found.taken else "left out"


def millimetres(length: float) -> str:
    """A distance at the tip [m] as a number of mm, without the unit."""
    if 0.0 < length < 1e-3 * SMALLEST_MM:
        return f"< {SMALLEST_MM:.0e}"
    return number(1e3 * length)


def share(part: float) -> str:
    """A part of the error asked for in percent, as far as a percentage says something."""
    if math.isinf(part):
        return "needed"
    percentage = 100 * part
    if percentage > LARGEST_PERCENT:
        return f"> {LARGEST_PERCENT} %"
    if 0.0 < percentage < SMALLEST_PERCENT:
        return f"< {SMALLEST_PERCENT} %"
    return f"{percentage:.0f} %" if percentage >= 100 else number(percentage, "%")


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
