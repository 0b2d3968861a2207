"""Events that end a run: from there on a solution has no meaning, whatever solves it.

Each has one time. Solvers look for events at all their own steps, and locate them between two of
these, so that no event depends on the outputs that were asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.rod_equations import RodForm
from viscodesign.solve.event_failures import (
    EventError,
    emptied_bellow,
    folded_axis,
    overdrawn_bellow,
    thinnest_section,
)
from viscodesign.solve.obstacles import FLOOR_REL_TOL
from viscodesign.solve.problem import Problem, evaluate_at, evaluate_times, section_strains
from viscodesign.solve.statics import Start

VANISHING_STRETCH = 0.01
"""Stretch of a section that ends a run: the linear law presses it to nothing, and on the way there
any two solutions part."""
DIP_MARGIN = 3.0
"""Depth of a dip between two rows, relative to its parabola's, that is looked into."""

Rows = Mapping[str, np.ndarray]
"""Named outputs, each (T, n); pressures and volumes in the order of the bellows."""


Found = tuple[int, EventError] | None
"""The first row without a meaning, and why."""


@dataclass(frozen=True)
class Crossing:
    """An event between two neighbouring times of a solution."""

    origin: Start
    origin_time: float
    """Unknowns some steps earlier, and when [s]."""
    before: Start
    """Unknowns at the first of the two."""
    begin: float
    end: float
    """Equal to ``begin`` where the solution begins with the event [s]."""
    error: EventError


class EventWatch:
    """Looks for events at any times of a solution."""

    def __init__(self, problem: Problem) -> None:
        self._problem = problem

    def first(self, time: np.ndarray, piece: np.ndarray, unknowns: np.ndarray) -> Found:
        """The first event among rows (m, nx + nz or more) at times (m,) of one smooth stretch.

        ``piece``: coefficients of the inputs there.
        """
        return first_event(self._problem, time, *self._rows(time, piece, unknowns))

    def crossing(
        self, time: np.ndarray, piece: np.ndarray, unknowns: np.ndarray
    ) -> Crossing | None:
        """The same as the times between which it happens, and the unknowns before it."""
        return self._between(time, unknowns, self.first(time, piece, unknowns))

    def crossing_and_dips(
        self, time: np.ndarray, pieces: np.ndarray, unknowns: np.ndarray
    ) -> tuple[Crossing | None, list[tuple[int, int]]]:
        """The same, and the pairs of rows before it between which an event may come and go.

        ``pieces``: coefficients of the inputs before each time (m, c).
        """
        rows, stretch = self._rows(time, pieces, unknowns)
        found = first_event(self._problem, time, rows, stretch)
        margins = event_margins(self._problem, rows, stretch)
        last = len(time) if found is None else found[0]
        dips = dips_below_zero(time[:last], margins[:last])
        return self._between(time, unknowns, found), dips

    def _rows(
        self, time: np.ndarray, piece: np.ndarray, unknowns: np.ndarray
    ) -> tuple[Rows, np.ndarray]:
        problem = self._problem
        states, count = problem.equations.states.count, problem.unknowns
        x, z = unknowns[:, :states].T, unknowns[:, states:count].T
        rows = evaluate_times(problem, x, z, time, piece)
        for name in ("pressure", "volume"):
            rows[name] = rows[name][:, problem.places]
        return rows, section_strains(problem, rows)[0]

    def _between(self, time: np.ndarray, unknowns: np.ndarray, found: Found) -> Crossing | None:
        if found is None:
            return None
        row, error = found
        before = max(row - 1, 0)
        origin, here = (start_of(self._problem, unknowns[k]) for k in (0, before))
        times = float(time[before]), float(time[row])
        return Crossing(origin, float(time[0]), here, *times, error)

    def vanishing(self, time: float, piece: np.ndarray, unknowns: np.ndarray) -> EventError | None:
        """The failure of a section that has hardly any length left, which no solver gets past."""
        here = start_of(self._problem, unknowns)
        values = evaluate_at(self._problem, here.states, here.algebraics, time, piece)
        stretch, _ = section_strains(self._problem, values)
        return thinnest_section(time, stretch[0]) if stretch.min() < VANISHING_STRETCH else None


def start_of(problem: Problem, unknowns: np.ndarray) -> Start:
    """States and algebraic unknowns of one row (nx + nz or more,)."""
    x, z, _ = np.split(unknowns, [problem.equations.states.count, problem.unknowns])
    return Start(x, z)


def first_event(problem: Problem, time: np.ndarray, rows: Rows, stretch: np.ndarray) -> Found:
    """The first event at times (T,); ``stretch``: of every section (T, S)."""
    checks: tuple[Callable[[], Found], ...] = (
        lambda: _vanished(time, stretch),
        lambda: _at_floor(problem, time, rows),
        lambda: _overdrawn(problem, time, rows),
        lambda: _jumped(problem, time, rows),
    )
    found = [event for check in checks if (event := check()) is not None]
    return min(found, key=lambda event: event[0]) if found else None


def event_margins(problem: Problem, rows: Rows, stretch: np.ndarray) -> np.ndarray:
    """How far all quantities are from the events that they lead to (T, k), in their own sizes."""
    margins = [stretch - VANISHING_STRETCH]
    if problem.floor_volume is not None:
        margins.append(rows["volume"] / (problem.floor_volume * (1 - FLOOR_REL_TOL)) - 1.0)
    if problem.drawing is not None:
        margins.append(1.0 - rows["pressure"] / problem.drawing.vacuum)
    return np.concatenate(margins, axis=1)


def dips_below_zero(time: np.ndarray, margins: np.ndarray) -> list[tuple[int, int]]:
    """Pairs of rows between which one of positive margins (T, k) may fall below zero and rise
    again: its parabola through a lowest row comes close.
    """
    if len(time) < 3:
        return []
    before, least, after = margins[:-2], margins[1:-1], margins[2:]
    step = np.diff(time)[:, None]
    into, out = (least - before) / step[:-1], (after - least) / step[1:]
    bend = (out - into) / (step[:-1] + step[1:])
    slope = into + bend * step[:-1]
    with np.errstate(divide="ignore", invalid="ignore"):
        drop = np.where(bend > 0.0, slope**2 / (4 * bend), 0.0)
    may_dip = (least <= before) & (least <= after) & (least < DIP_MARGIN * drop)
    return [(int(k), int(k) + 2) for k in np.flatnonzero(may_dip.any(axis=1))]


def _vanished(time: np.ndarray, stretch: np.ndarray) -> Found:
    row = _first(stretch.min(axis=1) < VANISHING_STRETCH)
    return None if row is None else (row, thinnest_section(float(time[row]), stretch[row]))


def _at_floor(problem: Problem, time: np.ndarray, rows: Rows) -> Found:
    """A gas-filled bellow at its minimum volume, below which its law becomes negative."""
    if problem.floor_volume is None:
        return None
    above = rows["volume"] - problem.floor_volume * (1 - FLOOR_REL_TOL)
    row = _first(above.min(axis=1) < 0.0)
    if row is None:
        return None
    return row, emptied_bellow(problem, float(time[row]), rows["volume"][row])


def _overdrawn(problem: Problem, time: np.ndarray, rows: Rows) -> Found:
    """Bellows from which a syringe cannot draw anything: at a vacuum, or with nothing to give."""
    if problem.drawing is None:
        return None
    is_over = rows["pressure"].min(axis=1) < problem.drawing.vacuum
    least = problem.drawing.least_volume
    if least is not None:
        is_over |= rows["volume"].mean(axis=1) < least * (1 - FLOOR_REL_TOL)
    row = _first(is_over)
    if row is None:
        return None
    return row, overdrawn_bellow(problem, float(time[row]), rows["pressure"][row])


def _jumped(problem: Problem, time: np.ndarray, rows: Rows) -> Found:
    """The rod's axis folds onto itself between two rows."""
    if problem.equations.rod_form is RodForm.ARCS:
        return None
    jump = problem.rod.angle_jump(rows)
    if jump is None:
        return None
    row, section = jump
    return row, folded_axis(float(time[row]), section)


def _first(marked: np.ndarray) -> int | None:
    """The first row that is marked, of (T,); None where none is."""
    return int(np.argmax(marked)) if marked.any() else None
