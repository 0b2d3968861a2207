"""Balances that must hold in every run: amount of fluid, and energy.

Both are kept by a ledger that takes consecutive rows, any number at a time.
"""

from __future__ import annotations

from viscodesign.postprocess.energy_balance import EnergyLedger
from viscodesign.postprocess.fluid_balance import FluidLedger
from viscodesign.postprocess.solved_edges import SolvedEdges
from viscodesign.results.trajectory import Invariants
from viscodesign.solve.problem import Problem


class Ledger:
    """Both balances of a run, updated block by block."""

    def __init__(self, problem: Problem) -> None:
        self._fluid = FluidLedger(problem)
        self._energy = EnergyLedger(problem)

    def add(self, block: SolvedEdges) -> None:
        """Add the edges that follow those before."""
        self._fluid.add(block)
        self._energy.add(block)

    def invariants(self, steps: int) -> Invariants:
        """Errors of the balances over all edges, which an integrator reached in ``steps``."""
        energy, coupling = self._energy.balance(steps)
        return Invariants(self._fluid.imbalance(), energy, coupling)
