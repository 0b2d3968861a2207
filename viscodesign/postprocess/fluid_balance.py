"""The balance of fluid: what flowed in is stored."""

from __future__ import annotations

import numpy as np

from viscodesign.model.graph import Component
from viscodesign.model.network_equations import NetworkForm
from viscodesign.postprocess.solved_edges import SolvedEdges
from viscodesign.solve.problem import Problem

AT_REST = 1e-3
"""Part of the contents below which no fluid moves: round-off is relative to that."""


class FluidLedger:
    """Largest difference between inflow and storage, over the amount that moved."""

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        equations = problem.equations
        self._fed = [holding_columns(problem, c) for c in equations.fed]
        self._driven = [
            [k for k, name in enumerate(equations.driven) if name in c.inlets]
            for c in equations.fed
        ]
        self._sealed = [holding_columns(problem, c) for c in equations.sealed]
        self._start: np.ndarray | None = None
        self._apart = np.zeros(len(self._fed) + len(self._sealed))
        self._inflow = np.zeros(len(self._fed))
        self._moved = self._held = 0.0

    def add(self, block: SolvedEdges) -> None:
        """Add the edges that follow those before."""
        stored = block.rows["stored"]
        if not stored.size:
            return
        if self._start is None:
            self._start = stored[0]
        self._moved = max(self._moved, float(np.max(np.abs(stored - self._start))))
        self._held = max(self._held, float(np.max(np.abs(stored))))
        self._add_fed(block, stored)
        self._add_sealed(stored)

    def _add_fed(self, block: SolvedEdges, stored: np.ndarray) -> None:
        states = self._problem.equations.states
        if "inflow" not in states.blocks:
            return
        inflows = states.physical("inflow", block.states)
        for k, (own, driven) in enumerate(zip(self._fed, self._driven, strict=True)):
            inflow = inflows[driven].sum(axis=0)
            self._inflow[k] = max(self._inflow[k], float(np.max(np.abs(inflow))))
            self._note(k, stored, own, inflow)

    def _add_sealed(self, stored: np.ndarray) -> None:
        equations = self._problem.equations
        distributed = equations.network_form is NetworkForm.DISTRIBUTED
        filled = zip(self._sealed, equations.sealed_volumes, strict=True)
        for k, (own, volume) in enumerate(filled, start=len(self._fed)):
            assert self._start is not None
            reference = 0.0 if distributed else volume - float(self._start[own].sum())
            self._note(k, stored, own, reference)

    def _note(self, k: int, stored: np.ndarray, own: list[int], came: np.ndarray | float) -> None:
        assert self._start is not None
        gained = stored[:, own].sum(axis=1) - self._start[own].sum()
        self._apart[k] = max(self._apart[k], float(np.max(np.abs(gained - came))))

    def imbalance(self) -> float:
        """Relative to the amount that moved, over all edges."""
        # Where nothing moves, round-off is relative to what is stored.
        moved = max(self._moved, AT_REST * self._held)
        scale = np.full(len(self._apart), moved)
        scale[: len(self._fed)] = np.maximum(moved, self._inflow)
        return float(np.max(self._apart / scale, initial=0.0)) if moved else 0.0


def holding_columns(problem: Problem, component: Component) -> list[int]:
    """Columns of a component's nodes among those that store fluid."""
    own = set(component.nodes)
    names = [*problem.bellows_along_tubes, *problem.equations.storing]
    return [k for k, name in enumerate(names) if name in own]
