"""The outcome of a run, as lines of text."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path

from viscodesign.cli.texts.check_text import notice_lines, percent, quadrant_lines
from viscodesign.cli.texts.layout import files_row, number, table
from viscodesign.results.coefficient_band import STILL_WORDS, CoefficientBand, why_no_band
from viscodesign.results.findings import NOT_APPLICABLE, RetryAttempt, outside_words
from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.disk_arrays import extremes


def summary_lines(trajectory: Trajectory, folder: Path, files: Sequence[Path]) -> list[str]:
    """Status, timescales, range and error of the tip, effects, warnings, files."""
    warnings = notice_lines(trajectory.warnings)
    rows = [
        ("run", _progress(trajectory)),
        ("timescales", _times(trajectory)),
        *(("note", note) for note in trajectory.notes),
        ("tip", _tip_extents(trajectory)),
        *_loop(trajectory),
        ("tip error", _tip_error(trajectory)),
        ("error breakdown", _error_parts(trajectory)),
        ("both errors", both_errors(trajectory)),
        *_contributors(trajectory),
        *_outside(trajectory),
        *(("retry", _retry(attempt)) for attempt in trajectory.ladder[:MAX_RETRIES]),
        *_decisions(trajectory),
        files_row(folder, files),
    ]
    return [
        *quadrant_lines(trajectory.classification),
        *table(rows),
        *(["warnings", *warnings] if warnings else []),
    ]


MAX_RETRIES = 6
"""Retries that are printed; all of them are in `summary.json`."""


def _decisions(trajectory: Trajectory) -> Iterator[tuple[str, str]]:
    for decision in ("included", "neglected", NOT_APPLICABLE):
        names = [v.name for v in trajectory.effects if v.decision == decision]
        if names or decision != NOT_APPLICABLE:
            yield decision, ", ".join(names) or "none"


def _retry(attempt: RetryAttempt) -> str:
    ended = "succeeded" if attempt.solved else "failed"
    return f"at {number(attempt.time_s, 's')}: {attempt.tried}, {ended}"


def _progress(trajectory: Trajectory) -> str:
    cost = trajectory.cost
    reached = float(trajectory.time[-1]) if trajectory.time.size else 0.0
    return (
        f"{trajectory.status}: {number(reached, 's')} of motion "
        f"in {number(cost.total_s, 's')}, {cost.steps} steps{_solver(trajectory)}"
    )


def _solver(trajectory: Trajectory) -> str:
    solver, native = (trajectory.settings.get(key) for key in ("solver", "native_code"))
    return (f" of {solver}" if solver else "") + (" in native code" if native else "")


def _times(trajectory: Trajectory) -> str:
    scales = trajectory.classification.scales
    times = {"t_s": scales.t_s, "t_f": scales.t_f, "t_i": scales.t_i, "t_net": scales.t_net}
    return ", ".join(f"{name} {number(value, 's')}" for name, value in times.items())


def _tip_extents(trajectory: Trajectory) -> str:
    if not trajectory.time.size:
        return "no output"
    low, high = extremes(trajectory.tip)
    return (
        f"x {1e3 * low[0]:.1f} to {1e3 * high[0]:.1f} mm, "
        f"z {1e3 * low[1]:.1f} to {1e3 * high[1]:.1f} mm, "
        f"angle {math.degrees(low[2]):.0f} to {math.degrees(high[2]):.0f} deg"
    )


def _loop(trajectory: Trajectory) -> Iterator[tuple[str, str]]:
    """The last period, or the run where there is none: its size, and how far L is behind R."""
    found = trajectory.metrics
    if math.isnan(found["loop_width_m"]):
        return
    lag = found["column_lag_s"]
    behind = "" if math.isnan(lag) else f", L {number(lag, 's')} behind R"
    yield (
        "loop",
        f"{1e3 * found['loop_width_m']:.1f} mm wide, {1e3 * found['loop_height_m']:.1f} mm high, "
        f"path {1e3 * found['path_length_m']:.1f} mm, "
        f"area {number(1e4 * found['loop_area_m2'], 'cm^2')}{behind}",
    )


def _tip_error(trajectory: Trajectory) -> str:
    accuracy, length = trajectory.accuracy, trajectory.length
    requested = (
        f"requested {number(1e3 * accuracy.requested_m, 'mm')}, "
        f"{percent(accuracy.requested_m, length)}"
    )
    error = accuracy.estimated_tip_error_m
    if error is None:
        return f"{accuracy.method} ({requested})"
    stated = f"{number(1e3 * error, 'mm')}, {percent(error, length)} of the length ({requested})"
    return ", ".join(filter(None, (stated, trajectory.error_qualifier)))


MAX_CONTRIBUTORS = 4
"""Numbers that are named as the largest contributions to the uncertainty."""
MIN_NAMED_SHARE = 0.005
"""Share of the variance below which a number is not named."""


def both_errors(trajectory: Trajectory) -> str:
    """What the numbers cost, what is known of the actuator, and whether the model holds."""
    error, band = trajectory.accuracy.estimated_tip_error_m, trajectory.uncertainty
    numerical = "not estimated" if error is None else number(1e3 * error, "mm")
    if band is None:
        known = why_no_band(trajectory.warnings, trajectory.notes, trajectory.spec_text)
    elif band.is_still:
        known = STILL_WORDS
    else:
        known = f"+-{number(1e3 * band.half_width_m, 'mm')} (95 %, at {_at(band)})"
        known += ", some assumed" if band.is_assumed else ""
    return f"numerical {numerical}; from the coefficients {known}; validity {trajectory.validity}"


def _at(band: CoefficientBand) -> str:
    return number(float(band.time[band.worst_row]), "s")


def _contributors(trajectory: Trajectory) -> Iterator[tuple[str, str]]:
    """The numbers whose uncertainty counts most."""
    band = trajectory.uncertainty
    if band is None:
        return
    named = [n for n in band.numbers[:MAX_CONTRIBUTORS] if n.share >= MIN_NAMED_SHARE]
    told = [f"{n.key} {100 * n.share:.0f} %{' (assumed)' if n.assumed else ''}" for n in named] or [
        "none moves the tip"
    ]
    yield "contributions", ", ".join(told)


def _outside(trajectory: Trajectory) -> Iterator[tuple[str, str]]:
    if trajectory.violations:
        told = outside_words(trajectory.violations)
        yield "validity", f"{told}; the tip error does not count it"


def _error_parts(trajectory: Trajectory) -> str:
    """The parts of the error, and how long it took to estimate it."""
    accuracy, cost = trajectory.accuracy, trajectory.cost
    is_whole = accuracy.time_m is None and accuracy.estimated_tip_error_m is not None
    parts = (
        ("time", accuracy.time_m),
        ("space", accuracy.space_m),
        ("all parts together" if is_whole else "omitted effects", accuracy.omitted_m),
    )
    known = [f"{name} {number(1e3 * size, 'mm')}" for name, size in parts if size is not None]
    price = [f"estimating it took {number(cost.verify_s, 's')}"] if cost.verify_s else []
    return "; ".join([", ".join(known), *price])
