"""What rows of a measurement leave of a run, and what was done to them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.results.findings import Notice
from viscodesign.scene.inputs.table import TableInput
from viscodesign.scene.scene import Scene

SPACINGS, SHARE_OF_RUN = 1.5, 0.01
"""Spacings of rows, and most parts of a run, without a row that are not worth a word."""
CUT_OFF, MANY_FINE_ROWS = 0.2, 300
"""Cut-off that is proposed, in times t_s, of which the first mode has a period of 1.8; and how many
rows, less than half of it apart, make a run slow."""
CYCLE_JUMP_REL_TOL = 1e-6
"""Difference of the ends of a cycle, relative to its range, that does not count as a jump."""


def input_notes(quantities: SceneQuantities) -> Iterator[str]:
    """What was read from files, what was taken out, and what is finer than the motion, in words;
    no warnings.
    """
    scene = quantities.scene
    for name, source in scene.inputs.items():
        if not isinstance(source, TableInput):
            continue
        if source.measured is not None:
            yield f"{_key(scene, name)}: {source.measured.sentence(len(source.rows or ()))}"
        if source.measured is None or not source.measured.largest:
            yield from _too_fine(source, quantities, _key(scene, name))


def _too_fine(source: TableInput, quantities: SceneQuantities, where: str) -> Iterator[str]:
    """A table that is followed row by row, many of its rows closer than the motion can tell."""
    end, motion = quantities.scene.run.duration, quantities.scales.t_s
    cut_off = CUT_OFF * motion
    time = np.array(source.rows or ())[:, 0]
    cycles = end / source.period if source.period is not None else 1.0
    gaps = np.diff(time if source.repeat else time[time <= end])
    fine = int(cycles * np.count_nonzero(gaps < cut_off / 2))
    if fine > MANY_FINE_ROWS:
        yield (
            f"{where}: {fine} rows of the run are less than {500 * cut_off:.2g} ms from the one "
            f"before, too close for the motion to resolve (t_s is {1e3 * motion:.2g} ms), but each "
            f"is followed, which takes time; fewer straight pieces: smooth: {1e3 * cut_off:.2g} ms"
        )


def table_notices(scene: Scene) -> Iterator[Notice]:
    """Tables that do not reach over the run, and cycles with a jump."""
    for name, source in scene.inputs.items():
        where = _key(scene, name)
        if source.covered is not None:
            yield from _uncovered(scene, name, source.covered, where)
        if isinstance(source, TableInput) and source.repeat:
            yield from _jump(source, where)


def _uncovered(
    scene: Scene, name: str, covered: tuple[float, float], where: str
) -> Iterator[Notice]:
    """Times of the run that have no row. Rows of a spec are meant so, unless none is met or the
    run goes on for a hundred times as long.
    """
    source, end = scene.inputs[name], scene.run.duration
    first, last = covered
    measured = source.measured if isinstance(source, TableInput) else None
    is_measured = measured is not None
    spacing = (last - first) / (measured.rows - 1) if measured is not None else 0.0
    margin = min(SPACINGS * spacing, SHARE_OF_RUN * end)
    held = [_amount(source.values(np.array([t]))[0], source.gives_pressure) for t in covered]
    span = f"the table has rows from {first:g} s to {last:g} s"
    if first >= end:
        yield Notice(
            "table_misses_run",
            f"{span}, the run ends at {end:g} s: nothing moves, the input stays at {held[0]}. "
            "Subtract the start from the table's times, or use a longer run.duration",
            where,
        )
        return
    if is_measured and first > margin:
        yield Notice(
            "table_starts_late",
            f"{span}: before, from 0 s on, the input stays at {held[0]}",
            where,
            0.0,
        )
    is_short = 0.0 < last - first < SHARE_OF_RUN * end
    if (is_measured or is_short) and last < end * (1 - 1e-9) - margin:
        yield Notice(
            "table_ends_early",
            f"{span}: from then to the end of the run at {end:g} s the input stays at {held[1]}",
            where,
            last,
        )


def _jump(source: TableInput, where: str) -> Iterator[Notice]:
    rows = source.rows or ()
    values = [value for _, value in rows]
    apart = values[0] - values[-1]
    if abs(apart) > CYCLE_JUMP_REL_TOL * (max(values) - min(values)):
        yield Notice(
            "cycle_jumps",
            f"the cycle ends at {_amount(values[-1], True)} and begins at "
            f"{_amount(values[0], True)}: the input jumps by {_amount(apart, True)} every "
            f"{source.period:.6g} s. Let the first and the last row meet if that is not meant",
            where,
        )


def _amount(value: float, is_pressure: bool) -> str:
    return f"{value / 1e3:.4g} kPa" if is_pressure else f"{1e6 * value:.4g} mL"


def _key(scene: Scene, name: str) -> str:
    return "input" if scene.several_inputs is None else f"inputs.{name}"
