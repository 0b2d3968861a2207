"""A sweep as lines of text: what was solved, what failed, and the range of every metric."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from viscodesign.cli.texts.check_text import notice_lines
from viscodesign.cli.texts.layout import and_more, files_row, number, seconds, table, wrap
from viscodesign.results.metrics import METRIC_NAMES
from viscodesign.results.sweep_table import COMPLETE, Sweep

MAX_FAILURES, MAX_KEYS = 5, 4
UNITS = {"_m": ("mm", 1e3), "_m2": ("cm^2", 1e4), "_s": ("s", 1.0)}


def sweep_lines(sweep: Sweep, folder: Path, files: Sequence[Path]) -> list[str]:
    """Rows, effects, the range of every metric with its design, failures, files."""
    solved = [r for r in sweep.results.values() if r.status == COMPLETE]
    rows = [
        ("rows", _counts(sweep, len(solved))),
        ("time", _time(sweep)),
        *_models(sweep),
        ("accuracy", f"{number(1e3 * sweep.requested_m, 'mm')} requested of each row"),
        *_verified(sweep),
        files_row(folder, files),
    ]
    warnings = notice_lines(sweep.warnings)
    return [
        f"{sweep.name}: {sweep.status} sweep over {_keys(sweep)}",
        *table(rows),
        *(["range of each metric", *table(list(_ranges(sweep)))] if solved else []),
        *_failures(sweep),
        *(["warnings", *warnings] if warnings else []),
    ]


def _keys(sweep: Sweep) -> str:
    names = [column.key for column in sweep.columns]
    more = f" and {len(names) - MAX_KEYS} more keys" if len(names) > MAX_KEYS else ""
    return ", ".join(names[:MAX_KEYS]) + more


def _counts(sweep: Sweep, solved: int) -> str:
    failed, missing = len(sweep.failures), len(sweep.missing)
    words = [f"{solved} complete", *([f"{failed} failed"] if failed else [])]
    words += [f"{missing} missing"] if missing else []
    return f"{len(sweep.designs)}: {', '.join(words)}"


def _time(sweep: Sweep) -> str:
    processes = f"{sweep.workers} process{'es' * (sweep.workers > 1)}"
    before = len(sweep.results) - sweep.computed
    kept = f", {before} rows from before" if before else ""
    return f"{seconds(sweep.wall_s)} for {sweep.computed} rows in {processes}{kept}"


def _models(sweep: Sweep) -> Iterator[tuple[str, str]]:
    counts = [sum(r.effects == m for r in sweep.results.values()) for m in sweep.models]
    for k, (effects, count) in enumerate(zip(sweep.models, counts, strict=True)):
        if k == 3:
            yield "model", f"and {len(counts) - 3} more, in sweep.json"
            return
        yield f"model {k + 1}", f"{count} rows with {', '.join(sorted(effects)) or 'no effects'}"


def _verified(sweep: Sweep) -> Iterator[tuple[str, str]]:
    for own in sweep.verified:
        if own.extremes_apart_m is None:
            yield f"row {own.row}", f"could not be verified: {'; '.join(own.reasons)}"
            continue
        stated, apart = own.estimated_tip_error_m, 1e3 * own.extremes_apart_m
        error = "unknown" if stated is None else number(1e3 * stated, "mm")
        words = f"stated error {error}, extremes {number(apart, 'mm')} from those in the table"
        outside = f"; OUTSIDE of what its model describes: {'; '.join(own.reasons)}"
        yield f"row {own.row}", words + outside * (own.validity == "outside")


def _ranges(sweep: Sweep) -> Iterator[tuple[str, str, str, str]]:
    for k, name in enumerate(METRIC_NAMES):
        own = {r.row: r.metrics[k] for r in sweep.results.values() if np.isfinite(r.metrics[k])}
        if not own or name.endswith("_time_s"):
            continue
        low, high = min(own, key=lambda row: own[row]), max(own, key=lambda row: own[row])
        unit, factor = UNITS[f"_{name.rpartition('_')[2]}"]
        ends = (f"{number(factor * own[row], unit)} (row {row})" for row in (low, high))
        yield name, next(ends), "to", next(ends)


def _failures(sweep: Sweep) -> list[str]:
    lines = ["failed rows"] if sweep.failures else []
    for found in sweep.failures[:MAX_FAILURES]:
        lines += wrap(
            f"{found.row}: {sweep.words(found.row, MAX_KEYS)}: {found.failure}", "  ", "    "
        )
    return [*lines, *and_more(len(sweep.failures), MAX_FAILURES, "sweep.csv")]
