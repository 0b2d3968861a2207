"""What a proof says of the effects: estimates beside measurements, and what to do."""

from __future__ import annotations

import math
from collections.abc import Mapping

from viscodesign.cli.texts.check_text import decision, millimetres, share
from viscodesign.cli.texts.layout import number, table, wrap
from viscodesign.results.findings import EffectAblation
from viscodesign.results.trajectory import Trajectory

NOTABLE = 0.1
"""Part of the error asked for below which nobody minds how good an estimate is."""
FAR_OFF = 3.0
"""Ratio of measurement and estimate from which the estimate is called wrong."""


def ablation_lines(trajectory: Trajectory) -> list[str]:
    """A table of the effects, what the omitted ones spend together, and what is amiss."""
    if not trajectory.proof:
        return wrap("proof: none; every effect is switched only after a run is complete")
    budget = trajectory.accuracy.requested_m
    rows = [("effect", "verdict", "estimated", "measured", "of budget", "says")]
    for ablation in trajectory.proof:
        part = "unknown" if ablation.measured_m is None else share(ablation.measured_m / budget)
        rows.append((
            ablation.name, decision(ablation), _mm(ablation.estimated_m), _mm(ablation.measured_m),
            part, _meaning(ablation, budget),
        ))  # fmt: skip
    caption = (
        f"proof: each effect switched, solved again, the tips compared; the budget, "
        f"the error asked for, is {number(1e3 * budget, 'mm')}"
    )
    alarms = alarm_lines(trajectory)
    return [
        *wrap(caption, hanging="  "),
        *table(rows),
        *wrap(_together(trajectory), "  ", "    "),
        *(["", *alarms] if alarms else []),
    ]


def _mm(length: float | None) -> str:
    if length is None or not math.isfinite(length):
        return number(length)
    return f"{millimetres(length)} mm"


def alarm_lines(trajectory: Trajectory) -> list[str]:
    """Every omitted effect that a proof found to move the tip beyond the error asked for."""
    budget = trajectory.accuracy.requested_m
    modes = {verdict.name: verdict.mode for verdict in trajectory.effects}
    lines: list[str] = []
    for ablation in trajectory.proof:
        if _is_missing(ablation, budget):
            lines += wrap(_alarm(ablation, budget, modes), hanging="  ")
    return lines


def _is_missing(ablation: EffectAblation, budget: float) -> bool:
    return not ablation.taken and ablation.measured_m is not None and ablation.measured_m > budget


def _alarm(ablation: EffectAblation, budget: float, modes: Mapping[str, str]) -> str:
    spec = modes.get(ablation.name) == "off"
    why = "as the spec says" if spec else "by the estimate"
    return (
        f"WARNING: {ablation.name} was left out {why}, but moves the tip by "
        f"{_mm(ablation.measured_m)}, {share((ablation.measured_m or 0.0) / budget)} of the "
        f"error asked for. Take it: --set effects.{ablation.name}=on"
    )


def _meaning(ablation: EffectAblation, budget: float) -> str:
    """In a word or two what the measurement says of the decision."""
    if ablation.measured_m is None:
        return f"not measured: {ablation.note}" if ablation.note else "not measured"
    if _is_missing(ablation, budget):
        word = "MISSING"
    elif ablation.measured_m == 0.0:
        word = "no change"
    elif ablation.taken:
        word = "needed" if ablation.measured_m > budget else "small"
    else:
        word = "spent"
    return "; ".join(part for part in (word, _quality(ablation, budget), ablation.note) if part)


def _quality(ablation: EffectAblation, budget: float) -> str:
    """What the estimate is worth, where it is far from a measurement that matters."""
    measured, estimated = ablation.measured_m or 0.0, ablation.estimated_m
    if max(measured, estimated) < NOTABLE * budget or not math.isfinite(estimated):
        return ""
    if measured > FAR_OFF * estimated:
        return "estimate too small"
    return "estimate too large" if estimated > FAR_OFF * measured else ""


def _together(trajectory: Trajectory) -> str:
    """What all omissions may do to the tip at most: the sum of what each does alone."""
    spent = [p.measured_m for p in trajectory.proof if not p.taken and p.measured_m is not None]
    total = sum(spent)
    part = share(total / trajectory.accuracy.requested_m)
    return (
        f"those left out add up to {_mm(total)}, {part} of the budget "
        f"({len(spent)} measured, one at a time)"
    )
