"""A solution so fine that the errors of others can be measured against it."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from viscodesign.errors import SolveError, ViscodesignError
from viscodesign.results.accuracy_study import Reference
from viscodesign.simulation.build_problem import Settings
from viscodesign.simulation.solve_once import Run, tip_difference
from viscodesign.solve.transient import solver_catalogue
from viscodesign.studies.bench import Bench, Names, OutOfTimeError

FIRST_TOLERANCE, FINEST_TOLERANCE = 1e-5, 1e-11
TRIAL_TOLERANCE = 1e-3
TOO_SLOW = 10.0
"""A solver that takes so many times the fastest one's time makes no reference."""
WELL_BELOW = 0.1
"""Convergence of a reference, of the smallest error to be told, at which it will do."""
FAR_BELOW = 0.01
"""The same at which it is not made finer even where that is cheap."""
CHEAP, AFFORDABLE = 0.2, 0.6
"""Parts of the study's time up to which a reference that does, or does not, is made finer."""
DEARER = 6.0
"""What the next finer solution costs in times of the last, until that is known better."""
TELLING = 3.0
"""Times its convergence, a reference can tell an error."""
ROUNDING = 1e-9
"""Distance of two tips, in actuator lengths, that says nothing."""


@dataclass(frozen=True)
class Gauge:
    """The reference's motion, which tells errors."""

    run: Run
    reference: Reference

    def error(self, run: Run) -> tuple[float, bool]:
        """Tip error [m], and whether it is only known to be at most this."""
        measured = tip_difference(run.motion, self.run.motion)
        least = self.reference.smallest_error_m
        return max(measured, least), measured < least


def make_reference(bench: Bench, least_edges: int, smallest_rel: float) -> Gauge:
    """Everything that the spec allows, ever finer, until its tip stands still.

    From one solution to the next, edges are doubled and the tolerance is cut to a
    tenth. ``smallest_rel``: smallest error to be told, in actuator lengths.
    Raises `SolveError` where the scene cannot be solved with all of its effects.
    """
    names = bench.selection.everything
    settings = Settings(2 * least_edges, FIRST_TOLERANCE, _solver(bench, names, least_edges))
    length = bench.quantities.body.length
    runs: list[Run] = []
    costs: list[float] = []
    apart = math.inf
    while _goes_on(bench, runs, costs, apart / length / smallest_rel):
        began = bench.spent_s
        # Without two solutions there is no study; a third may be had or not.
        share = 1.0 if len(runs) < 2 else AFFORDABLE
        try:
            found = _solved(bench, names, settings, share * bench.limit_s - began)
        except OutOfTimeError:
            break
        if runs:
            apart = max(tip_difference(runs[-1].motion, found.motion), ROUNDING * length)
        runs.append(found)
        costs.append(bench.spent_s - began)
        settings = _finer(found)
    if len(runs) < 2:
        raise _no_time(bench)
    return Gauge(runs[-1], _described(bench, runs[-1], apart, smallest_rel))


def _solver(bench: Bench, names: Names, edges: int) -> str:
    """The most accurate solver for its tolerance, of those that are not far slower."""
    times: dict[str, float] = {}
    for solver in solver_catalogue():
        settings = Settings(edges, TRIAL_TOLERANCE, solver)
        within = TOO_SLOW * min(times.values()) + 1.0 if times else bench.remaining_s
        try:
            run = bench.run(names, settings, within)
        except (ViscodesignError, OutOfTimeError):
            continue
        if run.is_complete:
            times[solver] = run.solve_s
    kinds = solver_catalogue()
    fit = [name for name in times if times[name] <= TOO_SLOW * min(times.values())]
    return min(fit, key=lambda name: kinds[name].tip_error_per_tolerance, default=next(iter(kinds)))


def _solved(bench: Bench, names: Names, settings: Settings, within_s: float) -> Run:
    try:
        run = bench.run(names, settings, within_s)
    except SolveError as error:
        raise _impossible(error) from error
    if run.motion.failure is not None:
        raise _impossible(run.motion.failure)
    return run


def _impossible(error: SolveError) -> SolveError:
    return SolveError(
        "there is no reference, since the scene cannot be solved with all the effects that its "
        f"spec allows: {error}",
        quantity=error.quantity,
        where="reference",
        time_s=error.time_s,
        remedy="Switch off what it cannot have, as in --set effects.NAME=off.",
    )


def _no_time(bench: Bench) -> SolveError:
    return SolveError(
        f"the reference, two solutions of the scene with all its effects, does not fit into "
        f"the {bench.limit_s:.3g} s of the study",
        quantity="time",
        where="reference",
        remedy="Give it more time with --limit, or a shorter run.duration.",
    )


def _goes_on(bench: Bench, runs: list[Run], costs: list[float], part: float) -> bool:
    """Whether to make it finer. ``part``: how far the last two are apart, of what is told."""
    if len(runs) < 2:
        return True
    if part <= FAR_BELOW or runs[-1].settings.tolerance <= FINEST_TOLERANCE:
        return False
    share = CHEAP if part <= WELL_BELOW else AFFORDABLE
    growth = max(costs[-1] / costs[-2], 2.0) if len(runs) > 2 else DEARER
    return bench.spent_s + growth * costs[-1] <= share * bench.limit_s


def _finer(run: Run) -> Settings:
    settings = run.settings
    edges = settings.edges_per_section * (1 if run.is_exact_in_space else 2)
    return replace(settings, edges_per_section=edges, tolerance=settings.tolerance / 10)


def _described(bench: Bench, run: Run, apart: float, smallest_rel: float) -> Reference:
    length = bench.quantities.body.length
    return Reference(
        effects=tuple(e.name for e in bench.selection.members(bench.selection.everything)),
        edges=run.settings.edges_per_section,
        tolerance=run.settings.tolerance,
        solver=run.settings.solver,
        solve_s=run.solve_s,
        convergence_m=apart,
        convergence_rel=apart / length,
        smallest_error_m=TELLING * apart,
        is_converged=apart / length <= WELL_BELOW * smallest_rel,
    )
