"""A plan of the pump as lines for people."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from viscodesign.cli.texts.check_text import notice_lines
from viscodesign.cli.texts.layout import number, table, wrap
from viscodesign.pump.planning.result import PumpPlan, PumpVerdict, SuggestedChange

MARKS = {"ok": "ok", "advice": "ADVICE", "infeasible": "FAILS"}
UNLIMITED_S = 1e6
"""Battery life that needs no number."""


def plan_lines(plan: PumpPlan, folder: Path, files: Sequence[Path]) -> list[str]:
    """Limits, changes, and what the pump would do."""
    alone = len(plan.inlets) == 1
    lines = [f"{plan.name}: {'feasible' if plan.is_feasible else 'INFEASIBLE'}", ""]
    for inlet in plan.inlets:
        lines += [*table(list(plan.words[inlet].items())), ""]
        own = [v for v in plan.verdicts if v.inlet == inlet]
        lines += ["limits" if alone else f"limits of {inlet}", *table([_row(v) for v in own]), ""]
    lines += [*_changes(plan), *_outcome(plan)]
    if plan.warnings:
        lines += ["", "warnings", *notice_lines(plan.warnings)]
    names = ", ".join(file.name for file in files)
    return [*lines, "", f"{folder}: {names}"]


def _row(verdict: PumpVerdict) -> tuple[str, str, str, str]:
    percent = ">9900 %" if verdict.ratio > 99.0 else f"{100 * verdict.ratio:.0f} %"
    return MARKS[verdict.severity], verdict.name, percent, verdict.message


def _changes(plan: PumpPlan) -> Iterator[str]:
    """What would help, limit by limit, then all together."""
    failed = [v for v in plan.verdicts if v.severity != "ok" and v.changes]
    if failed:
        yield "smallest changes, each tried"
        for verdict in failed:
            name = verdict.name if len(plan.inlets) == 1 else f"{verdict.name} ({verdict.inlet})"
            for change in verdict.changes:
                yield from wrap(f"{name}: {_words(change)}", "  ", " " * 6)
        yield ""
    if plan.is_feasible:
        return
    if not plan.together:
        yield "no combination of a few changes was found that makes it feasible"
    else:
        yield "feasible with"
        for change in plan.together:
            yield from wrap(_settings(change), "  ", " " * 6)
    yield ""


def _words(change: SuggestedChange) -> str:
    left = f"still infeasible: {', '.join(change.leaves)}" if change.leaves else "then feasible"
    return f"{_settings(change)}; {left}"


def _settings(change: SuggestedChange) -> str:
    options = " ".join(f"--set '{setting}'" for setting in change.settings)
    return f"{change.words} ({options})" if options else change.words


def _outcome(plan: PumpPlan) -> Iterator[str]:
    """What the actuator would do with what the pump can deliver."""
    error = plan.error_m
    total = "unknown" if error is None else number(1e3 * error, "mm")
    total = ", ".join(filter(None, (total, plan.error_qualifier)))
    yield "what the pump would do"
    deviation = number(1e3 * plan.deviation_m, "mm")
    life = plan.limits.get("battery_life_s")
    yield from table(
        [
            ("tip", f"up to {deviation} off its wanted path; errors of both runs: {total}"),
            *([] if life is None else [("battery", _battery(life))]),
            *(("cut off", words) for words in plan.clipped),
        ]
    )


def _battery(life: float) -> str:
    if life > UNLIMITED_S:
        return "unlimited: no load"
    return f"{life / 60:.3g} min at the mean current, electronics not counted"
