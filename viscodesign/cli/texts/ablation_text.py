"""Measured effects as lines of text: estimate, measurement, and what to do."""

from __future__ import annotations

import math
from collections.abc import Mapping

from viscodesign.cli.texts.check_text import millimetres, share
from viscodesign.cli.texts.layout import number, table, wrap
from viscodesign.results.findings import EffectAblation
from viscodesign.results.trajectory import Trajectory

NOTABLE_ERROR_SHARE = 0.1
"""Share of the requested error below which the quality of an estimate does not matter."""
WRONG_RATIO = 3.0
"""Ratio of measurement and estimate beyond which the estimate is called wrong."""


def ablation_lines(trajectory: Trajectory) -> list[str]:
    """A table of the effects, the sum of the neglected ones, and warnings."""
    if not trajectory.proof:
        is_complete = trajectory.status == "complete"
        why = "none was done" if is_complete else "effects are switched only after a complete run"
        return wrap(f"measured effects: none; {why}")
    budget = trajectory.accuracy.requested_m
    rows = [("effect", "verdict", "estimated", "measured", "of budget", "result")]
    for ablation in trajectory.proof:
        part = "unknown" if ablation.measured_m is None else share(ablation.measured_m / budget)
        rows.append((
            ablation.name, ablation.decision, _mm(ablation.estimated_m), _mm(ablation.measured_m),
            part, _meaning(ablation, budget),
        ))  # fmt: skip
    caption = (
        f"measured effects: each switched in turn, solved again and the tips compared; "
        f"the budget is the requested error, {number(1e3 * budget, 'mm')}"
    )
    warnings = wrongly_neglected_lines(trajectory)
    return [
        *wrap(caption, hanging="  "),
        *table(rows),
        *wrap(_together(trajectory), "  ", "    "),
        *(["", *warnings] if warnings else []),
    ]


def _mm(length: float | None) -> str:
    if length is None or not math.isfinite(length):
        return number(length)
    return f"{millimetres(length)} mm"


def wrongly_neglected_lines(trajectory: Trajectory) -> list[str]:
    """A warning for every neglected effect that moves the tip beyond the requested error."""
    budget = trajectory.accuracy.requested_m
    modes = {verdict.name: verdict.mode for verdict in trajectory.effects}
    lines: list[str] = []
    for ablation in trajectory.proof:
        if _is_neglected_wrongly(ablation, budget):
            lines += wrap(_warning(ablation, budget, modes), hanging="  ")
    return lines


def _is_neglected_wrongly(ablation: EffectAblation, budget: float) -> bool:
    return not ablation.taken and ablation.measured_m is not None and ablation.measured_m > budget


def _warning(ablation: EffectAblation, budget: float, modes: Mapping[str, str]) -> str:
    spec = modes.get(ablation.name) == "off"
    why = "as set in the spec" if spec else "by the estimate"
    return (
        f"WARNING: {ablation.name} was neglected {why}, but moves the tip by "
        f"{_mm(ablation.measured_m)}, {share((ablation.measured_m or 0.0) / budget)} of the "
        f"requested error. Include it: --set effects.{ablation.name}=on"
    )


def _meaning(ablation: EffectAblation, budget: float) -> str:
    """What the measurement says about the decision, in a word or two."""
    if ablation.measured_m is None:
        return f"not measured: {ablation.note}" if ablation.note else "not measured"
    if _is_neglected_wrongly(ablation, budget):
        word = "NEGLECTED BUT SIGNIFICANT"
    elif ablation.measured_m == 0.0:
        word = "no change"
    elif ablation.taken:
        word = "significant" if ablation.measured_m > budget else "minor"
    else:
        word = "within budget"
    return "; ".join(part for part in (word, _quality(ablation, budget), ablation.note) if part)


def _quality(ablation: EffectAblation, budget: float) -> str:
    """Whether the estimate is far from a measurement that matters."""
    measured, estimated = ablation.measured_m or 0.0, ablation.estimated_m
    if max(measured, estimated) < NOTABLE_ERROR_SHARE * budget or not math.isfinite(estimated):
        return ""
    if measured > WRONG_RATIO * estimated:
        return "underestimated"
    return "overestimated" if estimated > WRONG_RATIO * measured else ""


def _together(trajectory: Trajectory) -> str:
    """An upper bound of all that is neglected: the sum of what each effect does alone."""
    neglected = [p.measured_m for p in trajectory.proof if not p.taken and p.measured_m is not None]
    total = sum(neglected)
    part = share(total / trajectory.accuracy.requested_m)
    return (
        f"the neglected effects add up to {_mm(total)}, {part} of the budget "
        f"({len(neglected)} measured, one at a time)"
    )
