"""A scene's timescales, verdicts and warnings, as lines of text."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from viscodesign.cli.texts.layout import blocks, number, table, wrap
from viscodesign.results.findings import Classification, Notice, Verdict

TIMES = {
    "t_s": "elastic-inertial time of the solid",
    "t_f": "viscous-elastic time of the fluid",
    "t_i": "shortest transient of the inlet pressure",
    "t_net": "slowest time constant of the network",
}
RATIOS = {
    "ts_over_tf": ("t_s/t_f", "above 1: uniform pressure; below 1: distributed pressure"),
    "ts_over_ti": ("t_s/t_i", "above 1: solid inertia matters; below 1: quasi-static"),
    "tnet_over_ti": ("t_net/t_i", "far above 1: distal bellows hardly respond; far below: uniform"),
}

SMALLEST_MM = 1e-6
SMALLEST_PERCENT = 0.001
LARGEST_PERCENT = 1000
"""Numbers beyond these are printed as bounds."""


def quadrant_lines(found: Classification) -> list[str]:
    """The quadrant of the paper's Figure 1, in one paragraph."""
    return wrap(f"{found.name}: quadrant {found.quadrant}, {found.meaning}", hanging="  ")


def scale_lines(found: Classification) -> list[str]:
    """Times and ratios, one per line, with their meaning."""
    scales = found.scales
    seconds = {"t_s": scales.t_s, "t_f": scales.t_f, "t_i": scales.t_i, "t_net": scales.t_net}
    rows = [(name, number(seconds[name], "s"), meaning) for name, meaning in TIMES.items()]
    for key, (name, meaning) in RATIOS.items():
        rows.append((name, number(scales.ratios[key]), meaning))
    rows.append(("cut-off", number(found.cutoff_frequency_hz, "Hz"), "order of magnitude, 10/t_f"))
    return ["timescales", *table(rows)]


def verdict_lines(effects: Sequence[Verdict]) -> list[str]:
    """A table of the decisions, one effect per line; then every reason.

    Included effects come first, those that do not move the tip last.
    """
    ordered = sorted(effects, key=lambda v: (not v.taken, v.contribution_m == 0.0))
    rows = [("effect", "verdict", "mode", "tip [mm]", "of budget", "weight")]
    rows += [
        (v.name, v.decision, v.mode, millimetres(v.contribution_m), share(v.budget_share),
         number(v.weight)) for v in ordered
    ]  # fmt: skip
    caption = (
        "effects: tip displacement of each effect alone, also as a share of the requested error"
    )
    return [*wrap(caption, hanging="  "), *table(rows), "", "reasons", *_reason_lines(ordered)]


def _reason_lines(effects: Sequence[Verdict]) -> list[str]:
    heads = blocks([(v.name, f"weight = {v.formula}") for v in effects])
    lines: list[str] = []
    for head, verdict in zip(heads, effects, strict=True):
        lines += [*head, *wrap(verdict.reason, "      ")]
    return lines


def millimetres(length: float) -> str:
    """A distance at the tip [m] as a number of mm, without the unit."""
    if 0.0 < length < 1e-3 * SMALLEST_MM:
        return f"< {SMALLEST_MM:.0e}"
    return number(1e3 * length)


def share(part: float) -> str:
    """A share of the requested error in percent; bounds where a percentage means little."""
    if math.isinf(part):
        return "required"
    percentage = 100 * part
    if percentage > LARGEST_PERCENT:
        return f"> {LARGEST_PERCENT} %"
    if 0.0 < percentage < SMALLEST_PERCENT:
        return f"< {SMALLEST_PERCENT} %"
    return f"{percentage:.0f} %" if percentage >= 100 else number(percentage, "%")


def notice_lines(notices: Iterable[Notice]) -> list[str]:
    """One line per code, since a run may warn at many places and times; then how many more."""
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
    """Every notice in full: before a run there are few, and each is different."""
    texts = dict.fromkeys(f"{notice.code}: {notice_text(notice)}" for notice in notices)
    return [line for text in texts for line in wrap(text, "  ", "    ")]


def notice_text(notice: Notice) -> str:
    """A notice's message, with its place and time if it has them."""
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
