"""What ends a run by its name, so that no finite wrong answer gets out.

Each watch looks at what was solved, row by row, and names the first row from which on it
has no meaning. The balances of the whole run are watched in `broken_balance`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.model.rod_equations import RodForm
from viscodesign.results.findings import Notice
from viscodesign.results.trajectory import Invariants
from viscodesign.solve.problem import Problem
from viscodesign.solve.unloaded_state import vanished_section

NEARLY_EMPTY = 0.2
"""Volume of a bellow, of that at rest, at which a gas's failure is put down to it."""
NEARLY_NOTHING = 0.3
"""Stretch of a section below which a failure is put down to it."""
SLIGHT = 0.02
"""Part of its floor by which a bellow may pass it: loads take volume too."""
VOLUME_LIMIT = 1e-8
"""Imbalance of fluid, relative, that no run may have."""
ENERGY_BROKEN = 0.1
"""Imbalance of energy, over the work done, from which a motion is none of the model's. Over the
table of hard cases a verified run ends below 1e-4, a first solution, at the largest tolerance,
below 5e-3; an undamped rod let go, the worst that was met, at 0.03. A term of the equations that is
wrong twofold shows up in full. What is beyond a tenth was made or lost by the solution."""
ENERGY_DOUBTED = 1e-3
"""The same from which it is warned of: ten times what refinement seeks."""

Rows = Mapping[str, np.ndarray]
Found = tuple[int, SolveError] | None
"""The first row without meaning, and why."""


def first_ending(
    problem: Problem, time: np.ndarray, rows: Rows, stretch: np.ndarray, failure: SolveError | None
) -> tuple[int, SolveError | None]:
    """Rows (T,) up to which a motion has a meaning, and why it ends there.

    ``stretch``: of every section (T, S); ``failure``: the solver's, which a nearby cause
    explains better.
    """
    watches: tuple[Callable[[], Found], ...] = (
        lambda: _not_finite(problem, time, rows, stretch),
        lambda: _vanished(time, stretch),
        lambda: _at_floor(problem, time, rows),
        lambda: _jumped(problem, time, rows),
    )
    # What is not finite compares with nothing, hence is cut off before the others look.
    found = [ending for watch in watches if (ending := watch()) is not None]
    if found:
        return min(found, key=lambda ending: ending[0])
    if failure is not None and stretch[-1].min() < NEARLY_NOTHING:
        # The integrator gives up on a section that is about to vanish.
        return len(time), _thinnest(time[-1], stretch[-1])
    if failure is not None and not problem.equations.incompressible:
        least = float(rows["volume"][-1].min()) / _rest_volume(problem)
        if least < NEARLY_EMPTY:
            return len(time), _emptied(problem, time, rows, len(time) - 1)
    return len(time), failure


def broken_balance(invariants: Invariants, time: float) -> SolveError | None:
    """The failure of a run whose fluid or energy is not kept, up to ``time`` [s]."""
    volume, energy = invariants.volume_imbalance_rel, invariants.energy_imbalance_rel
    if volume is not None and not volume <= VOLUME_LIMIT:
        return SolveError(
            f"fluid is not kept: up to t = {time:.6g} s what flowed in and what is stored differ "
            f"by {volume:.2g}, more than {VOLUME_LIMIT:g}",
            quantity="volume balance",
            where="network",
            time_s=time,
            remedy="Ask for more accuracy; tubes of very unlike resistance make it hard to keep.",
        )
    if energy is not None and not energy <= ENERGY_BROKEN:
        return SolveError(
            f"energy is not kept: up to t = {time:.6g} s it differs by {energy:.2g} of the work "
            f"done, more than {ENERGY_BROKEN:g}, beyond the work of the coupling",
            quantity="energy balance",
            where="actuator",
            time_s=time,
            remedy="Ask for more accuracy, or write down more outputs.",
        )
    return None


def doubted_balance(invariants: Invariants) -> Iterator[Notice]:
    """A warning where energy is kept badly."""
    energy = invariants.energy_imbalance_rel
    if energy is not None and energy > ENERGY_DOUBTED:
        yield Notice(
            "energy_imbalance",
            f"energy differs by {energy:.2g} of the work done, beyond the work of the coupling: "
            "ask for more accuracy, or look at how finely the outputs show the motion",
            "actuator",
        )


def _not_finite(problem: Problem, time: np.ndarray, rows: Rows, stretch: np.ndarray) -> Found:
    bad = ~np.isfinite(stretch).all(axis=1)
    told = {name: rows[name] for name in ("pressure", "volume", "position") if name in rows}
    for values in told.values():
        bad |= ~np.isfinite(values).all(axis=1)
    row = _first(bad)
    if row is None:
        return None
    name = next((n for n, v in told.items() if not np.isfinite(v[row]).all()), "stretch")
    where = "rod"
    if name in ("pressure", "volume"):
        where = problem.bellows[int(np.argmin(np.isfinite(told[name][row])))]
    return row, SolveError(
        f"the {name} of {where} has no value from t = {time[row]:.6g} s on",
        quantity=name,
        where=where,
        time_s=float(time[row]),
        remedy="Lower the pressure or the loads; the last rows show where it runs away.",
    )


def _vanished(time: np.ndarray, stretch: np.ndarray) -> Found:
    row = _first(stretch.min(axis=1) <= 0.0)
    return None if row is None else (row, _thinnest(time[row], stretch[row]))


def _at_floor(problem: Problem, time: np.ndarray, rows: Rows) -> Found:
    """A gas-filled bellow at its floor, where nothing but the floor would keep it from nought."""
    if problem.floor_volume is None:
        return None
    row = _first(rows["volume"].min(axis=1) < problem.floor_volume * (1 - SLIGHT))
    return None if row is None else (row, _emptied(problem, time, rows, max(row - 1, 0)))


def _jumped(problem: Problem, time: np.ndarray, rows: Rows) -> Found:
    """The rod's axis folds onto itself between two outputs."""
    if problem.equations.rod_form is RodForm.ARCS:
        return None
    jump = problem.rod.angle_jump(rows)
    if jump is None:
        return None
    row, section = jump[0], jump[1] + 1
    when = float(time[row])
    return row, SolveError(
        f"the angle in section {section} jumps at t = {when:.6g} s: the rod folds onto itself "
        "between two nodes",
        quantity="angle",
        where=f"section {section}",
        time_s=when,
        remedy="Lower the loads, or ask for more accuracy, which takes a finer mesh.",
    )


def _first(marked: np.ndarray) -> int | None:
    """The first row that is marked (T,); None where none is."""
    return int(np.argmax(marked)) if marked.any() else None


def _thinnest(time: float, stretch: np.ndarray) -> SolveError:
    return vanished_section(float(time), int(np.argmin(stretch)), float(np.min(stretch)))


def _rest_volume(problem: Problem) -> float:
    """What one bellow holds at zero gauge [m3]."""
    return float(problem.equations.rest_amounts[0])


def _emptied(problem: Problem, time: np.ndarray, rows: Rows, row: int) -> SolveError:
    """The failure of a bellow that is sucked empty: no gas fills a volume of nothing."""
    volume = rows["volume"][row]
    name, when = problem.bellows[int(np.argmin(volume))], float(time[row])
    share = float(np.min(volume)) / _rest_volume(problem)
    return SolveError(
        f"{name} is sucked to its floor after t = {when:.6g} s, where it holds {share:.3g} of its "
        "rest volume: the linear law goes on to negative volumes, which no gas can fill",
        quantity="volume",
        where=name,
        time_s=when,
        remedy="Let effects.collapse be auto, or raise the lowest pressure.",
    )
