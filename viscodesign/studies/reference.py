"""A solution that is accurate enough to measure the errors of others."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from viscodesign.errors import SolveError, ViscodesignError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.accuracy_points import Reference
from viscodesign.simulation.build_problem import Settings
from viscodesign.simulation.solve_once import Run, tip_difference
from viscodesign.solve.transient import solver_catalogue
from viscodesign.studies.timed_runs import OutOfTimeError, TimedRuns

TRIAL_TOLERANCE = 1e-3
"""Tolerance of the trial of each solver on the coarsest mesh."""


@dataclass(frozen=True)
class ReferenceRules:
    """How the reference is chosen and refined."""

    first_tolerance: float = 1e-5
    finest_tolerance: float = 1e-11
    slow_factor: float = 10.0
    """A solver that takes this multiple of the fastest one's time makes no reference."""
    converged: float = 0.1
    """Convergence, relative to the smallest error of interest, that is sufficient."""
    fully_converged: float = 0.01
    """Convergence beyond which the reference is not refined even if that is cheap."""
    cheap_share: float = 0.2
    """Fraction of the study's time up to which a sufficient reference is refined."""
    affordable_share: float = 0.6
    """The same for one that is not yet sufficient."""
    cost_growth: float = 6.0
    """Assumed cost of a refinement relative to the last solution, until it is measured."""
    resolved: float = 3.0
    """Errors are resolved down to this multiple of the convergence."""
    rounding_rel: float = 1e-9
    """Distance of two tips that is rounding error, in actuator lengths."""


RULES = ReferenceRules()


@dataclass(frozen=True)
class ReferenceMotion:
    """The motion of the reference, against which errors are measured."""

    run: Run
    reference: Reference
    trials_s: Mapping[str, float]
    """Time of the trial of each solver that was not too slow [s]."""

    def error(self, run: Run) -> tuple[float, bool]:
        """Tip error [m], and whether it is an upper bound only."""
        measured = tip_difference(run.motion, self.run.motion)
        least = self.reference.smallest_error_m
        return max(measured, least), measured < least

    def trial_s(self, solver: str) -> float:
        """Time of a solver's trial [s]; a lower bound if it was too slow."""
        slow_s = RULES.slow_factor * min(self.trials_s.values(), default=self.run.solve_s)
        return self.trials_s.get(solver, slow_s)


def solve_reference(runs: TimedRuns, least_edges: int, smallest_rel: float) -> ReferenceMotion:
    """Solve with all effects that the spec allows, refining until the tip has converged.

    Each refinement doubles the edges and divides the tolerance by ten. ``smallest_rel``:
    smallest error of interest, in actuator lengths. Raises `SolveError` if the scene cannot be
    solved with all its effects.
    """
    trials_s = _trials(runs, least_edges)
    settings = Settings(2 * least_edges, RULES.first_tolerance, _most_accurate(trials_s))
    length = runs.quantities.body.length
    found: list[Run] = []
    costs: list[float] = []
    apart = math.inf
    while _refines(runs, found, costs, apart / length / smallest_rel):
        began = runs.spent_s
        # A study needs two solutions; a third one is optional.
        share = 1.0 if len(found) < 2 else RULES.affordable_share
        try:
            run = _solved(runs, settings, share * runs.limit_s - began)
        except OutOfTimeError:
            break
        if found:
            apart = max(tip_difference(found[-1].motion, run.motion), RULES.rounding_rel * length)
        found.append(run)
        costs.append(runs.spent_s - began)
        settings = _refined(run)
    if len(found) < 2:
        raise _no_time(runs)
    return ReferenceMotion(found[-1], _described(runs, found[-1], apart, smallest_rel), trials_s)


def _trials(runs: TimedRuns, edges: int) -> dict[str, float]:
    """Time of each solver at a loose tolerance [s], without those that are far slower."""
    times: dict[str, float] = {}
    for solver in solver_catalogue():
        settings = Settings(edges, TRIAL_TOLERANCE, solver)
        limit = RULES.slow_factor * min(times.values()) + 1.0 if times else runs.remaining_s
        try:
            run = runs.run(runs.selection.everything, settings, limit)
        except (ViscodesignError, OutOfTimeError):
            continue
        if run.is_complete and run.solution.solver == solver:
            times[solver] = run.solve_s
    fastest = min(times.values(), default=0.0)
    return {name: t for name, t in times.items() if t <= RULES.slow_factor * fastest}


def _most_accurate(solvers: Mapping[str, float]) -> str:
    """The most accurate solver for its tolerance."""
    kinds = solver_catalogue()
    return min(
        solvers, key=lambda name: kinds[name].tip_error_per_tolerance, default=next(iter(kinds))
    )


def _solved(runs: TimedRuns, settings: Settings, within_s: float) -> Run:
    try:
        run = runs.run(runs.selection.everything, settings, within_s)
    except SolveError as error:
        raise _unsolvable(error) from error
    if run.motion.failure is not None:
        raise _unsolvable(run.motion.failure)
    return run


def _unsolvable(error: SolveError) -> SolveError:
    return SolveError(
        "no reference solution: the scene cannot be solved with all the effects that its spec "
        f"allows: {error}",
        quantity=error.quantity,
        where="reference",
        time_s=error.time_s,
        remedy="Switch off the effect that fails, as in --set effects.NAME=off.",
    )


def _no_time(runs: TimedRuns) -> SolveError:
    return SolveError(
        "the reference (two solutions with all effects) does not fit into the time limit of "
        f"{runs.limit_s:.3g} s",
        quantity="time",
        where="reference",
        remedy="Increase --limit, or use a shorter run.duration.",
    )


def _refines(runs: TimedRuns, found: list[Run], costs: list[float], rel: float) -> bool:
    """Whether to refine; ``rel``: convergence relative to the smallest error of interest."""
    if len(found) < 2:
        return True
    if rel <= RULES.fully_converged or found[-1].settings.tolerance <= RULES.finest_tolerance:
        return False
    share = RULES.cheap_share if rel <= RULES.converged else RULES.affordable_share
    growth = max(costs[-1] / costs[-2], 2.0) if len(found) > 2 else RULES.cost_growth
    return runs.spent_s + growth * costs[-1] <= share * runs.limit_s


def _refined(run: Run) -> Settings:
    settings = run.settings
    edges = settings.edges_per_section * (1 if run.is_exact_in_space else 2)
    return replace(settings, edges_per_section=edges, tolerance=settings.tolerance / 10)


def _described(runs: TimedRuns, run: Run, apart: float, smallest_rel: float) -> Reference:
    length = runs.quantities.body.length
    return Reference(
        effects=tuple(e.name for e in runs.selection.members(runs.selection.everything)),
        edges=run.settings.edges_per_section,
        tolerance=run.settings.tolerance,
        solver=run.settings.solver,
        solve_s=run.solve_s,
        convergence_m=apart,
        convergence_rel=apart / length,
        smallest_error_m=RULES.resolved * apart,
        is_converged=apart / length <= RULES.converged * smallest_rel,
    )
