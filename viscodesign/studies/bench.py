"""A bench for settings: solves, takes the time, and stops when it is asked or due."""

from __future__ import annotations

import os
import signal
import threading
import time as clock
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType

from viscodesign.effects.select import Selection
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.interrupt import StopRequest
from viscodesign.simulation.build_problem import Settings, build
from viscodesign.simulation.solve_once import Progress, Run, Workspace, solve

REPEAT_S = 0.1
"""A solve is repeated while all of its repeats together took less [s]."""
MOST_REPEATS = 5
Names = frozenset[str]


class StudyInterruptedError(Exception):
    """The user asked to stop."""


class OutOfTimeError(Exception):
    """A solve was given up because the time for it was over."""


@dataclass(frozen=True)
class Timed:
    """A solution, and what it costs."""

    run: Run
    solve_s: float
    """The least of the repeats [s]."""
    build_s: float
    """Formulas and integrator, made for the first time [s]."""
    wall_s: float
    """All that measuring it took [s]."""


@contextmanager
def _alarm(within_s: float) -> Iterator[None]:
    """Raise `OutOfTimeError` in what takes longer, where the system has an alarm to set.

    Whatever computes in one long call is not disturbed before it returns. An alarm that
    somebody else has set is left alone; only the main thread may set one.
    """
    free = (
        os.name == "posix"
        and threading.current_thread() is threading.main_thread()
        and signal.getsignal(signal.SIGALRM) is signal.SIG_DFL
    )
    if not free:
        yield
        return

    rang = threading.Event()

    def ring(number: int, frame: FrameType | None) -> None:
        del number, frame
        rang.set()
        raise OutOfTimeError

    signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, within_s)
    try:
        yield
    except Exception as error:
        # Libraries that call back into Python make other errors of it.
        if rang.is_set():
            raise OutOfTimeError from error
        raise
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, signal.SIG_DFL)


class Bench:
    """Solves one scene with any effects at any setting, until its time is over."""

    def __init__(
        self,
        quantities: SceneQuantities,
        selection: Selection,
        limit_s: float,
        interrupt: StopRequest,
        progress: Progress | None = None,
    ) -> None:
        self.quantities = quantities
        self.selection = selection
        self.limit_s = limit_s
        self.interrupt = interrupt
        self.progress = progress
        self._workspace = Workspace()
        self.began = clock.perf_counter()
        self._until_s = limit_s
        self._formulas_s: dict[tuple[Names, int], float] = {}
        self._integrator_s: dict[tuple[Names, int, str], float] = {}

    @property
    def spent_s(self) -> float:
        """Wall time since the study began [s]."""
        return clock.perf_counter() - self.began

    @property
    def remaining_s(self) -> float:
        """Wall time that the study has left [s]."""
        return self.limit_s - self.spent_s

    def run(self, names: Names, settings: Settings, within_s: float) -> Run:
        """Solve once.

        Raises `OutOfTimeError` where it takes longer than ``within_s``,
        `StudyInterruptedError` where the user asked to stop, and a `ViscodesignError`
        where there is nothing to solve.
        """
        self._until_s = self.spent_s + within_s
        self._check(at_once=True)
        with _alarm(within_s):
            return self._solved(names, settings)

    def _solved(self, names: Names, settings: Settings) -> Run:
        effects = self.selection.members(names)
        if (names, settings.edges_per_section) not in self._formulas_s:
            began = clock.perf_counter()
            build(self.quantities, effects, settings)
            self._formulas_s[names, settings.edges_per_section] = clock.perf_counter() - began
            self._check()
        found = solve(self.quantities, effects, settings, self._watch, self._workspace)
        if found.solution.interrupted:
            self.interrupt.times += 1
        self._check()
        key = (names, settings.edges_per_section, settings.solver)
        made_s = found.solution.work.compile_s
        self._integrator_s[key] = max(made_s, self._integrator_s.get(key, 0.0))
        return found

    def measure(self, names: Names, settings: Settings, within_s: float) -> Timed:
        """Solve as often as a fair measurement of the time needs."""
        began = self.spent_s
        best = run = self.run(names, settings, within_s)
        total, repeats = run.solve_s, 1
        while run.is_complete and total < REPEAT_S and repeats < MOST_REPEATS:
            run = self.run(names, settings, within_s)
            total, repeats = total + run.solve_s, repeats + 1
            best = min(best, run, key=lambda one: one.solve_s)
        return Timed(best, best.solve_s, self._build_s(names, settings), self.spent_s - began)

    def _build_s(self, names: Names, settings: Settings) -> float:
        edges = settings.edges_per_section
        return self._formulas_s[names, edges] + self._integrator_s[names, edges, settings.solver]

    def _watch(self, fraction: float) -> None:
        """Called by a solve between two stretches of the motion."""
        del fraction
        # A solve hears Ctrl-C by itself, and gives the signal back to the system until its
        # end; a short one may be done before it could obey.
        alone = threading.current_thread() is threading.main_thread()
        if alone and signal.getsignal(signal.SIGINT) is signal.SIG_DFL:
            self.interrupt.times += 1
        self._tell()
        if self.spent_s > self._until_s and not self.interrupt.asked:
            raise OutOfTimeError

    def _check(self, *, at_once: bool = False) -> None:
        self._tell()
        if self.interrupt.asked:
            raise StudyInterruptedError
        if at_once and self.spent_s >= self._until_s:
            raise OutOfTimeError

    def _tell(self) -> None:
        if self.progress is not None:
            self.progress(min(self.spent_s / self.limit_s, 1.0))
