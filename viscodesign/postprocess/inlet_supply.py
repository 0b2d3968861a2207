"""Volume that every inlet has delivered, from what the network holds."""

from __future__ import annotations

import numpy as np

from viscodesign.postprocess.fluid_balance import holding_columns
from viscodesign.postprocess.outputs import Outputs
from viscodesign.solve.problem import Problem
from viscodesign.solve.transient import Solution


def contents(outputs: Outputs) -> np.ndarray:
    """Amount at every node beyond its filling (n, nodes) [m3 at ambient density].

    Bellows, then junctions, then inlets, of which only barrels hold anything.
    """
    problem, equations = outputs.problem, outputs.problem.equations
    beyond = outputs["stored"] - equations.filled_amounts
    names = [*problem.bellows_along_tubes, *equations.storing]
    held = dict(zip(names, beyond.T, strict=True))
    nothing = np.zeros(len(beyond))
    nodes = (*problem.bellows, *problem.junctions, *problem.inlets)
    return np.column_stack([held.get(name, nothing) for name in nodes])


class DeliveredVolume:
    """Amounts since the network was filled at the baseline, unloaded [m3 at ambient density].

    Several pressure-driven inlets of one network share equally what it held beyond its
    filling at the start of the run, since nothing says through which one it came.
    """

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        self._at_start: np.ndarray | None = None

    def along(self, outputs: Outputs, solution: Solution) -> np.ndarray:
        """Amount of every inlet at the rows of a block (n, inlets); blocks come in order."""
        problem, equations = self._problem, self._problem.equations
        beyond = outputs["stored"] - equations.filled_amounts
        if self._at_start is None:
            self._at_start = beyond[0].copy()
        names = [*problem.bellows_along_tubes, *equations.storing]
        given = {name: -beyond[:, k] for k, name in enumerate(names) if name in problem.inlets}
        later = self._inflow(outputs, solution)
        for component in equations.fed:
            driven = [name for name in component.inlets if name in equations.driven]
            own = holding_columns(problem, component)
            if len(driven) == 1:
                given[driven[0]] = beyond[:, own].sum(axis=1)
                continue
            first = self._at_start[own].sum() / len(driven)
            given |= {name: first + later[name] for name in driven}
        nothing = np.zeros((len(beyond), 0))
        return np.column_stack([nothing, *(given[name] for name in problem.inlets)])

    def _inflow(self, outputs: Outputs, solution: Solution) -> dict[str, np.ndarray]:
        """Inflow of every pressure-driven inlet since t = 0, where it is a state."""
        states = self._problem.equations.states
        if "inflow" not in states.blocks:
            return {}
        edges = slice(outputs.first, outputs.first + len(outputs.time))
        rows = states.physical("inflow", solution.states[:, edges])
        return dict(zip(self._problem.equations.driven, rows, strict=True))
