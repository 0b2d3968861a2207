"""How wrong the tip may be: in time, in space, and by what was left out.

Each part is measured or estimated apart, since each has its own cure:

- **Time.** The scene is solved again on the same mesh with a tenth of the tolerance.
  Of the two solutions the finer one is kept; its error is a fraction of the distance.
- **Space.** Again on a mesh of half the edges' length, with the tolerance of before.
- **Omitted effects.** The distance of two sketches, one with everything that the spec
  allows, one with what was taken.

A part that is too large is made smaller, and measured again, until all together are
below the accuracy asked for. The fractions are such that the sum is rarely below the
true error and rarely ten times above it (`benchmarks/error_study.py`).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from viscodesign.effects.base import Effect
from viscodesign.errors import SolveError
from viscodesign.estimate.scene_quantities import SceneQuantities
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

MAX_REFINEMENTS = 6
"""Solutions beyond the first after which a run is given up as not reaching its accuracy."""
LEFT_BY_TIME = 0.5
"""Error of the finer of two solutions whose tolerances differ tenfold, in parts of their
distance: over a hundred scenes 0.16 in the median, above 0.5 only where it was negligible."""
LEFT_BY_SPACE = 0.7
"""The same where the edges differ twofold: a third in the median, as order two has it; more
where the mesh is coarse for what happens on it."""
LEAST = 0.002
"""Part of the accuracy asked for that each of both is stated at least: two solutions may agree
by chance, the more so where little moves."""
NOISE = 0.9e-7
"""Part of the length below which no error in time is stated: jumps leave as much."""
MOST_GROWING = 2
"""Refinements in a row that each move the tip farther than the one before, after which no more
are tried."""
ENERGY_LIMIT = 1e-4
"""Imbalance of energy, over the work done, above which smaller steps are tried once the tip is
exact enough: a motion that looks right may still lose or gain what it should keep."""
MOST_LEFT = 0.8
"""Part of the least imbalance so far that smaller steps may leave, or they were no use."""
MOST_STUCK = 2
"""Solutions in a row that were no use, after which no more are tried: by chance one may be."""


@dataclass(frozen=True)
class ErrorParts:
    """What makes up the error at the tip [m]."""

    time_m: float
    space_m: float
    omitted_m: float

    @property
    def total_m(self) -> float:
        """All parts added up, as if they all pointed the same way."""
        return self.time_m + self.space_m + self.omitted_m


class Verifier:
    """Solves one scene, estimates its error, and refines it until that is small enough."""

    def __init__(
        self,
        quantities: SceneQuantities,
        effects: Sequence[Effect],
        omitted_m: float,
        progress: Progress | None,
        workspace: Workspace | None = None,
    ) -> None:
        self.quantities = quantities
        self.workspace = workspace or Workspace()
        self.effects = effects
        self.omitted_m = omitted_m
        self.progress = progress
        self.requested_m = quantities.accuracy * quantities.body.length
        self.spent_s = 0.0
        self.solutions = 0
        self.steps = 0
        """Of all solutions together."""
        self.stalled = ""
        """Why further refinement is no use, where it is none."""
        self.flows_apart: FlowDifference | None = None
        """How far the last cut of the tolerance moved the flows."""
        self._apart: dict[str, float] = {}
        self._growing = 0
        self.interrupted = False
        """Whether verification was stopped; the solution before it is kept."""

    def solve(self, settings: Settings) -> Run:
        """Build and solve once."""
        run = solve(self.quantities, self.effects, settings, self.progress, self.workspace)
        self.spent_s += run.spent_s
        self.solutions += 1
        self.steps += run.solution.work.steps
        if self.steps > run.problem.max_steps:
            self.stalled = f"the limit of {run.problem.max_steps} steps (run.max_steps) was reached"
        return run

    def verify(self, run: Run) -> tuple[Run, ErrorParts | None]:
        """The finest solution, and its error; None where one of them ended early."""
        space_m = 0.0 if run.is_exact_in_space else None
        time_m: float | None = None
        lost = math.inf  # least imbalance of energy, that smaller steps are to lessen
        stuck = 0
        while self.solutions <= MAX_REFINEMENTS and not self.stalled:
            if run.solution.asked_to_stop:
                self.interrupted = True
                return run, None
            coarse = time_m is not None and (space_m is None or space_m > time_m)
            in_space = coarse and lost == math.inf
            if in_space:
                settings = replace(
                    run.settings, edges_per_section=2 * run.settings.edges_per_section
                )
            else:
                settings = replace(run.settings, tolerance=run.settings.tolerance / 10)
            try:
                finer = self.solve(settings)
            except SolveError as error:
                # Not even its start was found: the coarser solution stays as it is.
                self.stalled = f"a finer solution has no start: {error.short}"
                break
            if finer.solution.interrupted:
                self.interrupted = True
                return run, None
            if not finer.is_complete:
                return finer, None
            apart = tip_difference(run.motion, finer.motion)
            if not in_space:
                self.flows_apart = flow_difference(run.motion, finer.motion)
            run = finer
            self._watch_shrinking("space" if in_space else "time", apart)
            if in_space:
                space_m = max(LEFT_BY_SPACE * apart, LEAST * self.requested_m)
            else:
                floor = max(LEAST * self.requested_m, NOISE * self.quantities.body.length)
                time_m = max(LEFT_BY_TIME * apart, floor)
            if time_m is None or space_m is None:
                continue
            parts = ErrorParts(time_m, space_m, self.omitted_m)
            solved_m = time_m + space_m
            if parts.total_m <= self.requested_m or solved_m <= self._negligible():
                imbalance = run.motion.invariants.energy_imbalance_rel or 0.0
                stuck = stuck + 1 if imbalance > MOST_LEFT * lost else 0
                if imbalance <= ENERGY_LIMIT or stuck >= MOST_STUCK:
                    return run, parts
                lost = min(lost, imbalance)
        if time_m is None or space_m is None:
            return run, None
        return run, ErrorParts(time_m, space_m, self.omitted_m)

    def _watch_shrinking(self, part: str, apart: float) -> None:
        """Note where a refinement moved the tip as far as the one before it did."""
        before = self._apart.get(part, math.inf)
        self._growing = self._growing + 1 if apart > self.requested_m and apart >= before else 0
        if self._growing >= MOST_GROWING:
            self.stalled = (
                f"the part of {part} does not shrink: refined again and again, the tip moved by "
                f"{1e3 * before:.3g} mm and then by {1e3 * apart:.3g} mm"
            )
        self._apart[part] = apart

    def _negligible(self) -> float:
        """Error of a solution beside which that of omitted effects is all that counts [m]."""
        return 0.05 * min(self.omitted_m, self.requested_m)
