"""A study of reach as lines of text."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from viscodesign.cli.texts.layout import files_row, number, seconds, table
from viscodesign.results.findings import outside_words
from viscodesign.results.reach_study import ReachStudy


def reach_lines(study: ReachStudy, folder: Path, files: Sequence[Path]) -> list[str]:
    """Areas, the point, files."""
    low, high = (number(1e-3 * value) for value in study.limits)
    rows = [
        *_point(study),
        *_areas(study),
        ("time", seconds(study.wall_s)),
        files_row(folder, files),
    ]
    return [f"{study.name}: pressures from {low} to {high} kPa", *table(rows)]


def _point(study: ReachStudy) -> Iterator[tuple[str, str]]:
    own = study.point
    if own is None:
        return
    x, z = (number(1e3 * value) for value in own.at)
    when = f"({x}, {z}) mm at {number(own.time_s, 's')}"
    if not own.is_verified:
        miss = number(1e3 * own.miss_m, "mm")
        yield "point", f"{when}: interrupted {miss} away, not verified; the input is input.csv"
    elif own.is_reached:
        stated = number(None if own.stated_error_m is None else 1e3 * own.stated_error_m, "mm")
        miss = number(1e3 * own.miss_m, "mm")
        yield "point", f"{when}: reached to {miss}, stated error {stated}; its input is input.csv"
    else:
        tip = ", ".join(number(1e3 * value) for value in own.tip)
        miss = number(1e3 * own.miss_m, "mm")
        yield "point", f"{when}: out of reach by {miss}; the tip comes to ({tip}) mm"
    if own.is_cut:
        yield "", "time ended the search"
    if own.violations:
        words = outside_words(own.violations)
        yield "validity", f"{words}; the stated error does not count it"


def _areas(study: ReachStudy) -> Iterator[tuple[str, str]]:
    if len(study.edge):
        family = "any input" if study.harmonics is None else f"{study.harmonics} harmonics"
        yield "area", f"{number(1e4 * study.area_m2, 'cm2')} with {family} in slow flow"
    yield "two inlets", f"{number(1e4 * study.area_two_inlets_m2, 'cm2')} with one a column"
    if study.edge_error_m is not None:
        words = "largest distance of simulated points of the edge, all effects included"
        yield "edge", f"{number(1e3 * study.edge_error_m, 'mm')}: {words}"
    for failure in study.edge_failures:
        yield "warning", f"a point of the edge could not be simulated: {failure}"
