"""Events that end a run with a named failure, so that no wrong answer passes for a result.

Each check looks at the solution row by row and finds the first row without a meaning. The
balances of the whole run are checked in `broken_balance`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.rod_equations import RodForm
from viscodesign.results.findings import Notice
from viscodesign.results.trajectory import Invariants
from viscodesign.solve.equilibrium_failures import vanished_section
from viscodesign.solve.obstacles import Obstacle, advice
from viscodesign.solve.problem import Problem

FLOOR_REL_TOL = 0.02
"""Part of its minimum volume by which a bellow may fall below it: loads take volume too."""


@dataclass(frozen=True)
class TerminationLimits:
    """When a solution has no meaning, and what its failure is attributed to."""

    empty_volume: float = 0.2
    """Volume of a bellow, of that at rest, below which the failure of a gas is attributed to it."""
    thin_stretch: float = 0.3
    """Stretch of a section below which a failure is attributed to it."""
    volume_imbalance: float = 1e-8
    """Imbalance of fluid, relative, that no run may have."""
    energy_imbalance: float = 0.1
    """Imbalance of energy, over the work done, from which a motion is not one of the model. Over
    the table of hard cases a verified run ends below 1e-4, a first solution, at the largest
    tolerance, below 5e-3; an undamped rod released from rest, the worst case seen, at 0.03. A
    term of the equations that is wrong by a factor of two shows up in full."""
    energy_doubtful: float = 1e-3
    """The same from which a warning is given: ten times what refinement seeks."""


LIMITS = TerminationLimits()

Rows = Mapping[str, np.ndarray]
Found = tuple[int, SolveError] | None
"""The first row without a meaning, and why."""


def first_termination(
    problem: Problem, time: np.ndarray, rows: Rows, stretch: np.ndarray, failure: SolveError | None
) -> tuple[int, SolveError | None]:
    """Number of rows up to which a motion has a meaning, and why it ends there.

    ``stretch``: of every section (T, S); ``failure``: that of the solver, which a nearby
    cause explains better.
    """
    checks: tuple[Callable[[], Found], ...] = (
        lambda: _not_finite(problem, time, rows, stretch),
        lambda: _vanished(time, stretch),
        lambda: _at_floor(problem, time, rows),
        lambda: _jumped(problem, time, rows),
    )
    # NaN compares false with everything: it is found first, so that its row is the earliest.
    found = [ending for check in checks if (ending := check()) is not None]
    if found:
        return min(found, key=lambda ending: ending[0])
    if failure is not None and stretch[-1].min() < LIMITS.thin_stretch:
        # The integrator gives up on a section that is about to vanish.
        return len(time), _thinnest(time[-1], stretch[-1])
    if failure is not None and not problem.equations.incompressible:
        least = float(rows["volume"][-1].min()) / _rest_volume(problem)
        if least < LIMITS.empty_volume:
            return len(time), _emptied(problem, time, rows, len(time) - 1)
    return len(time), failure


def broken_balance(invariants: Invariants, time: float) -> SolveError | None:
    """The failure of a run that violates the balance of fluid or energy, up to ``time`` [s]."""
    volume, energy = invariants.volume_imbalance_rel, invariants.energy_imbalance_rel
    if volume is not None and not volume <= LIMITS.volume_imbalance:
        return SolveError(
            f"fluid volume is not conserved: up to t = {time:.6g} s inflow and storage differ "
            f"by {volume:.2g} (relative, limit {LIMITS.volume_imbalance:g})",
            quantity="volume balance",
            where="network",
            time_s=time,
            remedy="Tighten `accuracy`; very different tube resistances make the balance "
            "ill-conditioned.",
        )
    if energy is not None and not energy <= LIMITS.energy_imbalance:
        return SolveError(
            f"energy balance violated: up to t = {time:.6g} s the residual is {energy:.2g} of the "
            f"work done (coupling work excluded, limit {LIMITS.energy_imbalance:g})",
            quantity="energy balance",
            where="actuator",
            time_s=time,
            remedy="Tighten `accuracy`, or use a smaller `run.output_interval`.",
        )
    return None


def doubted_balance(invariants: Invariants) -> Iterator[Notice]:
    """A warning where the energy balance is poor."""
    energy = invariants.energy_imbalance_rel
    if energy is not None and energy > LIMITS.energy_doubtful:
        yield Notice(
            "energy_imbalance",
            f"the residual of the energy balance is {energy:.2g} of the work done (coupling work "
            "excluded): tighten `accuracy`, or use a smaller `run.output_interval`",
            "actuator",
        )


def _not_finite(problem: Problem, time: np.ndarray, rows: Rows, stretch: np.ndarray) -> Found:
    bad = ~np.isfinite(stretch).all(axis=1)
    checked = {name: rows[name] for name in ("pressure", "volume", "position") if name in rows}
    for values in checked.values():
        bad |= ~np.isfinite(values).all(axis=1)
    row = _first(bad)
    if row is None:
        return None
    name = next((n for n, v in checked.items() if not np.isfinite(v[row]).all()), "stretch")
    where = "rod"
    if name in ("pressure", "volume"):
        where = problem.bellows[int(np.argmin(np.isfinite(checked[name][row])))]
    return row, SolveError(
        f"the {name} of {where} is not finite from t = {time[row]:.6g} s on",
        quantity=name,
        where=where,
        time_s=float(time[row]),
        remedy="Lower the pressure or the loads; the last rows show where it diverges.",
    )


def _vanished(time: np.ndarray, stretch: np.ndarray) -> Found:
    row = _first(stretch.min(axis=1) <= 0.0)
    return None if row is None else (row, _thinnest(time[row], stretch[row]))


def _at_floor(problem: Problem, time: np.ndarray, rows: Rows) -> Found:
    """A gas-filled bellow at its minimum volume, below which its law becomes negative."""
    if problem.floor_volume is None:
        return None
    row = _first(rows["volume"].min(axis=1) < problem.floor_volume * (1 - FLOOR_REL_TOL))
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
        remedy="Lower the loads, or tighten `accuracy`, which refines the mesh.",
    )


def _first(marked: np.ndarray) -> int | None:
    """The first row that is marked, of (T,); None where none is."""
    return int(np.argmax(marked)) if marked.any() else None


def _thinnest(time: float, stretch: np.ndarray) -> SolveError:
    return vanished_section(float(time), int(np.argmin(stretch)), float(np.min(stretch)))


def _rest_volume(problem: Problem) -> float:
    """Volume of one bellow at zero gauge [m3]."""
    return float(problem.equations.rest_amounts[0])


def _emptied(problem: Problem, time: np.ndarray, rows: Rows, row: int) -> SolveError:
    """The failure of a bellow that is emptied: no gas fills a negative volume."""
    volume = rows["volume"][row]
    name, when = problem.bellows[int(np.argmin(volume))], float(time[row])
    share = float(np.min(volume)) / _rest_volume(problem)
    return SolveError(
        f"{name} reached its minimum (collapsed) volume after t = {when:.6g} s, with {share:.3g} "
        "of its rest volume: the linear law continues to negative volumes, which no gas can fill",
        quantity="volume",
        where=name,
        time_s=when,
        remedy=advice(problem.remedies, Obstacle.EMPTY_BELLOW, "Raise the lowest pressure"),
    )
