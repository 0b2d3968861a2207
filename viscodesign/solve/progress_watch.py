"""Ends runs that crawl: steps so small that the run would never end."""

from __future__ import annotations

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class Patience:
    """How slow a run may be."""

    steps: int = 20_000
    """Steps over which the rate is measured: a fast transient takes some hundreds."""
    max_times: float = 10.0
    """Steps that the rest of the run would take at this rate, over those allowed in all."""


PATIENCE = Patience()


class ProgressWatch:
    """The rate at which steps pass through a run."""

    def __init__(self, begin: float, end: float, max_steps: int) -> None:
        self._end, self._max_steps = end, max_steps
        self._steps, self._time = 0, begin

    def crawl(self, steps: int, time: float) -> SolveError | None:
        """The failure of a run that hardly moves on; ``steps`` so far brought it to ``time`` [s].

        The rate is that since the last look, once there were steps enough to tell.
        """
        taken, moved = steps - self._steps, time - self._time
        if taken < PATIENCE.steps:
            return None
        self._steps, self._time = steps, time
        if moved > 0.0 and taken * (self._end - time) / moved <= self._longest:
            return None
        rest = f"about {taken * (self._end - time) / moved:.2g}" if moved > 0.0 else "endless"
        return SolveError(
            f"the run hardly advances at t = {time:.6g} s: {taken} steps covered {moved:.3g} s, "
            f"and the rest would take {rest} steps (run.max_steps: {self._max_steps})",
            quantity="work",
            where="integrator",
            time_s=time,
            remedy="Check the last shapes and pressures for what changes so fast, such as a "
            "section that is compressed to nearly nothing; include damping, or ask for less "
            "accuracy. A larger run.max_steps allows a slower run.",
        )

    @property
    def _longest(self) -> float:
        return PATIENCE.max_times * self._max_steps
