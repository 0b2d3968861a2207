"""Sensitivities as lines of text: numbers by how far they move the tip, and the band."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from viscodesign.cli.texts.layout import and_more, files_row, number, percentage, seconds, table
from viscodesign.results.sensitivity_study import AXES, SampledVariance, SensitivityStudy
from viscodesign.results.sweep_table import value_words

MAX_SENSITIVITY_ROWS = 20
NOTABLE_DIFFERENCE = 0.05
"""A sampled standard deviation that differs more from that of the band is worth a warning."""


def sensitivity_lines(study: SensitivityStudy, folder: Path, files: Sequence[Path]) -> list[str]:
    """One line a number, the band, its check, files."""
    head = "shift of the tip by one percent of each number, where it is largest"
    return [
        f"{study.name}: {head}",
        *table(list(_numbers(study))),
        *and_more(len(study.numbers), MAX_SENSITIVITY_ROWS, "sensitivity.csv"),
        "",
        *table(
            [
                *_band(study),
                *_sampled(study, study.sampled),
                *_left_out(study),
                ("effects", ", ".join(sorted(study.effects)) or "none"),
                ("time", seconds(study.wall_s)),
                files_row(folder, files),
            ]
        ),
    ]


def _numbers(study: SensitivityStudy) -> Iterator[tuple[str, str, str, str]]:
    per_percent = study.mm_per_percent
    for k in study.order[:MAX_SENSITIVITY_ROWS]:
        own, moved = study.numbers[k], per_percent[:, :, k]
        row = int((moved**2).sum(axis=1).argmax())
        words = ", ".join(f"{a} {moved[row, c]:+.3g}" for c, a in enumerate(AXES))
        shift = f"{words} mm per percent at {number(float(study.time[row]), 's')}"
        share = ""
        if own.deviation is not None:
            share = (
                f"; sd {value_words(own.deviation, own.unit)}, "
                f"{percentage(float(study.shares[k]))} of the variance"
            )
        yield own.key, value_words(own.value, own.unit), shift + share, ""


def _band(study: SensitivityStudy) -> Iterator[tuple[str, str]]:
    if study.has_band:
        rows = study.band.argmax(axis=0)
        words = (
            f"{axis} {number(1e3 * float(study.band[row, c]), 'mm')} at "
            f"{number(float(study.time[row]), 's')}"
            for c, (axis, row) in enumerate(zip(AXES, rows, strict=True))
        )
        yield "band", f"largest standard deviation of {' and of '.join(words)}"


def _sampled(study: SensitivityStudy, sampled: SampledVariance | None) -> Iterator[tuple[str, str]]:
    if sampled is None:
        return
    band, when = study.band[study.worst_row], number(float(study.time[study.worst_row]), "s")
    for c, axis in enumerate(AXES):
        own, found = float(band[c]), float(sampled.deviation_m[c])
        differs = abs(found - own) > NOTABLE_DIFFERENCE * max(band)
        verdict = "DIFFERS: numbers act together, trust the sample" if differs else "agrees"
        yield (
            f"sample, {axis}",
            f"{number(1e3 * found, 'mm')} at {when} over {sampled.solutions} solutions, "
            f"{number(1e3 * own, 'mm')} by the band: {verdict}",
        )
    if sampled.failed:
        yield "sample", f"{sampled.failed} solutions failed, and were taken by their slopes"


def _left_out(study: SensitivityStudy) -> Iterator[tuple[str, str]]:
    if study.left_out:
        names = ", ".join(key for key, _ in study.left_out)
        yield "left out", f"{names} (reasons in sensitivity.json)"
