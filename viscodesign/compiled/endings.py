"""What ends a run with a named failure, so that no wrong answer passes for a result."""

from __future__ import annotations

import casadi as ca
import numpy as np

from viscodesign.compiled.symbols import Symbols
from viscodesign.errors import SolveError
from viscodesign.model.rod_equations import RodForm
from viscodesign.postprocess.terminations import first_termination
from viscodesign.solve.problem import Problem, section_strains

OF_BELLOWS = ("pressure", "volume")
OF_CHAIN = ("position", "angle", "stretch")
OF_ARCS = ("intrinsic_curvature", "intrinsic_stretch")
"""Outputs in which a rod can be seen to have lost its meaning."""


class Endings:
    """Looks at a motion at the output times, as `simulate` does."""

    def __init__(self, problem: Problem, symbols: Symbols) -> None:
        named = symbols.outputs(problem)
        looked_at = [*OF_BELLOWS] if volumes_count(problem) else ["pressure"]
        looked_at += OF_ARCS if problem.equations.rod_form is RodForm.ARCS else OF_CHAIN
        order = problem.places.tolist()
        own = {n: named[n][order] if n in OF_BELLOWS else named[n] for n in looked_at}
        self._sizes = {name: int(value.numel()) for name, value in own.items()}
        self.formulas = ca.vertcat(*own.values())
        """What is looked at (k,), by a row of the symbols."""

    def check(self, problem: Problem, times: np.ndarray, values: np.ndarray) -> None:
        """Raise `SolveError` where the motion ends; ``values`` (T, k) of the formulas."""
        failure = self.failure(problem, times, values)
        if failure is not None:
            raise failure

    def failure(self, problem: Problem, times: np.ndarray, values: np.ndarray) -> SolveError | None:
        """Why the motion ends, if it does."""
        found = np.split(values, np.cumsum([*self._sizes.values()])[:-1], axis=1)
        named = dict(zip(self._sizes, found, strict=True))
        stretch, _ = section_strains(problem, named)
        return first_termination(problem, times, named, stretch, None)[1]


def volumes_count(problem: Problem) -> bool:
    """Whether a motion may end by the volumes of bellows."""
    return problem.floor_volume is not None or problem.drawing is not None
