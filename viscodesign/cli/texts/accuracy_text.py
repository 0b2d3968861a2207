"""An accuracy study as lines of text: the cost of each error, and the setting to use."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from viscodesign.cli.texts.layout import (
    and_more,
    files_row,
    number,
    percentage,
    seconds,
    table,
    wrap,
)
from viscodesign.results.accuracy_points import Point, tolerance_words
from viscodesign.results.accuracy_study import AccuracyStudy

MAX_NOTES = 5
NOTABLE_TIME_SHARE = 0.1
"""Share of a time below which a difference is timing noise."""


def cost_lines(
    study: AccuracyStudy, budget_s: float | None, folder: Path, files: Sequence[Path]
) -> list[str]:
    """Costs, recommendation, reference and what was not measured."""
    rows = [
        *([("recommended", _recommended(study))] if study.points else []),
        *([("to use it", usage)] if (usage := _usage(study)) else []),
        ("simulate", _simulate(study)),
        *([("budget", _budget(study, budget_s))] if budget_s is not None else []),
        ("reference", _reference(study)),
        ("points", f"{len(study.points)} in {number(study.spent_s, 's')}"),
        files_row(folder, files),
    ]
    caption = (
        f"{study.name}: solve time for a given tip error, relative to the actuator length "
        f"({number(1e3 * study.length, 'mm')})"
    )
    return [
        *wrap(caption, hanging="  "),
        *table([_cost(study, error) for error in study.errors]),
        "",
        *table(rows),
        *_note_lines(study),
    ]


def _cost(study: AccuracyStudy, error: float) -> tuple[str, str, str]:
    mark = " (requested)" if error == study.requested_rel else ""
    head = f"for {percentage(error)}{mark}"
    point = study.cheapest(error)
    if point is None:
        return head, "", "not reached in this study"
    return head, seconds(point.solve_s), study.words(point)


def _recommended(study: AccuracyStudy) -> str:
    point = study.recommended
    if point is None:
        return (
            f"none: no setting in this study reaches the requested "
            f"{percentage(study.requested_rel)}; the best has {_error(_best(study))}"
        )
    return f"{study.words(point)}: {seconds(point.solve_s)}, {_error(point)}"


def _usage(study: AccuracyStudy) -> str:
    """How to use the recommended setting, if `simulate` would not start with it."""
    best, start = study.recommended, study.start
    if best is None or start is None or best == start:
        return ""
    sets = " ".join(f"--set {change}" for change in study.recommended_changes)
    if best.is_stepless:
        return sets
    mesh = best.is_exact_in_space or best.edges == start.edges
    if mesh and best.solver == start.solver:
        python = f"simulate(scene, tolerance={tolerance_words(best.tolerance)})"
    else:
        given = f"{best.edges}, {tolerance_words(best.tolerance)}, {best.solver!r}"
        python = f"viscodesign.simulation.solve_once.solve with Settings({given})"
    return "; ".join(part for part in (sets, f"from Python: {python}") if part)


def _simulate(study: AccuracyStudy) -> str:
    point = study.start
    if point is None:
        return "its initial setting was not measured"
    said = f"starts with {study.words(point)}: {seconds(point.solve_s)}, {_error(point)}"
    best = study.recommended
    if best is None or best == point:
        return said
    saved = 1 - best.solve_s / point.solve_s
    if saved < NOTABLE_TIME_SHARE:
        return f"{said}; the recommended setting is not noticeably faster"
    return f"{said}; the recommended setting takes {100 * saved:.0f} % less time"


def _budget(study: AccuracyStudy, budget_s: float) -> str:
    if not study.points:
        return "nothing was measured"
    point = study.most_accurate(budget_s)
    if point is None:
        cheapest = min(study.points, key=lambda point: point.solve_s)
        return (
            f"no setting solves within {seconds(budget_s)}: the cheapest takes "
            f"{seconds(cheapest.solve_s)}, {study.words(cheapest)}, {_error(cheapest)}"
        )
    return (
        f"within {seconds(budget_s)}: {study.words(point)}: {seconds(point.solve_s)}, "
        f"{_error(point)}"
    )


def _reference(study: AccuracyStudy) -> str:
    found = study.reference
    if found is None:
        return "none: interrupted before it was solved"
    edges = f"{found.edges} edge{'s' * (found.edges != 1)} per section"
    return (
        f"every effect that the spec allows; {found.solver}, {edges}, tolerance "
        f"{tolerance_words(found.tolerance)}; "
        f"converged to {number(1e3 * found.convergence_m, 'mm')}, "
        f"{percentage(found.convergence_rel)} of the length"
    )


def _note_lines(study: AccuracyStudy) -> list[str]:
    if not study.notes:
        return []
    lines = ["notes"]
    for note in study.notes[:MAX_NOTES]:
        lines += wrap(note, "  ", "    ")
    return [*lines, *and_more(len(study.notes), MAX_NOTES, "accuracy.json")]


def _best(study: AccuracyStudy) -> Point:
    return min(study.points, key=lambda point: (point.tip_error_m, point.solve_s))


def _error(point: Point) -> str:
    sign = "<= " if point.is_bound else ""
    return f"error {sign}{percentage(point.tip_error_rel)}"
