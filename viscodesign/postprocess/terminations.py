"""Events that end a run with a named failure, so that no wrong answer passes for a result.

Each check looks at the solution row by row and finds the first row without a meaning. The
balances of the whole run are checked in `broken_balance`.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Notice
from viscodesign.results.trajectory import Invariants
from viscodesign.solve.event_failures import (
    EventError,
    emptied_bellow,
    thinnest_section,
)
from viscodesign.solve.events import Rows, first_event
from viscodesign.solve.problem import Problem


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


def first_termination(
    problem: Problem, time: np.ndarray, rows: Rows, stretch: np.ndarray, failure: SolveError | None
) -> tuple[int, SolveError | None]:
    """Number of rows up to which a motion has a meaning, and why it ends there.

    ``stretch``: of every section (T, S); ``failure``: that of the solver, which a nearby
    cause explains better.
    """
    # NaN compares false with everything: it is found first, so that its row is the earliest.
    checks = (_not_finite, first_event)
    found = [e for check in checks if (e := check(problem, time, rows, stretch)) is not None]
    if found:
        return min(found, key=lambda ending: ending[0])
    return len(time), _explained(problem, float(time[-1]), rows, stretch, failure)


def _explained(
    problem: Problem, time: float, rows: Rows, stretch: np.ndarray, failure: SolveError | None
) -> SolveError | None:
    """The failure of a solver, or its cause where the last row, at ``time`` [s], shows one."""
    if failure is None or isinstance(failure, EventError):
        return failure
    when = time if failure.time_s is None else failure.time_s
    if stretch[-1].min() < LIMITS.thin_stretch:
        # The integrator gives up on a section that is about to vanish.
        return thinnest_section(when, stretch[-1])
    if not problem.equations.incompressible:
        volume = rows["volume"][-1]
        if float(np.min(volume / problem.rest_volume)) < LIMITS.empty_volume:
            return emptied_bellow(problem, when, volume)
    return failure


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


def _not_finite(
    problem: Problem, time: np.ndarray, rows: Rows, stretch: np.ndarray
) -> tuple[int, SolveError] | None:
    bad = ~np.isfinite(stretch).all(axis=1)
    checked = {name: rows[name] for name in ("pressure", "volume", "position") if name in rows}
    for values in checked.values():
        bad |= ~np.isfinite(values).all(axis=1)
    if not bad.any():
        return None
    row = int(np.argmax(bad))
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
