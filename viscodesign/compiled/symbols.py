"""Arguments of the equations' functions as symbols, the parameters alone standing for a scene."""

from __future__ import annotations

from functools import lru_cache

import casadi as ca

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model import formulas as of
from viscodesign.model.equations import Equations, SharedFormulas
from viscodesign.solve.problem import Problem

SX = ca.SX


@dataclass(frozen=True)
class Symbols:
    """What a row of a motion consists of."""

    states: SX
    algebraics: SX
    time: SX
    piece: SX
    parameters: SX
    sealed: SX
    """Amounts with which sealed parts were filled, by the parameters."""

    @classmethod
    def of(cls, problem: Problem) -> Symbols:
        """Those of a problem."""
        equations = problem.equations
        parameters = SX.sym("parameters", len(equations.parameter_values))
        sealed, *_ = equations.compiled(of.quantities).call([parameters])
        return cls(
            SX.sym("x", equations.states.count),
            SX.sym("z", equations.algebraics.count),
            SX.sym("time"),
            SX.sym("piece", len(problem.schedule.initial_piece)),
            parameters,
            sealed,
        )

    @property
    def row(self) -> list[SX]:
        """Arguments of a function of rows; the parameters are the last."""
        return [self.states, self.algebraics, self.time, self.piece, self.parameters]

    @property
    def tail(self) -> list[SX]:
        """What follows the unknowns in every function of the equations, under all loads."""
        return [self.time, self.piece, SX(1), self.sealed, self.parameters]

    def outputs(self, problem: Problem) -> dict[str, SX]:
        """The equations' outputs by name."""
        output = problem.equations.output_function
        values = output.call([self.states, self.algebraics, *self.tail])
        return dict(zip(output.name_out(), values, strict=True))


def parameter_names(equations: Equations) -> tuple[str, ...]:
    """Names of a system's numbers, in the order of its parameters (p,)."""
    names = _symbol_names(equations.shared)
    return names[len(names) - len(equations.parameter_values) :]


@lru_cache(maxsize=16)
def _symbol_names(shared: SharedFormulas) -> tuple[str, ...]:
    """Names of all numbers of the formulas."""
    return tuple(symbol.name() for symbol in ca.vertsplit(shared.formulas.parameters))
