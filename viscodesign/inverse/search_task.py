"""What every part of a search shares: the path, what is free, how long, and who is told."""

from __future__ import annotations

import time as clock
from collections.abc import Callable
from dataclasses import field

from viscodesign.interrupt import StopRequest
from viscodesign.inverse.free_choice import FreeChoice
from viscodesign.inverse.wanted_path import WantedPath
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.path_design import HistoryRow
from viscodesign.studies.least_squares import DESCENT_REL_TOL

Progress = Callable[[float, float], None]
"""Called with the part of the time that is spent and the best distance so far [m]."""


@dataclass(frozen=True)
class DescentPlan:
    """How many starts a search has beside the spec's own numbers, and how exactly it ends."""

    draws_per_number: int = 4
    least_draws: int = 12
    most_draws: int = 48
    descents: int = 6
    """From the best of the draws."""
    converged: float = DESCENT_REL_TOL
    """As in `SearchLimits`."""
    exact_share: float = 0.01
    """Part of the tolerance at which nothing better is sought, where times count: solutions are no
    more accurate."""
    drawn_converged: float = DESCENT_REL_TOL
    """The same for draws; the best goes on to the former."""

    def draws(self, numbers: int) -> int:
        """Draws for so many free numbers."""
        return min(max(self.draws_per_number * numbers, self.least_draws), self.most_draws)


@dataclass
class SearchLog:
    """How the best got better."""

    began: float
    rows: list[HistoryRow] = field(default_factory=list)
    evaluations: int = 0
    quick_m: float | None = None
    """Best distance of the quick motion [m], where it was asked."""
    is_cut: bool = False
    """Whether time ended the search before its work was done."""
    lost_graphs: int = 0
    """Graphs that were not tried, since the process that did died."""

    @property
    def best_m(self) -> float:
        """Best distance so far [m]."""
        return min((row.rms_m for row in self.rows), default=float("inf"))

    def note(self, rms_m: float, graph: str) -> None:
        """Note a distance of the search."""
        if rms_m < self.best_m:
            wall = clock.perf_counter() - self.began
            self.rows.append(HistoryRow(self.evaluations, wall, rms_m, graph))


@dataclass(frozen=True)
class SearchTask:
    """A design task, and the limits of its search."""

    wanted: WantedPath
    choice: FreeChoice
    tolerance_m: float
    until: float
    """Time of `time.perf_counter` [s]."""
    budget_s: float
    stop: StopRequest
    log: SearchLog
    seed: int = 0
    progress: Progress | None = None
    workers: int = 1
    """Processes that try graphs; the design does not depend on it."""
    plan: DescentPlan = DescentPlan()

    @property
    def is_over(self) -> bool:
        """Whether the search has to end; asked where work is left."""
        return self.is_beyond(self.until)

    def is_beyond(self, until: float) -> bool:
        """Whether what ends at ``until`` [s] has to end; notes that time was the reason."""
        if self.stop.asked:
            return True
        self.log.is_cut = self.log.is_cut or clock.perf_counter() > until
        return clock.perf_counter() > until

    def report(self) -> None:
        """Report how far the search has come."""
        if self.progress is not None:
            spent = clock.perf_counter() - self.log.began
            self.progress(min(spent / self.budget_s, 1.0), self.log.best_m)
