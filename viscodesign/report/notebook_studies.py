"""What a notebook shows of a study: its main numbers as a table, and its picture."""

from __future__ import annotations

import base64
import functools
import html
import math
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.layout.drawing_library import import_matplotlib
from viscodesign.report.notebook import Rows, html_table
from viscodesign.results.channels import millimetres
from viscodesign.results.findings import outside_words
from viscodesign.results.fit_result import Fit, FittedNumber
from viscodesign.results.metrics import METRIC_NAMES
from viscodesign.results.path_design import PathDesign
from viscodesign.results.reach_study import ReachStudy
from viscodesign.results.run_comparison import Comparison
from viscodesign.results.sensitivity_study import AXES, SensitivityStudy
from viscodesign.results.sweep_table import Sweep, value_words

MAX_LISTED_NUMBERS = 20
"""Numbers that are listed; tables and files have all."""
CSS_DPI = 96


@dataclass(frozen=True)
class StudyView:
    """What is shown of a study."""

    rows: Rows
    draw: Callable[[Path], object] | None
    """Draws its picture into a file; None where there is nothing to draw."""


def study_html(study: Any) -> str:
    """A table of the main numbers, and the picture that the command draws."""
    import_matplotlib()
    view = study_view(study)
    shown = "" if view.draw is None else picture_html(repr(study), view.draw)
    return f"<div>{html_table(repr(study), view.rows)}{shown}</div>"


def picture_html(words: str, draw: Callable[[Path], object]) -> str:
    """A picture as part of the text, as large as on paper; ``words`` are its alternative text."""
    from viscodesign.report.layout.style import RC

    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "picture.png"
        draw(file)
        content = file.read_bytes()
    # The width [pixel] of a PNG stands in its first block.
    width = int.from_bytes(content[16:20], "big") * CSS_DPI / RC["savefig.dpi"]
    return (
        f'<img alt="{html.escape(words)}" style="width: {width:.0f}px; max-width: 100%" '
        f'src="data:image/png;base64,{base64.b64encode(content).decode()}">'
    )


@functools.singledispatch
def study_view(study: Any) -> StudyView:
    """Rows and picture of a study, by its type."""
    raise TypeError(f"nothing is known of how to show {type(study).__name__}")


@study_view.register
def _comparison(found: Comparison) -> StudyView:
    from viscodesign.report.charts.compare import draw_comparison

    rows = [(motion.title, f"stated error {motion.error_text}") for motion in found.motions]
    rows += [("difference", sentence) for own in found.differences for sentence in own.sentences]
    rows += [("missing", words) for words in found.missing]
    return StudyView(rows, functools.partial(draw_comparison, found))


@study_view.register
def _design(found: PathDesign) -> StudyView:
    from viscodesign.report.charts.design import draw_design

    return StudyView([*_answer(found)], functools.partial(draw_design, found))


def _answer(found: PathDesign) -> Iterator[tuple[str, str]]:
    yield "status", found.status.replace("_", " ")
    for name, told in (("reason", found.reason), ("hint", found.hint)):
        if told:
            yield name, told
    if found.confirmed_rms_m is not None:
        rms, worst, allowed = map(
            millimetres, (found.confirmed_rms_m, found.confirmed_worst_m, found.tolerance_m)
        )
        yield "distance, simulated", f"{rms} rms, at most {worst} (allowed {allowed} rms)"
    if found.violations:
        yield "validity", outside_words(found.violations)
    for key, value in list(found.parameters.items())[:MAX_LISTED_NUMBERS]:
        yield key, value_words(float(f"{value:.4g}"), found.units.get(key))
    yield from _more(len(found.parameters), "numbers")


@study_view.register
def _sweep(sweep: Sweep) -> StudyView:
    from viscodesign.report.charts.sweep import draw_sweep

    rows = [("status", sweep.status), *_extremes(sweep)]
    rows += [
        (f"row {own.row} failed", f"{sweep.words(own.row)}: {own.failure}")
        for own in sweep.failures[:MAX_LISTED_NUMBERS]
    ]
    rows += _more(len(sweep.failures), "rows failed")
    draw = functools.partial(draw_sweep, sweep, METRIC_NAMES[0]) if sweep.results else None
    return StudyView(rows, draw)


def _extremes(sweep: Sweep) -> Iterator[tuple[str, str]]:
    """The ends of each length and area, with the designs that have them."""
    for place, name in enumerate(METRIC_NAMES):
        own = {
            row: result.metrics[place]
            for row, result in sweep.results.items()
            if math.isfinite(result.metrics[place])
        }
        words, _, unit = name.rpartition("_")
        if own and unit == "m":
            ends = min(own, key=lambda row: own[row]), max(own, key=lambda row: own[row])
            told = (f"{millimetres(own[row])} ({sweep.words(row, 3)})" for row in ends)
            yield words.replace("_", " "), " to ".join(told)


@study_view.register
def _reach(study: ReachStudy) -> StudyView:
    from viscodesign.report.charts.reach import draw_reach

    return StudyView([*_places(study)], functools.partial(draw_reach, study))


def _places(study: ReachStudy) -> Iterator[tuple[str, str]]:
    if study.interrupted:
        yield "status", "interrupted: what there is was not verified, or not all of it"
    low, high = study.limits
    yield "inlet", f"{1e-3 * low:.3g} to {1e-3 * high:.3g} kPa above the baseline"
    areas = (("one inlet", study.area_m2), ("an inlet a column", study.area_two_inlets_m2))
    for words, area in areas:
        if math.isfinite(area):
            yield f"area, {words}", f"{1e4 * area:.3g} cm²"
    if study.edge_error_m is not None:
        yield "edge, simulated", f"off by at most {millimetres(study.edge_error_m)}"
    for why in study.edge_failures[:MAX_LISTED_NUMBERS]:
        yield "edge, not verified", why
    point = study.point
    if point is not None and point.is_verified:
        x, z = (1e3 * value for value in point.at)
        miss, error = millimetres(point.miss_m), millimetres(point.stated_error_m)
        reached = f"reached to {miss}, stated error {error}"
        told = reached if point.is_reached else f"out of reach by {miss}"
        told += f"; {outside_words(point.violations)}" if point.violations else ""
        yield f"({x:.4g}, {z:.4g}) mm at {point.time_s:.3g} s", told


@study_view.register
def _sensitivity(study: SensitivityStudy) -> StudyView:
    from viscodesign.report.charts.tornado import draw_tornado

    return StudyView([*_shifts(study)], functools.partial(draw_tornado, study))


def _shifts(study: SensitivityStudy) -> Iterator[tuple[str, str]]:
    if study.has_band:
        largest = study.band.max(axis=0, initial=0.0).tolist()
        told = (f"{axis} {millimetres(own)}" for axis, own in zip(AXES, largest, strict=True))
        yield "standard deviation, at most", ", ".join(told)
    sizes, shares = study.sizes.max(axis=0, initial=0.0), study.shares
    for k in study.order[:MAX_LISTED_NUMBERS]:
        known = study.numbers[k].deviation is not None
        share = f", {100 * shares[k]:.3g} % of the variance" if known and study.has_band else ""
        by = "by its tolerance" if study.has_band else "by one percent"
        yield study.numbers[k].key, f"tip moves {millimetres(1e-3 * float(sizes[k]))} {by}{share}"
    yield from _more(len(study.numbers), "numbers")


@study_view.register
def _fit(found: Fit) -> StudyView:
    from viscodesign.report.charts.fit import draw_fit

    rows: list[tuple[str, str]] = [("status", found.status)]
    rows += [(own.key, _interval(own)) for own in found.numbers[:MAX_LISTED_NUMBERS]]
    rows += _more(len(found.numbers), "numbers")
    rows += [("known together", f"{own.formula} = {own.value:.4g}") for own in found.products]
    rows += [("warning", words) for words in found.warnings]
    return StudyView(rows, functools.partial(draw_fit, found))


def _interval(own: FittedNumber) -> str:
    """A number with its unit, and its interval where the data set both ends."""
    value = value_words(float(f"{own.value:.5g}"), own.unit)
    if own.low is None or own.high is None:
        return f"{value}, not known by these data"
    told = f"{value}, 95 %: {own.low:.4g} to {own.high:.4g}"
    return told if own.is_identified else f"{told}, not identified"


def _more(count: int, what: str) -> list[tuple[str, str]]:
    return (
        [("", f"and {count - MAX_LISTED_NUMBERS} more {what}")]
        if count > MAX_LISTED_NUMBERS
        else []
    )
