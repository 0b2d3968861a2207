"""A plan of the pump as lines for people."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from viscodesign.cli.texts.check_text import notice_lines
from viscodesign.cli.texts.layout import number, table, wrap
from viscodesign.pump.planning.result import PumpPlan, PumpVerdict, SuggestedChange

MARKS = {"ok": "ok", "advice": "ADVICE", "infeasible": "FAILS"}


def plan_lines(plan: PumpPlan, folder: Path, files: Sequence[Path]) -> list[str]:
    """Verdicts, changes, and what comes of the plan."""
    alone = len(plan.inlets) == 1
    lines = [f"{plan.name}: {'feasible' if plan.is_feasible else 'INFEASIBLE'}", ""]
    for inlet, servo in zip(plan.inlets, plan.servos, strict=True):
        lines += [*_drive(plan, inlet, servo), ""]
        own = [v for v in plan.verdicts if v.inlet == inlet]
        lines += ["limits" if alone else f"limits of {inlet}", *table([_row(v) for v in own]), ""]
    lines += [*_changes(plan), *_outcome(plan)]
    if plan.warnings:
        lines += ["", "warnings", *notice_lines(plan.warnings)]
    names = ", ".join(file.name for file in files)
    return [*lines, "", f"{folder}: {names}"]


def _row(verdict: PumpVerdict) -> tuple[str, str, str, str]:
    return (MARKS[verdict.severity], verdict.name, _percent(verdict), verdict.message)


def _percent(verdict: PumpVerdict) -> str:
    if verdict.ratio > 99.0:
        return ">9900 %"
    return f"{100 * verdict.ratio:.0f} %"


def _drive(plan: PumpPlan, inlet: str, servo: int) -> list[str]:
    """The drive in numbers."""
    n = plan.numbers[inlet]
    rows = [
        ("drive", f"{plan.servo}, id {servo}, for the inlet '{inlet}'"),
        (
            "stall",
            f"{n['stall_pressure_pa_gauge'] / 1e3:.4g} kPa gauge; a fifth of it "
            f"{n['steady_pressure_pa_gauge'] / 1e3:.3g} kPa",
        ),
        (
            "counts",
            f"{n['counts_per_ml']:.3g} for a mL; for a kPa {n['counts_per_kpa_fast']:.3g} at once, "
            f"{n['counts_per_kpa_slow']:.3g} once the actuator follows",
        ),
        (
            "travel",
            f"{1e6 * n['travel_volume_m3']:.3g} mL; {1e3 * n['filled_length_m']:.4g} mm of the "
            "barrel filled at home",
        ),
        (
            "asked",
            f"{n['lowest_pressure_pa_gauge'] / 1e3:.4g} to "
            f"{n['highest_pressure_pa_gauge'] / 1e3:.4g} kPa gauge, "
            f"{number(n['largest_torque_nm'], 'N m')}, "
            f"{1e6 * n['largest_flow_m3_s']:.3g} mL/s, {number(n['largest_current_a'], 'A')}",
        ),
        ("lead-in", f"{number(n['lead_in_s'], 's')} from home to the start's pressure"),
    ]
    return table(rows)


def _changes(plan: PumpPlan) -> Iterator[str]:
    """What would help, verdict by verdict, then all together."""
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
        yield "no few changes that were tried make all of it feasible"
    else:
        yield "feasible with"
        for change in plan.together:
            yield from wrap(_settings(change), "  ", " " * 6)
    yield ""


def _words(change: SuggestedChange) -> str:
    left = (
        f"; then fails: {', '.join(change.leaves)}" if change.leaves else "; then all is feasible"
    )
    return _settings(change) + left


def _settings(change: SuggestedChange) -> str:
    told = " ".join(f"--set '{setting}'" for setting in change.settings)
    return f"{change.words} ({told})" if told else change.words


def _outcome(plan: PumpPlan) -> Iterator[str]:
    """What the actuator would do with what the pump can deliver."""
    error = plan.error_m
    sure = "unknown" if error is None else number(1e3 * error, "mm")
    yield "what the pump would do"
    rows = [
        (
            "tip",
            f"up to {number(1e3 * plan.deviation_m, 'mm')} from where it is wanted; the errors of "
            f"both runs add up to {sure}",
        ),
        ("battery", _battery(plan.limits["battery_life_s"])),
    ]
    rows += [("cut off", words) for words in plan.clipped]
    yield from table(rows)


def _battery(life: float) -> str:
    if life > 1e6:
        return "lasts: nothing is held"
    return f"lasts {life / 60:.3g} min at this course's mean current, electronics left out"
