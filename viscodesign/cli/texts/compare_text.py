"""A comparison as lines of text: metrics side by side, and the differences in words."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path

from viscodesign.cli.texts.layout import number, table, wrap
from viscodesign.cli.texts.sweep_text import UNITS
from viscodesign.results.metrics import METRIC_NAMES
from viscodesign.results.run_comparison import ComparedMotion, Comparison

MAX_BESIDE = 4
"""Motions in one table; more are in several."""


def comparison_lines(found: Comparison, folder: Path, files: Sequence[Path]) -> list[str]:
    """Motions, metrics, differences, what was assumed, files."""
    lines: list[str] = []
    for k in range(0, len(found.motions), MAX_BESIDE):
        lines += table(list(_side_by_side(found.motions[k : k + MAX_BESIDE])), indent="")
        lines.append("")
    for difference in found.differences:
        first, *more = difference.sentences
        lines += wrap(first, "", "  ")
        for sentence in more:
            lines += wrap(sentence, "  ", "    ")
    for note in found.notes:
        lines += wrap(f"note: {note}", "", "  ")
    return [*lines, f"files  {folder}: {', '.join(file.name for file in files)}"]


def _side_by_side(motions: Sequence[ComparedMotion]) -> Iterator[tuple[str, ...]]:
    yield "", *(motion.label for motion in motions)
    yield "status", *(_status(motion) for motion in motions)
    yield "stated error", *(motion.error_text for motion in motions)
    if any(motion.band is not None for motion in motions):
        yield "by coefficients", *(motion.band_text for motion in motions)
    for name in METRIC_NAMES:
        values = [motion.metrics[name] for motion in motions]
        if not all(math.isnan(value) for value in values):
            unit, factor = UNITS[f"_{name.rpartition('_')[2]}"]
            yield (
                name.rpartition("_")[0].replace("_", " "),
                *(_cell(factor * value, unit) for value in values),
            )


def _status(motion: ComparedMotion) -> str:
    if motion.status == "complete":
        return f"{motion.origin}, to {number(float(motion.time[-1]), 's')}"
    return f"{motion.status.upper()} at {number(float(motion.time[-1]), 's')}"


def _cell(value: float, unit: str) -> str:
    return "-" if math.isnan(value) else number(value, unit)
