"""Whether an event that ends a run is one of the scene, or of the solution's error.

An event is an answer as the motion is, and judged as it is: by a finer solution of the same scene.
Where a limit is hardly met, or hardly missed, two solutions may differ in whether the run ends at
all.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Notice
from viscodesign.simulation.error_control import Verifier
from viscodesign.simulation.solve_once import Run
from viscodesign.solve.event_failures import EventError


@dataclass(frozen=True)
class ConfirmationNumbers:
    """How events are confirmed."""

    max_solutions: int = 2
    """Finer solutions that are computed for the sake of an event."""
    agreeing_share: float = 1e-3
    """Part of the run's duration within which two solutions meet the same event."""
    mentioned_share: float = 1e-5
    """The same, above which the difference is told."""


CONFIRMATION = ConfirmationNumbers()


@dataclass(frozen=True)
class EventDoubt:
    """An event that the finest solution does not meet as the one before it did."""

    coarser: EventError
    finer: EventError | None
    """None where the finer solution goes past the limit."""

    @property
    def apart_s(self) -> float | None:
        """Time between the two events [s]; None where there is only one."""
        return None if self.finer is None else abs(self.coarser.time_s - self.finer.time_s)

    def is_within(self, share: float, duration: float) -> bool:
        """Whether both solutions meet one event within a part of the duration [s]."""
        if self.finer is None or self.finer.where != self.coarser.where:
            return False
        return abs(self.coarser.time_s - self.finer.time_s) <= share * duration

    def notices(self, duration: float) -> Iterator[Notice]:
        """What a user is to know of it, where the two differ noticeably."""
        if self.is_within(CONFIRMATION.mentioned_share, duration):
            return
        event = self.coarser
        before = (
            f"with a larger tolerance on a coarser mesh the run ends at t = {event.time_s:.6g} s "
            f"({event.quantity}, {event.where})"
        )
        if self.finer is None:
            code = "borderline_event"
            message = (
                f"{before}, and with the smaller one of this solution it does not: the motion "
                "comes so close to that limit that slightly different numbers may end there"
            )
        else:
            code = "uncertain_event"
            message = f"when the run ends is known to about {self.apart_s:.2g} s: {before}"
        yield Notice(code, message, event.where or "", event.time_s)


def confirm_event(verifier: Verifier, run: Run) -> tuple[Run, EventDoubt | None]:
    """The finer run that confirms or refutes the event that ends a run, and what is in doubt.

    The run itself and None where no finer one tells anything.
    """
    doubt: EventDoubt | None = None
    for _ in range(CONFIRMATION.max_solutions):
        event = run.motion.failure
        if not isinstance(event, EventError) or verifier.stalled:
            break
        finer = _finer(verifier, run)
        if finer is None:
            break
        met, run = finer.motion.failure, finer
        doubt = EventDoubt(event, met if isinstance(met, EventError) else None)
        duration = float(run.problem.schedule.edges[-1])
        if doubt.is_within(CONFIRMATION.agreeing_share, duration):
            break
    return run, doubt


def _finer(verifier: Verifier, run: Run) -> Run | None:
    """A solution with a tenth of the tolerance on twice the edges; None where it tells nothing."""
    settings = run.settings
    tolerance, edges = settings.tolerance / 10, 2 * settings.edges_per_section
    try:
        finer = verifier.solve(replace(settings, tolerance=tolerance, edges_per_section=edges))
    except SolveError:  # not even its start was found
        return None
    except KeyboardInterrupt:  # before its first step
        verifier.interrupted = True
        return None
    if finer.solution.interrupted:
        verifier.interrupted = True
        return None
    is_known = finer.is_complete or isinstance(finer.motion.failure, EventError)
    return finer if is_known else None  # a solver that gave up tells nothing of the event
