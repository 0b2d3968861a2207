"""What ends a run with a named failure, so that no wrong answer passes for a result."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

from viscodesign.compiled.row_functions import RowFunction
from viscodesign.compiled.symbols import Symbols
from viscodesign.model.rod_equations import RodForm
from viscodesign.postprocess.terminations import first_termination
from viscodesign.solve.problem import Problem, section_strains

OF_CHAIN = ("position", "angle", "stretch")
OF_ARCS = ("intrinsic_curvature", "intrinsic_stretch")
"""Outputs in which a rod can be seen to have lost its meaning."""


class Endings:
    """Looks at a motion at the output times, as `simulate` does."""

    def __init__(self, problem: Problem) -> None:
        symbols = Symbols.of(problem)
        named = symbols.outputs(problem)
        looked_at = ["pressure", "volume"] if _volumes_count(problem) else ["pressure"]
        looked_at += OF_ARCS if problem.equations.rod_form is RodForm.ARCS else OF_CHAIN
        own = {name: named[name] for name in looked_at}
        self._sizes = {name: int(value.numel()) for name, value in own.items()}
        self._function = RowFunction(symbols.row, ca.vertcat(*own.values()), shared=1)

    def check(self, problem: Problem, times: np.ndarray, rows: Sequence[np.ndarray]) -> None:
        """Raise `SolveError` where the motion ends; ``rows``: see `Reading`."""
        found = np.split(self._function(*rows), np.cumsum([*self._sizes.values()])[:-1], axis=1)
        values = dict(zip(self._sizes, found, strict=True))
        of_bellows = values.keys() & {"pressure", "volume"}
        values |= {name: values[name][:, problem.places] for name in of_bellows}
        stretch, _ = section_strains(problem, values)
        _, failure = first_termination(problem, times, values, stretch, None)
        if failure is not None:
            raise failure


def _volumes_count(problem: Problem) -> bool:
    """Whether a motion may end by the volumes of bellows."""
    return problem.floor_volume is not None or problem.drawing is not None
