"""The error of the tip: in time, in space, and by neglected effects.

Each part is measured or estimated separately, since each has its own remedy:

- **Time.** The scene is solved again on the same mesh with a tenth of the tolerance.
  Of the two solutions the finer one is kept; its error is a fraction of their distance.
  A solver that is exact in time needs no second solution.
- **Space.** Again on a mesh of half the edges' length, with the previous tolerance.
- **Neglected effects.** The distance to a solution with everything that the spec allows
  (`judged_effects`); where that is not to be had, of two estimates, with and without them.

That solution has ten times the tolerance and half the edges, so that its distance holds all three
at once. Where it is small enough nothing else is solved, and the parts are not told apart.

A part that is too large is refined and measured again, until the sum is below the requested
accuracy. The fractions are such that the sum is rarely below the true error and rarely ten
times above it (`benchmarks/error_study.py`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

from viscodesign.effects.base import Effect
from viscodesign.errors import SolveError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.simulation.build_problem import Settings
from viscodesign.simulation.solve_once import (
    FlowDifference,
    Progress,
    Run,
    Workspace,
    flow_difference,
    solve,
    tip_difference,
)


@dataclass(frozen=True)
class ErrorControlNumbers:
    """How errors follow from distances, and when refinement ends."""

    max_refinements: int = 6
    """Solutions beyond the first after which the accuracy counts as not reached."""
    time_share: float = 0.5
    """Error of the finer of two solutions whose tolerances differ tenfold, relative to their
    distance: over a hundred scenes 0.16 in the median, above 0.5 only where it was negligible."""
    space_share: float = 1.0
    """The same where the edges differ twofold, as order one has it: damped bellows on which the
    rod presses back. A third in the median, as order two has it."""
    least_share: float = 0.002
    """Part of the requested accuracy that each of both is at least: two solutions may agree by
    chance, the more so where little moves."""
    least_time_per_length: float = 0.9e-7
    """Least error in time, relative to the length: jumps leave as much."""
    max_growing: int = 2
    """Refinements in a row that each move the tip farther than the one before, after which no
    more are tried."""
    energy_imbalance: float = 1e-4
    """Energy residual, over the work done, above which smaller steps are tried once the tip is
    accurate enough: a motion that looks right may still lose or gain what it should keep."""
    useful_reduction: float = 0.8
    """Part of the least residual so far that smaller steps may leave, or they were of no use."""
    max_useless: int = 2
    """Solutions in a row that were of no use, after which no more are tried."""
    negligible_share: float = 0.05
    """Error of a solution, relative to that of neglected effects, that is not refined further."""


ERROR_CONTROL = ErrorControlNumbers()


@dataclass(frozen=True)
class ErrorParts:
    """The parts of the error at the tip [m]."""

    time_m: float | None
    space_m: float | None
    """These two are None where one distance holds all parts: then they are in the third."""
    neglected_m: float

    @property
    def total_m(self) -> float:
        """The sum of all parts, as if they all pointed the same way."""
        return self.steps_m + self.neglected_m

    @property
    def steps_m(self) -> float:
        """What is told apart as an error of steps and mesh."""
        return (self.time_m or 0.0) + (self.space_m or 0.0)


class Verifier:
    """Solves one scene, estimates its error, and refines it until that is small enough."""

    def __init__(
        self,
        quantities: SceneQuantities,
        effects: Sequence[Effect],
        neglected_m: float,
        progress: Progress | None,
        workspace: Workspace | None = None,
    ) -> None:
        self.quantities = quantities
        self.workspace = workspace or Workspace()
        self.effects = effects
        self.neglected_m = neglected_m
        """What is stated of neglected effects [m]."""
        self.measured_neglected = False
        """Whether that is measured, rather than estimated."""
        self.progress = progress
        self.requested_m = quantities.requested_m
        self.spent_s = 0.0
        self.solutions = 0
        self.steps = 0
        """Steps of all solutions together."""
        self.stalled = ""
        """Why further refinement would not help; empty where it may."""
        self.flows_apart: FlowDifference | None = None
        """How far the last refinement in time changed the flows."""
        self.interrupted = False
        """Whether verification was stopped; the solution before it is kept."""
        self._distance: dict[str, float] = {}
        self._growing = 0

    def solve(self, settings: Settings) -> Run:
        """Build and solve once."""
        run = solve(self.quantities, self.effects, settings, self.progress, self.workspace)
        self.spent_s += run.spent_s
        self.solutions += 1
        self.steps += run.solution.work.steps
        if self.steps > run.problem.max_steps:
            self.stalled = f"the limit of {run.problem.max_steps} steps (run.max_steps) was reached"
        return run

    def verify(
        self, run: Run, whole_error: Callable[[Run], float] | None = None
    ) -> tuple[Run, ErrorParts | None]:
        """The finest solution, and its error; None where one of them ended early.

        ``whole_error``: all parts of a solution's error together [m], where they need not be
        told apart.
        """
        refinement = _Refinement(self, run, whole_error)
        if not run.solution.asked_to_stop and refinement.is_sufficient():
            return run, refinement.parts
        while self.solutions <= ERROR_CONTROL.max_refinements and not self.stalled:
            if refinement.run.solution.asked_to_stop:
                self.interrupted = True
                return refinement.run, None
            try:
                finer = self.solve(refinement.next_settings())
            except SolveError as error:
                # Not even its start was found: the coarser solution stays as it is.
                self.stalled = f"the refined problem has no initial equilibrium: {error.short}"
                break
            except KeyboardInterrupt:  # before its first step
                self.interrupted = True
                return refinement.run, None
            if finer.solution.interrupted:
                self.interrupted = True
                return refinement.run, None
            if not finer.is_complete:
                return finer, None
            refinement.add(finer)
            if refinement.is_sufficient():
                break
        return refinement.run, refinement.parts

    def compare_flows(self, coarser: Run, finer: Run) -> None:
        """Note how far a coarser solution is from a finer one in its flows."""
        self.flows_apart = flow_difference(coarser.motion, finer.motion)

    def check_convergence(self, part: str, distance: float) -> None:
        """Note where refinements move the tip as far as those before them did."""
        before = self._distance.get(part, math.inf)
        is_growing = distance > self.requested_m and distance >= before
        self._growing = self._growing + 1 if is_growing else 0
        if self._growing >= ERROR_CONTROL.max_growing:
            self.stalled = (
                f"the error in {part} does not converge: successive refinements moved the tip by "
                f"{1e3 * before:.3g} mm and then by {1e3 * distance:.3g} mm"
            )
        self._distance[part] = distance


class _Refinement:
    """The solutions of one verification: the finest so far, and what is known of its error."""

    def __init__(
        self, verifier: Verifier, run: Run, whole_error: Callable[[Run], float] | None
    ) -> None:
        self.run = run
        self._verifier = verifier
        self._whole_error = whole_error
        self._space_m = 0.0 if run.is_exact_in_space else None
        self._time_m = self._round_off_m if run.is_exact_in_time else None
        self._least_imbalance = math.inf
        """Least energy residual, once smaller steps are to reduce it."""
        self._useless = 0

    @property
    def parts(self) -> ErrorParts | None:
        """The error of the finest solution, once all of its parts are known."""
        if self._whole_error is not None:
            return ErrorParts(None, None, self._whole_error(self.run))
        if self._time_m is None or self._space_m is None:
            return None
        return ErrorParts(self._time_m, self._space_m, self._verifier.neglected_m)

    @property
    def _is_in_space(self) -> bool:
        """Whether the mesh is to be refined next, or else the tolerance."""
        time_m, space_m = self._time_m, self._space_m
        is_coarse = time_m is not None and (space_m is None or space_m > time_m)
        return is_coarse and self._least_imbalance == math.inf

    @property
    def _round_off_m(self) -> float:
        """Least error in time."""
        return ERROR_CONTROL.least_time_per_length * self._verifier.quantities.body.length

    def next_settings(self) -> Settings:
        """Settings of the next solution."""
        settings = self.run.settings
        if self._is_in_space:
            return replace(settings, edges_per_section=2 * settings.edges_per_section)
        return replace(settings, tolerance=settings.tolerance / 10)

    def add(self, finer: Run) -> None:
        """Adopt a finer solution, and estimate the error from its distance."""
        coarser, self.run = self.run, finer
        if not self._is_in_space:
            self._compare_in_time(coarser)
            return
        distance = tip_difference(coarser.motion, finer.motion)
        self._verifier.check_convergence("space", distance)
        self._space_m = max(ERROR_CONTROL.space_share * distance, self._least_m)

    def _compare_in_time(self, coarser: Run) -> None:
        """Estimate the error in time from the distance of a solution with larger tolerance."""
        verifier, motion = self._verifier, self.run.motion
        distance = tip_difference(coarser.motion, motion)
        verifier.compare_flows(coarser, self.run)
        verifier.check_convergence("time", distance)
        self._time_m = max(ERROR_CONTROL.time_share * distance, self._least_m, self._round_off_m)

    @property
    def _least_m(self) -> float:
        """Least error in time or space that is stated [m]."""
        return ERROR_CONTROL.least_share * self._verifier.requested_m

    def is_sufficient(self) -> bool:
        """Whether the tip is accurate enough, and the energy balance as good as it gets."""
        parts, verifier = self.parts, self._verifier
        if parts is None:
            return False
        smaller = min(verifier.neglected_m, verifier.requested_m)
        is_negligible = parts.steps_m <= ERROR_CONTROL.negligible_share * smaller
        if parts.total_m > verifier.requested_m and not is_negligible:
            return False
        imbalance = self.run.motion.invariants.energy_imbalance_rel or 0.0
        is_useless = imbalance > ERROR_CONTROL.useful_reduction * self._least_imbalance
        self._useless = self._useless + 1 if is_useless else 0
        if imbalance <= ERROR_CONTROL.energy_imbalance:
            return True
        self._least_imbalance = min(self._least_imbalance, imbalance)
        return self._useless >= ERROR_CONTROL.max_useless
