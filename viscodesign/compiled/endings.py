"""What ends a run with a named failure, so that no wrong answer passes for a result."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

from viscodesign.compiled.row_functions import RowFunction
from viscodesign.model import formulas as of
from viscodesign.model.rod_equations import RodForm
from viscodesign.postprocess.outputs import Outputs
from viscodesign.postprocess.terminations import first_termination
from viscodesign.solve.problem import Problem

SX = ca.SX
OF_CHAIN = ("position", "angle", "stretch")
OF_ARCS = ("intrinsic_curvature", "intrinsic_stretch")
"""Outputs in which a rod can be seen to have lost its meaning."""


class Endings:
    """Looks at a motion at the output times, as `simulate` does."""

    def __init__(self, problem: Problem) -> None:
        equations, pieces = problem.equations, len(problem.schedule.initial_piece)
        x = SX.sym("x", equations.states.count)
        z = SX.sym("z", equations.algebraics.count)
        time, piece = SX.sym("time"), SX.sym("piece", pieces)
        parameters = SX.sym("parameters", len(equations.parameter_values))
        sealed, *_ = equations.compiled(of.quantities).call([parameters])
        output = equations.output_function
        values = output.call([x, z, time, piece, SX(1), sealed, parameters])
        named = dict(zip(output.name_out(), values, strict=True))
        looked_at = ["pressure"] if problem.floor_volume is None else ["pressure", "volume"]
        looked_at += OF_ARCS if equations.rod_form is RodForm.ARCS else OF_CHAIN
        own = {name: named[name] for name in looked_at}
        self._sizes = {name: int(value.numel()) for name, value in own.items()}
        given = [x, z, time, piece, parameters]
        self._function = RowFunction(given, ca.vertcat(*own.values()), shared=1)

    def check(self, problem: Problem, times: np.ndarray, rows: Sequence[np.ndarray]) -> None:
        """Raise `SolveError` where the motion ends; ``rows``: see `Reading`."""
        found = np.split(self._function(*rows), np.cumsum([*self._sizes.values()])[:-1], axis=1)
        values = dict(zip(self._sizes, found, strict=True))
        of_bellows = values.keys() & {"pressure", "volume"}
        values |= {name: values[name][:, problem.places] for name in of_bellows}
        outputs = Outputs(problem, 0, 0, len(times), times, values)
        stretch, _ = outputs.section_strains()
        _, failure = first_termination(problem, times, values, stretch, None)
        if failure is not None:
            raise failure
