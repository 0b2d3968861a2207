"""Output times of a compiled function: as they are, or in proportion to the end of the run."""

from __future__ import annotations

import numpy as np

from viscodesign.compiled.scene_numbers import ProblemNumbers
from viscodesign.lazy_dataclass import dataclass
from viscodesign.solve.problem import Problem


@dataclass(frozen=True, eq=False)
class OutputTimes:
    """Times of the outputs of a problem, from which they are made."""

    own: np.ndarray
    """(T,) [s]"""
    end: float
    """End of the run that they are made for [s]."""
    follow: bool
    """Whether they keep their share of the run as its end moves."""

    @classmethod
    def of(cls, problem: Problem, *, follow: bool) -> OutputTimes:
        """Those of a problem."""
        edges = problem.schedule.edges
        return cls(edges[problem.schedule.outputs], float(edges[-1]), follow)

    def at(self, numbers: ProblemNumbers) -> np.ndarray:
        """(T,) for the numbers of a run [s]."""
        if not self.follow:
            return self.own
        end = float(numbers.stops[-1])
        return np.append(self.own[:-1] * (end / self.end), end)
